// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/runge_kutta.h"

#include <cmath>

#include <Eigen/Core>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_runge_kutta {

/// Sums of the order conditions up to order 5 (Hairer, Norsett & Wanner, Solving ODEs I, table II.2.2), one row a tree.
template <std::size_t s>
std::vector<std::pair<double, double>> conditions(const Tableau<s>& t, const std::array<double, s>& b)
{
    std::array<double, s> c{};
    for (std::size_t i = 0; i < s; ++i)
        for (std::size_t j = 0; j < s; ++j) c[i] += t.a[i][j];
    const auto through = [&](const std::array<double, s>& x) { // A x
        std::array<double, s> y{};
        for (std::size_t i = 0; i < s; ++i)
            for (std::size_t j = 0; j < s; ++j) y[i] += t.a[i][j] * x[j];
        return y;
    };
    const auto times = [](std::array<double, s> x, const std::array<double, s>& y) {
        for (std::size_t i = 0; i < s; ++i) x[i] *= y[i];
        return x;
    };
    const auto sum = [&](const std::array<double, s>& x) {
        double total = 0.0;
        for (std::size_t i = 0; i < s; ++i) total += b[i] * x[i];
        return total;
    };
    std::array<double, s> one;
    one.fill(1.0);
    const auto c2 = times(c, c);
    const auto c3 = times(c2, c);
    const auto ac = through(c);
    return {{sum(one), 1.0},
            {sum(c), 1.0 / 2},
            {sum(c2), 1.0 / 3},
            {sum(ac), 1.0 / 6},
            {sum(c3), 1.0 / 4},
            {sum(times(c, ac)), 1.0 / 8},
            {sum(through(c2)), 1.0 / 12},
            {sum(through(ac)), 1.0 / 24},
            {sum(times(c3, c)), 1.0 / 5},
            {sum(times(c2, ac)), 1.0 / 10},
            {sum(times(ac, ac)), 1.0 / 20},
            {sum(times(c, through(c2))), 1.0 / 15},
            {sum(times(c, through(ac))), 1.0 / 30},
            {sum(through(c3)), 1.0 / 20},
            {sum(through(times(c, ac))), 1.0 / 40},
            {sum(through(through(c2))), 1.0 / 60},
            {sum(through(through(ac))), 1.0 / 120}};
}

int satisfied(const std::vector<std::pair<double, double>>& rows)
{
    int n = 0;
    for (const auto& [sum, expected] : rows) {
        if (std::abs(sum - expected) > 1e-14) break;
        ++n;
    }
    return n;
}

constexpr int upToOrder4 = 8;
constexpr int upToOrder5 = 17;

class TestRungeKutta : public QObject {
    Q_OBJECT

private slots:
    void rk4HasOrder4() { QCOMPARE(satisfied(conditions(rk4Tableau, rk4Tableau.b)), upToOrder4); }
    void dopri5HasOrder5() { QCOMPARE(satisfied(conditions(dopri5Tableau, dopri5Tableau.b)), upToOrder5); }
    void embeddedMethodHasOrder4()
    {
        std::array<double, 7> embedded;
        for (std::size_t i = 0; i < 7; ++i) embedded[i] = dopri5Tableau.b[i] - dopri5Tableau.e[i];
        QCOMPARE(satisfied(conditions(dopri5Tableau, embedded)), upToOrder4);
    }
    void lastStageIsTheNextFirst()
    {
        for (std::size_t j = 0; j < 7; ++j) QCOMPARE(dopri5Tableau.a[6][j], dopri5Tableau.b[j]);
    }
    /// One step of y' = y is the Taylor polynomial of e^h up to the order.
    void oneStepOfTheExponential()
    {
        using Scalar = Eigen::Matrix<double, 1, 1>;
        std::array<Scalar, 4> k;
        const double h = 0.1;
        const Scalar y(1.0);
        k[0] = y;
        evaluateStages<rk4Tableau>(y, h, k, [](const Scalar& at) { return at; });
        const double result = (y + combine<TableauRow<rk4Tableau, &Tableau<4>::b>, 4>(h, k))[0];
        QVERIFY(std::abs(result - (1.0 + h + h * h / 2 + h * h * h / 6 + h * h * h * h / 24)) < 1e-15);
    }
};

TOUCHDOWN_TEST(TestRungeKutta)

} // namespace test_runge_kutta

#include "test_runge_kutta.moc"
