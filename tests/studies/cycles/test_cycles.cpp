// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/cycles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "core/studies/cycles/bouncing_run.h"
#include "core/studies/cycles/bouncing_springs.h"
#include "core/studies/study_plan.h"
#include "tests/support/bouncing_slider.h"
#include "tests/support/study_cells.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cycles {

StudyReport performed(const Case& c, const std::string& text, int jobs = 2, const StudyCallback& callback = {})
{
    const StudyPlan plan = parseStudy("cycles", text, "study", {}, &c);
    if (!plan.valid()) qFatal("%s", plan.problems.front().text().c_str());
    return plan.perform(jobs, callback);
}

/// The last number before a unit: 2.5 of "from 1 mN to 2.5 mN: ..." [that unit].
double lastAmount(const std::string& text, const std::string& unit)
{
    const std::size_t end = text.rfind(" " + unit);
    if (end == std::string::npos) return std::numeric_limits<double>::quiet_NaN();
    return std::stod(text.substr(text.rfind(' ', end - 1) + 1));
}

bool says(const StudyReport& report, const std::string& part)
{
    return std::ranges::any_of(report.findings,
                               [&](const std::string& each) { return each.find(part) != std::string::npos; });
}

const char* few = "values = 3\nstarts = 1\nduration = \"1 ms\"\n";
const char* force = "from = \"1 mN\"\nto = \"4 mN\"\n";

class TestCycles : public QObject {
    Q_OBJECT

private slots:
    /// W = 0 at f_m = 2.5 mN; the dashpots take energy, so the bouncing ends below.
    void bouncingEndsBelowZeroWork()
    {
        const StudyReport report = performed(bouncingSlider(), std::string(force) + few);
        QCOMPARE(report.status, StudyStatus::Completed);
        QVERIFY2(
            report.findings.front().starts_with(
                "Self-excited: for maximum meniscus force f_m from 1 mN to 2.414 mN the slider can bounce for ever"),
            report.findings.front().c_str());
        QVERIFY(says(report, "The stable cycle ends at 2.414 mN by grazing"));
        QVERIFY(says(report, "The energies of each cycle add up to zero within"));
        QCOMPARE(report.charts.size(), std::size_t(2));
        const StudyTable& cycles = table(report, "cycles");
        QVERIFY(cycles.rows.size() > 20);
        for (std::size_t i = 0; i < cycles.rows.size(); ++i) {
            const double sum = number(cycles, i, "contact") + number(cycles, i, "air") +
                               number(cycles, i, "suspension") + number(cycles, i, "friction");
            const double largest = std::abs(number(cycles, i, "contact"));
            // Where the pad grazes d_e, P changes as a square root and round-off grows.
            const bool grazes = number(cycles, i, "separation_max") - 4e-9 < 1e-13;
            QVERIFY(std::abs(sum) < (grazes ? 1e-4 : 1e-8) * largest);
            QVERIFY(number(cycles, i, "value") < 2.5e-3);
        }
        // W = 0 at f_m = f_c0^2/(2 k_c (d_e - d_s)) = 2.5 mN.
        QCOMPARE(report.warnings.size(), std::size_t(1));
        QCOMPARE(lastAmount(report.warnings.front(), "mN"), 2.5);
        for (const StudyTable& each : report.tables)
            for (const auto& row : each.rows) {
                QCOMPARE(row.size(), each.columns.size());
                for (const StudyValue& value : row)
                    if (const auto* real = std::get_if<double>(&value)) QVERIFY(std::isfinite(*real));
            }
    }

    /// With little damping the bouncing ends where -W is what the dashpots take; runs on both sides confirm the value.
    void theThresholdBalancesWorkAndDissipation()
    {
        Case c = bouncingSlider();
        c.springs.frontDampingRatio = c.springs.rearDampingRatio = 0.003;
        const StudyReport report = performed(c, "from = \"2 mN\"\nto = \"2.6 mN\"\nvalues = 2\nstarts = 1\n");
        const StudyTable& special = table(report, "special_points");
        std::size_t end = 0;
        while (end < special.rows.size() && word(special, end, "ends") != "yes") ++end;
        QVERIFY(end < special.rows.size());
        const double value = number(special, end, "value");
        const double dissipated = -number(special, end, "air") - number(special, end, "suspension");
        QVERIFY(value > 2.4e-3 && value < 2.5e-3);
        QVERIFY(std::abs(-number(special, end, "work") / dissipated - 1.0) < 0.05);
        const auto endAt = [&](double meniscusForce) {
            Case at = c;
            at.onoYamane.meniscusForce = meniscusForce;
            return searchCycle(BouncingSprings(at, sectionUnits(c)), meniscusForce, {.duration = 2e-3}).end;
        };
        QCOMPARE(endAt(0.995 * value), BouncingEnd::Bounces);
        QVERIFY(endAt(1.005 * value) != BouncingEnd::Bounces);
    }

