// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions of an oscillator with an elastic stop, against its piecewise exact solution.
#include "core/studies/response/settled_motion.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include <QTest>

#include "core/simulation/run.h"
#include "core/studies/response/forced_springs.h"
#include "tests/support/impact_oscillator.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_settled_motion {

using std::numbers::pi;

ForcedMotion motionAt(const ImpactOscillator& oscillator, double w, const ForcedState* start = nullptr)
{
    const double frequency = w * ImpactOscillator::frequency;
    const Case c = caseOverWave(oscillator.slider(), ImpactOscillator::wave, frequency, ImpactOscillator::length);
    const ForcedSprings springs(c, "flying_height");
    return settledMotion(springs, start == nullptr ? springs.start() : *start, {});
}

class TestSettledMotion : public QObject {
    Q_OBJECT

private slots:
    /// The motion of one impact in each period of the forcing, where it is stable and the only one: contact share and
    /// largest multiplier.
    void onePeriodWithOneImpact()
    {
        std::mt19937 draw(3);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        std::vector<double> errors;
        for (int set = 0; set < 20; ++set) {
            const ImpactOscillator oscillator{0.03 + 0.07 * share(draw), 1.0 + 9.0 * share(draw), 0.5 * share(draw)};
            const double w = 1.0 + 0.8 * share(draw);
            const std::vector<double> shares = oscillator.shares(w);
            if (shares.size() != 1 || std::abs(oscillator.traceRatio(w, shares.front())) > 0.9) continue;
            const ForcedMotion motion = motionAt(oscillator, w);
            QCOMPARE(motion.period, 1);
            QCOMPARE(motion.touchDowns, 1.0);
            errors.push_back(std::abs(motion.contactShare - shares.front()));
        }
        QVERIFY2(errors.size() >= 8, qPrintable(QString::number(errors.size())));
        std::ranges::sort(errors);
        qInfo("contact share of %zu motions: median error %g, largest %g", errors.size(), errors[errors.size() / 2],
              errors.back());
        QVERIFY2(errors.back() < 1e-4, qPrintable(QString::number(errors.back())));
    }

    /// A multiplier passes -1 at a frequency that the exact solution gives: period 1 below, period 2 above.
    void periodDoubling()
    {
        std::mt19937 draw(5);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        std::vector<double> errors;
        for (int set = 0; set < 12; ++set) {
            const ImpactOscillator oscillator{0.03 + 0.07 * share(draw), 4.0 + 6.0 * share(draw),
                                              0.1 + 0.5 * share(draw)};
            const double stiff = std::sqrt(1.0 + oscillator.kappa), twoSprings = 2.0 * stiff / (1.0 + stiff);
            const double w = oscillator.doubling(1.2 * twoSprings, 1.8 * twoSprings);
            if (w == 0.0) continue;
            const ForcedMotion before = motionAt(oscillator, 0.999 * w);
            QCOMPARE(before.period, 1);
            const ForcedMotion after = motionAt(oscillator, 1.001 * w, &before.end);
            QCOMPARE(after.period, 2);
            // The larger root of m^2 - tr m + det = 0; where both are complex, pitch may decay more slowly.
            const auto [trace, determinant] = oscillator.invariants(0.999 * w, oscillator.shares(0.999 * w).front());
            const double square = trace * trace - 4.0 * determinant;
            QVERIFY(before.multiplier);
            if (square < 0.0) continue;
            const double expected = 0.5 * (-trace + std::sqrt(square));
            errors.push_back(std::abs(*before.multiplier - expected));
        }
        QVERIFY2(errors.size() >= 8, qPrintable(QString::number(errors.size())));
        std::ranges::sort(errors);
        qInfo("multipliers of %zu motions: median error %g, largest %g", errors.size(), errors[errors.size() / 2],
              errors.back());
        QVERIFY2(errors.back() < 5e-3, qPrintable(QString::number(errors.back())));
    }

