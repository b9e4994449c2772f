// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/work_precision.h"

#include <cmath>
#include <map>

#include <QTest>

#include "core/case_files/case_file.h"
#include "core/studies/precision/precision_report.h"
#include "core/studies/precision/precision_runs.h"
#include "core/studies/precision/precision_task.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study_plan.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_work_precision {

const StudyCallback noCallback;

StudyPlan planOf(const std::string& text) { return parseStudy("work-precision", text, "study.toml", {}); }

StudyReport performed(const std::string& text)
{
    const StudyPlan plan = planOf(text);
    if (!plan.valid()) qFatal("%s", plan.problems.front().text().c_str());
    return plan.perform(2, noCallback);
}

const StudyTable& tableOf(const StudyReport& report, const std::string& name)
{
    for (const StudyTable& table : report.tables)
        if (table.name == name) return table;
    qFatal("no table %s", name.c_str());
}

std::size_t columnOf(const StudyTable& table, const std::string& name)
{
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (table.columns[i].name == name) return i;
    qFatal("no column %s", name.c_str());
}

const StudyValue& valueOf(const StudyReport& report, const std::string& method, const std::string& setting,
                          const std::string& column)
{
    const StudyTable& table = tableOf(report, "runs");
    for (const auto& row : table.rows)
        if (std::get<std::string>(row[0]) == method && std::get<std::string>(row[1]) == setting)
            return row[columnOf(table, column)];
    qFatal("no run %s, %s", method.c_str(), setting.c_str());
}

double numberOf(const StudyReport& report, const std::string& method, const std::string& setting,
                const std::string& column)
{
    return std::get<double>(valueOf(report, method, setting, column));
}

std::string textOf(const StudyReport& report, const std::string& method, const std::string& setting,
                   const std::string& column)
{
    return std::get<std::string>(valueOf(report, method, setting, column));
}

bool tells(const std::vector<std::string>& sentences, const std::string& part)
{
    for (const std::string& sentence : sentences)
        if (sentence.find(part) != std::string::npos) return true;
    return false;
}

/// A method of one integrator over steps.
std::string stepMethod(const std::string& integrator, const std::string& values)
{
    return "[[method]]\nname = \"" + integrator + "\"\nset = { \"run.integrator\" = \"" + integrator +
           "\" }\nkey = \"run.step\"\nvalues = " + values + "\n";
}

/// So that a test takes no longer than it must.
const std::string quick = "repeats = 1\ntime_limit = \"1 ms\"\n";
/// Two families that prove each other in milliseconds.
const std::string references =
    "[[reference]]\nname = \"dopri5\"\nset = { \"run.integrator\" = \"dopri5\", \"run.tolerance\" = 1e-13 }\n"
    "[[reference]]\nname = \"rk4-events\"\nset = { \"run.integrator\" = \"rk4-events\", \"run.step\" = \"5 ns\" }\n";

class TestWorkPrecision : public QObject {
    Q_OBJECT

private slots:
    void orderOfTheMethod_data()
    {
        QTest::addColumn<QString>("integrator");
        QTest::addColumn<double>("order");
        QTest::newRow("rk4") << "rk4" << 4.0;
        QTest::newRow("rk4-events") << "rk4-events" << 4.0;
        QTest::newRow("newmark") << "newmark" << 2.0;
    }
    /// Halving the step of a method of order p divides its error by 2^p. w dt is 0.063 at 1 us, where the errors of
    /// order p + 1 and more are smaller by that factor.
    void orderOfTheMethod()
    {
        QFETCH(QString, integrator);
        QFETCH(double, order);
        const std::string method = integrator.toStdString();
        const StudyReport report = performed("case = \"textbook_oscillator\"\n" + quick +
                                             stepMethod(method, "[\"1 us\", \"500 ns\"]") + references);
        QCOMPARE(report.status, StudyStatus::Completed);
        for (const char* error : {"error_worst", "error_l2"}) {
            const double observed =
                std::log2(numberOf(report, method, "1 us", error) / numberOf(report, method, "500 ns", error));
            QVERIFY2(std::abs(observed - order) < 0.05, qPrintable(QString::number(observed)));
        }
    }

