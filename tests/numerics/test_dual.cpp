// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/dual.h"

#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_dual {

class TestDual : public QObject {
    Q_OBJECT

private slots:
    /// At x = 3, y = -2, by hand; exact in binary or to a rounding.
    void rules()
    {
        const Dual<2> x = Dual<2>::variable(3.0, 0), y = Dual<2>::variable(-2.0, 1);
        const auto check = [](const Dual<2>& result, double value, double byX, double byY) {
            QCOMPARE(result.value, value);
            QCOMPARE(result.by[0], byX);
            QCOMPARE(result.by[1], byY);
        };
        check(x + y, 1.0, 1.0, 1.0);
        check(x - y, 5.0, 1.0, -1.0);
        check(-y, 2.0, 0.0, -1.0);
        check(x * y, -6.0, -2.0, 3.0);
        check(x / y, -1.5, -0.5, -0.75); // 1/y, -x/y^2
        check(exp(x * y), std::exp(-6.0), -2.0 * std::exp(-6.0), 3.0 * std::exp(-6.0));
        check(x + 1.0, 4.0, 1.0, 0.0); // a constant has no derivatives
        check(Dual<2>(2.0) * y, -4.0, 0.0, 2.0);
        check(x.chain(9.0, 6.0), 9.0, 6.0, 0.0); // x^2 from outside
        Dual<2> sum = x;
        sum += y;
        check(sum, 1.0, 1.0, 1.0);
    }

    /// f = exp(-x y)/(x - y z) + x y/z against its derivatives written out.
    void chainOfAllRules()
    {
        const double x = 0.7, y = 1.3, z = -0.4;
        const Dual<3> X = Dual<3>::variable(x, 0), Y = Dual<3>::variable(y, 1), Z = Dual<3>::variable(z, 2);
        const Dual<3> f = exp(-(X * Y)) / (X - Y * Z) + X * Y / Z;
        const double e = std::exp(-x * y), d = x - y * z;
        QVERIFY(std::abs(f.value - (e / d + x * y / z)) < 1e-15 * 8);
        QVERIFY(std::abs(f.by[0] - (-y * e / d - e / (d * d) + y / z)) < 1e-15 * 8);
        QVERIFY(std::abs(f.by[1] - (-x * e / d + z * e / (d * d) + x / z)) < 1e-15 * 8);
        QVERIFY(std::abs(f.by[2] - (y * e / (d * d) - x * y / (z * z))) < 1e-15 * 16);
    }

    void valueOfEither()
    {
        QCOMPARE(valueOf(2.5), 2.5);
        QCOMPARE(valueOf(Dual<4>::variable(2.5, 3)), 2.5);
    }
};

TOUCHDOWN_TEST(TestDual)

} // namespace test_dual

#include "test_dual.moc"
