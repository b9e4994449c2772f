// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_maps.h"

#include <algorithm>
#include <memory>

#include <QSignalSpy>
#include <QTest>

#include "core/simulation/run.h"
#include "core/simulation/static_state/film_setup.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_contact.h"
#include "tests/ui/sample_slider.h"
#include "ui/maps/field_map.h"
#include "ui/maps/field_sections.h"
#include "ui/maps/fields_view.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_run_maps {

class TestRunMaps : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void beginsWithoutARun();
    void offersEachField();
    void followsARunUnderWay();
    void staysWhereTheUserWent();
    void endsAtTheClosestApproach();
    void goesThroughTheTimes();
    void scalesSpanTheRunOrTheTime();
    void sectionsShareTheScale();
    void aHiddenPageTakesNothing();
    void saysWhyThereAreNoMaps();
    void thinsWhatMemoryCannotHold();
    void aRunThatIsDeletedLeaves();
    void paintsBothThemes_data();
    void paintsBothThemes();
    void controlsHaveNames();
    void showsTheSetsOfAFilm();
    void keepsTheTimeFromSetToSet();
    void theLeastGapIsTheMinimumSpacingOfTheTime();

private:
    double shownPressure(std::size_t cell) const { return maps_->view()->map()->value(cell); }

    std::unique_ptr<RunsModel> runs_;
    std::unique_ptr<RunMaps> maps_;
};

void TestRunMaps::initTestCase() { QLocale::setDefault(QLocale::c()); }

void TestRunMaps::init()
{
    applyTheme(Theme::Light);
    maps_.reset();
    runs_ = std::make_unique<RunsModel>();
    maps_ = std::make_unique<RunMaps>(*runs_);
    maps_->resize(800, 700);
    maps_->show();
    QVERIFY(QTest::qWaitForWindowExposed(maps_.get()));
}

void TestRunMaps::beginsWithoutARun()
{
    QVERIFY(maps_->empty());
    QVERIFY(maps_->emptyText().contains(QStringLiteral("run the case")));
    QVERIFY(!maps_->time()->isVisible());
}

void TestRunMaps::offersEachField()
{
    runs_->add(sampleContactRun(1));
    maps_->showRun(1);
    QVERIFY(!maps_->empty());
    QCOMPARE(maps_->tabs()->count(), 2);
    QCOMPARE(maps_->tabs()->tabText(0), QStringLiteral("Gap"));
    QCOMPARE(maps_->tabs()->currentIndex(), 1); // the pressure is what one looks for
    // On a pad of 8 x 4 um there is no edge of a slider to name, and lengths are read in um.
    QCOMPARE(maps_->view()->map()->area(), QRectF(0.0, 0.0, 8e-6, 4e-6));
    QCOMPARE(maps_->view()->map()->lengthUnit(), std::string_view("um"));
    maps_->tabs()->setCurrentIndex(0);
    QCOMPARE(maps_->view()->map()->title(), QStringLiteral("Gap of the deformed surfaces"));
}

void TestRunMaps::followsARunUnderWay()
{
    runs_->add(sampleContactRun(1, 3)); // up to 0.2 ms
    maps_->showRun(1);
    QCOMPARE(maps_->time()->value(), 2);
    runs_->append(1, sampleContactBatch(0.21e-3, 0.4e-3), {}, {sampleSnapshot(0.3e-3), sampleSnapshot(0.4e-3)});
    maps_->dataArrived(1);
    QCOMPARE(maps_->time()->maximum(), 4);
    QCOMPARE(maps_->time()->value(), 4);
    // d = -5 nm + 10 nm * 0.1/0.5 = -3 nm: 3 MPa for each number of the cell.
    QVERIFY(std::abs(shownPressure(10) - 30e6) < 1.0);
    QVERIFY2(maps_->reading()->text().contains(QChar(0x2212) + QStringLiteral("3.000")),
             qPrintable(maps_->reading()->text()));
}

void TestRunMaps::staysWhereTheUserWent()
{
    runs_->add(sampleContactRun(1, 5));
    maps_->showRun(1);
    maps_->time()->setValue(1);
    runs_->append(1, sampleContactBatch(0.41e-3, 0.5e-3), {}, {sampleSnapshot(0.5e-3)});
    maps_->dataArrived(1);
    QCOMPARE(maps_->time()->value(), 1);
    QCOMPARE(maps_->time()->maximum(), 5);
    maps_->time()->setValue(5); // at the end it follows again
    runs_->append(1, sampleContactBatch(0.51e-3, 0.6e-3), {}, {sampleSnapshot(0.6e-3)});
    maps_->dataArrived(1);
    QCOMPARE(maps_->time()->value(), 6);
}

