// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <QTest>

#include "core/simulation/run.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/study_plan.h"
#include "core/studies/sweep/sweep_task.h"
#include "tests/support/sample_case.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_sweep {

StudyPlan planOf(const Case& c, const std::string& text) { return parseStudy("sweep", text, "study", {}, &c); }

StudyReport performed(const Case& c, const std::string& text, int jobs = 2)
{
    const StudyPlan plan = planOf(c, text);
    if (!plan.valid()) qFatal("%s", plan.problems.front().text().c_str());
    return plan.perform(jobs, {});
}

Case shortRun()
{
    Case c = sample("fig10a");
    c.run.duration = 50e-6;
    return c;
}

double number(const StudyValue& value)
{
    const double* number = std::get_if<double>(&value);
    return number == nullptr ? NAN : *number;
}

const std::string endReading = "[[reading]]\nquantity = \"flying_height\"\nat = \"end\"\n";

class TestSweep : public QObject {
    Q_OBJECT

private slots:
    /// Each row is the run of its case alone, on any number of threads.
    void rowsAreRuns()
    {
        const std::string text = "[[axis]]\nkey = \"initial.flying_height\"\nvalues = [\"5 nm\", \"9 nm\", \"20 nm\"]\n"
                                 "[[axis]]\nkeys = [\"springs.front_stiffness\", \"springs.rear_stiffness\"]\n"
                                 "from = \"1 N/um\"\nto = \"2 N/um\"\ncount = 2\n" +
                                 endReading;
        const StudyReport report = performed(shortRun(), text);
        QCOMPARE(report.status, StudyStatus::Completed);
        const StudyTable& table = report.tables.front();
        QCOMPARE(table.rows.size(), std::size_t(6));
        QCOMPARE(table.columns[0].name, std::string("initial_flying_height"));
        QCOMPARE(table.columns[2].name, std::string("flying_height_end"));
        for (const auto& row : table.rows) {
            Case c = shortRun();
            c.initial.flyingHeight = number(row[0]);
            c.springs.frontStiffness = c.springs.rearStiffness = number(row[1]);
            c.run.stepCheck = false;
            c.run.fieldSnapshots = 0;
            QCOMPARE(number(row[2]), valueOr(run(c).final, "flying_height", 0.0));
        }
        QVERIFY(performed(shortRun(), text, 1).tables[0].rows == table.rows);
        QVERIFY(performed(shortRun(), text, 5).tables[0].rows == table.rows);
    }

    void staticStates()
    {
        const Case c = smallSlider(17);
        const StudyReport report = performed(c, "calculate = \"steady\"\n[[axis]]\nkey = \"suspension.preload\"\n"
                                                "from = \"10 mN\"\nto = \"20 mN\"\ncount = 3\n[[reading]]\nquantity = "
                                                "\"minimum_spacing\"\n");
        QCOMPARE(report.status, StudyStatus::Completed);
        QCOMPARE(report.tables[0].rows.size(), std::size_t(3));
        for (const auto& row : report.tables[0].rows) {
            Case at = c;
            at.suspension.preload = number(row[0]);
            QCOMPARE(number(row[1]), steady(at).minimumSpacing);
        }
        QCOMPARE(report.charts[0].panels[0].series[0].points.size(), std::size_t(3));
    }

    /// A key that is no number, and values for which the case contradicts itself: a row with its reason.
    void failuresAreRows()
    {
        const StudyReport report = performed(
            shortRun(), "[[axis]]\nkey = \"ono_yamane.take_off\"\nvalues = [\"2 nm\", \"5 nm\"]\n[[axis]]\nkey = "
                        "\"run.integrator\"\nvalues = [\"dopri5\", \"rk4\"]\n" +
                            endReading);
        QCOMPARE(report.status, StudyStatus::Completed);
        const StudyTable& table = report.tables.front();
        QCOMPARE(table.rows.size(), std::size_t(4));
        QCOMPARE(std::get<std::string>(table.rows[1][1]), std::string("rk4"));
        for (const auto& row : table.rows) {
            const std::string& problem = std::get<std::string>(row.back());
            QCOMPARE(problem.empty(), number(row[0]) > 3e-9);
            QCOMPARE(std::holds_alternative<double>(row[2]), problem.empty());
        }
        QCOMPARE(report.warnings.size(), std::size_t(1));
        QVERIFY2(report.warnings[0].starts_with("2 items of 4 have no valid end"), report.warnings[0].c_str());
        const StudyReport none =
            performed(shortRun(), "[[axis]]\nkey = \"ono_yamane.take_off\"\nvalues = [\"2 nm\"]\n" + endReading);
        QCOMPARE(none.status, StudyStatus::Failed);
        QVERIFY(!none.message.empty());
    }

