// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/bounded_step.h"

#include <array>
#include <cmath>
#include <limits>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_bounded_step {

constexpr double far = std::numeric_limits<double>::infinity();
constexpr double hardlyDamped = 1e-14;

std::vector<double> freeStep(const std::vector<std::vector<double>>& slopes, const std::vector<double>& r,
                             double lambda)
{
    return boundedStep(slopes, r, lambda, std::vector<double>(slopes.size(), -far),
                       std::vector<double>(slopes.size(), far));
}

class TestBoundedStep : public QObject {
    Q_OBJECT

private slots:
    /// J = (2 1; 1 3), r = (-5, -10): du = (1, 3).
    void asManyTargetsAsParameters()
    {
        const auto step = freeStep({{2.0, 1.0}, {1.0, 3.0}}, {-5.0, -10.0}, hardlyDamped);
        QVERIFY(std::abs(step[0] - 1.0) < 1e-11 && std::abs(step[1] - 3.0) < 1e-11);
    }
    /// A straight line a + b t through (0, 1), (1, 3), (2, 4): b = 3/2, a = 7/6.
    void moreTargets()
    {
        const auto step = freeStep({{1.0, 1.0, 1.0}, {0.0, 1.0, 2.0}}, {-1.0, -3.0, -4.0}, hardlyDamped);
        QVERIFY(std::abs(step[0] - 7.0 / 6.0) < 1e-11 && std::abs(step[1] - 1.5) < 1e-11);
    }
    /// One target 2 a + b = 1; with D = diag(4, 1) the penalty 4 a^2 + b^2 is least at 2 a = b = 1/2 as lambda goes to
    /// 0.
    void moreParameters()
    {
        const auto step = freeStep({{2.0}, {1.0}}, {-1.0}, 1e-7);
        QVERIFY(std::abs(step[0] - 0.25) < 1e-6 && std::abs(step[1] - 0.5) < 1e-6);
    }
    /// One parameter: du = -J r/(J^2 (1 + lambda)), whatever its scale.
    void damping()
    {
        QCOMPARE(freeStep({{4.0}}, {-8.0}, 1.0)[0], 1.0);
        QCOMPARE(freeStep({{4e-6}}, {-8e-6}, 3.0)[0], 0.5);
    }
    /// r = (a - 3, a + b - 4): the least is at (3, 1). With a <= 2 the rest is b = 2; with both bounded, both bounds.
    void bounds()
    {
        const std::vector<std::vector<double>> slopes{{1.0, 1.0}, {0.0, 1.0}};
        const std::array<double, 2> r{-3.0, -4.0}, low{0.0, 0.0};
        const auto one = boundedStep(slopes, r, hardlyDamped, low, std::array{2.0, far});
        QCOMPARE(one[0], 2.0);
        QVERIFY(std::abs(one[1] - 2.0) < 1e-12);
        const auto both = boundedStep(slopes, r, hardlyDamped, low, std::array{2.0, 0.5});
        QCOMPARE(both, (std::vector{2.0, 0.5}));
    }
    void withoutEffect()
    {
        const auto step = freeStep({{0.0, 0.0}, {1.0, 0.0}}, {-2.0, 5.0}, 1.0);
        QCOMPARE(step[0], 0.0);
        QVERIFY(std::abs(step[1] - 1.0) < 1e-15);
    }
    /// Two parameters that do the same: the damping keeps the step finite, and the sum is right.
    void alike()
    {
        const auto step = freeStep({{1.0}, {1.0}}, {-2.0}, 1e-9);
        QVERIFY(std::abs(step[0] - 1.0) < 1e-6 && std::abs(step[1] - 1.0) < 1e-6);
    }
};

TOUCHDOWN_TEST(TestBoundedStep)

} // namespace test_bounded_step

#include "test_bounded_step.moc"
