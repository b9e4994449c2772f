// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/response.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <QTest>

#include "core/case_files/case_file.h"
#include "core/formats/units.h"
#include "core/studies/study_plan.h"
#include "tests/support/impact_oscillator.h"
#include "tests/support/study_cells.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_response {

StudyPlan planOf(const Case& c, const std::string& text) { return parseStudy("response", text, "study", {}, &c); }

StudyReport performed(const Case& c, const std::string& text, const StudyCallback& callback = {})
{
    const StudyPlan plan = planOf(c, text);
    if (!plan.valid()) qFatal("%s", plan.problems.front().text().c_str());
    return plan.perform(1, callback);
}

bool says(const StudyReport& report, const std::string& part)
{
    return std::ranges::any_of(report.findings,
                               [&](const std::string& each) { return each.find(part) != std::string::npos; });
}
bool hasSeries(const StudyReport& report, const std::string& name)
{
    for (const StudyChart& chart : report.charts)
        for (const ChartPanel& panel : chart.panels)
            if (std::ranges::find(panel.series, name, &ChartSeries::name) != panel.series.end()) return true;
    return false;
}

/// The waves of the oscillator from one frequency to another [omega_0].
std::string overWaves(double from, double to, int steps, int starts = 0)
{
    return "from = " + std::to_string(from * ImpactOscillator::frequency) +
           "\nto = " + std::to_string(to * ImpactOscillator::frequency) + "\nsteps = " + std::to_string(steps) +
           "\nstarts = " + std::to_string(starts) + "\namplitude = \"100 nm\"\nwavelength = \"125 um\"\n";
}

class TestResponse : public QObject {
    Q_OBJECT

private slots:
    /// An elastic stop hardens the spring. Upwards, the motion with impacts lasts to the fold of its exact solution;
    /// downwards, the one without lasts until it grazes the stop.
    void jumpsOfAnElasticStop()
    {
        std::mt19937 draw(1);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        std::vector<double> up, down;
        for (int set = 0; set < 12; ++set) {
            const double zeta = 0.03 + 0.04 * share(draw);
            const ImpactOscillator oscillator{zeta, 3.0 + 7.0 * share(draw),
                                              2.0 + (0.7 / (2.0 * zeta) - 2.0) * share(draw)};
            const double fold = oscillator.fold(), grazing = oscillator.grazing();
            if (fold < 1.03 * grazing) continue;
            const StudyReport report = performed(oscillator.slider(), overWaves(0.9, fold + 0.1, 60));
            QCOMPARE(report.status, StudyStatus::Completed);
            const StudyTable& jumps = table(report, "jumps");
            QCOMPARE(jumps.rows.size(), std::size_t(2));
            for (std::size_t row = 0; row < 2; ++row) {
                const bool rising = word(jumps, row, "way") == "up";
                const double found = number(jumps, row, "frequency") / ImpactOscillator::frequency;
                (rising ? up : down).push_back(std::abs(found / (rising ? fold : grazing) - 1.0));
                // Beyond the fold the motion is smaller, below the grazing larger.
                QCOMPARE(number(jumps, row, "after") < number(jumps, row, "before"), rising);
            }
            QVERIFY(says(report, "two states between"));
        }
        QVERIFY2(up.size() >= 6 && down.size() == up.size(), qPrintable(QString::number(up.size())));
        std::ranges::sort(up);
        std::ranges::sort(down);
        qInfo("jumps of %zu sets: fold median %g, largest %g; grazing %g, %g", up.size(), up[up.size() / 2], up.back(),
              down[down.size() / 2], down.back());
        QVERIFY2(up.back() < 2e-3, qPrintable(QString::number(up.back())));
        QVERIFY2(down.back() < 2e-3, qPrintable(QString::number(down.back())));
    }