    /// The default slider, with friction, menisci and the hysteresis of its contact law, over waves of 0.5 to 3 nm.
    /// From each state to which it settles with contact, a run over 24 of its periods keeps its harmonic and repeats
    /// its touch-downs.
    void runsKeepTheMotionsWithContact()
    {
        std::mt19937 draw(7);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        std::vector<double> errors;
        int longer = 0;
        for (int set = 0; set < 60; ++set) {
            const double frequency = 60e3 + 340e3 * share(draw), wave = 0.5e-9 + 2.5e-9 * share(draw);
            Case c;
            c.springs.frontDampingRatio = c.springs.rearDampingRatio = 0.01 + 0.09 * share(draw);
            c.springs.flyingHeight = c.initial.flyingHeight = 4e-9 + 4e-9 * share(draw);
            c.initial.pitch = c.springs.pitch;
            c = caseOverWave(c, wave, frequency, 0.0);
            // sin(k x - w t + c) under the pad is zero and rises at t = 0.
            const double place = 0.5 * c.slider.length + c.springs.padDistance;
            c.diskSurface.wavePhases = {pi - 2.0 * pi * place / c.diskSurface.waveLengths[0]};
            const ForcedSprings springs(c, "flying_height");
            const ForcedMotion motion = settledMotion(springs, springs.start(), {});
            if (!motion.settled() || motion.contactShare == 0.0) continue;
            longer += motion.period > 1 ? 1 : 0;
            c.initial.pitch = motion.end.y[1];
            c.initial.flyingHeight = motion.end.y[0] - c.springs.padDistance * motion.end.y[1];
            c.initial.verticalVelocity = motion.end.y[2];
            c.initial.pitchVelocity = motion.end.y[3];
            c.initial.branch = OnoYamaneLaw::branch(motion.end.mode.contact);
            constexpr int samples = 512; // of a period of the forcing
            const int periods = 24 * motion.period;
            c.run.tolerance = 1e-12;
            c.run.duration = periods / frequency;
            c.run.sampleInterval = 1.0 / frequency / samples;
            std::vector<double> heights;
            const auto column = static_cast<std::size_t>(findQuantity(recordedQuantities(c), "flying_height"));
            const Summary summary = run(c, [&](const RunUpdate& update) {
                if (update.samples.columns.empty()) return true;
                const std::vector<double>& more = update.samples.columns[column];
                heights.insert(heights.end(), more.begin(), more.end());
                return true;
            });
            QVERIFY2(summary.status == RunStatus::Completed, summary.message.c_str());
            std::complex<double> sum = 0.0;
            for (int k = 0; k < periods * samples; ++k)
                sum += heights[std::size_t(k)] * std::polar(1.0, -2.0 * pi * (k % samples) / samples);
            errors.push_back(std::abs(2.0 * sum / double(periods * samples) / motion.harmonic - 1.0));
            const auto touchDowns = std::ranges::count(summary.events, "touch-down", &RunEvent::name);
            QVERIFY(std::abs(double(touchDowns) - periods * motion.touchDowns) <= 1.0); // one at the very end
        }
        QVERIFY2(errors.size() >= 12 && longer >= 2, qPrintable(QString("%1 %2").arg(errors.size()).arg(longer)));
        std::ranges::sort(errors);
        qInfo("runs of %zu motions with contact, %d of them of two periods or more: median difference %g, largest %g",
              errors.size(), longer, errors[errors.size() / 2], errors.back());
        QVERIFY2(errors.back() < 1e-4, qPrintable(QString::number(errors.back())));
    }

    /// The same period by period without Newton's method, for as long as it takes: it ends in the motion that was
    /// found. Drawn from high starts and with little damping, so that the motion has a long way.
    void waitingEndsInTheSameMotion()
    {
        std::mt19937 draw(11);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        int settled = 0, other = 0, touching = 0;
        std::vector<double> errors;
        for (int set = 0; set < 30; ++set) {
            const double frequency = 40e3 * std::pow(25.0, share(draw)), wave = 0.1e-9 * std::pow(30.0, share(draw));
            Case c;
            c.springs.frontDampingRatio = c.springs.rearDampingRatio = 0.005 + 0.05 * share(draw);
            c.springs.flyingHeight = 4e-9 + 4e-9 * share(draw);
            c.initial.flyingHeight = 10e-9 + 100e-9 * share(draw);
            const ForcedSprings springs(caseOverWave(c, wave, frequency, 0.0), "flying_height");
            const ForcedMotion motion = settledMotion(springs, springs.start(), {});
            if (!motion.settled()) continue;
            ++settled;
            touching += motion.contactShare > 0.0 ? 1 : 0;
            ForcedState waiting = springs.continued(springs.start());
            for (int k = 0; k < 3000; ++k) waiting = springs.run(waiting, {.rough = true}).end;
            double nearest = 1.0; // of the states of the motion at the beginning of a period
            ForcedState at = motion.end;
            for (int k = 0; k < motion.period; ++k) {
                nearest = std::min(nearest, std::abs(at.y[0] - waiting.y[0]) / wave);
                at = springs.run(at, {}).end;
            }
            errors.push_back(nearest);
            if (nearest > 1e-3) ++other;
        }
        std::ranges::sort(errors);
        qInfo("%d motions, %d with contact: median distance %g, %d end elsewhere", settled, touching,
              errors[errors.size() / 2], other);
        QVERIFY2(settled >= 22 && touching >= 6, qPrintable(QString("%1 %2").arg(settled).arg(touching)));
        QCOMPARE(other, 0);
    }
};

TOUCHDOWN_TEST(TestSettledMotion)

} // namespace test_settled_motion

#include "test_settled_motion.moc"
