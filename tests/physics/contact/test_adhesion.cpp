// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/adhesion.h"

#include <cmath>
#include <numbers>

#include <QTest>

#include "core/physics/contact/adhesion_kind.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_adhesion {

bool close(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * std::abs(b); }

class TestAdhesion : public QObject {
    Q_OBJECT

private slots:
    void derivatives_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("voltage");
        QTest::newRow("Lennard-Jones") << static_cast<int>(AdhesionKind::LennardJones) << 0.0;
        QTest::newRow("van der Waals") << static_cast<int>(AdhesionKind::VanDerWaals) << 0.0;
        QTest::newRow("electrostatic") << static_cast<int>(AdhesionKind::None) << 1.5;
        QTest::newRow("Lennard-Jones with voltage") << static_cast<int>(AdhesionKind::LennardJones) << 1.5;
        QTest::newRow("van der Waals with voltage") << static_cast<int>(AdhesionKind::VanDerWaals) << 1.5;
    }

    /// f = -dphi/dg and df/dg by central differences of step e, whose error is e^2/6 times the third derivative: with e
    /// = g/3000 that is at most n (n+1)(n+2)/6 (e/g)^2 < 4e-5 for the ninth power, the steepest part.
    void derivatives()
    {
        QFETCH(int, kind);
        QFETCH(double, voltage);
        const AdhesionLaw law({.kind = static_cast<AdhesionKind>(kind), .voltage = voltage});
        for (const double g : {0.14e-9, 0.21e-9, 0.5e-9, 2e-9, 20e-9}) {
            const double e = g / 3000.0;
            QVERIFY(close(-(law.energy(g + e) - law.energy(g - e)) / (2.0 * e), law.pressure(g), 2e-4));
            QVERIFY(close((law.pressure(g + e) - law.pressure(g - e)) / (2.0 * e), law.derivative(g), 2e-4));
        }
    }

    /// Lennard-Jones: -dgamma at gap 0. Van der Waals: f = 0 where g^6 = 2B/(15A), and there phi = -A/(12 pi g^2) (1 -
    /// 1/4).
    void depth()
    {
        const Adhesion adhesion{.kind = AdhesionKind::VanDerWaals};
        const double g2 = std::cbrt(2.0 * adhesion.hamakerB / (15.0 * adhesion.hamakerA));
        QVERIFY(close(AdhesionLaw(adhesion).leastEnergy(), -0.75 * adhesion.hamakerA / (12.0 * std::numbers::pi * g2),
                      1e-12));
        QVERIFY(close(AdhesionLaw({.kind = AdhesionKind::LennardJones}).leastEnergy(), -0.05, 1e-12));
    }

    /// Finite at every gap; below zero as at zero; towards the peak the attraction grows, beyond it falls.
    void finite()
    {
        for (const auto kind : {AdhesionKind::LennardJones, AdhesionKind::VanDerWaals, AdhesionKind::None}) {
            for (const double b : {1e-76, 0.0}) {
                const AdhesionLaw law({.kind = kind, .hamakerB = b, .voltage = 1.0});
                for (const double g : {-1.0, 0.0, 1e-15, 1e-11, 1e-10, 1e-9, 1e-3, 1e3}) {
                    QVERIFY(std::isfinite(law.pressure(g)) && std::isfinite(law.derivative(g)) &&
                            std::isfinite(law.energy(g)));
                    QVERIFY(law.pressure(g) >= -law.peakAttraction());
                }
                QCOMPARE(law.pressure(-1e-9), law.pressure(0.0));
                QCOMPARE(law.energy(-1e-9), law.energy(0.0));
            }
        }
    }

    /// phi(0) = -(8 dgamma/3) (1/2 - 1/8) = -dgamma. df/dg = 0 where 3 s^4 = 9 s^10: s^6 = 1/3, g = z0 (3^(1/6) - 1),
    /// and there s^3 - s^9 = (2/3)/sqrt(3), f = -16 dgamma/(9 sqrt(3) z0).
    void lennardJones()
    {
        const double dgamma = 0.08, z0 = 0.35e-9;
        const AdhesionLaw law({.kind = AdhesionKind::LennardJones, .surfaceEnergy = dgamma, .equilibriumDistance = z0});
        QVERIFY(close(law.energy(0.0), -dgamma, 1e-14));
        QCOMPARE(law.pressure(0.0), 0.0);
        QVERIFY(close(law.derivative(0.0), -16.0 * dgamma / (z0 * z0), 1e-14));
        QVERIFY(close(law.peakGap(), z0 * (std::pow(3.0, 1.0 / 6.0) - 1.0), 1e-12));
        QVERIFY(close(law.peakAttraction(), 16.0 * dgamma / (9.0 * std::sqrt(3.0) * z0), 1e-14));
    }

    /// f = 0 where g^6 = 2 B/(15 A); df/dg = 0 where 3 A/6 = 9 B/(45 g^6): g^6 = 2 B/(5 A). Far away -A/(6 pi g^3).
    void vanDerWaals()
    {
        const double a = 2e-19, b = 3e-76;
        const AdhesionLaw law({.kind = AdhesionKind::VanDerWaals, .hamakerA = a, .hamakerB = b});
        const double zero = std::pow(2.0 * b / (15.0 * a), 1.0 / 6.0);
        QVERIFY(law.pressure(zero * (1.0 - 1e-9)) > 0.0 && law.pressure(zero * (1.0 + 1e-9)) < 0.0);
        QVERIFY(close(law.peakGap(), std::pow(2.0 * b / (5.0 * a), 1.0 / 6.0), 1e-10));
        QVERIFY(close(law.pressure(10e-9), -a / (6.0 * std::numbers::pi * 1e-24), 1e-7));
        QVERIFY(law.pressure(0.0) > 1e11); // the half of the distance holds bodies apart before they meet
        // Without repulsion held at z0.
        const AdhesionLaw attraction(
            {.kind = AdhesionKind::VanDerWaals, .equilibriumDistance = 0.3e-9, .hamakerA = a, .hamakerB = 0.0});
        QVERIFY(close(attraction.pressure(0.0), -a / (6.0 * std::numbers::pi * 27e-30), 1e-12));
        QCOMPARE(attraction.pressure(0.1e-9), attraction.pressure(0.0));
    }

    /// -eps0 V^2/(2 (g + z0)^2): 2 V over 1.7 + 0.3 nm.
    void electrostatic()
    {
        const AdhesionLaw law({.kind = AdhesionKind::None, .equilibriumDistance = 0.3e-9, .voltage = -2.0});
        QVERIFY(close(law.pressure(1.7e-9), -8.8541878128e-12 * 4.0 / (2.0 * 4e-18), 1e-13));
        QVERIFY(law.acts() && !AdhesionLaw(Adhesion{}).acts());
        QCOMPARE(AdhesionLaw(Adhesion{}).pressure(1e-9), 0.0);
    }
};

TOUCHDOWN_TEST(TestAdhesion)

} // namespace test_adhesion

#include "test_adhesion.moc"