    void noneWhereTheLawTakesEnergy()
    {
        const StudyReport report = performed(bouncingSlider(), std::string("from = \"4 mN\"\nto = \"20 mN\"\n") + few);
        QCOMPARE(report.status, StudyStatus::Completed);
        QVERIFY2(report.findings.front().starts_with("No sustained bouncing found in 3 runs for "),
                 report.findings.front().c_str());
        QVERIFY(table(report, "cycles").rows.empty());
        QVERIFY(report.charts.empty());
    }

    void noWarningWhereTheLawTakesEnergy()
    {
        QVERIFY(
            performed(bouncingSlider(4e-3), std::string("from = \"2.5 mN\"\nto = \"20 mN\"\n") + few).warnings.empty());
    }
    /// The law of the case creates energy at every value of another parameter.
    void warnsWhereTheParameterLeavesTheLawAlone()
    {
        const StudyReport report =
            performed(bouncingSlider(2e-3), "parameter = \"springs.rear_damping_ratio\"\nfrom = 0.005\nto = 0.01\n"
                                            "values = 1\nstarts = 1\nduration = \"0.2 ms\"\n");
        QCOMPARE(report.warnings.size(), std::size_t(1));
    }

    /// f_m = 2.4 mN is near the end of the stable cycle: a drop from 250 nm is caught there, though the cycle exists.
    void saysWhichStartsReachTheCycle()
    {
        const StudyReport report = performed(bouncingSlider(), "from = \"1.8 mN\"\nto = \"2.4128 mN\"\n"
                                                               "values = 24\nstarts = 1\n");
        const StudyTable& runs = table(report, "runs");
        std::size_t reached = 0;
        for (std::size_t i = 0; i < runs.rows.size(); ++i) reached += word(runs, i, "end") == "bounces" ? 1 : 0;
        QVERIFY(reached > 0 && reached < runs.rows.size());
        QVERIFY(says(report, "from a flying height of 250 nm at " + std::to_string(reached) + " of 24 values"));
        QVERIFY(says(report, "no start of this study leads to the stable cycle"));
    }

    /// With friction the contact takes energy at the end of the branch: W = +0.28 pJ.
    void theContactTakesWhatFrictionGives()
    {
        Case c = bouncingSlider(2.6e-3);
        c.onoYamane.friction = 0.8;
        const StudyReport report = performed(c, "from = \"2.6 mN\"\nto = \"3 mN\"\nvalues = 4\nstarts = 1\n");
        QVERIFY(says(report, "the contact takes 0.28 pJ"));
        QVERIFY(!says(report, "gives -") && !says(report, "takes -"));
    }

    /// At f_m = 2.5 mN W is zero, and what the contact gives is zero as well; friction keeps the slider bouncing.
    void theContactOfNoAreaGivesNothing()
    {
        Case c = bouncingSlider(2.5e-3);
        c.onoYamane.friction = 0.8;
        const StudyReport report = performed(c, "from = \"2.5 mN\"\nto = \"2.51 mN\"\nvalues = 1\nstarts = 1\n");
        const StudyTable& cycles = table(report, "cycles");
        std::size_t zeros = 0;
        for (std::size_t i = 0; i < cycles.rows.size(); ++i) {
            if (number(cycles, i, "value") != 2.5e-3) continue;
            QVERIFY(number(cycles, i, "work") == 0.0); // QCOMPARE takes 1e-13 for zero
            QVERIFY(number(cycles, i, "contact") == 0.0);
            QVERIFY(number(cycles, i, "friction") > 0.0);
            ++zeros;
        }
        QVERIFY(zeros > 0);
    }

    /// Both dashpots of the air at once; the cycle doubles its period at 0.00217 and the branch that leaves it there is
    /// followed.
    void severalKeysTakeOneValue()
    {
        const StudyReport report = performed(
            bouncingSlider(),
            "parameter = \"springs.front_damping_ratio, springs.rear_damping_ratio\"\nfrom = 0.0019\nto = 0.0025\n"
            "values = 1\nstarts = 1\n");
        QVERIFY(says(report, "The stable cycle loses its stability at 0.002166 in a period doubling"));
        const StudyTable& special = table(report, "special_points");
        bool meets = false;
        for (std::size_t i = 0; i < special.rows.size(); ++i)
            meets = meets || word(special, i, "remark") == "meets the cycle of half the period";
        QVERIFY(meets);
        const StudyTable& cycles = table(report, "cycles");
        QVERIFY(std::ranges::any_of(cycles.rows, [&](const std::vector<StudyValue>& row) {
            return std::get<double>(row[columnOf(cycles, "touch_downs")]) == 2.0;
        }));
    }

