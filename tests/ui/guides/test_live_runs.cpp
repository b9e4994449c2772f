// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/live_runs.h"

#include <algorithm>
#include <vector>

#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "tests/ui/fake_workbench.h"

using namespace touchdown;

namespace test_live_runs {

constexpr int longest = 60000; // for what takes some milliseconds on an idle machine [ms]
const LiveValue height{{"initial.flying_height"}, 100e-9, 400e-9, {}};

class TestLiveRuns : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_live_runs"));
    }
    void init()
    {
        QSettings().clear();
        bench_ = std::make_unique<test::FakeWorkbench>();
        live_ = std::make_unique<LiveRuns>(*bench_, nullptr);
    }
    void cleanup()
    {
        live_.reset();
        bench_.reset();
    }

    /// One run of the list while the reader moves, with the newest value; an ordinary run at last.
    void runsAtEachMovement()
    {
        QSignalSpy shown(live_.get(), &LiveRuns::shown);
        live_->move(height, "300 nm");
        QVERIFY(shown.wait(longest));
        QCOMPARE(bench_->runs().count(), 1);
        QVERIFY(!bench_->controller().active());
        QCOMPARE(bench_->runs().record(0).value.initial.flyingHeight, 300e-9);
        QVERIFY(sameAsARun(bench_->runs().record(0)));
        // Faster than the runs: the last value is always shown in the end.
        for (int i = 50; i >= 0; --i) live_->move(height, std::to_string(350 - i) + " nm");
        QTRY_VERIFY_WITH_TIMEOUT(!live_->busy() && bench_->runs().count() == 1 &&
                                     bench_->runs().record(0).value.initial.flyingHeight == 350e-9,
                                 longest);
        QVERIFY(shown.count() < 40);
        QCOMPARE(bench_->runs().record(0).number, 1);

        QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        live_->settle();
        QVERIFY(!ended.isEmpty() || ended.wait(longest));
        QCOMPARE(bench_->runs().count(), 1);
        QCOMPARE(bench_->runs().record(0).number, 1);
        QCOMPARE(bench_->runs().record(0).caseText, bench_->files().wholeText());
        QVERIFY(sameAsARun(bench_->runs().record(0)));

        // The next movement leaves that run, and undo takes a movement back as one.
        live_->move(height, "200 nm");
        live_->move(height, "210 nm");
        QTRY_VERIFY_WITH_TIMEOUT(!live_->busy() && bench_->runs().count() == 2, longest);
        bench_->edits().undoStack().undo();
        QCOMPARE(bench_->edits().value().initial.flyingHeight, 350e-9);
        bench_->edits().undoStack().undo();
        QCOMPARE(bench_->edits().value().initial.flyingHeight, 250e-9);
    }

    /// Where the plots show the beginning alone, a movement computes no more; when the reader lets go, the whole run.
    void computesWhatIsShown()
    {
        const Case& c = bench_->edits().value();
        RunView& view = bench_->runView();
        QCOMPARE(neededUntil(view, c), c.run.duration); // of the spectrum
        PlotStage stage;
        stage.plots << "spacing";
        stage.time = PlotRange{0.0, 0.25e-3};
        view.setStage(stage);
        QCOMPARE(neededUntil(view, c), 0.25e-3);

        live_->move(height, "300 nm");
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 1, longest);
        const RunRecord& part = bench_->runs().record(0);
        QCOMPARE(part.lastTime(), 0.25e-3);
        QCOMPARE(part.note, QString("first 250.0\u00a0µs"));
        const std::vector<double> shown = spacingOf(part);
        QCOMPARE(part.value, c);
        QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        live_->settle();
        QVERIFY(!ended.isEmpty() || ended.wait(longest));
        QCOMPARE(bench_->runs().count(), 1);
        const RunRecord& whole = bench_->runs().record(0);
        QCOMPARE(whole.lastTime(), c.run.duration);
        QVERIFY(whole.note.isEmpty() && sameAsARun(whole));
        const std::vector<double> all = spacingOf(whole);
        QVERIFY(shown.size() > 2000 && all.size() > shown.size());
        QVERIFY(std::equal(shown.begin(), shown.end() - 1, all.begin()));

        // Whatever needs the rest.
        view.fit();
        QCOMPARE(neededUntil(view, c), c.run.duration);
        stage.time = PlotRange{0.0, 0.1e-3};
        view.setStage(stage);
        QCOMPARE(neededUntil(view, c), 0.1e-3);
        stage.spectrum = true;
        view.setStage(stage);
        QCOMPARE(neededUntil(view, c), c.run.duration);
        stage.spectrum = false;
        stage.time = PlotRange{0.0, 1.0};
        view.setStage(stage);
        QCOMPARE(neededUntil(view, c), c.run.duration);
    }

    void settlesWhileARunIsUnderWay()
    {
        QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        live_->move(height, "300 nm");
        live_->move(height, "310 nm");
        live_->settle();
        QVERIFY(!ended.isEmpty() || ended.wait(longest));
        QCOMPARE(bench_->runs().count(), 1);
        QCOMPARE(bench_->runs().record(0).value.initial.flyingHeight, 310e-9);
        live_->settle(); // nothing has moved
        QVERIFY(!bench_->controller().active());
    }

    /// A run that the user removed, or started meanwhile, is not replaced.
    void leavesOtherRunsAlone()
    {
        live_->move(height, "300 nm");
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 1, longest);
        bench_->runs().remove(0);
        live_->move(height, "310 nm");
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 1, longest);
        QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        bench_->startRun();
        QVERIFY(!ended.isEmpty() || ended.wait(longest));
        QCOMPARE(bench_->runs().count(), 2);
        live_->move(height, "320 nm");
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().record(1).value.initial.flyingHeight, 320e-9, longest);
        QCOMPARE(bench_->runs().count(), 2);
        QCOMPARE(bench_->runs().record(0).value.initial.flyingHeight, 310e-9);
    }

    void movesValuesTogether()
    {
        const LiveValue damping{{"springs.front_damping_ratio", "springs.rear_damping_ratio"}, 0.001, 0.1, {}};
        live_->move(damping, "0.05");
        QCOMPARE(bench_->edits().value().springs.frontDampingRatio, 0.05);
        QCOMPARE(bench_->edits().value().springs.rearDampingRatio, 0.05);
        live_->move(damping, "-1"); // out of range
        QCOMPARE(bench_->edits().value().springs.frontDampingRatio, 0.05);
    }

    void coarserGrid()
    {
        const Case fine = openCase("fig05_fm_3_62mN").value;
        QCOMPARE(fine.film.nodes, (std::array{257, 257}));
        const Case coarse = coarser(fine);
        QCOMPARE(coarse.film.nodes, (std::array{129, 129}));
        QVERIFY(checkCombinations(coarse).empty());
        const Case rough = coarser(openCase("fig02_case_2_moving").value);
        QCOMPARE(rough.film.nodes, (std::array{49, 49}));
        QCOMPARE(rough.elastic.cell, 2e-6);
        QCOMPARE(rough.diskSurface.cell, 2e-6);
        Case coarsest = fine;
        coarsest.film.nodes = {17, 33};
        QCOMPARE(coarser(coarsest).film.nodes, (std::array{17, 17}));
    }

    /// First on the coarse grid, then on its own; the coarse run makes room.
    void aFilmRunsWhenTheReaderLetsGo()
    {
        bench_->files().openNow("film_plane");
        Case c = bench_->edits().value();
        c.run.duration = 2e-6;
        bench_->edits().setAll(c, "short");
        const LiveValue start{{"initial.nominal_trailing_edge_height"}, 1e-9, 1e-6, {}};
        Case moved = c;
        moved.initial.nominalTrailingEdgeHeight *= 1.02;
        const std::string text = toText(moved, *findParameter(start.keys[0]));
        QVERIFY(!setFromText(moved, *findParameter(start.keys[0]), text));
        std::vector<std::array<int, 2>> grids;
        connect(&bench_->runs(), &RunsModel::added, this,
                [this, &grids](int number) { grids.push_back(bench_->runs().find(number)->value.film.nodes); });
        live_->move(start, text);
        QVERIFY(!bench_->controller().active() && !live_->busy());
        live_->settle();
        QTRY_VERIFY_WITH_TIMEOUT(grids.size() == 2 && !bench_->controller().active(), longest);
        QCOMPARE(grids[0], coarser(c).film.nodes);
        QCOMPARE(grids[1], c.film.nodes);
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 1, longest);
        QCOMPARE(bench_->runs().record(0).value.film.nodes, c.film.nodes);
        QCOMPARE(bench_->runs().record(0).value, moved);
        QCOMPARE(bench_->runs().record(0).caseText, bench_->files().wholeText());
    }

    /// Another case is open: the finer run of the film does not come, nor a run of springs.
    void endsWithItsCase()
    {
        bench_->files().openNow("film_plane");
        Case c = bench_->edits().value();
        c.run.duration = 2e-6;
        bench_->edits().setAll(c, "short");
        QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        live_->move({{"initial.nominal_trailing_edge_height"}, 1e-9, 1e-6, {}}, "345 nm");
        live_->settle();
        bench_->files().leaveUnsaved();
        bench_->files().openNow("fig10a");
        QVERIFY(!ended.isEmpty() || ended.wait(longest));
        QCOMPARE(bench_->runs().count(), 1); // the coarse one
        // What the end of the coarse run may have asked for.
        QCoreApplication::processEvents();
        QVERIFY(!bench_->controller().active());
        live_->move(height, "300 nm");
        bench_->files().leaveUnsaved();
        bench_->files().openNow("fig12a");
        QVERIFY(!live_->busy());
        live_->move(height, "310 nm");
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 2, longest);
        QCOMPARE(bench_->runs().record(1).value.title, openCase("fig12a").value.title);
    }

    /// A movement that begins before the last run of the one before is there loses nothing.
    void movementsFollowEachOther()
    {
        QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        live_->move(height, "300 nm");
        live_->settle();
        live_->move(height, "320 nm");
        live_->settle();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, longest);
        QCOMPARE(bench_->runs().count(), 2);
        QCOMPARE(bench_->runs().record(0).value.initial.flyingHeight, 300e-9);
        QCOMPARE(bench_->runs().record(1).value.initial.flyingHeight, 320e-9);
    }

    /// A run that takes long waits until the reader lets go, and is then an ordinary one.
    void aLongRunWaits()
    {
        Case c = bench_->edits().value();
        c.run.duration = 1.0;
        c.run.sampleInterval = 1e-6;
        bench_->edits().setAll(c, "long");
        live_->move(height, "300 nm");
        QTRY_VERIFY_WITH_TIMEOUT(!live_->busy(), longest);
        live_->move(height, "310 nm");
        QVERIFY(!live_->busy());
        QCOMPARE(bench_->runs().count(), 0);
        live_->settle();
        QVERIFY(bench_->controller().active());
        bench_->controller().stopAndWait();
        QCOMPARE(bench_->runs().record(0).value.initial.flyingHeight, 310e-9);
    }

    /// Its run comes after the reader began another movement, and has its own value.
    void aLongRunHasTheValueOfItsMovement()
    {
        Case c = bench_->edits().value();
        c.run.duration = 1.0;
        c.run.sampleInterval = 1e-6;
        bench_->edits().setAll(c, "long");
        live_->move(height, "300 nm");
        live_->settle();
        live_->move(height, "320 nm");
        QTRY_VERIFY_WITH_TIMEOUT(bench_->controller().active(), longest);
        QCOMPARE(bench_->runs().count(), 1);
        QCOMPARE(bench_->runs().record(0).value.initial.flyingHeight, 300e-9);
        QTRY_VERIFY_WITH_TIMEOUT(!live_->busy(), longest);
        bench_->controller().stopAndWait();
    }

    /// A linear film finds its state when the reader lets go; the next movement does not wait for it, and another case
    /// ends it.
    void nobodyWaitsForAState()
    {
        bench_->files().openNow("film_pico");
        Case c = bench_->edits().value();
        c.film.nodes = {49, 49};
        c.film.motion = FilmMotion::Linear;
        c.initial.state = InitialState::Static;
        c.run.duration = 5e-6;
        c.suspension.preload *= 1.003; // no other test has its state
        bench_->edits().setAll(c, "linear");
        const LiveValue load{{"suspension.preload"}, 1e-3, 1e-1, {}};
        const auto text = [&](double share) {
            Case moved = c;
            moved.suspension.preload *= share;
            return toText(moved, *findParameter("suspension.preload"));
        };
        live_->move(load, text(1.0001));
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 1, longest);
        live_->settle();
        QTRY_VERIFY_WITH_TIMEOUT(!live_->busy(), longest);
        QVERIFY(bench_->runs().record(0).note.isEmpty());
        live_->move(load, text(1.0002));
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 2, longest);
        QCOMPARE(bench_->runs().record(1).note, QString("preview"));
        live_->settle();
        QVERIFY(live_->finds());
        live_->move(load, text(1.0003)); // leaves the one before, and its preview
        QVERIFY(!live_->finds());
        QCOMPARE(bench_->runs().count(), 1);
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 2, longest);
        QCOMPARE(bench_->runs().record(1).note, QString("preview"));
        live_->settle();
        QVERIFY(live_->finds());
        bench_->files().leaveUnsaved();
        bench_->files().openNow("fig10a");
        QVERIFY(!live_->finds() && !live_->busy());
        QCOMPARE(bench_->runs().count(), 1);
        live_->move(height, "300 nm"); // it comes after the one that was left
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 2, longest);
        QCOMPARE(bench_->runs().record(1).value.title, openCase("fig10a").value.title);
    }

    /// A run under way goes on; the live one is announced after it.
    void leavesTheActiveRunAlone()
    {
        Case c = bench_->edits().value();
        c.run.duration = 0.2;
        bench_->edits().setAll(c, "long");
        bench_->startRun();
        bench_->controller().pause(); // it does not end before the live one
        c.run.duration = 1e-3;
        bench_->edits().setAll(c, "short");
        live_->move(height, "300 nm");
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 2, longest);
        QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        live_->settle();
        QVERIFY(bench_->controller().active());
        QCOMPARE(ended.count(), 0);
        bench_->controller().stopAndWait();
        QCOMPARE(ended.count(), 2);
        QCOMPARE(ended[0][0].toInt(), 1);
        QCOMPARE(ended[1][0].toInt(), 2);
    }

private:
    static std::vector<double> spacingOf(const RunRecord& record)
    {
        const auto column = std::size_t(findQuantity(record.quantities, "minimum_spacing"));
        std::vector<double> held;
        for (std::size_t part = 0; part < record.parts(); ++part) {
            const std::vector<double> piece = record.samples(part).columns[column];
            held.insert(held.end(), piece.begin(), piece.end());
        }
        return held;
    }
    /// As the core runs the case.
    static bool sameAsARun(const RunRecord& record)
    {
        std::vector<double> spacing;
        const auto column = std::size_t(findQuantity(record.quantities, "minimum_spacing"));
        const Summary summary = touchdown::run(record.value, [&](const RunUpdate& update) {
            const std::vector<double>& added = update.samples.columns[column];
            spacing.insert(spacing.end(), added.begin(), added.end());
            return true;
        });
        const std::vector<double> held = spacingOf(record);
        return !held.empty() && held == spacing && record.events.size() == summary.events.size();
    }

    std::unique_ptr<test::FakeWorkbench> bench_;
    std::unique_ptr<LiveRuns> live_;
};

TOUCHDOWN_TEST(TestLiveRuns)

} // namespace test_live_runs

#include "test_live_runs.moc"
