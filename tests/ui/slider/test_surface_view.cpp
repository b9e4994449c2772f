// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/surface_view.h"

#include <cmath>
#include <set>

#include <QBuffer>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_surface_view {

class TestSurfaceView : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(Theme::Light); }
    void init();
    void coloursFollowTheRecess_data();
    void coloursFollowTheRecess();
    void wallsAreBandsOfColour();
    void crownDoesNotHideTheSteps();
    void sharpensAfterZooming();
    void readsRecessAndRail();
    void drawsTheGridOnRequest();
    void marksTheMinimumSpacing();
    void aSurfaceThatCannotBeDrawnLeavesTheSliderEmpty();
    void staysStillWhenNothingChanged();
    void aNarrowRailHasNoNumber();
    void offersItsCorners();
    void drawsLightAndDark();

private:
    QColor at(double x, double y) const { return view_->grab().toImage().pixelColor(view_->toPixel({x, y}).toPoint()); }
    void show(const Case& c)
    {
        view_->setSurface(c.surface, c.slider.length, c.slider.width);
        QTRY_VERIFY(view_->settled());
    }

    std::unique_ptr<SurfaceView> view_;
    Case case_;
};

void TestSurfaceView::init()
{
    case_ = sampleFilmCase();
    view_ = std::make_unique<SurfaceView>();
    view_->resize(900, 700);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    show(case_);
}

void TestSurfaceView::coloursFollowTheRecess_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("recess");
    QTest::newRow("pad") << 0.20e-3 << 0.20e-3 << 0.0;
    QTest::newRow("shelf") << 0.12e-3 << 0.50e-3 << 150e-9;
    QTest::newRow("base") << 0.50e-3 << 0.10e-3 << 1.5e-6;
}

void TestSurfaceView::coloursFollowTheRecess()
{
    QFETCH(const double, x);
    QFETCH(const double, y);
    QFETCH(const double, recess);
    QCOMPARE(at(x, y).rgb(), view_->scale().colour(recess));
}

// Rails of 4, 4, 4 and 5 corners; the last corner of the pad at the rear lies at 700 and 350 um.
void TestSurfaceView::offersItsCorners()
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    view_->dataWriter()(buffer);
    const QList<QByteArray> lines = buffer.data().trimmed().split('\n');
    QCOMPARE(lines.size(), 18);
    const QList<QByteArray> last = lines.back().split(',');
    QCOMPARE(last.size(), 6);
    QCOMPARE(QByteArray(last[0] + last[1] + last[4]), QByteArray("452"));
    QCOMPARE(last[2].toDouble(), 0.70e-3);
    QCOMPARE(last[3].toDouble(), 0.35e-3);
}

// The shelf's wall goes from 300 nm at the edge to 1.5 um at 20 um outside; 10 um outside it is 900 nm deep.
void TestSurfaceView::wallsAreBandsOfColour()
{
    view_->zoom(20.0, view_->toPixel({0.25e-3, 0.65e-3}));
    QTRY_VERIFY(view_->settled());
    const QColor wall = at(0.25e-3, 0.64e-3 + 10e-6);
    const QColor expected = QColor::fromRgb(view_->scale().colour(900e-9));
    QVERIFY2(std::abs(wall.red() - expected.red()) < 8 && std::abs(wall.green() - expected.green()) < 8 &&
                 std::abs(wall.blue() - expected.blue()) < 8,
             qPrintable(wall.name() + QLatin1Char(' ') + expected.name()));
}

void TestSurfaceView::crownDoesNotHideTheSteps()
{
    const QColor before = at(0.20e-3, 0.20e-3);
    case_.surface.crown = 100e-9; // of the order of the steps
    show(case_);
    QCOMPARE(at(0.20e-3, 0.20e-3), before);
}

void TestSurfaceView::sharpensAfterZooming()
{
    view_->zoom(30.0, view_->toPixel({0.15e-3, 0.30e-3}));
    QVERIFY(!view_->settled());
    QTRY_VERIFY(view_->settled());
    // Left of the pad's edge is its wall, right of it the pad: a few micrometres apart.
    QCOMPARE(at(0.15e-3 + 4e-6, 0.30e-3).rgb(), view_->scale().colour(0.0));
    QVERIFY(at(0.15e-3 - 6e-6, 0.30e-3).rgb() != view_->scale().colour(0.0));
}

void TestSurfaceView::readsRecessAndRail()
{
    QLocale::setDefault(QLocale::c());
    emit view_->pointed(SurfacePoint{0.12e-3, 0.50e-3});
    QVERIFY2(view_->reading().contains(QStringLiteral("rail 1")), qPrintable(view_->reading()));
    // 150 nm without form; the crown takes 4 * 15 nm * X (1 - X) with X = 0.12/0.85: 7.276 nm.
    QVERIFY2(view_->reading().contains(QStringLiteral("recess 142.7\u00a0nm")), qPrintable(view_->reading()));
    emit view_->pointed(SurfacePoint{0.50e-3, 0.10e-3});
    QVERIFY(view_->reading().contains(QStringLiteral("base")));
    emit view_->pointed(std::nullopt);
    QVERIFY(view_->reading().isEmpty());
}

