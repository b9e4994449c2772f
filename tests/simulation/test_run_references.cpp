// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs against exact solutions, SciPy, and the states that the paper names.
#include "core/simulation/run.h"

#include <cmath>
#include <numbers>

#include <QFile>
#include <QTest>

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
    /// Converged end states of the stand-in parameter set, found by others (event-located Dormand-Prince, SciPy).
    void paperTable_data()
    {
        QTest::addColumn<double>("friction");
        QTest::addColumn<double>("meniscusForce");
        QTest::addColumn<double>("takeOff");
        QTest::addColumn<double>("cutoff");
        QTest::addColumn<double>("flyingHeight");
        QTest::addColumn<double>("pitch");
        QTest::newRow("default, d_1 = 0.3 nm") << 0.3 << 10e-3 << 5e-9 << 0.3e-9 << 7.000e-9 << 90.00e-6;
        QTest::newRow("default, d_1 = d_s") << 0.3 << 10e-3 << 5e-9 << 3e-9 << 7.000e-9 << 90.00e-6;
        QTest::newRow("mu = 2.0, d_1 = 0.3 nm") << 2.0 << 10e-3 << 5e-9 << 0.3e-9 << 7.000e-9 << 90.00e-6;
        QTest::newRow("mu = 2.0, d_1 = d_s") << 2.0 << 10e-3 << 5e-9 << 3e-9 << 7.000e-9 << 90.00e-6;
        QTest::newRow("f_m = 50 mN, d_1 = 0.3 nm") << 0.3 << 50e-3 << 5e-9 << 0.3e-9 << 1.5929e-9 << 95.613e-6;
        QTest::newRow("d_e = 8 nm, d_1 = 0.3 nm") << 0.3 << 10e-3 << 8e-9 << 0.3e-9 << 3.8369e-9 << 93.203e-6;
        QTest::newRow("d_e = 8 nm, d_1 = d_s") << 0.3 << 10e-3 << 8e-9 << 3e-9 << 3.8369e-9 << 93.203e-6;
    }
    void paperTable()
    {
        QFETCH(double, friction);
        QFETCH(double, meniscusForce);
        QFETCH(double, takeOff);
        QFETCH(double, cutoff);
        QFETCH(double, flyingHeight);
        QFETCH(double, pitch);
        Case c;
        c.onoYamane.friction = friction;
        c.onoYamane.meniscusForce = meniscusForce;
        c.onoYamane.takeOff = takeOff;
        c.springs.cutoff = cutoff;
        const Summary summary = run(c);
        QCOMPARE(summary.status, RunStatus::Completed);
        QVERIFY(std::abs(finalValue(summary, "flying_height") - flyingHeight) < 0.001e-9);
        QVERIFY(std::abs(finalValue(summary, "pitch") - pitch) < 0.01e-6);
        QVERIFY(!summary.bouncing());
    }

    void aSpringLostForGoodIsAFailure()
    {
        const Summary summary = run(sample("fig12b"));
        QCOMPARE(summary.status, RunStatus::Failed);
        QVERIFY(QByteArray(summary.message.c_str()).contains("rear air spring is lost for good"));
        QVERIFY(QByteArray(summary.message.c_str()).contains("outside the model"));
        QVERIFY(std::abs(finalValue(summary, "flying_height") + 5.607e-9) < 0.001e-9);
        QVERIFY(std::abs(finalValue(summary, "pitch") - 98.13e-6) < 0.01e-6);
    }

    void lowDampingStillRingsAtTheEnd()
    {
        const Summary summary = run(sample("fig14a"));
        QCOMPARE(summary.status, RunStatus::Completed);
        for (const auto& [name, tail] : summary.tail) {
            if (name != "flying_height") continue;
            QVERIFY(std::abs(tail.mean - 7e-9) < 0.002e-9);
            QVERIFY(tail.max - tail.min > 0.005e-9 && tail.max - tail.min < 0.2e-9);
        }
        QVERIFY(!summary.bouncing());
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
                           .padDistance = 0.41e-3,
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
                           .padDistance = 0.58e-3,
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
        QCOMPARE(summary.motion, Motion::Bounces);
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
