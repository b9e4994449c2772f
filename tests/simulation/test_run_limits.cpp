// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where methods and models end: runs that fail say so, and runs that only look like failures do not.
#include "core/case/contact_kind.h"
#include "core/case/integrator_kind.h"
#include "core/formats/units.h"
#include "core/simulation/run.h"

#include <cmath>

#include <QTest>

#include "core/case_files/case_file.h"
#include "tests/simulation/run_trace.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_run_limits {

class TestRunLimits : public QObject {
    Q_OBJECT

private slots:
    /// The paper's own trouble: switching by looking between steps, 10 ns and 1 ns end in different states, the located
    /// methods agree with the finer one, and the program says that halving the step changes the end.
    void naiveSwitchingCanEndInTheWrongState()
    {
        Case c;
        c.springs.cutoff = 3e-9;
        c.initial.flyingHeight = 230e-9;
        c.run.integrator = IntegratorKind::Rk4;
        c.run.step = 10e-9;
        const Summary coarse = run(c);
        QVERIFY(coarse.stepCheck.has_value());
        QVERIFY(!coarse.stepCheck->sameEndState);
        QVERIFY(!coarse.warnings.empty());
        QVERIFY(QByteArray(coarse.warnings.front().c_str()).contains("changes the end state"));
        c.run.step = 1e-9;
        c.run.stepCheck = false;
        const Summary fine = run(c);
        QVERIFY(!fine.stepCheck.has_value());
        c.run.integrator = IntegratorKind::Rk4Events;
        c.run.step = 10e-9;
        const Summary located = run(c);
        c.run.integrator = IntegratorKind::Dopri5;
        const Summary adaptive = run(c);
        QVERIFY(std::abs(finalValue(coarse, "flying_height") - 3.799e-9) < 0.01e-9);
        for (const Summary* good : {&fine, &located, &adaptive})
            QVERIFY(std::abs(finalValue(*good, "flying_height") - 7e-9) < 0.01e-9);
    }

    void aGoodStepSaysSo()
    {
        Case c;
        c.run.integrator = IntegratorKind::Rk4Events;
        const Summary summary = run(c);
        QVERIFY(summary.stepCheck && summary.stepCheck->sameEndState);
        QVERIFY(summary.warnings.empty());
        QCOMPARE(summary.stepCheck->step, 5e-9);
    }

    void tooLongAStepFailsClearly_data()
    {
        QTest::addColumn<int>("integrator");
        QTest::addColumn<double>("step");
        for (const double step : {1e-6, 3e-6}) {
            QTest::addRow("rk4, %g us", step * 1e6) << int(IntegratorKind::Rk4) << step;
            QTest::addRow("rk4-events, %g us", step * 1e6) << int(IntegratorKind::Rk4Events) << step;
        }
    }
    /// Beyond 2.83/omega rk4 cannot follow the rear spring: a wall jumped, a spring lost or a divergence, in words, and
    /// only numbers.
    void tooLongAStepFailsClearly()
    {
        QFETCH(int, integrator);
        QFETCH(double, step);
        Case c;
        c.run.integrator = IntegratorKind(integrator);
        c.run.step = step;
        c.run.stepCheck = false;
        Trace trace;
        const Summary summary = run(c, trace.recorder(c));
        QVERIFY(summary.status == RunStatus::Failed || summary.status == RunStatus::Diverged);
        QVERIFY(!summary.message.empty());
        QVERIFY(summary.endTime <= c.run.duration);
        QVERIFY(trace.finite);
        for (const auto& [name, value] : summary.final) QVERIFY(std::isfinite(value));
    }

