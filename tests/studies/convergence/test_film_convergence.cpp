// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/film_convergence.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <thread>

#include <QTest>

#include "core/simulation/static_state/steady.h"
#include "tests/support/sample_case.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_convergence {

/// States the net force 1 N + factor (nodes - 1)^-order N, and half of that error.
FilmMethod known(const std::string& name, double factor, double order)
{
    return {name, [=](const Case& slider, int nodes, const GoOn&) {
                const double error = slider.slider.mass * factor * std::pow(nodes - 1.0, -order);
                FilmState state;
                state.netForce = 1.0 + error;
                state.minimumSpacing = 5e-9 + error;
                state.statedError = 0.5 * error;
                state.seconds = 1e-6 * nodes * nodes;
                return state;
            }};
}

/// The mass stands for how large the errors of a slider are.
Case ofSize(double size)
{
    Case c = test::smallSlider();
    c.slider.mass = size;
    return c;
}

FilmConvergenceTask knownTask()
{
    return {.sliders = {ofSize(1.0), ofSize(3.0), ofSize(2.0)},
            .fixedAttitude = true,
            .methods = {known("second", 1.0, 2.0), known("first", 1.0, 1.0)},
            .grids = {17, 33, 65},
            .reference = 1025};
}

class TestFilmConvergence : public QObject {
    Q_OBJECT

private slots:
    void errors()
    {
        const FilmConvergenceTask task = knownTask();
        const FilmConvergence study = performFilmConvergence(task, 2, {});
        QCOMPARE(study.status, StudyStatus::Completed);
        QCOMPARE(study.runs.size(), std::size_t{3 * 2 * 3});
        const FilmRun& run = study.runs[6 + 3]; // of the second slider by the second method, the coarsest grid
        QCOMPARE(run.slider, std::size_t{1});
        QCOMPARE(run.method, std::size_t{1});
        QCOMPARE(run.nodes, 17);
        const double reference = 3.0 / (1024.0 * 1024.0);
        QVERIFY(std::abs(*run.error - (3.0 / 16.0 - reference)) < 1e-14);
        QVERIFY(std::abs(*run.ratio() - 0.5 * (3.0 / 16.0) / *run.error) < 1e-12);
        // The reference differs from the first method's finest run.
        QVERIFY(std::abs(*study.uncertainty[1] - (3.0 / (64.0 * 64.0) - reference)) < 1e-14);
    }
    /// Of the flying slider the minimum spacing counts.
    void flying()
    {
        FilmConvergenceTask task = knownTask();
        task.fixedAttitude = false;
        FilmState state;
        state.netForce = 1.0;
        state.minimumSpacing = 2.0;
        QCOMPARE(resultOf(task, state), 2.0);
        task.fixedAttitude = true;
        QCOMPARE(resultOf(task, state), 1.0);
    }
    void summaries()
    {
        const FilmConvergenceTask task = knownTask();
        const std::vector<FilmGridSummary> all = summarize(task, performFilmConvergence(task, 1, {}));
        QCOMPARE(all.size(), std::size_t{2 * 3});
        const FilmGridSummary& coarse = all[3]; // first order, 17 lines: 1/16, 3/16 and 2/16
        QCOMPARE(coarse.solved, std::size_t{3});
        QVERIFY(std::abs(coarse.median - 2.0 / 16.0) < 1e-5);
        QVERIFY(std::abs(coarse.worst - 3.0 / 16.0) < 1e-5);
        QCOMPARE(coarse.stated, std::size_t{3});
        QCOMPARE(coarse.held, std::size_t{0}); // a half is less than two thirds
        QVERIFY(std::abs(*coarse.leastRatio - 0.5) < 1e-3 && *coarse.medianRatio >= *coarse.leastRatio);
        QCOMPARE(coarse.seconds, 289e-6);
    }
    /// The reference distorts it by the share of its own error: below (64/1024)^p.
    void orders()
    {
        const FilmConvergenceTask task = knownTask();
        const std::vector<FilmGridSummary> all = summarize(task, performFilmConvergence(task, 1, {}));
        QVERIFY(std::abs(*observedFilmOrder(task, all, 0) - 2.0) < 0.01);
        QVERIFY(std::abs(*observedFilmOrder(task, all, 1) - 1.0) < 0.01);
        FilmConvergenceTask coarse = task;
        coarse.reference = 97; // a third of its cells: 32, so that one grid is left
        QVERIFY(!observedFilmOrder(coarse, all, 0));
    }
    void aRunWithoutSolution()
    {
        FilmConvergenceTask task = knownTask();
        const FilmMethod good = task.methods[1];
        task.methods[1].solve = [good](const Case& slider, int nodes, const GoOn& goOn) {
            FilmState state = good.solve(slider, nodes, goOn);
            if (nodes == 17) state.problem = "too coarse";
            return state;
        };
        const FilmConvergence study = performFilmConvergence(task, 1, {});
        QCOMPARE(study.status, StudyStatus::Completed);
        QVERIFY(!study.runs[3].error && study.runs[4].error);
        QCOMPARE(summarize(task, study).size(), std::size_t{2 * 3 - 1});
    }
    void noReference()
    {
        FilmConvergenceTask task = knownTask();
        task.methods.front().solve = [](const Case&, int, const GoOn&) {
            FilmState state;
            state.problem = "it sinks";
            return state;
        };
        const FilmConvergence study = performFilmConvergence(task, 1, {});
        QCOMPARE(study.status, StudyStatus::Failed);
        QCOMPARE(study.message, std::string("the reference has no solution: it sinks"));
        QVERIFY(!study.uncertainty.front());
    }
    /// At a pace that nobody knows before the first solution has ended; then its cost is the share.
    void theFirstSolutionTellsThePace()
    {
        FilmConvergenceTask task = knownTask();
        task.sliders.resize(1);
        std::atomic<int> polls = 0;
        const auto solve = task.methods.front().solve;
        task.methods.front().solve = [&](const Case& slider, int nodes, const GoOn& goOn) {
            while (nodes == task.reference && polls < 3 && goOn()) std::this_thread::yield();
            return solve(slider, nodes, goOn);
        };
        double before = 0.0, after = 0.0; // the first solution ends
        performFilmConvergence(task, 1, [&](const StudyProgress& progress) {
            ++polls;
            if (progress.doing.starts_with("0 of 1"))
                before = std::max(before, progress.share);
            else if (after == 0.0)
                after = progress.share;
            return true;
        });
        QVERIFY(polls > 3);
        QCOMPARE(before, 0.0);
        const double reference = 1025.0 * 1025.0, all = reference + 2.0 * (17.0 * 17.0 + 33.0 * 33.0 + 65.0 * 65.0);
        // The first grid may be under way by then.
        QVERIFY2(after * all > reference - 1e-3 && after * all < reference + 17.0 * 17.0,
                 std::to_string(after).c_str());
    }
    void stops()
    {
        const FilmConvergenceTask task = knownTask();
        const FilmConvergence study = performFilmConvergence(task, 1, [](const StudyProgress&) { return false; });
        QCOMPARE(study.status, StudyStatus::Cancelled);
        QVERIFY(!study.message.empty());
        double last = 0.0;
        performFilmConvergence(task, 1, [&](const StudyProgress& progress) {
            if (progress.share < last || progress.share > 1.0) last = NAN;
            last = progress.share;
            return true;
        });
        QVERIFY(last > 0.9);
    }

    /// As `touchdown steady` computes it.
    void steadyStates()
    {
        Case c = test::smallSlider(33);
        c.steady.fixedAttitude = true;
        const FilmState state = steadyMethod("upwind", {{"film.scheme", "upwind"}}).solve(c, 49, {});
        QCOMPARE(state.problem, std::string());
        c.film.nodes = {49, 49};
        c.film.scheme = ConvectionScheme::Upwind;
        const SteadyResult result = steady(c);
        QCOMPARE(state.netForce, result.forces.net);
        QCOMPARE(state.minimumSpacing, result.minimumSpacing);
        QCOMPARE(*state.statedError, result.discretisationError.load);
        QVERIFY(steadyMethod("wrong", {{"film.scheme", "none"}}).solve(c, 49, {}).problem.starts_with("film.scheme"));
    }
};

TOUCHDOWN_TEST(TestFilmConvergence)

} // namespace test_film_convergence

#include "test_film_convergence.moc"