    void sameWithOneThreadOrTwo()
    {
        const std::string text = "from = \"1 mN\"\nto = \"1.5 mN\"\nvalues = 2\nstarts = 2\nduration = \"0.4 ms\"\n";
        const StudyReport one = performed(bouncingSlider(), text, 1), two = performed(bouncingSlider(), text, 2);
        QCOMPARE(one.findings, two.findings);
        for (std::size_t i = 0; i < one.tables.size(); ++i) QVERIFY(one.tables[i].rows == two.tables[i].rows);
    }

    void stops()
    {
        const StudyReport report =
            performed(bouncingSlider(), std::string(force) + few, 2, [](const StudyProgress&) { return false; });
        QCOMPARE(report.status, StudyStatus::Cancelled);
        QVERIFY(report.findings.empty());
    }

    void problems_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        QTest::newRow("no such key") << "parameter = \"springs.front_dampin_ratio\"\nfrom = 0\nto = 1\n"
                                     << "study:1: parameter: \"springs.front_dampin_ratio\" ";
        QTest::newRow("of the computation") << "parameter = \"run.duration\"\nfrom = \"1 ms\"\nto = \"2 ms\"\n"
                                            << "study:1: parameter: \"run.duration\" belongs to the computation";
        QTest::newRow("of the start") << "parameter = \"initial.pitch\"\nfrom = \"0 urad\"\nto = \"9 urad\"\n"
                                      << "study:1: parameter: \"initial.pitch\" belongs to the start";
        QTest::newRow("two units") << "parameter = \"slider.mass, springs.pitch\"\nfrom = \"1 mg\"\nto = \"2 mg\"\n"
                                   << "study:1: parameter: \"springs.pitch\" has another unit than \"slider.mass\"";
        QTest::newRow("an empty key") << "parameter = \"slider.mass,\"\nfrom = \"1 mg\"\nto = \"2 mg\"\n"
                                      << "study:1: parameter: \"\" ";
        QTest::newRow("no range") << "parameter = \"slider.mass\"\nfrom = \"1 mg\"\n"
                                  << "study: to: is missing: ";
        QTest::newRow("an empty range") << "from = \"1 mN\"\nto = \"1 mN\"\n"
                                        << "study:2: to: is the same as from";
        QTest::newRow("out of range") << "from = \"-1 mN\"\n"
                                      << "study:1: from: ";
        QTest::newRow("no values") << "values = 0\n"
                                   << "study:1: values: must be a whole number from 1 to 200";
        QTest::newRow("no starts") << "starts = 0\n"
                                   << "study:1: starts: must be a whole number from 1 to 8";
        QTest::newRow("crossings") << "crossings = \"x\"\n"
                                   << "study:1: crossings: ";
        QTest::newRow("a long duration") << "duration = \"2 s\"\n"
                                         << "study:1: duration: ";
        QTest::newRow("a mark without a map") << "values = 3\n[[mark]]\nname = \"here\"\nx = \"1 mN\"\ny = 0.01\n"
                                              << "study:2: mark[1]: needs a map";
        QTest::newRow("an unknown key") << "value = 3\n"
                                        << "study:1: value: unknown key; did you mean values?";
    }
    void problems()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const Case c = bouncingSlider();
        const StudyPlan plan = parseStudy("cycles", text.toStdString(), "study", {}, &c);
        QCOMPARE(plan.problems.size(), std::size_t(1));
        const QString said = QString::fromStdString(plan.problems.front().text());
        QVERIFY2(said.startsWith(says), qPrintable(said));
    }

    void refusesOtherCases()
    {
        for (const ModelKind model : {ModelKind::Film, ModelKind::Contact}) {
            const Case c = defaultsOf(model);
            const StudyPlan plan = parseStudy("cycles", "", "study", {}, &c);
            QCOMPARE(plan.problems.size(), std::size_t(1));
            QCOMPARE(plan.problems.front().key, std::string("case"));
        }
        Case free = bouncingSlider();
        free.contact = noContact;
        const StudyPlan plan = parseStudy("cycles", "", "study", {}, &free);
        QCOMPARE(plan.problems.size(), std::size_t(1));
        QVERIFY(plan.problems.front().message.starts_with("has no contact"));
        free.contact = ContactKind::Asperity;
        const StudyPlan summits = parseStudy("cycles", "", "study", {}, &free);
        QCOMPARE(summits.problems.size(), std::size_t(1));
        QVERIFY(summits.problems.front().message.starts_with("has contact = \"asperity\""));
        Case uneven = bouncingSlider();
        uneven.diskSurface.kind = DiskSurfaceKind::Waves;
        uneven.diskSurface.waveAmplitudes = {1e-9};
        uneven.diskSurface.waveLengths = {50e-6};
        const StudyPlan driven = parseStudy("cycles", "", "study", {}, &uneven);
        QCOMPARE(driven.problems.size(), std::size_t(1));
        QVERIFY(driven.problems.front().message.starts_with("has a disk that is not flat"));
    }
};

TOUCHDOWN_TEST(TestCycles)

} // namespace test_cycles

#include "test_cycles.moc"
