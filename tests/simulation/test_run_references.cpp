// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs against exact solutions, SciPy, and the states that the paper names.
#include "core/simulation/run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QFile>
#include <QTest>

#include "core/case/integrator_kind.h"
#include "core/case_files/case_file.h"
#include "core/numerics/cvode.h"
#include "tests/simulation/run_trace.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_run_references {

class TestRunReferences : public QObject {
    Q_OBJECT

private slots:
    /// What the paper says of Figs. 10 to 14, at the digits that it prints, and the equilibria of the same balances of
    /// forces and moments, solved by SciPy's fsolve (0: there is none to compare with).
    void endStatesOfThePaper_data()
    {
        QTest::addColumn<double>("flyingHeight"); // [nm]
        QTest::addColumn<double>("pitch");        // [urad]; 0: none is printed
        QTest::addColumn<double>("solvedHeight");
        QTest::addColumn<double>("solvedPitch");
        QTest::addColumn<bool>("inContact");
        for (const char* flies : {"fig10a", "fig10b", "fig11a", "fig11b"})
            QTest::newRow(flies) << 7.0 << 0.0 << 7.0 << 90.6 << false;
        QTest::newRow("fig12a") << 1.6 << 94.2 << 1.60178 << 94.1717 << true;
        for (const char* caught : {"fig13a", "fig13b"})
            QTest::newRow(caught) << 3.8 << 94.2 << 3.79943 << 94.1709 << true;
    }
    void endStatesOfThePaper()
    {
        QFETCH(double, flyingHeight);
        QFETCH(double, pitch);
        QFETCH(double, solvedHeight);
        QFETCH(double, solvedPitch);
        QFETCH(bool, inContact);
        const Summary summary = run(sample(QTest::currentDataTag()));
        QCOMPARE(summary.status, RunStatus::Completed);
        const double height = 1e9 * finalValue(summary, "flying_height");
        const double angle = 1e6 * finalValue(summary, "pitch");
        QVERIFY2(std::abs(height - flyingHeight) < 0.05, qPrintable(QString::number(height)));
        if (pitch > 0.0) QVERIFY2(std::abs(angle - pitch) < 0.05, qPrintable(QString::number(angle)));
        QVERIFY(std::abs(height - solvedHeight) < 0.0005);
        QVERIFY(std::abs(angle - solvedPitch) < 0.01);
        // "The slider contacts the disk, which is shown from the non-zero contact force and non-zero system energy."
        QCOMPARE(finalValue(summary, "net_contact_force") != 0.0, inContact);
        QCOMPARE(finalValue(summary, "energy") > 1e-13, inContact);
        QVERIFY(!summary.bouncing());
    }

    /// "In both cases [Fig. 10 a, b] the spacing at the rear air bearing center is always above d_1"; "the slider's
    /// dynamics doesn't change with d_1".
    void theRearSpacingOfFig10StaysAboveBothCutoffs()
    {
        std::vector<std::vector<double>> heights;
        for (const char* name : {"fig10a", "fig10b"}) {
            const Case c = sample(name);
            Trace trace;
            const auto recorder = trace.recorder(c);
            const auto rear = std::size_t(findQuantity(recordedQuantities(c), "rear_spacing"));
            double least = 1.0;
            const Summary summary = run(c, [&](const RunUpdate& update) {
                for (const double spacing : update.samples.columns[rear]) least = std::min(least, spacing);
                return recorder(update);
            });
            QVERIFY2(least > c.onoYamane.touchDown, qPrintable(QString::number(least)));
            for (const RunEvent& event : summary.events) QVERIFY(event.name != "rear spring lost");
            heights.push_back(trace.flyingHeight);
        }
        QVERIFY(heights[0] == heights[1]);
    }

    /// Extremes are those of the motion, not of the samples: 3.120 nm by an independent integration with RK4 steps of
    /// 1 ns. Samples of 0.1 us miss it by 0.12 nm.
    void extremesDoNotDependOnTheSamples_data()
    {
        QTest::addColumn<double>("interval"); // [s]
        for (const double us : {0.01, 0.1, 1.0, 10.0, 37.0})
            QTest::newRow(qPrintable(QString("%1 us").arg(us))) << 1e-6 * us;
    }
    void extremesDoNotDependOnTheSamples()
    {
        QFETCH(double, interval);
        Case c = sample("fig10b");
        c.run.sampleInterval = interval;
        for (const auto& [name, extremes] : run(c).extremes) {
            if (name == "rear_spacing") QVERIFY(std::abs(extremes.least - 3.120e-9) < 0.001e-9);
            if (name == "flying_height") QVERIFY(std::abs(extremes.most - 250e-9) < 50e-9); // the start
        }
        // The swing of the tail, too: about 0.03 nm of ringing.
        c = sample("fig14a");
        const auto swing = [](const Summary& summary) {
            for (const auto& [name, tail] : summary.tail)
                if (name == "flying_height") return tail.max - tail.min;
            return 0.0;
        };
        const double expected = swing(run(c));
        c.run.sampleInterval = std::min(interval, 10e-6);
        const double found = swing(run(c));
        QVERIFY2(std::abs(found / expected - 1.0) < 0.05, qPrintable(QString("%1 %2").arg(found).arg(expected)));
    }

