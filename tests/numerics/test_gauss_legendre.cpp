// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/gauss_legendre.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_gauss_legendre {

template <std::size_t N, typename Function>
double integral(double lower, double upper, Function f)
{
    double sum = 0.0;
    GaussLegendre<N>{}.sample(lower, upper, [&](double x, double weight) { sum += weight * f(x); });
    return sum;
}

class TestGaussLegendre : public QObject {
    Q_OBJECT

private slots:
    /// int_-1^1 x^(2k) = 2/(2k + 1) exactly up to degree 2 N - 1. One degree further the rule of N points is short by
    /// 2^(2N+1) (N!)^4/((2N + 1) ((2N)!)^2): for N = 3, 2^7 6^4/(7 720^2) = 0.0457142857.
    void exactUpToItsDegree()
    {
        for (int degree = 0; degree <= 23; ++degree) {
            const double expected = degree % 2 == 0 ? 2.0 / (degree + 1.0) : 0.0;
            QVERIFY(std::abs(integral<12>(-1.0, 1.0, [&](double x) { return std::pow(x, degree); }) - expected) <
                    1e-14);
        }
        const double six = integral<3>(-1.0, 1.0, [](double x) { return std::pow(x, 6); });
        QVERIFY(std::abs(2.0 / 7.0 - six - 0.0457142857142857) < 1e-14);
    }

    /// Two points: +-1/sqrt(3), weight 1 (Abramowitz & Stegun 25.4).
    void twoPoints()
    {
        GaussLegendre<2>{}.sample(-1.0, 1.0, [](double x, double weight) {
            QVERIFY(std::abs(std::abs(x) - 1.0 / std::sqrt(3.0)) < 1e-15);
            QVERIFY(std::abs(weight - 1.0) < 1e-15);
        });
    }

    /// int_1^3 e^x = e^3 - e.
    void anyInterval()
    {
        QVERIFY(std::abs(integral<12>(1.0, 3.0, [](double x) { return std::exp(x); }) -
                         (std::exp(3.0) - std::exp(1.0))) < 1e-13);
    }
};

TOUCHDOWN_TEST(TestGaussLegendre)

} // namespace test_gauss_legendre

#include "test_gauss_legendre.moc"