void TestRunMaps::endsAtTheClosestApproach()
{
    runs_->add(sampleContactRun(1));
    maps_->showRun(1);
    QCOMPARE(maps_->time()->value(), contactSnapshots - 1);
    runs_->finish(1, Summary{});
    maps_->dataArrived(1);
    QCOMPARE(maps_->time()->value(), (contactSnapshots - 1) / 2);
}

void TestRunMaps::goesThroughTheTimes()
{
    runs_->add(sampleContactRun(1));
    maps_->showRun(1);
    const QSignalSpy chosen(maps_.get(), &RunMaps::timeChosen);
    maps_->time()->setFocus();
    QTest::keyClick(maps_->time(), Qt::Key_Home);
    QCOMPARE(chosen.last()[0].toDouble(), 0.0);
    QCOMPARE(shownPressure(31), 0.0);
    QTest::keyClick(maps_->time(), Qt::Key_Right);
    QCOMPARE(maps_->time()->value(), 1);
    maps_->showTime(0.47e-3); // nearest to 0.5 ms, which is the sixth
    QCOMPARE(maps_->time()->value(), 5);
    QVERIFY(maps_->reading()->text().contains(QStringLiteral("6 of 11")));
    QCOMPARE(chosen.count(), 2); // what the program shows is not the user's choice
}

void TestRunMaps::scalesSpanTheRunOrTheTime()
{
    runs_->add(sampleContactRun(1));
    maps_->showRun(1);
    maps_->time()->setValue(3); // d = -1 nm: at most 31 MPa; over the run 155 MPa
    QVERIFY(maps_->sameScale()->isChecked());
    QVERIFY(std::abs(maps_->view()->map()->look().scale.high() - 155e6) < 1.0);
    maps_->sameScale()->setChecked(false);
    QVERIFY(std::abs(maps_->view()->map()->look().scale.high() - 31e6) < 1.0);
}

void TestRunMaps::sectionsShareTheScale()
{
    runs_->add(sampleContactRun(1));
    maps_->showRun(1);
    maps_->time()->setValue(3);
    const auto range = [this] { return maps_->view()->sections()->alongX()->yAxis().range(); };
    QVERIFY(range().contains(0.0) && range().contains(155e6));
    const PlotRange before = range();
    maps_->time()->setValue(5);
    QCOMPARE(range().low, before.low);
    QCOMPARE(range().high, before.high);
    maps_->sameScale()->setChecked(false);
    maps_->time()->setValue(3);
    QTRY_VERIFY(range().high < 60e6);
}

void TestRunMaps::aHiddenPageTakesNothing()
{
    maps_->hide();
    runs_->add(sampleContactRun(1));
    maps_->showRun(1);
    QVERIFY(maps_->view()->map()->empty());
    QCOMPARE(maps_->tabs()->count(), 0);
    maps_->show();
    QCOMPARE(maps_->tabs()->count(), 2);
    QVERIFY(!maps_->view()->map()->empty());
}

void TestRunMaps::saysWhyThereAreNoMaps()
{
    runs_->add(std::make_unique<RunRecord>(1, sampleContactCase(), "", sampleContactQuantities()));
    runs_->finish(1, Summary{});
    maps_->showRun(1);
    QVERIFY(maps_->empty());
    QVERIFY(maps_->emptyText().contains(QStringLiteral("has no maps")));
    runs_->add(std::make_unique<RunRecord>(2, sampleContactCase(), "", sampleContactQuantities(),
                                           std::vector{sampleContactFields()}));
    maps_->showRun(2);
    QVERIFY(maps_->emptyText().contains(QStringLiteral("not ready yet")));
}

