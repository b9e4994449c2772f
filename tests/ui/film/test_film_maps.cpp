// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/film_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <QTest>

#include "core/simulation/static_state/steady.h"
#include "tests/support/random_slider.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/film/compare_page.h"
#include "ui/maps/field_cursor_table.h"
#include "ui/maps/field_map.h"
#include "ui/maps/field_sections.h"
#include "ui/maps/fields_view.h"
#include "ui/slider/attitude_sections.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_film_maps {

using Page = FilmView::Page;

class TestFilmMaps : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void showsPressureAboveAmbient();
    void aPressureHasOneNumber();
    void theLeastGapHasOneNumber();
    void theLeastGapOfAnyRails();
    void showsGapAndRecess();
    void sectionsAreTheCellsOfARowAndAColumn();
    void sectionsHaveTheNumbersOfTheTable();
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
    QAction solve_;
    std::unique_ptr<FilmView> film_;
    FieldsView* view_ = nullptr; // the maps of the page
    Case case_;
    SteadyResult result_;
};

void TestFilmMaps::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
}

void TestFilmMaps::init()
{
    case_ = sampleFilmCase();
    result_ = sampleResult(case_);
    film_ = std::make_unique<FilmView>(&solve_);
    view_ = film_->maps();
    film_->resize(800, 740);
    film_->setResult(case_, result_);
    film_->setPage(Page::Pressure);
    film_->show();
    QVERIFY(QTest::qWaitForWindowExposed(film_.get()));
}

void TestFilmMaps::showsPressureAboveAmbient()
{
    QCOMPARE(film_->page(), Page::Pressure);
    for (const std::size_t cell : {std::size_t(0), std::size_t(777), result_.pressure.size() - 1})
        QCOMPARE(view_->map()->value(cell), result_.pressure[cell] - 101325.0);
    QCOMPARE(view_->map()->look().scale.position(0.0), 0.5);
}

/// The peak on the map, in the table of the attitude and beside other solutions; each says that it is above ambient.
void TestFilmMaps::aPressureHasOneNumber()
{
    const double peak = *std::ranges::max_element(result_.pressure);
    result_.forces.maximumPressure = peak;
    const FieldMap* map = view_->map();
    const QString onTheMap = fieldText(peak - 101325.0, map->look());
    QCOMPARE(map->look().title, QStringLiteral("Pressure above ambient"));
    QStringList inTheTable;
    for (const AttitudeSection& section : attitudeSections(case_, result_))
        for (const QStringList& row : section.rows)
            if (row[0] == QStringLiteral("Peak pressure above ambient")) inTheTable = row;
    QCOMPARE(inTheTable.value(1), onTheMap);
    SolutionRecord record;
    record.value = case_;
    record.result = result_;
    QString compared;
    for (const ComparedRow& row : comparisonOf({&record}, -1).rows)
        if (row.name == QStringLiteral("Peak pressure above ambient")) compared = row.values[0];
    QCOMPARE(compared, onTheMap);
    // The axis of the sections says it too, and the head of their numbers.
    QCOMPARE(view_->sections()->alongX()->yAxis().label.title, QStringLiteral("p \u2212 p\u2080"));
    QCOMPARE(view_->sections()->alongX()->curves()[0].name, QStringLiteral("Pressure above ambient"));
}