    /// An axis with the name of a reading: both are columns.
    void namesDiffer()
    {
        const StudyReport report = performed(
            shortRun(), "[[axis]]\nkey = \"contact\"\nvalues = [\"none\", \"ono-yamane\"]\n[[reading]]\nquantity "
                        "= \"contact\"\n");
        const StudyTable& table = report.tables.front();
        QCOMPARE(table.columns[0].name, std::string("contact_of_the_case"));
        QCOMPARE(table.columns[1].name, std::string("contact"));
        QCOMPARE(std::get<std::string>(table.rows[0][0]), std::string("none"));
        // What one of the cases does not have is a row with its reason.
        const StudyReport hole = performed(
            shortRun(), "[[axis]]\nkey = \"contact\"\nvalues = [\"none\", \"ono-yamane\"]\n[[reading]]\nquantity "
                        "= \"touch_downs\"\n");
        QCOMPARE(std::get<std::string>(hole.tables[0].rows[0].back()), std::string("this case has no \"touch_downs\""));
        QVERIFY2(hole.findings[0].find("wherever there is a value, at 1 of 2 points") != std::string::npos,
                 hole.findings[0].c_str());
    }

    /// The share of starts that are caught, by an axis that is averaged over.
    void shares()
    {
        const std::string axes =
            "[[axis]]\nkey = \"ono_yamane.meniscus_force\"\nvalues = [\"3 mN\", \"12 mN\"]\n"
            "[[axis]]\nkey = \"initial.flying_height\"\nfrom = \"5 nm\"\nto = \"30 nm\"\ncount = 6\n";
        const std::string read = "[[reading]]\nquantity = \"caught\"\n[[reading]]\nquantity = \"motion\"\n";
        Case c = shortRun();
        c.run.duration = 0.3e-3;
        const StudyReport all = performed(c, axes + read), mean = performed(c, axes + "average = true\n" + read);
        QCOMPARE(all.tables[0].rows.size(), std::size_t(12));
        QCOMPARE(mean.tables[0].rows.size(), std::size_t(2));
        double both = 0.0;
        for (std::size_t i = 0; i < 2; ++i) {
            double sum = 0.0;
            for (std::size_t k = 0; k < 6; ++k) sum += number(all.tables[0].rows[6 * i + k][2]);
            QCOMPARE(number(mean.tables[0].rows[i][1]), sum / 6.0);
            both += sum;
        }
        QVERIFY(both > 0.0 && both < 12.0); // a slider that always does the same shows nothing
    }

    /// Two axes: a map whose classes are steps of the values, and which tells each cell's value.
    void maps()
    {
        const StudyReport report =
            performed(shortRun(), "[[axis]]\nkey = \"initial.flying_height\"\nfrom = \"4 nm\"\nto "
                                  "= \"40 nm\"\ncount = 5\n[[axis]]\nkey = "
                                  "\"ono_yamane.meniscus_force\"\nfrom = \"1 mN\"\nto = \"9 "
                                  "mN\"\ncount = 3\n" +
                                      endReading + "[[reading]]\nquantity = \"motion\"\n");
        QCOMPARE(report.charts.size(), std::size_t(2));
        const ChartMap& map = *report.charts[0].panels[0].map;
        QCOMPARE(map.x.size(), std::size_t(5));
        QCOMPARE(map.y.size(), std::size_t(3));
        QVERIFY(map.classes.size() >= 2 && map.classes.size() <= 12);
        for (std::size_t i = 0; i < map.classes.size(); ++i) QVERIFY(map.classes[i].shade >= 0.0);
        const auto& rows = report.tables[0].rows;
        for (const auto& row : rows) {
            const auto x = std::size_t(std::ranges::find(map.x, number(row[0])) - map.x.begin()),
                       y = std::size_t(std::ranges::find(map.y, number(row[1])) - map.y.begin());
            const int cell = map.cells[y * 5 + x];
            for (const auto& other : rows) {
                const auto u = std::size_t(std::ranges::find(map.x, number(other[0])) - map.x.begin()),
                           v = std::size_t(std::ranges::find(map.y, number(other[1])) - map.y.begin());
                if (map.cells[v * 5 + u] > cell) QVERIFY(number(other[2]) > number(row[2]));
            }
        }
    }

