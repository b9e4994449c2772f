// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/maps_view.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <QTest>

#include "core/case/case.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/maps/field_map.h"
#include "ui/maps/field_sections.h"
#include "ui/style/theme.h"

using namespace touchdown;
using Quantity = MapsView::Quantity;

class TestMapsView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void showsPressureAboveAmbient();
    void showsGapAndRecess();
    void sectionsAreTheCellsOfARowAndAColumn();
    void sectionsAreSteps();
    void beginsAtTheMinimumSpacing();
    void sectionsFollowThePointerUntilPinned();
    void aCursorInASectionMovesTheOther();
    void shiftAndArrowsMoveByACell();
    void logarithmOfTheGap();
    void aGapOfZeroHasNoLogarithm();
    void unitsBelongToTheQuantity();
    void aNewResultKeepsWhatWasChosen();
    void clears();
    void controlsHaveNames();

private:
    std::unique_ptr<MapsView> view_;
    Case case_;
    SteadyResult result_;
};

void TestMapsView::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
}

void TestMapsView::init()
{
    case_ = sampleFilmCase();
    result_ = sampleResult(case_);
    view_ = std::make_unique<MapsView>();
    view_->resize(800, 700);
    view_->setResult(result_, case_.slider, case_.disk.skew, 101325.0);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
}

void TestMapsView::showsPressureAboveAmbient()
{
    QCOMPARE(view_->quantity(), Quantity::Pressure);
    for (const std::size_t cell : {std::size_t(0), std::size_t(777), result_.pressure.size() - 1})
        QCOMPARE(view_->map()->value(cell), result_.pressure[cell] - 101325.0);
    QCOMPARE(view_->map()->look().scale.position(0.0), 0.5);
}

void TestMapsView::showsGapAndRecess()
{
    view_->setQuantity(Quantity::Gap);
    QCOMPARE(view_->map()->value(100), result_.gap[100]);
    // Bright is near the disk.
    const ColourScale& scale = view_->map()->look().scale;
    QVERIFY(QColor::fromRgb(scale.colour(scale.low())).lightness() >
            QColor::fromRgb(scale.colour(scale.high())).lightness());
    view_->setQuantity(Quantity::Recess);
    QCOMPARE(view_->map()->value(100), result_.recess[100]);
}

void TestMapsView::sectionsAreTheCellsOfARowAndAColumn()
{
    view_->setQuantity(Quantity::Gap);
    const SurfacePoint point{result_.grid.centreX(30), result_.grid.centreY(10)};
    view_->setSectionPoint(point, true);
    const MinMaxPyramid& x = *view_->sections()->alongX()->curves().at(0).data;
    const MinMaxPyramid& y = *view_->sections()->alongY()->curves().at(0).data;
    // At the middle of each cell stands its own value.
    for (int i = 0; i < 48; ++i)
        QCOMPARE(*x.valueAt(result_.grid.centreX(i)), result_.gap[static_cast<std::size_t>(10 * 48 + i)]);
    for (int j = 0; j < 40; ++j)
        QCOMPARE(*y.valueAt(result_.grid.centreY(j)), result_.gap[static_cast<std::size_t>(j * 48 + 30)]);
    QVERIFY(view_->sections()->alongX()->title().contains(QStringLiteral("y = 0.183"))); // 10.5/40 of 0.7 mm
}

void TestMapsView::sectionsAreSteps()
{
    const MinMaxPyramid& x = *view_->sections()->alongX()->curves().at(0).data;
    QCOMPARE(x.size(), std::size_t(2 * 48));
    QCOMPARE(x.firstTime(), 0.0);
    QCOMPARE(x.lastTime(), case_.slider.length);
    for (std::size_t i = 0; i < 48; ++i) QCOMPARE(x.value(2 * i), x.value(2 * i + 1));
    // Also at a border, where two cells meet, there is a number.
    for (const double border : result_.grid.x) QVERIFY(std::isfinite(*x.valueAt(border)));
}

void TestMapsView::beginsAtTheMinimumSpacing()
{
    QVERIFY(view_->sectionPoint());
    // The sample's minimum is the smallest of its cells, at its middle.
    QCOMPARE(view_->sectionPoint()->x, result_.minimumAt.x);
    QCOMPARE(view_->sectionPoint()->y, result_.minimumAt.y);
    QVERIFY(!view_->pinned());
}

void TestMapsView::sectionsFollowThePointerUntilPinned()
{
    emit view_->map()->pointed(SurfacePoint{0.2e-3, 0.3e-3});
    QCOMPARE(view_->sectionPoint()->x, 0.2e-3);
    emit view_->map()->chosen(SurfacePoint{0.4e-3, 0.5e-3});
    QVERIFY(view_->pinned());
    emit view_->map()->pointed(SurfacePoint{0.1e-3, 0.1e-3});
    QCOMPARE(view_->sectionPoint()->x, 0.4e-3);
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    emit view_->map()->pointed(SurfacePoint{0.1e-3, 0.1e-3});
    QCOMPARE(view_->sectionPoint()->x, 0.1e-3);
}