/// The mark of the map, the table of the cursors, which begin there, and the reading under the pointer are the state's
/// minimum spacing, though the smallest mean of a cell is more; with the digits of the state. A slider that pitches has
/// it on the rear edge of the last rail, between two cells of which one is recessed.
void TestFilmMaps::theLeastGapHasOneNumber()
{
    for (const double error : {0.0, 0.03e-9, 0.4e-9}) {
        Case c = test::smallSlider(33);
        SteadyResult state = steady(c);
        QCOMPARE(state.status, SteadyStatus::Converged);
        state.discretisationError.minimumSpacing = error;
        film_->setResult(c, state);
        film_->setPage(Page::Gap);
        const FieldMap& map = *view_->map();
        const QString number = roundedToError(state.minimumSpacing, error, "nm");
        QVERIFY(*std::ranges::min_element(state.gap) > state.minimumSpacing);
        const SurfacePoint at = *view_->sectionPoint();
        QVERIFY(std::hypot(at.x - state.minimumAt.x, at.y - state.minimumAt.y) < 1e-10);
        QVERIFY(std::abs(*map.valueAt(at) - state.minimumSpacing) < 1e-14);
        QCOMPARE(fieldText(*map.valueAt(at), map.look()), number);
        const auto* table = view_->cursors()->table();
        QCOMPARE(table->text(0, 4), number.chopped(3));
        QVERIFY(map.marks().contains(number));
        // The sections pass through the cells of the rail.
        QVERIFY(state.recess[*map.cellAt(at)] < 0.5e-6);
        // Elsewhere the gap is that of the point, as of the points of interest.
        for (const SurfacePoint& p : {SurfacePoint{0.3e-3, 0.1e-3}, SurfacePoint{0.5e-3, 0.4e-3}}) {
            c.surface.pointsOfInterest = {p};
            Case held = c;
            held.steady.fixedAttitude = true;
            held.initial.nominalTrailingEdgeHeight = state.attitude.height;
            held.initial.pitch = state.attitude.pitch;
            held.initial.roll = state.attitude.roll;
            QVERIFY(std::abs(*map.valueAt(p) - steady(held).interestSpacing[0]) < 1e-15);
        }
        film_->setPage(Page::Recess);
        QVERIFY(std::abs(*map.valueAt({0.05e-3, 0.4e-3}) - (150e-9 - 4.0 * 10e-9 * 0.05 * 0.95 - 3e-9)) < 1e-15);
        film_->setPage(Page::Pressure);
    }
}

/// Also on rails with slanted edges and with walls, where the point is the corner of a rail inside a cell, or beside
/// its rail by rounding. Drawn sliders, held where they fly about.
void TestFilmMaps::theLeastGapOfAnyRails()
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Case c = test::RandomSlider(seed).shape();
        c.film.nodes = {33, 33};
        c.steady.fixedAttitude = true;
        c.initial.nominalTrailingEdgeHeight = 30e-9;
        c.initial.pitch = 140e-6;
        c.initial.roll = (static_cast<double>(seed % 5) - 2.0) * 2e-6;
        const SteadyResult state = steady(c);
        QVERIFY2(state.status == SteadyStatus::Converged, state.message.c_str());
        film_->setResult(c, state);
        film_->setPage(Page::Gap);
        const FieldMap& map = *view_->map();
        const QString number = roundedToError(state.minimumSpacing, 0.0, "nm");
        QCOMPARE(map.marks().front(), number);
        QCOMPARE(view_->cursors()->table()->text(0, 4), number.chopped(3));
        // No number under the pointer is less. Of a crowned top the minimum is found to some 0.001 nm.
        for (int i = 0; i <= 500; ++i)
            for (int j = 0; j <= 50; ++j) {
                const double gap = *map.valueAt({c.slider.length * i / 500.0, c.slider.width * j / 50.0});
                QVERIFY2(gap >= state.minimumSpacing - 2e-12, qPrintable(QString::number(gap - state.minimumSpacing)));
            }
        film_->setPage(Page::Pressure);
    }
}

void TestFilmMaps::showsGapAndRecess()
{
    film_->setPage(Page::Gap);
    QCOMPARE(view_->map()->value(100), result_.gap[100]);
    // Bright is near the disk.
    const ColourScale& scale = view_->map()->look().scale;
    QVERIFY(QColor::fromRgb(scale.colour(scale.low())).lightness() >
            QColor::fromRgb(scale.colour(scale.high())).lightness());
    film_->setPage(Page::Recess);
    QCOMPARE(view_->map()->value(100), result_.recess[100]);
}

void TestFilmMaps::sectionsAreTheCellsOfARowAndAColumn()
{
    const SurfacePoint point{result_.grid.centreX(30), result_.grid.centreY(10)};
    view_->setSectionPoint(point, true);
    const MinMaxPyramid& x = *view_->sections()->alongX()->curves().at(0).data;
    const MinMaxPyramid& y = *view_->sections()->alongY()->curves().at(0).data;
    const FieldMap& map = *view_->map();
    // At the middle of each cell stands its own value.
    for (int i = 0; i < 48; ++i)
        QCOMPARE(*x.valueAt(result_.grid.centreX(i)), map.value(static_cast<std::size_t>(10 * 48 + i)));
    for (int j = 0; j < 40; ++j)
        QCOMPARE(*y.valueAt(result_.grid.centreY(j)), map.value(static_cast<std::size_t>(j * 48 + 30)));
    QVERIFY(view_->sections()->alongX()->title().contains(QStringLiteral("y = 0.183"))); // 10.5/40 of 0.7 mm
}

