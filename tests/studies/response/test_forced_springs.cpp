// SPDX-License-Identifier: GPL-3.0-or-later
//
// Amplitude and phase of forced motion against the exact answer of a linear oscillator and against long runs.
#include "core/studies/response/forced_springs.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include <QTest>

#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "core/studies/response/settled_motion.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_forced_springs {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double waveAmplitude = 1e-9; // [m]

/// The pad stays on the contact stiffness, which is linear: M z" + c z' + k (z - z_0) = k_c (d_s - z + w).
Case linearOscillator(double stiffness, double ratio, double contactStiffness, double mass)
{
    Case c;
    c.slider.mass = mass;
    c.springs.frontStiffness = c.springs.rearStiffness = 0.0;
    c.springs.flyingHeight = 100e-9;
    c.springs.pitch = c.initial.pitch = 0.0;
    c.suspension.stiffness = stiffness;
    c.suspension.dampingRatio = ratio;
    c.onoYamane = {.meniscusForce = 0.0,
                   .contactStiffness = contactStiffness,
                   .initialContactForce = 0.0,
                   .touchDown = 1e-6,
                   .takeOff = 1e-6,
                   .friction = 0.0,
                   .takeOffShape = TakeOffShape::Constant};
    c.springs.padDistance = 0.0;
    c.initial.flyingHeight =
        (stiffness * 100e-9 + contactStiffness * 1e-6) / (stiffness + contactStiffness) - 3e-9; // not at rest
    return c;
}

/// First harmonic of a run from 400 to 432 periods, against the disk under the pad.
Complex harmonicOfRun(Case c, const char* quantity, double frequency, double begin)
{
    constexpr int samples = 256; // of a period
    c.run.tolerance = 1e-11;
    c.run.sampleInterval = 1.0 / frequency / samples;
    c.run.duration = 432.0 / frequency;
    const auto column = static_cast<std::size_t>(findQuantity(recordedQuantities(c), quantity));
    std::vector<double> time, values;
    run(c, [&](const RunUpdate& update) {
        time.insert(time.end(), update.samples.time.begin(), update.samples.time.end());
        if (update.samples.columns.empty()) return true;
        const std::vector<double>& more = update.samples.columns[column];
        values.insert(values.end(), more.begin(), more.end());
        return true;
    });
    Complex sum = 0.0;
    constexpr std::size_t taken = 32 * samples;
    for (std::size_t k = values.size() - taken; k < values.size(); ++k)
        sum += values[k] * std::polar(1.0, -2.0 * pi * frequency * (time[k] - begin));
    return 2.0 * sum / double(taken);
}

class TestForcedSprings : public QObject {
    Q_OBJECT

private slots:
    /// Q/a = -i k_c/(k + k_c - M w^2 + i w c) at drawn stiffness, damping, mass and frequency.
    void linearOscillatorIsExact()
    {
        std::mt19937 draw(1);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        std::vector<double> errors, linear;
        for (int set = 0; set < 40; ++set) {
            const double mass = 1e-6 * (0.5 + 2.0 * share(draw)), stiffness = 1e5 * std::pow(10.0, share(draw));
            const double contact = stiffness * (1.0 + 9.0 * share(draw)), ratio = 0.15 * std::pow(8.0, share(draw));
            const double own = std::sqrt((stiffness + contact) / mass), omega = own * 0.2 * std::pow(20.0, share(draw));
            const double frequency = omega / (2.0 * pi);
            const Case c =
                caseOverWave(linearOscillator(stiffness, ratio, contact, mass), waveAmplitude, frequency, 0.0);
            const ForcedSprings springs(c, "height");
            const ForcedMotion motion = settledMotion(springs, springs.start(), {});
            QCOMPARE(motion.period, 1);
            QCOMPARE(motion.contactShare, 1.0);
            QCOMPARE(motion.touchDowns, 0.0);
            const double dashpot = 2.0 * ratio * std::sqrt(mass * stiffness);
            const Complex expected = Complex(0.0, -waveAmplitude) * contact /
                                     Complex(stiffness + contact - mass * omega * omega, omega * dashpot);
            errors.push_back(std::abs(motion.harmonic / expected - 1.0));
            QVERIFY(springs.linear());
            linear.push_back(std::abs(*springs.linear() / expected - 1.0));
        }
        std::ranges::sort(errors);
        std::ranges::sort(linear);
        qInfo("forced motion: median error %g, largest %g; small motions: %g, %g", errors[20], errors.back(),
              linear[20], linear.back());
        QVERIFY2(errors.back() < 1e-6, qPrintable(QString::number(errors.back())));
        QVERIFY2(linear.back() < 1e-6, qPrintable(QString::number(linear.back())));
    }