    /// The leading error of Newmark's average acceleration is that of its phase: w is changed by -w (w dt)^2/12, its
    /// damping by terms of xi (w dt)^2. The largest error of A exp(-xi w t) cos(w t) is then A (w dt)^2/12 max(w t
    /// exp(-xi w t) |sin w t|), and the largest w t exp(-xi w t) is 1/(xi e): with A = 100 nm, w = 63245.55 rad/s, dt =
    /// 500 ns, xi = 0.02 it is 100 nm * 1e-3/12 * 50/e = 0.15328 nm. |sin| comes close to 1 near the top, which is
    /// flat; w dt is small beside 1.
    void errorAgreesWithTheExactSolution()
    {
        const StudyReport report =
            performed("case = \"textbook_oscillator\"\n" + quick + stepMethod("newmark", "[\"500 ns\"]") + references);
        const double worst = numberOf(report, "newmark", "500 ns", "error_worst");
        QVERIFY2(std::abs(worst / 0.15328e-9 - 1.0) < 0.02, qPrintable(QString::number(worst)));
    }

    /// A bilinear oscillator: where it touches down the jerk jumps by 15 w_1^2 v with v = A w_1. A switch that is seen
    /// up to a step late changes v by up to half of that times dt^2, and the motion by 7.5 A (w_1 dt)^2 = 0.03 nm at
    /// 100 ns: second order, whatever the method. With located switches rk4 keeps its fourth, A (w_2 dt)^4 = 4e-5 nm.
    /// No more than that at each of 40 switches.
    void switchesAreWhatCosts()
    {
        const StudyReport report =
            performed("case = \"textbook_bounce\"\n" + quick + stepMethod("rk4", "[\"100 ns\"]") +
                      stepMethod("rk4-events", "[\"100 ns\"]") + references);
        const double naive = numberOf(report, "rk4", "100 ns", "error_worst");
        const double located = numberOf(report, "rk4-events", "100 ns", "error_worst");
        QVERIFY2(naive > 1e-12 && naive < 40 * 0.03e-9, qPrintable(QString::number(naive)));
        QVERIFY2(located > 0.0 && located < 40 * 4e-14, qPrintable(QString::number(located)));
    }

    void ownSettingIsAddedAndMarked()
    {
        const StudyReport report = performed(
            "case = \"textbook_oscillator\"\n" + quick +
            "[[method]]\nname = \"dopri5\"\nkey = \"run.tolerance\"\nvalues = [1e-4, 1e-6, 1e-10]\n" + references);
        const StudyTable& runs = tableOf(report, "runs");
        QCOMPARE(runs.rows.size(), std::size_t{4});
        QCOMPARE(std::get<std::string>(runs.rows[2][1]), std::string("1e-8"));
        QCOMPARE(std::get<std::string>(runs.rows[2][columnOf(runs, "chosen")]), std::string("yes"));
        QCOMPARE(std::get<std::string>(runs.rows[3][columnOf(runs, "chosen")]), std::string());
        int ringed = 0;
        for (const ChartSeries& series : report.charts.front().panels.front().series)
            for (const ChartPoint& point : series.points) ringed += point.chosen;
        QCOMPARE(ringed, 1);
    }

    void chartIsDrawable()
    {
        const StudyReport report = performed("case = \"fig10a\"\nset = { \"run.duration\" = \"0.2 ms\" }\n" + quick +
                                             stepMethod("rk4", "[\"2 us\", \"100 ns\", \"10 ns\"]") +
                                             "[[method]]\nname = \"dopri5\"\nset = { \"run.integrator\" = \"dopri5\" "
                                             "}\nkey = \"run.tolerance\"\nvalues = [1e-6, 1e-8]\n" +
                                             references);
        const StudyChart& chart = report.charts.front();
        QCOMPARE(chart.panels.size(), std::size_t{2});
        for (const ChartPanel& panel : chart.panels) {
            QVERIFY(panel.x.logarithmic && panel.y.logarithmic);
            for (const ChartSeries& series : panel.series)
                for (const ChartPoint& point : series.points)
                    QVERIFY(std::isfinite(point.x) && point.x > 0.0 && std::isfinite(point.y) && point.y > 0.0);
            // The last series: the best of all, from the most accurate to the fastest.
            const ChartSeries& front = panel.series.back();
            QVERIFY(front.quiet);
            for (std::size_t i = 1; i < front.points.size(); ++i) QVERIFY(front.points[i].x > front.points[i - 1].x);
        }
        // A step of 2 us goes through the wall of an air spring.
        QCOMPARE(textOf(report, "rk4", "2 us", "verdict"), std::string("failed"));
        const ChartSeries& rk4 = chart.panels.front().series.front();
        QCOMPARE(rk4.points.front().kind, PointKind::Failed);
        QVERIFY(rk4.points.front().x > rk4.points.back().x);
        QVERIFY(tells(report.findings, "Errors are distances from a reference, dopri5, which rk4-events confirms to "));
        QVERIFY(tells(report.findings, "The paper's method, rk4 (10 ns), takes "));
    }