    /// Drawn over all axes, within their limits; the correlation finds what the spacing follows.
    void samples()
    {
        const StudyReport report =
            performed(shortRun(), "[[axis]]\nkey = \"springs.flying_height\"\nfrom = \"8 nm\"\nto = \"12 nm\"\n"
                                  "[[axis]]\nkey = \"springs.pitch\"\ndistribution = \"normal\"\nmean = \"90 urad\"\n"
                                  "deviation = \"5 urad\"\nfrom = \"80 urad\"\n[samples]\nmethod = \"sobol\"\ncount = "
                                  "40\n[[reading]]\nquantity = \"flying_height\"\nat = \"mean\"\n");
        QCOMPARE(report.status, StudyStatus::Completed);
        QCOMPARE(report.tables[0].rows.size(), std::size_t(40));
        std::set<double> heights;
        for (const auto& row : report.tables[0].rows) {
            QVERIFY(number(row[0]) >= 8e-9 && number(row[0]) <= 12e-9);
            QVERIFY(number(row[1]) >= 80e-6 && number(row[1]) < 130e-6);
            heights.insert(number(row[0]));
        }
        QCOMPARE(heights.size(), std::size_t(40));
        QCOMPARE(report.tables[1].name, std::string("rank_correlations"));
        QCOMPARE(report.tables[1].rows.size(), std::size_t(2));
        QVERIFY(std::abs(number(report.tables[1].rows[0][2])) > 0.5);
    }

    /// Every number and choice of cases of each model. Values that the case itself refuses are told by key.
    void anyKey()
    {
        std::size_t keys = 0, refused = 0;
        for (const char* name :
             {"fig10a", "springs_waviness", "film_pico", "fig02_case_2_moving", "contact_adhesion"}) {
            const Case c = sample(name);
            for (const Parameter& parameter : parameters()) {
                const bool varies = parameter.kind == ParameterKind::Number || parameter.kind == ParameterKind::Choice;
                const std::string text = sweepTemplate(c, parameter.key);
                QCOMPARE(text.find("key = \"" + parameter.key + "\"") != std::string::npos, varies);
                if (!varies || !parameter.used(c)) continue;
                const StudyPlan plan = parseStudy("sweep", text, "sweep", {}, &c);
                ++keys;
                if (plan.valid()) continue;
                ++refused;
                for (const InputProblem& problem : plan.problems)
                    QVERIFY2(problem.key.starts_with("axis"), problem.text().c_str());
            }
        }
        qInfo("%zu of %zu keys refuse a value", refused, keys);
        QVERIFY(keys > 200 && 4 * refused < keys);
    }

    void standard()
    {
        for (const char* name : {"fig10a", "film_femto", "contact_hertz"}) {
            const StudyPlan plan = planOf(sample(name), "");
            QVERIFY2(plan.valid(), plan.valid() ? "" : plan.problems.front().text().c_str());
            const StudyPlan written =
                parseStudy("sweep", studyTemplate("sweep", sample(name)), "study", {}, &plan.start.value);
            QVERIFY2(written.valid(), written.valid() ? "" : written.problems.front().text().c_str());
        }
    }