    /// The default slider over a wave so low that its motion is linear: each quantity as the small motions say.
    void smallWavesMoveItLinearly()
    {
        for (const char* quantity : {"height", "pitch", "flying_height", "minimum_spacing", "front_spacing"}) {
            for (const double frequency : {60e3, 140e3, 310e3}) {
                Case c;
                c.springs.frontDampingRatio = 0.05;
                c.springs.rearDampingRatio = 0.08;
                c.initial.flyingHeight = c.springs.flyingHeight;
                c.initial.pitch = c.springs.pitch;
                const ForcedSprings springs(caseOverWave(c, 1e-13, frequency, 0.0), quantity);
                const ForcedMotion motion = settledMotion(springs, springs.start(), {});
                QCOMPARE(motion.period, 1);
                const double error = std::abs(motion.harmonic / springs.linear().value() - 1.0);
                QVERIFY2(error < 1e-4, qPrintable(QString("%1: %2").arg(quantity).arg(error)));
            }
        }
    }

    /// With a wave of 0.5 nm the air springs are not linear: the same as a run of 432 periods, sampled evenly.
    void sameAsALongRun()
    {
        std::mt19937 draw(2);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        std::vector<double> errors;
        for (int set = 0; set < 10; ++set) {
            const double frequency = 50e3 + 350e3 * share(draw);
            Case c;
            c.springs.frontDampingRatio = 0.03 + 0.05 * share(draw);
            c.springs.rearDampingRatio = 0.03 + 0.05 * share(draw);
            c.initial.flyingHeight = c.springs.flyingHeight;
            c.initial.pitch = c.springs.pitch;
            c = caseOverWave(c, 0.5e-9, frequency, 0.0);
            const ForcedSprings springs(c, "flying_height");
            const ForcedMotion motion = settledMotion(springs, springs.start(), {});
            QCOMPARE(motion.period, 1);
            // sin(2 pi (x - v t)/l) under the pad is zero and rises at t = x/v - T/2, x from the leading edge.
            const double place = 0.5 * c.slider.length + c.springs.padDistance;
            const double begin = place / speedAlong(c) - 0.5 / frequency;
            const Complex expected = harmonicOfRun(c, "flying_height", frequency, begin);
            errors.push_back(std::abs(motion.harmonic / expected - 1.0));
        }
        std::ranges::sort(errors);
        qInfo("against long runs: median difference %g, largest %g", errors[5], errors.back());
        QVERIFY2(errors.back() < 1e-6, qPrintable(QString::number(errors.back())));
    }

    /// Under a disk of 0.4 m/s the place of the pad is a thousand waves of 1.2 um away from the origin of the surface:
    /// the round-off of its height is larger than that of the time. A switch at this distance once held the time still.
    void shortWavesOfASlowDisk()
    {
        Case c = openCase("fig11a").value;
        c.onoYamane.takeOffShape = TakeOffShape::BothLinear;
        for (const double frequency : {322978.49602873315, 300e3, 250e3, 200e3}) {
            const ForcedSprings springs(caseOverWave(c, 2.4204610142076852e-9, frequency, 1.229732988550818e-6),
                                        "height");
            const ForcedPeriods way = springs.run(springs.start(), {.periods = 300, .rough = true});
            QVERIFY2(way.problem.empty(), way.problem.c_str());
            QVERIFY(way.touchDowns > 0);
        }
    }

    /// The wave has its frequency whether the length or the speed is held.
    void heldLengthOrHeldSpeed()
    {
        const Case bySpeed = caseOverWave(Case{}, 1e-9, 200e3, 50e-6),
                   byLength = caseOverWave(Case{}, 1e-9, 200e3, 0.0);
        QVERIFY(std::abs(speedAlong(bySpeed) - 10.0) < 1e-9);
        QVERIFY(std::abs(speedAlong(byLength) / byLength.diskSurface.waveLengths[0] - 200e3) < 1e-6);
        QVERIFY(std::abs(ForcedSprings(bySpeed, "height").frequency() - 200e3) < 1e-6);
    }
};

TOUCHDOWN_TEST(TestForcedSprings)

} // namespace test_forced_springs

#include "test_forced_springs.moc"