    /// However loose, the adaptive method does not jump the wall.
    void looseToleranceDoesNotTunnel()
    {
        for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
            Case c;
            c.run.tolerance = tolerance;
            const Summary summary = run(c);
            QCOMPARE(summary.status, RunStatus::Completed);
            const double height = finalValue(summary, "flying_height");
            QVERIFY2(height > 2e-9 && height < 10e-9, qPrintable(QString::number(height)));
        }
    }

    /// Equation (5) as printed: with d_1 = d_s the rear spacing becomes negative, and so does the energy.
    void energyAsPrintedFailsWhereItHasNoMeaning()
    {
        Case c = sample("fig12b");
        c.springs.potential = PotentialBelowCutoff::AsPrinted;
        Trace trace;
        const Summary summary = run(c, trace.recorder(c));
        QCOMPARE(summary.status, RunStatus::Failed);
        QVERIFY(QByteArray(summary.message.c_str()).contains("energy became negative"));
        QVERIFY(summary.endTime < 0.1e-3);
        QVERIFY(trace.time.back() <= summary.endTime);
        // The message and the summary name one time: that of the state which failed.
        QVERIFY2(summary.message.find(" at " + fewDigitsOfTime(summary.endTime, 4) + ":") != std::string::npos,
                 summary.message.c_str());
        QCOMPARE(summary.endTime, 25.3e-6);
    }

    /// A spring without stiffness is not there: no height loses it, and z = 0 is a place as any other.
    void anAbsentSpringIsNotLost_data() { integratorRows(); }
    void anAbsentSpringIsNotLost()
    {
        QFETCH(int, integrator);
        Case c = massOnASpring();
        c.run.integrator = IntegratorKind(integrator);
        c.initial.flyingHeight = 0.0;
        Trace trace;
        const Summary summary = run(c, trace.recorder(c));
        QVERIFY2(summary.status == RunStatus::Completed, summary.message.c_str());
        QVERIFY(trace.finite);
        QVERIFY(summary.events.empty());
        // From -10 nm about the static state: a cosine.
        const double omega = std::sqrt(c.suspension.stiffness / c.slider.mass);
        QVERIFY(std::abs(finalValue(summary, "flying_height") - (10e-9 - 10e-9 * std::cos(omega * c.run.duration))) <
                1e-4 * 10e-9);
    }

    /// At rest, but for the round-off of the pitch between steps.
    void aMotionWithoutEnergyIsNoDivergence()
    {
        Case c = massOnASpring();
        c.suspension.stiffness = 0.0;
        c.suspension.pitchStiffness = 1.7e-5;
        c.springs.pitch = c.initial.pitch = 98.43e-6;
        QCOMPARE(run(c).status, RunStatus::Completed);
    }

    /// Let go from 10 um deep in a contact of 1e6 N/m: 1e6/2 (1e-5)^2 = 5e-5 J, the speed of 1e-6 kg becomes 10 m/s.
    void energyOfTheContactIsNoDivergence()
    {
        Case c = massOnASpring();
        c.contact = ContactKind::OnoYamane;
        c.suspension.stiffness = 0.0;
        c.onoYamane.contactStiffness = 1e6;
        c.onoYamane.initialContactForce = c.onoYamane.meniscusForce = c.onoYamane.friction = 0.0;
        c.onoYamane.touchDown = c.onoYamane.takeOff = 0.0;
        c.initial.flyingHeight = -10e-6;
        const Summary summary = run(c);
        QVERIFY2(summary.status == RunStatus::Completed, summary.message.c_str());
        QVERIFY(std::abs(finalValue(summary, "vertical_velocity") / 10.0 - 1.0) < 1e-3);
    }

    /// Pressed against the wall by a large meniscus force, the pad swings about d_s more than a thousand times as fast
    /// as at rest. Many switches, but two in a swing.
    void fastSwitchingAtTheWallIsNotChattering()
    {
        Case c = massOnASpring();
        c.contact = ContactKind::OnoYamane;
        c.springs.rearStiffness = 1e6;
        c.springs.rearDampingRatio = 0.0;
        c.springs.flyingHeight = 100e-9;
        c.springs.cutoff = 0.3e-9;
        c.onoYamane.meniscusForce = 1e3; // rests where 1e6 N/m (100 nm)^2/z^2 (100 nm - z) = 1e3 N: near z = 1 nm
        c.onoYamane.contactStiffness = 1.0;
        c.onoYamane.initialContactForce = c.onoYamane.friction = 0.0;
        c.onoYamane.touchDown = 1e-9;
        c.onoYamane.takeOff = 1e-6;
        c.initial.flyingHeight = 1.1e-9;
        c.initial.branch = ContactBranch::TakeOff;
        c.run.duration = 1e-6;
        c.run.sampleInterval = 1e-9;
        c.run.step = 0.1e-9;
        for (const IntegratorKind kind : {IntegratorKind::Dopri5, IntegratorKind::Rk4Events}) {
            c.run.integrator = kind;
            const Summary summary = run(c);
            QVERIFY2(summary.status == RunStatus::Completed, summary.message.c_str());
            // omega^2 = k z_0^2 (2 z_0 - z)/(M z^3) at 1 nm: a swing takes 4.5 ns.
            QVERIFY2(summary.events.size() > 200, qPrintable(QString::number(summary.events.size())));
        }
    }

    /// What a lost spring leaves is said as it is: without contact no pad hangs on anything.
    void aLostSpringWithoutContact()
    {
        Case c;
        c.contact = noContact;
        c.initial.verticalVelocity = -1.0;
        c.run.duration = 0.2e-3; // the suspension brings it back after 1.6 ms
        const Summary summary = run(c);
        QCOMPARE(summary.status, RunStatus::Failed);
        QVERIFY(QByteArray(summary.message.c_str()).contains("is lost for good"));
        QVERIFY(!QByteArray(summary.message.c_str()).contains("contact"));
    }

    /// The last values are of a state that was looked at, also when the motion outgrows all numbers between two
    /// samples.
    void theEndOfADivergedRunIsSane()
    {
        for (const IntegratorKind kind : {IntegratorKind::Rk4, IntegratorKind::Rk4Events}) {
            Case c = massOnASpring();
            c.initial.flyingHeight = 20e-9;
            c.run.integrator = kind;
            c.run.step = 100.0 * std::sqrt(c.slider.mass / c.suspension.stiffness); // far beyond 2.83/omega
            c.run.duration = c.run.sampleInterval = 1e4 * c.run.step;
            const Summary summary = run(c);
            QCOMPARE(summary.status, RunStatus::Diverged);
            QCOMPARE(summary.final.size(), recordedQuantities(c).size());
            QVERIFY(std::abs(finalValue(summary, "flying_height")) < 1e-3);
        }
    }
};

TOUCHDOWN_TEST(TestRunLimits)

} // namespace test_run_limits

#include "test_run_limits.moc"