    /// Without the stop the same oscillators have one state at each frequency, that of the formula.
    void noJumpWithoutAStop()
    {
        std::mt19937 draw(4);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        for (int set = 0; set < 6; ++set) {
            const ImpactOscillator oscillator{0.03 + 0.07 * share(draw), 0.0, 0.0};
            Case c = oscillator.slider();
            c.contact = noContact;
            const StudyReport report = performed(c, overWaves(0.5, 2.0, 30, 20));
            QVERIFY(table(report, "jumps").rows.empty());
            QVERIFY(says(report, "Up and down agree at all 31 frequencies"));
            QVERIFY(says(report, "No other motion was found from 20 other starts (5 at rest, 15 drawn)"));
            const StudyTable& points = table(report, "points");
            QCOMPARE(points.rows.size(), std::size_t(62));
            for (std::size_t row = 0; row < points.rows.size(); ++row) {
                QCOMPARE(word(points, row, "settled"), std::string("yes"));
                const double w = number(points, row, "frequency") / ImpactOscillator::frequency;
                const std::complex<double> answer =
                    w * w / std::complex<double>(1.0 - w * w, 2.0 * oscillator.zeta * w);
                const double expected = std::abs(answer) * ImpactOscillator::wave;
                const double accuracy = 1e-6;
                QVERIFY(std::abs(number(points, row, "amplitude") / expected - 1.0) < accuracy);
                const double phaseError = std::abs(number(points, row, "phase") - std::arg(answer));
                QVERIFY2(phaseError < accuracy, qPrintable(QString::number(phaseError)));
                QVERIFY(std::abs(number(points, row, "linear_amplitude") / expected - 1.0) < 1e-6);
            }
        }
    }

    /// Above the frequency of the exact solution the motion takes two periods of the forcing.
    void periodDoublingIsNamed()
    {
        const ImpactOscillator oscillator{0.05, 6.0, 0.3};
        const double w = oscillator.doubling(1.8, 2.8);
        QVERIFY(w > 1.8);
        const StudyReport report = performed(oscillator.slider(), overWaves(w - 0.1, w + 0.1, 20));
        const StudyTable& points = table(report, "points");
        for (std::size_t row = 0; row < points.rows.size(); ++row) {
            const double at = number(points, row, "frequency") / ImpactOscillator::frequency;
            if (std::abs(at - w) < 1e-3) continue;
            QCOMPARE(number(points, row, "period"), at < w ? 1.0 : 2.0);
        }
        QVERIFY(says(report, "repeats after 2 periods of the forcing"));
        QVERIFY(says(report, "In and out of contact"));
    }

    /// The softening air springs of the sample case: a jump above on the way down, and a range that does not settle, as
    /// the waves excite both modes at the sum of their frequencies.
    void samplesOfTheProgram()
    {
        const Case c = openCase("springs_waviness").value;
        const StudyReport report = performed(c, templateText(responseForm(c)));
        QCOMPARE(report.status, StudyStatus::Completed);
        const StudyTable& jumps = table(report, "jumps");
        QVERIFY(jumps.rows.size() >= 2);
        QCOMPARE(word(jumps, 0, "way"), std::string("up"));
        QCOMPARE(word(jumps, 1, "way"), std::string("down"));
        QVERIFY(number(jumps, 0, "frequency") > number(jumps, 1, "frequency"));
        QVERIFY(number(jumps, 0, "after") > number(jumps, 0, "before")); // upwards it rises
        double largest = 0.0;                                            // on both sides of the jumps
        for (std::size_t row = 0; row < jumps.rows.size(); ++row)
            largest = std::max({largest, number(jumps, row, "before"), number(jumps, row, "after")});
        QVERIFY(says(report, "Largest amplitude of the flying height: " + fewDigits(largest, "nm", 3)));
        for (const char* name : {"up", "down", "small motions"}) QVERIFY2(hasSeries(report, name), name);
        for (const StudyTable& each : report.tables)
            for (const auto& row : each.rows) {
                QCOMPARE(row.size(), each.columns.size());
                for (const StudyValue& value : row)
                    if (const auto* one = std::get_if<double>(&value)) QVERIFY(std::isfinite(*one));
            }
        const StudyTable& points = table(report, "points");
        for (std::size_t row = 0; row < points.rows.size(); ++row) // a period is given only where it has settled
            QCOMPARE(std::holds_alternative<double>(points.rows[row][columnOf(points, "period")]),
                     word(points, row, "settled") == "yes");
    }