/// At the place of the least gap, where the dots stand at first, and elsewhere; of each state that is compared.
void TestFilmMaps::sectionsHaveTheNumbersOfTheTable()
{
    std::array<SolutionRecord, 2> records;
    for (SolutionRecord& record : records) record.value = test::smallSlider(33);
    records[0].number = 1;
    records[1].number = 2;
    records[1].value.suspension.preload *= 1.2;
    for (SolutionRecord& record : records) record.result = steady(record.value);
    film_->setResult(records[0].value, records[0].result);
    film_->compare(&records[0], {&records[0], &records[1]}, -1);
    const auto* table = view_->cursors()->table();
    for (const Page page : {Page::Gap, Page::Recess})
        for (const auto& place : {std::optional<SurfacePoint>(), std::optional(SurfacePoint{0.31e-3, 0.168e-3})}) {
            film_->setPage(page);
            if (place) view_->setSectionPoint(*place, true);
            const SurfacePoint at = *view_->sectionPoint();
            for (const auto& [plot, along] :
                 {std::pair(view_->sections()->alongX(), at.x), std::pair(view_->sections()->alongY(), at.y)}) {
                QCOMPARE(plot->curves().size(), std::size_t{2});
                for (std::size_t k = 0; k < 2; ++k) { // the shown state is drawn last, and stands first in the table
                    const QString drawn =
                        fieldNumber(*plot->curves()[1 - k].data->valueAt(along), view_->map()->look());
                    QCOMPARE(drawn, table->text(0, 4 + static_cast<int>(k)));
                }
            }
        }
    // Between the cursors, too: cells have one gap, the side rail slopes with pitch and crown.
    const MinMaxPyramid& x = *view_->sections()->alongX()->curves().back().data;
    for (const double along : {0.2e-3, 0.3456e-3, 0.5e-3})
        QVERIFY(std::abs(*x.valueAt(along) - *view_->map()->valueAt({along, view_->sectionPoint()->y})) < 1e-12);
}

void TestFilmMaps::sectionsAreSteps()
{
    const MinMaxPyramid& x = *view_->sections()->alongX()->curves().at(0).data;
    QCOMPARE(x.size(), std::size_t(2 * 48));
    QCOMPARE(x.firstTime(), 0.0);
    QCOMPARE(x.lastTime(), case_.slider.length);
    for (std::size_t i = 0; i < 48; ++i) QCOMPARE(x.value(2 * i), x.value(2 * i + 1));
    // Also at a border, where two cells meet, there is a number.
    for (const double border : result_.grid.x) QVERIFY(std::isfinite(*x.valueAt(border)));
}

void TestFilmMaps::beginsAtTheMinimumSpacing()
{
    QVERIFY(view_->sectionPoint());
    // The sample's minimum is the smallest of its cells, at its middle.
    QCOMPARE(view_->sectionPoint()->x, result_.minimumAt.x);
    QCOMPARE(view_->sectionPoint()->y, result_.minimumAt.y);
    QVERIFY(!view_->pinned());
}

void TestFilmMaps::sectionsFollowThePointerUntilPinned()
{
    emit view_->map()->pointed(SurfacePoint{0.2e-3, 0.3e-3});
    QCOMPARE(view_->sectionPoint()->x, 0.2e-3);
    emit view_->map()->chosen(SurfacePoint{0.4e-3, 0.5e-3});
    QVERIFY(view_->pinned());
    emit view_->map()->pointed(SurfacePoint{0.1e-3, 0.1e-3});
    QCOMPARE(view_->sectionPoint()->x, 0.4e-3);
    QTest::keyClick(view_, Qt::Key_Escape);
    emit view_->map()->pointed(SurfacePoint{0.1e-3, 0.1e-3});
    QCOMPARE(view_->sectionPoint()->x, 0.1e-3);
}