void TestRunMaps::thinsWhatMemoryCannotHold()
{
    // 2 fields of 2^20 cells: 16 snapshots fill the 2^25 values; the 17th makes 9 of them, every second one.
    auto run = std::make_unique<RunRecord>(1, sampleContactCase(), "", sampleContactQuantities(),
                                           std::vector{sampleContactFields()});
    const FieldHistory& kept = run->fields.front();
    FieldSnapshot snapshot{0.0, 0, {std::vector<double>(1U << 20U), std::vector<double>(1U << 20U)}};
    for (int i = 0; i < 20; ++i) {
        snapshot.time = i;
        snapshot.values[0][0] = i;
        run->append({}, {}, {snapshot});
        QVERIFY(kept.snapshots.size() <= 16);
    }
    QCOMPARE(kept.stride, std::size_t(2));
    QCOMPARE(kept.arrived, std::size_t(20));
    QCOMPARE(kept.snapshots.size(), std::size_t(10));
    for (std::size_t i = 0; i < kept.snapshots.size(); ++i)
        QCOMPARE(kept.snapshots[i].time, 2.0 * static_cast<double>(i));
    QCOMPARE(kept.ranges[0].high, 19.0); // of those that went, too
    QVERIFY(!saveHdf5(*run, QStringLiteral("nowhere.h5")).isEmpty());
}

void TestRunMaps::aRunThatIsDeletedLeaves()
{
    runs_->add(sampleContactRun(1));
    maps_->showRun(1);
    runs_->remove(0);
    QVERIFY(maps_->empty());
    QCOMPARE(maps_->shownRun(), -1);
}