    /// A setting that was not run, one whose time is not known, and one that was run.
    void onlyRunsWithAHeightAreDrawn()
    {
        PrecisionTask task;
        task.methods.emplace_back().name = "a";
        for (const char* label : {"not run", "no time", "run"})
            task.methods.front().settings.emplace_back().label = label;
        PrecisionRuns runs;
        for (std::size_t setting = 0; setting < 3; ++setting) {
            PrecisionPoint& point = runs.points.emplace_back();
            point.setting = setting;
            point.ran = setting != 0;
            if (setting != 1) point.seconds = {1e-3};
            if (setting != 1) point.work = 100.0;
        }
        const StudyChart chart = precisionChart(task, runs);
        QCOMPARE(chart.panels.size(), std::size_t{2});
        for (const ChartPanel& panel : chart.panels) {
            QCOMPARE(panel.series.size(), std::size_t{1});
            QCOMPARE(panel.series.front().points.size(), std::size_t{1});
            QCOMPARE(panel.series.front().points.front().label, std::string("run"));
        }
    }

    /// Fig. 14 (b) with a quarter of its damping and 6 mN bounces for so long that even dopri5 at 1e-14 and rk4-events
    /// in steps of 1 ns part.
    void trajectoryIsNotDetermined()
    {
        const StudyReport report =
            performed("case = \"fig14b\"\nset = { \"springs.front_damping_ratio\" = 0.0005, "
                      "\"springs.rear_damping_ratio\" = 0.0005, "
                      "\"ono_yamane.meniscus_force\" = \"6 mN\", \"run.duration\" = \"0.8 ms\" }\n" +
                      quick + stepMethod("rk4-events", "[\"10 ns\"]") + references + "[ensemble]\nstarts = 4\n");
        QCOMPARE(report.status, StudyStatus::Completed);
        QVERIFY(tells(report.findings,
                      "The trajectory is not determined: dopri5 and rk4-events differ by more than 0.1 nm "));
        QVERIFY(report.charts.front().caption.find("is not determined") != std::string::npos);
        QCOMPARE(report.charts.size(), std::size_t{2});
        QCOMPARE(tableOf(report, "ensembles").rows.size(),
                 std::size_t{3}); // the reference, rk4-events, the case as it is
        // Statistics of the whole run are not compared, and before the horizon nothing is further off than what decides
        // it.
        QVERIFY(std::holds_alternative<std::monostate>(valueOf(report, "rk4-events", "10 ns", "error_mean")));
        QCOMPARE(textOf(report, "rk4-events", "10 ns", "verdict"), std::string("not determined"));
    }

    /// The same where the agreement that is asked for is more than any two runs can give.
    void agreementIsRefused()
    {
        const StudyReport report =
            performed("case = \"fig10b\"\nset = { \"run.duration\" = \"0.2 ms\" }\nagreement = \"1e-12 nm\"\n" + quick +
                      stepMethod("rk4-events", "[\"20 ns\"]") + references + "[ensemble]\nstarts = 2\n");
        QVERIFY(tells(report.findings, "differ by more than 1e-12 nm at "));
    }