    /// Without contact, at the speed of the disk: a slow sweep by another program, with a Runge-Kutta method of fixed
    /// steps, jumps at 243.6715 kHz upwards and at 213.489 kHz downwards, to 2 Hz. Arclength continuation has a
    /// separate piece of branch from 205.57 to 212.48 kHz beside it. The way down must not pass to it, whatever the
    /// step is.
    void placesOfJumpsDoNotDependOnTheStep()
    {
        Case c = openCase("springs_waviness").value;
        c.contact = noContact;
        for (const int steps : {20, 60, 250}) {
            const StudyReport report = performed(
                c, "from = \"190 kHz\"\nto = \"300 kHz\"\nstarts = 0\nsteps = " + std::to_string(steps) + "\n");
            const StudyTable& jumps = table(report, "jumps");
            QCOMPARE(jumps.rows.size(), std::size_t(2));
            const std::array<double, 2> folds{243.6715e3, 213.489e3};
            for (std::size_t row = 0; row < 2; ++row) {
                const double error = std::abs(number(jumps, row, "frequency") - folds[row]);
                QVERIFY2(error < 2.0 + number(jumps, row, "uncertainty"), qPrintable(QString::number(error)));
                QVERIFY(number(jumps, row, "uncertainty") < 1.0);
            }
        }
    }

    /// The motion without contact ends where it grazes the disk: the same place with each step.
    void grazingDoesNotDependOnTheStep()
    {
        const Case c = openCase("springs_waviness").value;
        std::vector<double> places, errors;
        for (const int steps : {17, 34, 120}) {
            const StudyReport report = performed(c, "from = \"190 kHz\"\nto = \"300 kHz\"\nwavelength = \"50 um\"\n"
                                                    "starts = 0\nsteps = " +
                                                        std::to_string(steps) + "\n");
            const StudyTable& jumps = table(report, "jumps");
            QCOMPARE(word(jumps, 1, "way"), std::string("down"));
            places.push_back(number(jumps, 1, "frequency"));
            errors.push_back(number(jumps, 1, "uncertainty"));
        }
        const auto [lowest, highest] = std::ranges::minmax(places);
        QVERIFY2(highest - lowest <= 2.0 * std::ranges::max(errors), qPrintable(QString::number(highest - lowest)));
        QVERIFY(std::abs(places.front() - 228.8e3) < 50.0); // a slow sweep outside the program: 228.81 kHz
    }

    /// From rest at 420 kHz the slider of the sample bounces with a third of that frequency; neither way comes by.
    void otherStartsFindOtherMotions()
    {
        const StudyPlan plan = openStudy("response", "response_period_doubling", {}, {"from=380 kHz", "steps=20"});
        QVERIFY(plan.valid());
        const StudyReport one = plan.perform(1, {}), two = plan.perform(2, {});
        const StudyTable& points = table(one, "points");
        double lowest = 1e9, highest = 0.0, amplitude = 0.0;
        for (std::size_t row = 0; row < points.rows.size(); ++row) {
            if (!word(points, row, "way").starts_with("other") || number(points, row, "period") != 3.0) continue;
            lowest = std::min(lowest, number(points, row, "frequency"));
            if (number(points, row, "frequency") > highest) {
                highest = number(points, row, "frequency");
                amplitude = 0.5 * (number(points, row, "most") - number(points, row, "least"));
            }
        }
        QCOMPARE(highest, 420e3);
        QVERIFY2(std::abs(lowest - 390e3) < 2.1e3, qPrintable(QString::number(lowest)));
        // Half of the swing of a run from rest.
        QVERIFY2(std::abs(amplitude - 6.9e-9) < 0.1e-9, qPrintable(QString::number(amplitude)));
        QVERIFY(two.tables.front().rows == points.rows); // on any number of threads
    }

    /// A case without contact is linear over low waves, down to the smallest amplitude that is allowed.
    void lowWavesHaveOneLinearMotion()
    {
        Case c = openCase("springs_waviness").value;
        c.contact = noContact;
        for (const char* amplitude : {"1e-6 nm", "1e-5 nm", "1e-3 nm"}) {
            const StudyReport report =
                performed(c, "from = \"100 kHz\"\nto = \"380 kHz\"\nsteps = 60\nstarts = 40\namplitude = \"" +
                                 std::string(amplitude) + "\"\n");
            QVERIFY(table(report, "jumps").rows.empty());
            const StudyTable& points = table(report, "points");
            QCOMPARE(points.rows.size(), std::size_t(122));
            for (std::size_t row = 0; row < points.rows.size(); ++row) {
                QCOMPARE(number(points, row, "period"), 1.0);
                const double error =
                    std::abs(number(points, row, "amplitude") / number(points, row, "linear_amplitude") - 1.0);
                QVERIFY2(error < 1e-3, qPrintable(QString::number(error)));
            }
        }
        // Under a height of 10 mm such a wave is lost: 4 epsilon 10 mm = 9e-9 nm.
        const StudyPlan plan = planOf(ImpactOscillator{}.slider(), "amplitude = \"1e-6 nm\"\n");
        QVERIFY(!plan.valid());
        QCOMPARE(plan.problems.front().key, std::string("amplitude"));
    }

