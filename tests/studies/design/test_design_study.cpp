// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/design/design_study.h"

#include <QtTest>

#include "core/studies/design/design.h"
#include "core/studies/study_plan.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_design_study {

class TestDesignStudy : public QObject {
    Q_OBJECT

private slots:
    void report()
    {
        DesignTask task;
        task.parameters = {
            {.keys = {Parameter{.key = "suspension.preload", .unit = "N", .displayUnit = "mN"}}, .start = 0.02}};
        task.targets = {{{"pitch", "rad", "urad", "Pitch, leading edge up"}, 150e-6, 1e-6}};
        DesignStudy study;
        study.status = StudyStatus::Completed;
        study.solves = 4;
        study.steps = {{0, {0.02}, {140e-6}, 10.0, ""}, {1, {0.025}, {150.5e-6}, 0.5, ""}};
        study.state.discretisationError.pitch = 2e-6;
        study.found.suspension.preload = 0.025;
        const StudyReport report = designReport(task, study);
        QCOMPARE(report.status, StudyStatus::Completed);
        QCOMPARE(report.findings,
                 (std::vector<std::string>{
                     "All targets are reached after 4 static states.", "suspension.preload: 25 mN, from 20 mN.",
                     "pitch: 150.5 urad (grid error about 2 urad), wanted 150 urad within 1 urad."}));
        QCOMPARE(report.warnings.size(), std::size_t{1}); // the error of the grid is larger than the tolerance
        QVERIFY(report.warnings[0].starts_with("pitch is compared with its target on this grid: the error of the grid, "
                                               "about 2 urad, is larger than the tolerance of 1 urad."));
        QVERIFY(report.found && report.found->suspension.preload == 0.025);
        QCOMPARE(report.tables.at(0).columns.at(1).name, std::string("suspension.preload"));
        QCOMPARE(report.tables.at(0).rows.at(1), (std::vector<StudyValue>{1.0, 0.025, 150.5e-6, 0.5}));
        QCOMPARE(report.tables.at(1).rows.at(0),
                 (std::vector<StudyValue>{std::string("pitch"), std::string("rad"), 150e-6, 1e-6, 150.5e-6, 2e-6}));
        QCOMPARE(report.charts.at(0).panels.at(0).series.at(0).points.size(), std::size_t{2});
        study.status = StudyStatus::Failed;
        QVERIFY(!designReport(task, study).found);
    }
    /// A start without a static state has neither quantities nor a misfit.
    void noState()
    {
        DesignTask task;
        task.parameters = {
            {.keys = {Parameter{.key = "suspension.preload", .unit = "N", .displayUnit = "mN"}}, .start = 0.02}};
        task.targets = {{{"pitch", "rad", "urad", ""}, 150e-6, 1e-6}};
        DesignStudy study;
        study.steps = {{0, {0.02}, {}, 0.0, "not converged"}};
        const StudyReport report = designReport(task, study);
        QCOMPARE(report.tables.at(0).rows.at(0), (std::vector<StudyValue>{0.0, 0.02, {}, {}}));
        QVERIFY(report.charts.at(0).panels.at(0).series.at(0).points.empty());
    }
    /// At the height that a held plane has, the film carries what it carried.
    void performs()
    {
        const StudyPlan plan = openStudy("design", "film_plane", {"film.nodes=33, 33"});
        QVERIFY(plan.valid());
        double share = -1.0;
        const StudyReport report = plan.perform(1, [&](const StudyProgress& progress) {
            share = progress.share;
            return true;
        });
        QVERIFY(report.status != StudyStatus::Cancelled);
        QVERIFY(share >= 0.0 && share <= 1.0);
        QCOMPARE(report.kind, std::string("design"));
        QCOMPARE(plan.perform(1, [](const StudyProgress&) { return false; }).status, StudyStatus::Cancelled);
    }
};

TOUCHDOWN_TEST(TestDesignStudy)

} // namespace test_design_study

#include "test_design_study.moc"