    /// Fig. 12 (b): the spring is lost, whoever integrates. That is the answer, and those who find it agree.
    void failureThatIsTheAnswer()
    {
        const StudyReport report = performed("case = \"fig12b\"\nset = { \"run.duration\" = \"0.2 ms\" }\n" + quick +
                                             stepMethod("rk4-events", "[\"10 ns\"]") + references);
        QCOMPARE(textOf(report, "rk4-events", "10 ns", "verdict"), std::string("same end"));
        QVERIFY(tells(report.findings, "The case itself has no valid end"));
    }

    void staticState()
    {
        const StudyReport report =
            performed("case = \"film_plane\"\nof = \"static\"\nquantity = \"net_force\"\n" + quick +
                      "[[method]]\nname = \"power law\"\nset = { \"film.scheme\" = \"power-law\" }\nkey = "
                      "\"film.nodes\"\nvalues = [17, 33]\n"
                      "[[method]]\nname = \"complete flux\"\nset = { \"film.scheme\" = \"complete-flux\" }\nkey = "
                      "\"film.nodes\"\nvalues = [17, 33]\n"
                      "[[reference]]\nname = \"97\"\nset = { \"film.nodes\" = [97, 97] }\n"
                      "[[reference]]\nname = \"129\"\nset = { \"film.nodes\" = [129, 129] }\n");
        QCOMPARE(report.status, StudyStatus::Completed);
        for (const char* method : {"power law", "complete flux"})
            QVERIFY(numberOf(report, method, "33", "error_final") < numberOf(report, method, "17", "error_final"));
        QVERIFY(numberOf(report, "complete flux", "33", "error_final") <
                numberOf(report, "power law", "33", "error_final"));
        QVERIFY(numberOf(report, "power law", "33", "work") > 0.0);
    }

    /// d_1 = d_s from 230 nm: steps of 10 ns end in contact where the reference flies. No two runs stay together as
    /// long as is asked here, so that the trajectory counts as not determined; its end is. The wrong one is drawn
    /// hollow, beside the errors where it has none.
    void wrongEndWhereTheTrajectoryIsNotDetermined()
    {
        for (const std::string error : {"worst", "mean"}) {
            const StudyReport report =
                performed("case = \"fig10b_naive_switching\"\nset = { \"run.duration\" = \"0.5 ms\" }\nagreement = "
                          "\"1e-12 nm\"\nerror = \"" +
                          error + "\"\n" + quick + stepMethod("rk4", "[\"10 ns\"]") +
                          stepMethod("rk4-events", "[\"10 ns\"]") + references + "[ensemble]\nstarts = 2\n");
            QVERIFY(tells(report.findings, "The end is determined: it flies at 7 nm"));
            QCOMPARE(textOf(report, "rk4", "10 ns", "verdict"), std::string("other end"));
            QCOMPARE(textOf(report, "rk4-events", "10 ns", "verdict"), std::string("same end"));
            QCOMPARE(report.charts.front().panels.front().series.front().points.front().kind, PointKind::WrongState);
            QCOMPARE(tells(report.warnings, "take error = \"worst\""), error == "mean");
        }
    }

    /// References of a second within a share of 6 ms.
    void budgetIsTheReferencesToo()
    {
        const StudyReport report =
            performed("case = \"fig10a\"\nbudget = \"0.01 s\"\n" + stepMethod("rk4", "[\"10 ns\", \"1 ns\"]"));
        QCOMPARE(report.status, StudyStatus::Failed);
        QCOMPARE(report.message, std::string("there is no reference: fewer than two reference runs "
                                             "ended within 6 ms, their share of the budget of 10 ms; give it more"));
    }

    /// What is not run for lack of time is said; the rest is an answer.
    void spentBudgetIsSaid()
    {
        const StudyReport report =
            performed("case = \"fig10a\"\nset = { \"run.duration\" = \"0.2 ms\" }\nbudget = \"1 s\"\n" +
                      stepMethod("rk4", "[\"10 ns\", \"0.001 ns\"]") + references);
        QCOMPARE(report.status, StudyStatus::Completed);
        QVERIFY(tells(report.warnings, "The budget of 1 s was spent before these were run: rk4 (0.001 ns)"));
        QCOMPARE(textOf(report, "rk4", "0.001 ns", "verdict"), std::string("not run"));
    }