    void refuses_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        const QString axis = "[[axis]]\nkey = \"springs.flying_height\"\n",
                      read = "[[reading]]\nquantity = \"pitch\"\n";
        const auto row = [](const char* name, const QString& text, const char* says) {
            QTest::newRow(name) << text << says;
        };
        row("no axis", read, "axis: is missing");
        row("no reading", axis + "from = \"3 nm\"\nto = \"4 nm\"\n", "reading: is missing");
        row("no range", axis + read, ".from: is missing; write from and to, or values = [...]");
        row("no key", "[[axis]]\nfrom = 1\n" + read, "has no key");
        row("an unknown key", "[[axis]]\nkey = \"springs.flying_hight\"\nvalues = [1]\n" + read,
            "springs.flying_height");
        row("a key twice", axis + "values = [\"3 nm\"]\n" + axis + "values = [\"3 nm\"]\n" + read,
            "is changed by two axes");
        row("beyond its range", "[[axis]]\nkey = \"slider.mass\"\nfrom = \"-1 mg\"\nto = \"1 mg\"\n" + read, "from");
        row("a wrong unit", axis + "values = [\"3 urad\"]\n" + read, "3 urad");
        row("a value twice", axis + "values = [\"3 nm\", \"4 nm\", \"0.003 um\"]\n" + read, "is twice in the list");
        row("both lists", axis + "values = [\"3 nm\"]\ncount = 3\n" + read, "stands beside values");
        row("no number", "[[axis]]\nkey = \"run.integrator\"\nfrom = 1\nto = 2\n" + read, "is no number");
        row("the model", "[[axis]]\nkey = \"model\"\nvalues = [\"film\"]\n" + read, "cannot be varied");
        row("unused", "[[axis]]\nkey = \"disk.surface.rms\"\nvalues = [\"0.2 nm\"]\n" + read, "has no effect here");
        row("logarithm of zero", axis + "spacing = \"logarithmic\"\nfrom = 0\nto = \"4 nm\"\n" + read,
            "greater than 0");
        row("too many",
            axis +
                "from = \"3 nm\"\nto = \"4 nm\"\ncount = 100000\n[[axis]]\nkey = \"springs.pitch\"\nfrom = "
                "\"90 urad\"\nto = \"95 urad\"\ncount = 100000\n" +
                read,
            "1e7 are possible");
        row("an unknown reading", axis + "values = [\"3 nm\"]\n[[reading]]\nquantity = \"pich\"\n",
            "did you mean pitch?");
        row("an unknown place", axis + "values = [\"3 nm\"]\n[[reading]]\nquantity = \"pitch\"\nat = \"begin\"\n",
            "is none of end, tail");
        row("twice", axis + "values = [\"3 nm\"]\n" + read + read, "is read twice");
        row("a static state of springs", "calculate = \"steady\"\n" + axis + "values = [\"3 nm\"]\n" + read,
            "only a case of model \"film\"");
        row("modes that are kept", "keep = \"all\"\ncalculate = \"steady\"\n" + axis + "values = [\"3 nm\"]\n" + read,
            "only runs have files");
        row("runs of a surface",
            "keep = \"all\"\n" + axis + "from = \"3 nm\"\nto = \"4 nm\"\n" + read +
                "[samples]\nmethod = \"sobol\"\nby = \"surface\"\n",
            "write one of the two");
        row("a distribution of a grid", axis + "from = \"3 nm\"\nto = \"4 nm\"\ndistribution = \"normal\"\n" + read,
            "is of samples");
        row("all averaged", axis + "from = \"3 nm\"\nto = \"4 nm\"\naverage = true\n" + read, "averaged");
        row("a misspelt key of an axis", axis + "values = [\"3 nm\"]\nspaceing = 3\n" + read, "unknown key");
    }
    void refuses()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const StudyPlan plan = planOf(shortRun(), text.toStdString());
        QVERIFY(!plan.valid());
        QStringList all;
        for (const InputProblem& problem : plan.problems) all << QString::fromStdString(problem.text());
        QVERIFY2(all.join('\n').contains(says), qPrintable(all.join('\n')));
    }

    void logarithmicValues()
    {
        const StudyReport report =
            performed(shortRun(), "[[axis]]\nkey = \"initial.flying_height\"\nfrom = \"10 nm\"\nto "
                                  "= \"1000 nm\"\ncount = 3\nspacing = \"logarithmic\"\n" +
                                      endReading);
        QVERIFY(std::abs(number(report.tables[0].rows[1][0]) / 100e-9 - 1.0) < 1e-12);
        QCOMPARE(number(report.tables[0].rows[2][0]), 1000e-9);
    }
};

TOUCHDOWN_TEST(TestSweep)

} // namespace test_sweep

#include "test_sweep.moc"
