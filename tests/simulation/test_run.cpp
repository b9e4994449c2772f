// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run.h"

#include <cmath>
#include <numbers>

#include <QFile>
#include <QTest>

#include "core/case_files/case_file.h"
#include "core/numerics/cvode.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace {

double finalValue(const Summary& summary, const char* name)
{
    for (const auto& [quantity, value] : summary.final)
        if (quantity == name) return value;
    return NAN;
}

/// All samples of a run.
struct Trace {
    std::vector<double> time;
    std::vector<double> flyingHeight;
    std::vector<double> pitch;
    int updates = 0;
    bool finite = true;

    RunCallback recorder(const Case& c)
    {
        const auto quantities = recordedQuantities(c);
        const auto height = std::size_t(findQuantity(quantities, "flying_height"));
        const auto angle = std::size_t(findQuantity(quantities, "pitch"));
        return [this, height, angle](const RunUpdate& update) {
            ++updates;
            const SampleBatch& batch = update.samples;
            time.insert(time.end(), batch.time.begin(), batch.time.end());
            flyingHeight.insert(flyingHeight.end(), batch.columns[height].begin(), batch.columns[height].end());
            pitch.insert(pitch.end(), batch.columns[angle].begin(), batch.columns[angle].end());
            for (const auto& column : batch.columns)
                for (const double value : column) finite = finite && std::isfinite(value);
            return true;
        };
    }
};

Case sample(const char* name)
{
    const CaseDocument document = openCase(name);
    if (!document.valid()) qFatal("%s", document.problems.front().text().c_str());
    return document.value;
}

/// 1 mg on a spring of 1e3 N/m and nothing else, at rest at 10 nm; its period is 199 us.
Case massOnASpring()
{
    Case c;
    c.contact = ContactKind::None;
    c.slider.mass = 1e-6;
    c.springs.frontStiffness = c.springs.rearStiffness = 0.0;
    c.springs.frontDistance = c.springs.rearDistance = c.onoYamane.padDistance = 0.0;
    c.springs.flyingHeight = c.initial.flyingHeight = 10e-9;
    c.springs.pitch = c.initial.pitch = 0.0;
    c.suspension = {.stiffness = 1e3, .pitchStiffness = 0.0, .dampingRatio = 0.0, .pitchDampingRatio = 0.0};
    c.run.duration = 100e-6;
    c.run.stepCheck = false;
    return c;
}

void integratorRows()
{
    QTest::addColumn<int>("integrator");
    QTest::newRow("rk4") << int(IntegratorKind::Rk4);
    QTest::newRow("rk4-events") << int(IntegratorKind::Rk4Events);
    QTest::newRow("newmark") << int(IntegratorKind::Newmark);
    QTest::newRow("dopri5") << int(IntegratorKind::Dopri5);
    if (haveCvode) QTest::newRow("cvode") << int(IntegratorKind::Cvode);
}

} // namespace

class TestRun : public QObject {
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
        QVERIFY(!summary.bouncing);
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
        QVERIFY(!summary.bouncing);
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
        QVERIFY(summary.bouncing);
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

    /// The paper's own trouble: switching by looking between steps, 10 ns and 1 ns end in different states, the located
    /// methods agree with the finer one, and the program says that halving the step changes the end.
    void naiveSwitchingCanEndInTheWrongState()
    {
        Case c;
        c.springs.cutoff = 3e-9;
        c.initial.flyingHeight = 50e-9;
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
        QVERIFY(std::abs(finalValue(coarse, "flying_height") - 3.837e-9) < 0.01e-9);
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
    }