void TestRunMaps::paintsBothThemes_data()
{
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

void TestRunMaps::paintsBothThemes()
{
    QFETCH(const bool, dark);
    applyTheme(dark ? Theme::Dark : Theme::Light);
    runs_->add(sampleContactRun(1));
    maps_->showRun(1);
    maps_->time()->setValue(5);
    const auto background = [this] {
        const QImage image = maps_->view()->map()->grab().toImage();
        return image.pixelColor(2, image.height() - 2).lightness();
    };
    QTRY_COMPARE(background() < 128, dark);
    const QImage image = maps_->view()->map()->grab().toImage();
    // Pressure rises with the number of the cell: at a quarter of viridis there is blue, at five sixths green. Corners
    // and middle hold marks of the extremes and the sections.
    const FieldMap* map = maps_->view()->map();
    const double ratio = image.devicePixelRatio();
    const auto at = [&](std::size_t cell) {
        return image.pixelColor((map->toPixel(map->centre(cell)) * ratio).toPoint());
    };
    QVERIFY(at(8).blue() > at(8).green());
    QVERIFY(at(26).green() > at(26).blue());
}

void TestRunMaps::controlsHaveNames()
{
    runs_->add(sampleContactRun(1));
    maps_->showRun(1);
    for (const QWidget* widget : maps_->findChildren<QWidget*>()) {
        if (!(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy() || !widget->isVisible()) continue;
        QVERIFY2(!widget->accessibleName().isEmpty() || !widget->property("text").toString().isEmpty(),
                 widget->metaObject()->className());
    }
}

/// Air over the slider, 2 x 1 cells, at 0, 1 .. 4 us; contact over the patch at its rear, 3 x 1 cells, at 0, 2, 4 us.
std::unique_ptr<RunRecord> filmRun()
{
    const Case c = sampleFilmCase();
    const double L = c.slider.length, W = c.slider.width;
    const std::vector<RecordedFields> sets{
        {"fields",
         {{0.0, 0.5 * L, L}, {0.0, W}},
         {{"gap", "m", "nm", "Gap"}, {"air_pressure", "Pa", "kPa", "Pressure of the air"}}},
        {"contact_fields",
         {{0.8e-3, 0.81e-3, 0.82e-3, 0.83e-3}, {0.3e-3, 0.31e-3}},
         {{"gap", "m", "nm", "Gap of the contact"}, {"contact_pressure", "Pa", "MPa", "Contact pressure"}}}};
    auto run = std::make_unique<RunRecord>(1, c, "", sampleContactQuantities(), sets);
    std::vector<FieldSnapshot> snapshots;
    for (int k = 0; k < 5; ++k) {
        const double t = k * 1e-6;
        snapshots.push_back({t, 0, {{100e-9, 10e-9}, {airOf(c.air).pressure, airOf(c.air).pressure + 1e5 * k}}});
        if (k % 2 == 0) snapshots.push_back({t, 1, {{1e-9, 2e-9, 3e-9}, {0.0, 1e6 * k, 2e6 * k}}});
    }
    run->append({}, {}, snapshots);
    return run;
}

void TestRunMaps::showsTheSetsOfAFilm()
{
    runs_->add(filmRun());
    maps_->showRun(1);
    QStringList names;
    for (int i = 0; i < maps_->tabs()->count(); ++i) names << maps_->tabs()->tabText(i);
    QCOMPARE(names, QStringList({"Gap", "Air pressure", "Contact gap", "Contact pressure"}));
    // At the latest time, above ambient.
    QCOMPARE(maps_->tabs()->currentIndex(), 1);
    QCOMPARE(maps_->view()->map()->title(), QStringLiteral("Air pressure above ambient"));
    QCOMPARE(maps_->time()->maximum(), 4);
    QCOMPARE(maps_->time()->value(), 4);
    QVERIFY(std::abs(shownPressure(1) - 4e5) < 1e-6);
    QCOMPARE(maps_->view()->map()->area(), QRectF(0.0, 0.0, 0.85e-3, 0.70e-3));
    maps_->tabs()->setCurrentIndex(3);
    QCOMPARE(maps_->time()->maximum(), 2);
    QCOMPARE(maps_->time()->value(), 2);
    QCOMPARE(shownPressure(2), 8e6);
    QVERIFY(std::abs(maps_->view()->map()->area().x() - 0.8e-3) < 1e-12);
    QCOMPARE(maps_->view()->map()->grid().nx(), 3);
    // A run that has ended stays at its last time: no slider goes back to where it began.
    runs_->finish(1, Summary{});
    maps_->dataArrived(1);
    QCOMPARE(maps_->time()->value(), 2);
}

void TestRunMaps::keepsTheTimeFromSetToSet()
{
    runs_->add(filmRun());
    maps_->showRun(1);
    maps_->time()->setValue(2); // 2 us
    maps_->tabs()->setCurrentIndex(3);
    QCOMPARE(maps_->time()->value(), 1);
    QCOMPARE(shownPressure(1), 2e6);
    maps_->tabs()->setCurrentIndex(0);
    QCOMPARE(maps_->time()->value(), 2);
    QCOMPARE(shownPressure(1), 10e-9);
}

/// The mark of each picture is what the plots have at its time, and the gap at the centre of a cell is the one that the
/// run has recorded there. The last picture is a part of a step later than the last sample.
void TestRunMaps::theLeastGapIsTheMinimumSpacingOfTheTime()
{
    Case c = test::smallSlider(17);
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {1e-9};
    c.diskSurface.waveLengths = {0.2e-3};
    c.initial.state = InitialState::Static;
    c.initial.rollOffset = 2e-6;
    c.run.duration = 20e-6;
    c.run.sampleInterval = 0.01e-6;
    c.run.fieldSnapshots = 4;
    std::unique_ptr<RunRecord> made = performedRecord(c, c.run.duration, [] { return true; });
    const RunRecord& record = *made;
    made->number = 1;
    runs_->add(std::move(made));
    maps_->showRun(1);
    QCOMPARE(maps_->tabs()->tabText(0), QStringLiteral("Gap"));
    maps_->tabs()->setCurrentIndex(0);
    const FieldHistory& history = record.fields[0];
    const MinMaxPyramid& spacing = *record.pyramid("minimum_spacing");
    QVERIFY2(history.snapshots.size() > 2, record.summary->message.c_str());
    for (std::size_t k = 0; k < history.snapshots.size(); ++k) {
        maps_->time()->setValue(static_cast<int>(k));
        const FieldMap& map = *maps_->view()->map();
        const double least = *spacing.valueAt(std::min(history.snapshots[k].time, spacing.lastTime()));
        QVERIFY(*std::ranges::min_element(history.values(k, 0)) > least + 0.05e-9);
        QCOMPARE(map.marks().front(), fieldText(least, map.look()));
        QVERIFY2(maps_->reading()->text().contains(readout(least, "nm", 3)), qPrintable(maps_->reading()->text()));
        if (history.snapshots[k].time > spacing.lastTime()) continue;
        // Between two samples the motion bends by less than 1e-13 m; the start is a sample.
        const double close = k == 0 ? 1e-20 : 1e-12;
        for (std::size_t cell = 0; cell < map.grid().cells(); cell += 7)
            QVERIFY(std::abs(*map.valueAt(map.centre(cell)) - history.values(k, 0)[cell]) < close);
    }
    maps_->tabs()->setCurrentIndex(1); // the pressure has no other numbers than those of its cells
    const FieldMap& map = *maps_->view()->map();
    QCOMPARE(*map.valueAt(map.centre(40)), map.value(40));
}

TOUCHDOWN_TEST(TestRunMaps)

} // namespace test_run_maps

#include "test_run_maps.moc"
