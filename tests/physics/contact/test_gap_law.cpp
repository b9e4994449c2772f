// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/gap_law.h"

#include <cmath>

#include <QTest>

#include "core/physics/contact/adhesion_kind.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_gap_law {

const Asperities summits{.radius = 1e-6, .density = 10e12, .heightDeviation = 0.4e-9, .planeHeight = 1e-9};

Adhesion attraction(AdhesionKind kind, double voltage)
{
    Adhesion adhesion;
    adhesion.kind = kind;
    adhesion.voltage = voltage;
    return adhesion;
}

class TestGapLaw : public QObject {
    Q_OBJECT

private slots:
    void pressuresAdd()
    {
        const Adhesion adhesion = attraction(AdhesionKind::LennardJones, 0.5);
        const GapLaw law(summits, {}, adhesion);
        const AsperityContact contact(summits, {});
        const AdhesionLaw attracted(adhesion);
        for (const double gap : {-0.5e-9, 0.3e-9, 1.5e-9, 3e-9, 20e-9}) {
            const GapForces at = law.at(gap), quick = law.pressures(gap);
            QCOMPARE(at.contact, contact.pressure(gap));
            QCOMPARE(at.adhesion, attracted.pressure(gap));
            QCOMPARE(quick.contact, at.contact);
            QCOMPARE(quick.adhesion, at.adhesion);
        }
    }

    void slopesAndEnergyBelongToThePressures_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("voltage");
        QTest::newRow("summits alone") << int(AdhesionKind::None) << 0.0;
        QTest::newRow("Lennard-Jones") << int(AdhesionKind::LennardJones) << 0.0;
        QTest::newRow("van der Waals and a voltage") << int(AdhesionKind::VanDerWaals) << 1.0;
    }
    /// Central differences over 1e-13 m: of second order, (1e-13/1e-10)^2, and rounding, 1e-16 10 MPa/1e-13 m.
    void slopesAndEnergyBelongToThePressures()
    {
        QFETCH(int, kind);
        QFETCH(double, voltage);
        const GapLaw law(summits, {}, attraction(static_cast<AdhesionKind>(kind), voltage));
        constexpr double h = 1e-13;
        for (const double gap : {-0.7e-9, 0.45e-9, 1.3e-9, 2.6e-9, 12e-9}) {
            const GapForces at = law.at(gap), above = law.at(gap + h), below = law.at(gap - h);
            const double size = std::abs(at.contact) + std::abs(at.adhesion) + 1.0;
            const auto near = [](double a, double b, double allowed) { return std::abs(a - b) <= allowed; };
            QVERIFY(near(at.contactSlope, (above.contact - below.contact) / (2.0 * h), 1e-4 * size / 1e-10));
            QVERIFY(near(at.adhesionSlope, (above.adhesion - below.adhesion) / (2.0 * h), 1e-4 * size / 1e-10));
            QVERIFY2(near(at.total(), (below.energy - above.energy) / (2.0 * h), 1e-4 * size),
                     qPrintable(
                         QString("%1: %2 %3").arg(gap).arg(at.total()).arg((below.energy - above.energy) / (2.0 * h))));
        }
    }

    /// Nine deviations above the summits' plane; an attraction farther.
    void reach()
    {
        QCOMPARE(GapLaw(summits, {}).reach(), 1e-9 + 9 * 0.4e-9);
        const Adhesion far = attraction(AdhesionKind::None, 1.0);
        const GapLaw law(summits, {}, far);
        QVERIFY(law.reach() > 100e-9);
        QVERIFY(std::abs(law.at(law.reach()).adhesion) <= 1.1e-10 * AdhesionLaw(far).peakAttraction() ||
                law.reach() >= 1e-4);
    }
};

TOUCHDOWN_TEST(TestGapLaw)

} // namespace test_gap_law

#include "test_gap_law.moc"
