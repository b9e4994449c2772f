// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions of an oscillator with an elastic stop, against its piecewise exact solution.
#include "core/studies/response/settled_motion.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <QTest>

#include "tests/support/impact_oscillator.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_settled_motion {

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
};

TOUCHDOWN_TEST(TestSettledMotion)

} // namespace test_settled_motion

#include "test_settled_motion.moc"