    void everySampleArrives_data() { integratorRows(); }
    void everySampleArrives()
    {
        QFETCH(int, integrator);
        Case c;
        c.run.integrator = IntegratorKind(integrator);
        c.run.step = 7e-9; // not a divisor of the sample interval
        c.run.duration = 100e-6;
        c.run.stepCheck = false;
        Trace trace;
        const Summary summary = run(c, trace.recorder(c));
        QCOMPARE(summary.status, RunStatus::Completed);
        QCOMPARE(trace.time.size(), std::size_t{1001});
        for (std::size_t i = 0; i < trace.time.size(); ++i) QVERIFY(std::abs(trace.time[i] - 1e-7 * double(i)) < 1e-18);
        QCOMPARE(summary.endTime, 100e-6);
        QCOMPARE(trace.flyingHeight.front(), 250e-9);
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
        c.contact = ContactKind::None;
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

    /// Rounding of sample times near the end of millions of samples loses none: as numbers, 9100000 * 0.11e-6 > 1.001.
    void everyOneOfMillionsOfSamplesArrives()
    {
        Case c = massOnASpring();
        c.suspension.stiffness = 0.0;
        c.run.duration = 1.001;
        c.run.sampleInterval = 0.11e-6;
        long long count = 0;
        run(c, [&](const RunUpdate& update) {
            count += static_cast<long long>(update.samples.size());
            return true;
        });
        QCOMPARE(count, 9100001LL);
    }

    /// Free flight is one step with a million samples in it: it stops at the batch at which it is told to.
    void cancellingWithinAStep()
    {
        Case c = massOnASpring();
        c.suspension.stiffness = 0.0;
        c.run.sampleInterval = 1e-6 * c.run.duration;
        int updates = 0;
        std::size_t samples = 0;
        const Summary summary = run(c, [&](const RunUpdate& update) {
            samples += update.samples.size();
            return ++updates < 3;
        });
        QCOMPARE(summary.status, RunStatus::Cancelled);
        QCOMPARE(updates, 4); // the last one hands on what was left
        QVERIFY(samples < 4 * 1024);
        QVERIFY(summary.endTime >= double(samples - 1) * c.run.sampleInterval &&
                summary.endTime < 0.01 * c.run.duration);
    }
    void cancelling()
    {
        Case c;
        c.run.duration = 10.0;
        c.run.sampleInterval = 1e-6;
        int updates = 0;
        bool behind = true; // no sample is of a time not yet reached
        const Summary summary = run(c, [&](const RunUpdate& update) {
            for (const double t : update.samples.time) behind = behind && t <= update.time;
            return ++updates < 3;
        });
        QVERIFY(behind);
        QCOMPARE(summary.status, RunStatus::Cancelled);
        QCOMPARE(updates, 4); // the last one hands on what was left
        QVERIFY(summary.endTime > 0.0 && summary.endTime < 10.0);
    }
    void repeatsToTheBit()
    {
        const Case c = sample("fig14b");
        Trace a, b;
        run(c, a.recorder(c));
        run(c, b.recorder(c));
        QVERIFY(a.flyingHeight == b.flyingHeight);
        QVERIFY(a.pitch == b.pitch);
    }

    void everySampleCaseRuns_data()
    {
        QTest::addColumn<QString>("name");
        for (const SampleCase& sample : sampleCases())
            if (parseCase(sample.text, sample.name).value.model == ModelKind::Springs)
                QTest::newRow(sample.name.c_str()) << QString::fromStdString(sample.name);
    }
    void everySampleCaseRuns()
    {
        QFETCH(QString, name);
        const Case c = sample(qPrintable(name));
        Trace trace;
        const Summary summary = run(c, trace.recorder(c));
        QCOMPARE(summary.status, name == "fig12b" ? RunStatus::Failed : RunStatus::Completed);
        QCOMPARE(summary.endTime, c.run.duration);
        QVERIFY(trace.finite);
        QVERIFY(!summary.tail.empty());
        // No sustained bouncing on a flat disk, as the paper found; the undamped textbook bounce is meant to go on.
        QCOMPARE(summary.bouncing, name == "textbook_bounce");
    }
    void aFilmCaseRecordsItsAttitude()
    {
        const Case c = sample("film_plane");
        QVERIFY(reasonNotToRun(c).empty());
        for (const char* name : {"flying_height", "minimum_spacing", "pitch", "roll", "air_bearing_force", "energy"})
            QVERIFY2(findQuantity(recordedQuantities(c), name) >= 0, name);
        QCOMPARE(recordedFields(c).size(), std::size_t(1)); // of the film; there is no contact
    }
};

TOUCHDOWN_TEST(TestRun)
#include "test_run.moc"