    /// With the speed held, the waves under both air springs are in phase each v/(d_f + d_r), 11.9 kHz.
    void stepsResolveTheBeat()
    {
        const Case c = openCase("springs_waviness").value;
        const StudyForm form = responseForm(c);
        const auto row = std::ranges::find(form.keys, "steps", &StudyKey::key);
        QVERIFY(row != form.keys.end());
        const double beat = 2.0 * std::numbers::pi * 90.0 * 0.023 / 1.095e-3; // 5400 rpm at 23 mm
        const double range = 410e3 - 45e3;
        QVERIFY(range / std::get<int>(row->standard) <= beat / 8.0);
        const std::string part = "from = \"250 kHz\"\nto = \"310 kHz\"\nstarts = 0\n";
        QVERIFY(performed(c, part).warnings.empty());
        QVERIFY(!performed(c, part + "steps = 10\n").warnings.empty());
        QCOMPARE(table(performed(c, part + "wavelength = \"50 um\"\n"), "points").rows.size(), std::size_t(2 * 61));
    }

    void repeatsItself()
    {
        const ImpactOscillator oscillator{0.05, 6.0, 0.3};
        const std::string text = overWaves(1.0, 2.0, 10);
        const StudyReport a = performed(oscillator.slider(), text), b = performed(oscillator.slider(), text);
        QVERIFY(a.tables.front().rows == b.tables.front().rows);
    }

    void stopsWhenAsked()
    {
        const Case c = openCase("springs_waviness").value;
        const StudyReport report =
            performed(c, "steps = 2000\n", [](const StudyProgress& progress) { return progress.share < 0.01; });
        QCOMPARE(report.status, StudyStatus::Cancelled);
        QVERIFY(report.findings.empty());
        QVERIFY(table(report, "points").rows.size() < 2000);
    }

    void wrongInput_data()
    {
        QTest::addColumn<QString>("case_");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("key");
        const auto row = [](const char* name, const char* c, const char* text, const char* key) {
            QTest::newRow(name) << c << text << key;
        };
        row("a film", "film_pico", "", "case");
        row("downwards", "fig10a", "from = \"200 kHz\"\nto = \"100 kHz\"\n", "to");
        row("unit", "fig10a", "from = \"200 nm\"\n", "from");
        row("too high", "fig10a", "to = \"1 GHz\"\n", "to");
        row("quantity", "fig10a", "quantity = \"roll\"\n", "quantity");
        row("no wave", "fig10a", "amplitude = 0\n", "amplitude");
        row("wavelength", "fig10a", "wavelength = \"2 m\"\n", "wavelength");
        row("speed", "fig10a", "wavelength = \"100 mm\"\nto = \"10 MHz\"\n", "to");
        row("periods", "fig10a", "periods = 1\n", "periods");
        row("unknown", "fig10a", "hold = \"1 ms\"\n", "hold");
    }
    void wrongInput()
    {
        QFETCH(QString, case_);
        QFETCH(QString, text);
        QFETCH(QString, key);
        const Case c = openCase(case_.toStdString()).value;
        const StudyPlan plan = planOf(c, text.toStdString());
        QVERIFY(!plan.valid());
        QVERIFY2(std::ranges::find(plan.problems, key.toStdString(), &InputProblem::key) != plan.problems.end(),
                 plan.problems.front().text().c_str());
    }
    void aDiskAtRestIsRefused()
    {
        Case c;
        c.disk.speed = 0.0;
        QCOMPARE(planOf(c, "").problems.front().key, std::string("case"));
    }
};

TOUCHDOWN_TEST(TestResponse)

} // namespace test_response

#include "test_response.moc"