    /// Fig. 12 (b): "the spacing at the rear air bearing center is sometimes less than d_s", "negative values of
    /// system energy".
    void aSpringLostForGoodIsAFailure()
    {
        Case c = sample("fig12b");
        const Summary summary = run(c);
        QCOMPARE(summary.status, RunStatus::Failed);
        QVERIFY(QByteArray(summary.message.c_str()).contains("rear air spring is lost for good"));
        QVERIFY(QByteArray(summary.message.c_str()).contains("outside the model"));
        QVERIFY(std::abs(finalValue(summary, "flying_height") + 5.04e-9) < 0.01e-9);
        c.springs.potential = PotentialBelowCutoff::AsPrinted;
        QCOMPARE(run(c).failure, RunFailure::NegativeEnergy);
    }

    /// Fig. 14: "the low air bearing damping ratios only cause a slow decay", to "the slider's static state"; with
    /// d_1 = d_s "initially the spacing at the rear air bearing center becomes less than d_1, the system energy becomes
    /// negative".
    void lowDampingStillRingsAtTheEnd()
    {
        for (const char* name : {"fig14a", "fig14b"}) {
            const Summary summary = run(sample(name));
            QCOMPARE(summary.status, RunStatus::Completed);
            QCOMPARE(summary.verdict.motion, Motion::Settles);
            for (const auto& [quantity, tail] : summary.tail) {
                if (quantity != "flying_height") continue;
                QVERIFY(std::abs(tail.mean - 7e-9) < 0.002e-9);
                QVERIFY(tail.max - tail.min > 0.005e-9 && tail.max - tail.min < 0.2e-9);
            }
        }
        Case c = sample("fig14b");
        c.springs.potential = PotentialBelowCutoff::AsPrinted;
        const Summary negative = run(c);
        QCOMPARE(negative.failure, RunFailure::NegativeEnergy);
        QVERIFY(negative.endTime < 50e-6);
    }

    /// Table III: steady states, none bounces. The equilibria by SciPy's fsolve: 2.6473 and 2.3298 nm.
    void lowerSlidersRestInContact_data()
    {
        QTest::addColumn<double>("flyingHeight"); // [nm]
        QTest::newRow("table3_4nm_from_100nm") << 2.6473;
        QTest::newRow("table3_4nm_from_250nm") << 2.6473;
        QTest::newRow("table3_3nm_from_100nm") << 2.3298;
        QTest::newRow("table3_3nm_from_250nm") << 2.3298;
    }
    void lowerSlidersRestInContact()
    {
        QFETCH(double, flyingHeight);
        const Summary summary = run(sample(QTest::currentDataTag()));
        QCOMPARE(summary.status, RunStatus::Completed);
        QCOMPARE(summary.verdict.motion, Motion::AtRest);
        QVERIFY(std::abs(1e9 * finalValue(summary, "flying_height") - flyingHeight) < 0.003);
    }

    /// Why the first stand-ins for Table II were left: they contradict the sentence on Fig. 10, and miss two numbers.
    void theFirstStandInsContradictThePaper()
    {
        Case c = sample("fig10b_first_set");
        int lost = 0;
        for (const RunEvent& event : run(c).events) lost += event.name == "rear spring lost";
        QCOMPARE(lost, 1);
        c.onoYamane.takeOff = 8e-9;
        c.springs.cutoff = 0.3e-9;
        const Summary caught = run(c);
        QVERIFY(std::abs(1e6 * finalValue(caught, "pitch") - 93.203) < 0.01);
    }

    /// A spring that goes and comes back on the way is an event, not a failure.
    void aSpringCaughtAgainIsAnEvent()
    {
        Case c = sample("fig14b");
        const Summary summary = run(c);
        QCOMPARE(summary.status, RunStatus::Completed);
        int lost = 0, caught = 0;
        for (const RunEvent& event : summary.events) {
            lost += event.name == "rear spring lost";
            caught += event.name == "rear spring caught";
        }
        QVERIFY(lost > 0);
        QCOMPARE(caught, lost);
    }