void TestMapsView::aCursorInASectionMovesTheOther()
{
    view_->setSectionPoint({0.4e-3, 0.2e-3}, true);
    emit view_->sections()->alongX()->cursorMoved(0, true, 0.8e-3);
    QCOMPARE(view_->sectionPoint()->x, 0.8e-3);
    QCOMPARE(view_->sectionPoint()->y, 0.2e-3);
    QVERIFY(view_->sections()->alongY()->title().contains(QStringLiteral("0.8000")));
    emit view_->sections()->alongY()->cursorMoved(0, true, 0.6e-3);
    QCOMPARE(view_->sectionPoint()->y, 0.6e-3);
}

void TestMapsView::shiftAndArrowsMoveByACell()
{
    view_->setSectionPoint({result_.grid.centreX(10), result_.grid.centreY(20)}, true);
    view_->map()->setFocus();
    QTest::keyClick(view_->map(), Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(view_->sectionPoint()->x, result_.grid.centreX(11));
    QTest::keyClick(view_->map(), Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(view_->sectionPoint()->y, result_.grid.centreY(21));
    for (int i = 0; i < 100; ++i) QTest::keyClick(view_->map(), Qt::Key_Left, Qt::ShiftModifier);
    QCOMPARE(view_->sectionPoint()->x, result_.grid.centreX(0)); // not beyond the edge
    QVERIFY(view_->map()->isFitted());                           // and the view stayed
}

void TestMapsView::logarithmOfTheGap()
{
    view_->setQuantity(Quantity::Gap);
    QVERIFY(view_->map()->look().scale.isLogarithmic());
    QVERIFY(view_->sections()->alongX()->yAxis().logarithmic());
    view_->logarithmic()->setChecked(false);
    QVERIFY(!view_->map()->look().scale.isLogarithmic());
    QVERIFY(!view_->sections()->alongX()->yAxis().logarithmic());
    view_->setQuantity(Quantity::Pressure);
    // Of the pressure the choice is another, and the sections stay as they are.
    QVERIFY(!view_->logarithmic()->isChecked());
    view_->logarithmic()->setChecked(true);
    QVERIFY(view_->map()->look().scale.position(3e5) > 0.85); // of 9e5
    QVERIFY(!view_->sections()->alongX()->yAxis().logarithmic());
    view_->setQuantity(Quantity::Recess);
    QVERIFY(view_->logarithmic()->isHidden());
}

void TestMapsView::aGapOfZeroHasNoLogarithm()
{
    result_.gap[5] = 0.0;
    view_->setResult(result_, case_.slider, case_.disk.skew, 101325.0);
    view_->setQuantity(Quantity::Gap);
    QVERIFY(!view_->map()->look().scale.isLogarithmic());
}

void TestMapsView::unitsBelongToTheQuantity()
{
    const auto units = [this] {
        QStringList list;
        for (int i = 0; i < view_->unit()->count(); ++i) list << view_->unit()->itemText(i);
        return list;
    };
    QCOMPARE(units(), (QStringList{"kPa", "atm", "MPa"}));
    view_->unit()->setCurrentIndex(1);
    QCOMPARE(view_->map()->look().factor, 101325.0);
    view_->setQuantity(Quantity::Recess);
    QCOMPARE(units(), (QStringList{"nm", QStringLiteral("µm")}));
    QCOMPARE(view_->map()->look().factor, 1e-9);
}

void TestMapsView::aNewResultKeepsWhatWasChosen()
{
    view_->setQuantity(Quantity::Gap);
    view_->setSectionPoint({0.3e-3, 0.3e-3}, true);
    view_->map()->zoom(3.0, view_->map()->toPixel({0.3e-3, 0.3e-3}));
    const QRectF seen = view_->map()->view();
    view_->setResult(sampleResult(case_, 60, 50), case_.slider, case_.disk.skew, 101325.0);
    QCOMPARE(view_->quantity(), Quantity::Gap);
    QCOMPARE(view_->sectionPoint()->x, 0.3e-3);
    QCOMPARE(view_->map()->view(), seen);
    QCOMPARE(view_->sections()->alongX()->curves().at(0).data->size(), std::size_t(120));
}

void TestMapsView::clears()
{
    view_->clear();
    QVERIFY(view_->map()->empty());
    QVERIFY(view_->sections()->alongX()->curves().empty());
    QVERIFY(!view_->sectionPoint());
    QTest::keyClick(view_->map(), Qt::Key_Right, Qt::ShiftModifier); // nothing to move
    QVERIFY(!view_->sectionPoint());
}

void TestMapsView::controlsHaveNames()
{
    for (const QWidget* widget : view_->findChildren<QWidget*>()) {
        if (!(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy()) continue;
        QVERIFY2(!widget->accessibleName().isEmpty() || !widget->property("text").toString().isEmpty(),
                 widget->metaObject()->className());
    }
}

TOUCHDOWN_TEST(TestMapsView)
#include "test_maps_view.moc"
