// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/film_convergence_report.h"

#include <cmath>

#include <QTest>

#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_convergence_report {

FilmState stateOf(double force, std::optional<double> stated)
{
    FilmState state;
    state.netForce = force;
    state.minimumSpacing = 5e-9;
    state.pitch = 1e-4;
    state.statedError = stated;
    state.seconds = 0.5;
    return state;
}

/// Each slider has the reference 10 mN and the errors 0.4 and 0.1 mN by "ours", 2 mN and none by "theirs".
FilmConvergenceTask someTask(int sliders)
{
    FilmConvergenceTask task{.sliders = {},
                             .fixedAttitude = true,
                             .methods = {{"ours", {}}, {"theirs", {}}},
                             .grids = {49, 65},
                             .reference = 129};
    for (int i = 0; i < sliders; ++i) {
        task.sliders.push_back(test::smallSlider(65));
        task.sliders.back().title = "slider " + std::to_string(i + 1);
    }
    return task;
}
FilmConvergence someStudy(const FilmConvergenceTask& task)
{
    FilmConvergence study;
    for (std::size_t s = 0; s < task.sliders.size(); ++s) {
        study.references.push_back(stateOf(10e-3, 0.02e-3));
        study.uncertainty.emplace_back(0.1e-3);
        study.runs.push_back({s, 0, 49, stateOf(10.4e-3, 0.2e-3), 0.4e-3}); // too small by half
        study.runs.push_back({s, 0, 65, stateOf(9.9e-3, 0.3e-3), 0.1e-3});
        study.runs.push_back({s, 1, 49, stateOf(12e-3, {}), 2e-3});
        study.runs.push_back({s, 1, 65, stateOf(0.0, {}), {}});
        study.runs.back().state.problem = "no solution";
    }
    return study;
}

StudyReport someReport(int sliders)
{
    const FilmConvergenceTask task = someTask(sliders);
    return filmConvergenceReport(task, someStudy(task));
}

class TestFilmConvergenceReport : public QObject {
    Q_OBJECT

private slots:
    void tables()
    {
        const StudyReport report = someReport(1);
        const StudyTable& runs = report.tables.at(0);
        QCOMPARE(runs.rows.size(), std::size_t{4});
        for (const StudyTable& table : report.tables)
            for (const auto& row : table.rows) QCOMPARE(row.size(), table.columns.size());
        QCOMPARE(runs.columns.at(7).name, std::string("error"));
        QCOMPARE(runs.columns.at(7).unit, std::string("N"));
        QCOMPARE(runs.rows.at(0).at(2), StudyValue(49.0));
        QCOMPARE(runs.rows.at(0).at(7), StudyValue(0.4e-3));
        QCOMPARE(runs.rows.at(0).at(9), StudyValue(0.5));
        QCOMPARE(runs.rows.at(2).at(8), StudyValue()); // states none
        QCOMPARE(runs.rows.at(3).at(3), StudyValue()); // no force
        QCOMPARE(runs.rows.at(3).back(), StudyValue(std::string("no solution")));
        const StudyTable& summary = report.tables.at(1);
        QCOMPARE(summary.rows.size(), std::size_t{3}); // the last one has no error
        QCOMPARE(summary.rows.at(0).at(7), StudyValue(0.0));
        QCOMPARE(summary.rows.at(1).at(7), StudyValue(1.0));
        QCOMPARE(report.tables.at(2).rows.at(0).at(6), StudyValue(0.1e-3));
    }
    void flyingSlider()
    {
        FilmConvergenceTask task = someTask(1);
        task.fixedAttitude = false;
        const StudyReport report = filmConvergenceReport(task, someStudy(task));
        QCOMPARE(report.tables.at(0).columns.at(7).displayUnit, std::string("nm"));
    }
    void findings()
    {
        const StudyReport report = someReport(1);
        QCOMPARE(report.findings.size(), std::size_t{4});
        QCOMPARE(report.findings.at(0), std::string("Ours: no observed order; with 65 lines the error of the net force "
                                                    "is 0.1 mN, in 500 ms."));
        QCOMPARE(report.findings.at(1), std::string("Theirs: no observed order."));
        QCOMPARE(report.findings.at(2),
                 std::string("Stated errors, ours: 1 of 2 are at least two thirds of the error found; the least is 0.5 "
                             "times the error found (49 lines)."));
        QVERIFY2(report.findings.at(3).starts_with("Errors are distances from ours with 129 lines. The reference "
                                                   "differs from the result with 65 lines by 0.1 mN;"),
                 report.findings.at(3).c_str());
        QCOMPARE(report.warnings.size(), std::size_t{1});
        QVERIFY2(report.warnings.at(0).starts_with("1 run has no solution"), report.warnings.at(0).c_str());
    }
    void severalSliders()
    {
        const StudyReport report = someReport(3);
        QCOMPARE(report.title, std::string("Static films of 3 sliders over their grids"));
        QVERIFY2(report.findings.at(0).find("0.1 mN in the median and 0.1 mN at most over 3 sliders") !=
                     std::string::npos,
                 report.findings.at(0).c_str());
        QVERIFY2(report.findings.at(2).find("(slider 1, 49 lines)") != std::string::npos,
                 report.findings.at(2).c_str());
        QVERIFY2(report.warnings.at(0).starts_with("3 runs have no solution"), report.warnings.at(0).c_str());
    }
    void charts()
    {
        for (const int sliders : {1, 2}) {
            const StudyReport report = someReport(sliders);
            // Of several sliders the median and the largest error.
            QCOMPARE(report.charts.size(), static_cast<std::size_t>(sliders == 1 ? 2 : 3));
            const StudyChart& errors = report.charts.at(0);
            QCOMPARE(errors.panels.size(), std::size_t{2});
            QCOMPARE(errors.panels.at(0).series.size(), std::size_t{2});
            const ChartSeries& ours = errors.panels.at(1).series.at(0);
            QCOMPARE(ours.points.at(0).x, 49.0);
            QCOMPARE(ours.points.at(0).y, 0.4e-3);
            QVERIFY(!ours.points.at(0).chosen && ours.points.at(1).chosen); // the grid of the case
            QCOMPARE(errors.panels.at(0).bands.at(0).upper, 0.1e-3);
            for (const StudyChart& chart : report.charts)
                for (const ChartPanel& panel : chart.panels)
                    for (const ChartSeries& series : panel.series)
                        for (const ChartPoint& point : series.points) QVERIFY(point.x > 0.0 && point.y > 0.0);
        }
    }
    /// A study that was stopped, or found nothing, keeps its tables.
    void withoutErrors()
    {
        const FilmConvergenceTask task = someTask(1);
        FilmConvergence study = someStudy(task);
        study.status = StudyStatus::Cancelled;
        study.message = "stopped";
        for (FilmRun& run : study.runs) run.error.reset();
        study.uncertainty.front().reset();
        const StudyReport report = filmConvergenceReport(task, study);
        QCOMPARE(report.message, std::string("stopped"));
        QCOMPARE(report.tables.size(), std::size_t{3});
        QVERIFY(report.charts.empty() && report.findings.empty());
    }
};

TOUCHDOWN_TEST(TestFilmConvergenceReport)

} // namespace test_film_convergence_report

#include "test_film_convergence_report.moc"