void TestSurfaceView::drawsTheGridOnRequest()
{
    view_->setGrid(sampleGrid(case_, 8, 5));
    const QImage without = view_->grab().toImage();
    view_->setGridShown(true);
    const QImage with = view_->grab().toImage();
    // Along the base at y = 0.03 mm the eight columns have seven borders inside.
    int lines = 0;
    bool inLine = false;
    const QPoint from = view_->toPixel({5e-6, 0.03e-3}).toPoint();
    const QPoint to = view_->toPixel({0.845e-3, 0.03e-3}).toPoint();
    for (int x = from.x(); x < to.x(); ++x) {
        const bool differs = with.pixel(x, from.y()) != without.pixel(x, from.y());
        lines += differs && !inLine;
        inLine = differs;
    }
    QCOMPARE(lines, 7);
}

void TestSurfaceView::marksTheMinimumSpacing()
{
    const SurfacePoint where{0.6e-3, 0.1e-3};
    const QColor before = at(where.x, where.y);
    view_->setMinimumSpacing(where, QStringLiteral("5.6 nm"));
    const QImage image = view_->grab().toImage();
    const QPoint tip = view_->toPixel(where).toPoint();
    QVERIFY(image.pixelColor(tip - QPoint(0, 5)) != before); // the triangle stands on its tip
    view_->setMinimumSpacing(std::nullopt);
    QCOMPARE(at(where.x, where.y), before);
}

void TestSurfaceView::aSurfaceThatCannotBeDrawnLeavesTheSliderEmpty()
{
    case_.surface.rails[0].points[0].wall = 7; // there are two
    view_->setSurface(case_.surface, case_.slider.length, case_.slider.width);
    QCOMPARE(at(0.25e-3, 0.03e-3).rgb(), view_->scale().colour(1.5e-6));
    QCOMPARE(at(0.20e-3, 0.20e-3).rgb(), view_->scale().colour(1.5e-6));
    // And comes back.
    show(sampleFilmCase());
    QCOMPARE(at(0.20e-3, 0.20e-3).rgb(), view_->scale().colour(0.0));
}

void TestSurfaceView::staysStillWhenNothingChanged()
{
    view_->zoom(3.0, view_->toPixel({0.4e-3, 0.3e-3}));
    QTRY_VERIFY(view_->settled());
    const QRectF seen = view_->view();
    view_->setSurface(case_.surface, case_.slider.length, case_.slider.width);
    QVERIFY(view_->settled());
    case_.surface.rails[1].recess[0] = 10e-9; // an edit keeps the view, too
    show(case_);
    QCOMPARE(view_->view(), seen);
}

// A rail of 2 um, a pixel or two, has no room for a number; of 60 um it has. The box of a number is lighter than the
// base that lies 4 px above the middle of the narrow rail.
void TestSurfaceView::aNarrowRailHasNoNumber()
{
    const auto boxOver = [this](double height) {
        Case c = case_;
        c.surface.pointsOfInterest.clear();
        c.surface.rails = {{RailKind::Step,
                            {{0.2e-3, 0.35e-3 - 0.5 * height, 0},
                             {0.6e-3, 0.35e-3 - 0.5 * height, 0},
                             {0.6e-3, 0.35e-3 + 0.5 * height, 0},
                             {0.2e-3, 0.35e-3 + 0.5 * height, 0}},
                            {150e-9, 0.0, 0.0}}};
        view_->setSurface(c.surface, c.slider.length, c.slider.width);
        const QImage image = view_->grab().toImage();
        const int y = static_cast<int>(view_->toPixel({0.4e-3, 0.35e-3}).y()) - 4;
        const int left = static_cast<int>(view_->toPixel({0.205e-3, 0.35e-3}).x());
        const int right = static_cast<int>(view_->toPixel({0.595e-3, 0.35e-3}).x());
        for (int x = left; x < right; ++x)
            if (image.pixelColor(x, y) != image.pixelColor(left, y)) return true;
        return false;
    };
    QVERIFY(boxOver(60e-6));
    QTRY_VERIFY(!boxOver(2e-6)); // once the picture of the wider rail is gone
}

void TestSurfaceView::drawsLightAndDark()
{
    const QColor light = view_->grab().toImage().pixelColor(2, 2);
    applyTheme(Theme::Dark);
    QTRY_VERIFY(view_->grab().toImage().pixelColor(2, 2).lightness() < 60);
    QVERIFY(light.lightness() > 200);
    // The surface itself keeps its colours.
    QCOMPARE(at(0.20e-3, 0.20e-3).rgb(), view_->scale().colour(0.0));
    applyTheme(Theme::Light);
}

TOUCHDOWN_TEST(TestSurfaceView)

} // namespace test_surface_view

#include "test_surface_view.moc"
