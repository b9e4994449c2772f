// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/air_spring.h"

#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_air_spring {

constexpr AirSpring spring{.stiffness = 1.35e6, .staticSpacing = 9.25e-9, .cutoff = 0.3e-9};

class TestAirSpring : public QObject {
    Q_OBJECT

private slots:
    void forceAtTheStaticSpacingIsZero() { QCOMPARE(spring.force(9.25e-9), 0.0); }
    /// z = z_0/2: k_0 z_0^2 4/z_0^2 (z_0/2) = 2 k_0 z_0 = 2 * 1.35e6 * 9.25e-9 = 0.024975 N.
    void forceAtHalfTheSpacing() { QCOMPARE(spring.force(0.5 * 9.25e-9), 0.024975); }
    /// The tangent at z_0 is -k_0, and follows finite differences elsewhere.
    void tangent()
    {
        QCOMPARE(spring.tangent(9.25e-9), -1.35e6);
        for (const double z : {0.5e-9, 3e-9, 20e-9, -4e-9}) {
            const double e = 1e-5 * z;
            const double difference = (spring.force(z + e) - spring.force(z - e)) / (2.0 * e);
            QVERIFY(std::abs(spring.tangent(z) / difference - 1.0) < 1e-8);
        }
    }
    /// -dU/dz = F above the cutoff; U(z_0) = 0; U(z_0/2) = k_0 z_0^2 (2 - ln 2 - 1).
    void potential()
    {
        QCOMPARE(spring.potential(9.25e-9), 0.0);
        QCOMPARE(spring.potential(0.5 * 9.25e-9), 1.35e6 * 9.25e-9 * 9.25e-9 * (1.0 - std::log(2.0)));
        for (const double z : {0.5e-9, 3e-9, 30e-9}) {
            const double e = 1e-5 * z;
            const double slope = (spring.potential(z + e) - spring.potential(z - e)) / (2.0 * e);
            QVERIFY(std::abs(-slope / spring.force(z) - 1.0) < 1e-8);
        }
    }
    void potentialIsHeldBelowTheCutoff()
    {
        for (const double z : {0.3e-9, 0.1e-9, 0.0, -5e-9}) QCOMPARE(spring.potential(z), spring.potential(0.3e-9));
    }
    /// Equation (5) as printed, z = -z_0: -1 - ln|-1| - 1 = -2.
    void potentialAsPrintedBecomesNegative()
    {
        QCOMPARE(spring.potential(-9.25e-9, PotentialBelowCutoff::AsPrinted), -2.0 * 1.35e6 * 9.25e-9 * 9.25e-9);
    }
    void noStiffnessNoEnergy() { QCOMPARE(AirSpring{}.potential(0.0), 0.0); }
};

TOUCHDOWN_TEST(TestAirSpring)

} // namespace test_air_spring

#include "test_air_spring.moc"