    void stops()
    {
        const StudyPlan plan = planOf("case = \"fig10a\"\n");
        QVERIFY(plan.valid());
        int calls = 0;
        const StudyReport report = plan.perform(2, [&](const StudyProgress& progress) {
            if (progress.share < 0.0 || progress.share > 1.0) qFatal("share");
            return ++calls < 3;
        });
        QCOMPARE(report.status, StudyStatus::Cancelled);
        QCOMPARE(calls, 3);
    }

    void problems_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("problem");
        QTest::newRow("unknown key of a method") << "[[method]]\nname = \"a\"\nkey = \"run.stepp\"\nvalues = [1]\n"
                                                 << "run.stepp: unknown key";
        QTest::newRow("value out of range") << "[[method]]\nname = \"a\"\nkey = \"run.tolerance\"\nvalues = [1]\n"
                                            << "is out of range";
        QTest::newRow("setting without effect") << "[[method]]\nname = \"a\"\nkey = \"run.step\"\nvalues = [\"1 ns\"]\n"
                                                << "run.step: has no effect";
        QTest::newRow("no values") << "[[method]]\nname = \"a\"\nkey = \"run.tolerance\"\n"
                                   << "has no values";
        QTest::newRow("no name") << "[[method]]\nkey = \"run.tolerance\"\nvalues = [1e-4]\n"
                                 << "has no name";
        QTest::newRow("name twice") << "[[method]]\nname = \"a\"\n[[method]]\nname = \"a\"\n"
                                    << "is the name of another method";
        QTest::newRow("duration swept") << "[[method]]\nname = \"a\"\nkey = \"run.duration\"\nvalues = [\"1 ms\"]\n"
                                        << "must be the same for all methods";
        QTest::newRow("unknown quantity") << "quantity = \"flying_heigth\"\n"
                                          << "flying_height";
        QTest::newRow("unknown error") << "error = \"wrost\"\n"
                                       << "worst";
        QTest::newRow("static springs") << "of = \"static\"\n"
                                        << "is for cases of model \"film\"";
        QTest::newRow("one reference") << "[[reference]]\nname = \"a\"\nset = { \"run.tolerance\" = 1e-12 }\n"
                                       << "two or more are needed";
        QTest::newRow("ensemble of no number") << "[ensemble]\nkey = \"run.integrator\"\n"
                                               << "is no key of a number";
        QTest::newRow("unknown key") << "repeat = 3\n"
                                     << "unknown key";
    }
    void problems()
    {
        QFETCH(QString, text);
        QFETCH(QString, problem);
        const StudyPlan plan = planOf("case = \"fig10a\"\n" + text.toStdString());
        QVERIFY(!plan.valid());
        std::vector<std::string> sentences;
        for (const InputProblem& each : plan.problems) sentences.push_back(each.text());
        QVERIFY2(tells(sentences, problem.toStdString()), sentences.front().c_str());
    }
    void contactIsRefusedInOneSentence()
    {
        const StudyPlan plan = planOf("case = \"contact_hertz\"\n");
        QCOMPARE(plan.problems.size(), std::size_t{1});
        QVERIFY(plan.problems.front().text().find("list them as [[method]] and [[reference]]") != std::string::npos);
    }

    void templateIsAStudy_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"fig10a", "film_pico"}) QTest::newRow(name) << name;
    }
    void templateIsAStudy()
    {
        QFETCH(QString, name);
        const CaseDocument document = openCase(name.toStdString());
        const StudyPlan plan =
            planOf("case = \"" + name.toStdString() + "\"\n" + templateText(workPrecisionForm(document.value)));
        for (const InputProblem& problem : plan.problems) qWarning("%s", problem.text().c_str());
        QVERIFY(plan.valid());
    }

    void sampleStudiesAreValid()
    {
        int count = 0;
        for (const SampleStudy& study : sampleStudies()) {
            if (study.kind != "work-precision") continue;
            const StudyPlan plan = openStudy(study.kind, study.name);
            for (const InputProblem& problem : plan.problems) qWarning("%s", problem.text().c_str());
            QVERIFY2(plan.valid(), study.name.c_str());
            ++count;
        }
        QCOMPARE(count, 9);
    }
};

TOUCHDOWN_TEST(TestWorkPrecision)

} // namespace test_work_precision

#include "test_work_precision.moc"
