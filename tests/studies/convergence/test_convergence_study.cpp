// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/convergence.h"

#include <cmath>

#include <QtTest>

#include "core/studies/study_plan.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_convergence_study {

ConvergenceStudy someStudy()
{
    ConvergenceStudy study;
    study.separation = -1e-9;
    study.quantities = {{"contact_force", "N", "mN", "Real contact force"}, {"contact_area", "m^2", "um^2", "Area"}};
    for (int i = 0; i < 3; ++i) study.levels.push_back({4e-6 / (1 << i), 100 << i, {1e-3 + i, 1e-12 * i}, 7, 0.25, ""});
    study.observed = {{2.0, 3e-3, 1e-5}, {{}, 2e-12, 1e-12}};
    return study;
}

class TestConvergenceStudy : public QObject {
    Q_OBJECT

private slots:
    void report()
    {
        const StudyReport report = convergenceReport(someStudy());
        const StudyTable& levels = report.tables.at(0);
        QCOMPARE(levels.columns.at(3).name, std::string("contact_force"));
        QCOMPARE(levels.columns.at(4).unit, std::string("m^2"));
        QCOMPARE(levels.rows.size(), std::size_t{3});
        QCOMPARE(levels.rows.at(0), (std::vector<StudyValue>{4e-6, 100.0, 0.25, 1e-3, 0.0, 7.0}));
        const StudyTable& observed = report.tables.at(1);
        QCOMPARE(observed.rows.at(0),
                 (std::vector<StudyValue>{std::string("contact_force"), 2.0, 3e-3, 1e-5, std::string("N")}));
        QVERIFY(std::holds_alternative<std::monostate>(observed.rows.at(1).at(1))); // no order
        QCOMPARE(report.findings.size(), std::size_t{3});
        QVERIFY2(report.findings.at(1).starts_with("Real contact force: observed order 2, limit 3 mN; "),
                 report.findings.at(1).c_str());
        QVERIFY2(report.findings.at(2).starts_with("Area: no observed order; "), report.findings.at(2).c_str());
        const ChartSeries& force = report.charts.at(0).panels.at(0).series.at(0);
        QVERIFY(force.points.at(1).chosen && !force.points.at(2).chosen); // the cells of the case
        for (const ChartPoint& point : force.points) QVERIFY(point.x > 0.0 && point.y > 0.0);
    }
    /// The levels that were solved stay in the table.
    void failed()
    {
        ConvergenceStudy study = someStudy();
        study.status = StudyStatus::Failed;
        study.observed.clear();
        study.levels.back().problem = "not solved";
        const StudyReport report = convergenceReport(study);
        QCOMPARE(report.tables.size(), std::size_t{1});
        QCOMPARE(report.tables.at(0).rows.size(), std::size_t{2});
        QVERIFY(report.charts.empty());
    }
    void performs()
    {
        const StudyPlan plan = openStudy("convergence", "contact_hertz", {}, {"levels=3"});
        QVERIFY(plan.valid());
        const StudyReport report = plan.perform(2, {});
        QCOMPARE(report.status, StudyStatus::Completed);
        QCOMPARE(report.tables.at(0).rows.size(), std::size_t{3});
        QCOMPARE(plan.perform(1, [](const StudyProgress&) { return false; }).status, StudyStatus::Cancelled);
    }
    void refuses()
    {
        const auto said = [](const char* name, const std::vector<std::string>& options = {}) {
            const StudyPlan plan = openStudy("convergence", name, {}, options);
            return plan.valid() ? std::string() : plan.problems.front().text();
        };
        QVERIFY2(said("fig10a").starts_with("fig10a: case: is of model \"springs\""), said("fig10a").c_str());
        QCOMPARE(said("contact_hertz", {"levels=1"}),
                 std::string("--option: levels: must be a whole number from 3 to 6"));
    }
};

TOUCHDOWN_TEST(TestConvergenceStudy)

} // namespace test_convergence_study

#include "test_convergence_study.moc"