void TestFilmMaps::aCursorInASectionMovesTheOther()
{
    view_->setSectionPoint({0.4e-3, 0.2e-3}, true);
    emit view_->sections()->alongX()->cursorMoved(0, true, 0.8e-3);
    QCOMPARE(view_->sectionPoint()->x, 0.8e-3);
    QCOMPARE(view_->sectionPoint()->y, 0.2e-3);
    QVERIFY(view_->sections()->alongY()->title().contains(QStringLiteral("0.8000")));
    emit view_->sections()->alongY()->cursorMoved(0, true, 0.6e-3);
    QCOMPARE(view_->sectionPoint()->y, 0.6e-3);
}

void TestFilmMaps::shiftAndArrowsMoveByACell()
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

void TestFilmMaps::logarithmOfTheGap()
{
    film_->setPage(Page::Gap);
    QVERIFY(view_->map()->look().scale.isLogarithmic());
    QVERIFY(view_->sections()->alongX()->yAxis().logarithmic());
    view_->logarithmic()->setChecked(false);
    QVERIFY(!view_->map()->look().scale.isLogarithmic());
    QVERIFY(!view_->sections()->alongX()->yAxis().logarithmic());
    film_->setPage(Page::Pressure);
    // Of the pressure the choice is another, and the sections stay as they are.
    QVERIFY(!view_->logarithmic()->isChecked());
    view_->logarithmic()->setChecked(true);
    QVERIFY(view_->map()->look().scale.position(3e5) > 0.85); // of 9e5
    QVERIFY(!view_->sections()->alongX()->yAxis().logarithmic());
    film_->setPage(Page::Recess);
    QVERIFY(view_->logarithmic()->isHidden());
}

void TestFilmMaps::aGapOfZeroHasNoLogarithm()
{
    result_.gap[5] = 0.0;
    film_->setResult(case_, result_);
    film_->setPage(Page::Gap);
    QVERIFY(!view_->map()->look().scale.isLogarithmic());
}

void TestFilmMaps::unitsBelongToTheQuantity()
{
    const auto units = [this] {
        QStringList list;
        for (int i = 0; i < view_->unit()->count(); ++i) list << view_->unit()->itemText(i);
        return list;
    };
    QCOMPARE(units(), (QStringList{"kPa", "atm", "MPa"}));
    view_->unit()->setCurrentIndex(1);
    QCOMPARE(view_->map()->look().factor, 101325.0);
    film_->setPage(Page::Recess);
    QCOMPARE(units(), (QStringList{"nm", QStringLiteral("µm")}));
    QCOMPARE(view_->map()->look().factor, 1e-9);
}

void TestFilmMaps::aNewResultKeepsWhatWasChosen()
{
    film_->setPage(Page::Gap);
    view_->setSectionPoint({0.3e-3, 0.3e-3}, true);
    view_->map()->zoom(3.0, view_->map()->toPixel({0.3e-3, 0.3e-3}));
    const QRectF seen = view_->map()->view();
    film_->setResult(case_, sampleResult(case_, 60, 50));
    QCOMPARE(film_->page(), Page::Gap);
    QCOMPARE(view_->sectionPoint()->x, 0.3e-3);
    QCOMPARE(view_->map()->view(), seen);
    QCOMPARE(view_->sections()->alongX()->curves().at(0).data->size(), std::size_t(60 * 9 + 1)); // and the cursor
}

void TestFilmMaps::clears()
{
    film_->clearResult();
    QVERIFY(view_->map()->empty());
    QVERIFY(view_->sections()->alongX()->curves().empty());
    QVERIFY(!view_->sectionPoint());
    QTest::keyClick(view_->map(), Qt::Key_Right, Qt::ShiftModifier); // nothing to move
    QVERIFY(!view_->sectionPoint());
}

void TestFilmMaps::controlsHaveNames()
{
    for (const QWidget* widget : view_->findChildren<QWidget*>()) {
        if (!(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy()) continue;
        QVERIFY2(!widget->accessibleName().isEmpty() || !widget->property("text").toString().isEmpty(),
                 widget->metaObject()->className());
    }
}

TOUCHDOWN_TEST(TestFilmMaps)

} // namespace test_film_maps

#include "test_film_maps.moc"