    /// tests/support/scipy_reference.py: an independent program, method and unit system.
    void agreesWithSciPy_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("light slider, springs lost and caught") << "light";
        QTest::newRow("linear take-off, start in contact") << "linear";
    }
    void agreesWithSciPy()
    {
        QFETCH(QString, name);
        Case c;
        if (name == "light") {
            c.slider = {.mass = 0.9e-6, .pitchInertia = 0.8e-13, .thickness = 0.23e-3};
            c.springs = {.frontStiffness = 4.1e5,
                         .rearStiffness = 0.9e6,
                         .frontDistance = 0.31e-3,
                         .rearDistance = 0.37e-3,
                         .padDistance = 0.41e-3,
                         .frontDampingRatio = 0.03,
                         .rearDampingRatio = 0.04,
                         .cutoff = 2.6e-9,
                         .flyingHeight = 6e-9,
                         .pitch = 130e-6,
                         .potential = PotentialBelowCutoff::Held};
            c.suspension = {
                .stiffness = 11.0, .pitchStiffness = 0.9e-4, .dampingRatio = 0.02, .pitchDampingRatio = 0.03};
            c.onoYamane = {.meniscusForce = 14e-3,
                           .contactStiffness = 3.3e6,
                           .initialContactForce = 4e-3,
                           .touchDown = 2.8e-9,
                           .takeOff = 5.7e-9,
                           .friction = 0.45,
                           .takeOffShape = TakeOffShape::Constant};
            c.initial = {.flyingHeight = 60e-9,
                         .pitch = 40e-6,
                         .verticalVelocity = -0.02,
                         .pitchVelocity = 60.0,
                         .branch = ContactBranch::TouchDown};
            c.run.duration = 300e-6;
        } else {
            c.slider = {.mass = 1.5e-6, .pitchInertia = 2.0e-13, .thickness = 0.3e-3};
            c.springs = {.frontStiffness = 6e5,
                         .rearStiffness = 1.2e6,
                         .frontDistance = 0.45e-3,
                         .rearDistance = 0.52e-3,
                         .padDistance = 0.58e-3,
                         .frontDampingRatio = 0.02,
                         .rearDampingRatio = 0.03,
                         .cutoff = 0.5e-9,
                         .flyingHeight = 8e-9,
                         .pitch = 100e-6,
                         .potential = PotentialBelowCutoff::Held};
            c.onoYamane = {.meniscusForce = 6e-3,
                           .contactStiffness = 5e6,
                           .initialContactForce = 5e-3,
                           .touchDown = 3e-9,
                           .takeOff = 5e-9,
                           .friction = 0.3,
                           .takeOffShape = TakeOffShape::Linear};
            c.initial = {.flyingHeight = 2e-9,
                         .pitch = 100e-6,
                         .verticalVelocity = 0.0,
                         .pitchVelocity = 0.0,
                         .branch = ContactBranch::TouchDown};
            c.run.duration = 200e-6;
        }
        c.run.sampleInterval = 1e-6;

        QFile file(QStringLiteral(TOUCHDOWN_SOURCE_DIR "/tests/simulation/springs/scipy_reference_%1.csv").arg(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        std::vector<std::array<double, 3>> reference;
        std::vector<double> switches;
        for (const QByteArray& line : file.readAll().split('\n')) {
            const QList<QByteArray> words = line.split(',');
            if (line.startsWith("# switch at "))
                switches.push_back(line.split(' ')[3].toDouble() * 1e-6);
            else if (words.size() == 3 && words[0] != "time [us]")
                reference.push_back(
                    {words[0].toDouble() * 1e-6, words[1].toDouble() * 1e-9, words[2].toDouble() * 1e-6});
        }
        Trace trace;
        const Summary summary = run(c, trace.recorder(c));
        QCOMPARE(summary.status, RunStatus::Completed);
        QCOMPARE(trace.time.size(), reference.size());
        for (std::size_t i = 0; i < reference.size(); ++i) {
            QVERIFY(std::abs(trace.time[i] - reference[i][0]) < 1e-15);
            QVERIFY2(std::abs(trace.flyingHeight[i] - reference[i][1]) < 1e-4 * 1e-9,
                     qPrintable(QString::number(trace.time[i])));
            QVERIFY(std::abs(trace.pitch[i] - reference[i][2]) < 1e-3 * 1e-6);
        }
        QCOMPARE(summary.events.size(), switches.size());
        for (std::size_t i = 0; i < switches.size(); ++i)
            QVERIFY(std::abs(summary.events[i].time - switches[i]) < 2e-12);
    }

    /// The textbook oscillator against its formula, by every integrator.
    void textbookOscillator_data()
    {
        QTest::addColumn<int>("integrator");
        QTest::addColumn<double>("allowed"); // of the amplitude [-]
        QTest::newRow("rk4") << int(IntegratorKind::Rk4) << 1e-9;
        QTest::newRow("rk4-events") << int(IntegratorKind::Rk4Events) << 1e-9;
        QTest::newRow("newmark") << int(IntegratorKind::Newmark) << 1e-3;
        QTest::newRow("dopri5") << int(IntegratorKind::Dopri5) << 1e-6;
        if (haveCvode) QTest::newRow("cvode") << int(IntegratorKind::Cvode) << 1e-4;
    }
    void textbookOscillator()
    {
        QFETCH(int, integrator);
        QFETCH(double, allowed);
        Case c = sample("textbook_oscillator");
        c.run.integrator = IntegratorKind(integrator);
        const double omega = std::sqrt(c.suspension.stiffness / c.slider.mass);
        c.run.step = 0.002 / omega;
        Trace trace;
        QCOMPARE(run(c, trace.recorder(c)).status, RunStatus::Completed);
        const double zeta = c.suspension.dampingRatio;
        const double damped = omega * std::sqrt(1.0 - zeta * zeta);
        const double amplitude = c.initial.flyingHeight - c.springs.flyingHeight;
        double worst = 0.0;
        for (std::size_t i = 0; i < trace.time.size(); ++i) {
            const double t = trace.time[i];
            const double exact = amplitude * std::exp(-zeta * omega * t) *
                                 (std::cos(damped * t) + zeta * omega / damped * std::sin(damped * t));
            worst = std::max(worst, std::abs(trace.flyingHeight[i] - c.springs.flyingHeight - exact));
        }
        QVERIFY2(worst < allowed * std::abs(amplitude), qPrintable(QString::number(worst / std::abs(amplitude))));
    }

    /// The bilinear bounce repeats itself for ever: sustained, with the period pi/w1 + pi/w2.
    void textbookBounceIsSustained()
    {
        const Case c = sample("textbook_bounce");
        const Summary summary = run(c);
        QCOMPARE(summary.status, RunStatus::Completed);
        QCOMPARE(summary.verdict.motion, Motion::Bounces);
        const double w1 = std::sqrt(c.suspension.stiffness / c.slider.mass);
        const double w2 = std::sqrt((c.suspension.stiffness + c.onoYamane.contactStiffness) / c.slider.mass);
        const double frequency = 1.0 / (std::numbers::pi / w1 + std::numbers::pi / w2);
        std::vector<double> touchDowns;
        for (const RunEvent& event : summary.events)
            if (event.name == "touch-down") touchDowns.push_back(event.time);
        QVERIFY(touchDowns.size() > 3);
        for (std::size_t i = 1; i < touchDowns.size(); ++i)
            QVERIFY(std::abs((touchDowns[i] - touchDowns[i - 1]) * frequency - 1.0) < 1e-6);
        QVERIFY(!summary.peaks.empty());
        QVERIFY(std::abs(summary.peaks.front().frequency / frequency - 1.0) < 0.05);
    }

    /// Different methods, one motion: samples agree before the first switches can part them.
    void integratorsAgree()
    {
        Case c;
        c.run.duration = 40e-6;
        c.run.stepCheck = false;
        c.run.tolerance = 1e-11;
        Trace reference;
        run(c, reference.recorder(c));
        c.run.step = 2e-9;
        for (const IntegratorKind kind : {IntegratorKind::Rk4Events, IntegratorKind::Newmark, IntegratorKind::Cvode}) {
            if (kind == IntegratorKind::Cvode && !haveCvode) continue;
            c.run.integrator = kind;
            Trace trace;
            QCOMPARE(run(c, trace.recorder(c)).status, RunStatus::Completed);
            for (std::size_t i = 0; i < trace.time.size(); ++i)
                QVERIFY2(std::abs(trace.flyingHeight[i] - reference.flyingHeight[i]) < 0.01e-9,
                         qPrintable(QStringLiteral("%1 at %2").arg(int(kind)).arg(trace.time[i])));
        }
    }

    void freeFlight_data() { integratorRows(); }
    /// Nothing pushes: from 10 nm to 10 nm + v t, a thousand million heights away, with the tightest tolerance.
    void freeFlight()
    {
        QFETCH(int, integrator);
        Case c = massOnASpring();
        c.suspension.stiffness = 0.0;
        c.initial.verticalVelocity = 1000.0;
        c.run.integrator = IntegratorKind(integrator);
        c.run.tolerance = 1e-14;
        const Summary summary = run(c);
        QVERIFY2(summary.status == RunStatus::Completed, summary.message.c_str());
        QVERIFY(std::abs(finalValue(summary, "flying_height") / (10e-9 + 1000.0 * c.run.duration) - 1.0) < 1e-12);
    }
};

TOUCHDOWN_TEST(TestRunReferences)

} // namespace test_run_references

#include "test_run_references.moc"
