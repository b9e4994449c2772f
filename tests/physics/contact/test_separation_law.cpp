// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/separation_law.h"

#include <cmath>

#include <QTest>

#include "core/physics/contact/adhesion_kind.h"
#include "tests/support/asperity_pad.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_separation_law {

OnoYamane fiveParameters()
{
    return {.meniscusForce = 10e-3,
            .contactStiffness = 5e6,
            .initialContactForce = 5e-3,
            .touchDown = 3e-9,
            .takeOff = 5e-9,
            .friction = 0.3};
}

/// So soft that it jumps both ways.
MultiAsperity jumping()
{
    test::AsperityPad pad;
    pad.pair.diskModulus = 1e9;
    return pad.model();
}

double net(const SeparationLaw& law, double d)
{
    const SeparationForces forces = law.at(d);
    return forces.contact.at(d) + forces.adhesion.at(d);
}

class TestSeparationLaw : public QObject {
    Q_OBJECT

private slots:
    /// At d_s the pad is pressed by f_c0 and pulled by f_m.
    void fiveParametersOnBothBranches()
    {
        CharacteristicLaw law(fiveParameters());
        law.begin(ContactBranch::TouchDown, 4e-9);
        QVERIFY(!law.acts());
        QCOMPARE(law.interval().lower, 3e-9);
        QCOMPARE(QString::fromStdString(law.cross(false)), QStringLiteral("touch-down"));
        QVERIFY(std::abs(net(law, 3e-9) - -5e-3) < 1e-15);
        law.begin(ContactBranch::TakeOff, 4.5e-9);
        QVERIFY(law.acts());
        QVERIFY(std::abs(net(law, 4.5e-9) - -10e-3) < 1e-15);
        QCOMPARE(law.reach(), 5e-9);
        QVERIFY(!law.outOfReach(4.5e-9));
    }

    /// No force tells of the menisci, yet the slider touches down at d_s only after it was at d_e.
    void withoutMenisciTakeOffCounts()
    {
        OnoYamane parameters = fiveParameters();
        parameters.meniscusForce = 0.0;
        CharacteristicLaw law(parameters);
        law.begin(ContactBranch::TakeOff, 4.5e-9);
        QCOMPARE(net(law, 4.5e-9), 0.0);
        QVERIFY(law.interval().lower > 3e-9);
        QCOMPARE(law.interval().upper, 5e-9);
        QCOMPARE(QString::fromStdString(law.cross(true)), QStringLiteral("take-off"));
        QCOMPARE(law.interval().lower, 3e-9);
        QVERIFY(std::isinf(law.interval().upper));
    }

    /// The pad's area times the pressures; a tangent meets the law beside it but for the square of the distance.
    void pressureOfTheGapOnAPad()
    {
        Adhesion attraction;
        attraction.kind = AdhesionKind::LennardJones;
        const GapLaw gap({}, {}, attraction);
        const double area = 300e-12, step = 1e-14;
        const UniformGapLaw law(gap, area);
        for (const double d : {-1e-9, 0.5e-9, 2e-9, 4e-9}) {
            const SeparationForces forces = law.at(d);
            const GapForces pressures = gap.at(d), beside = gap.at(d + step);
            QCOMPARE(forces.contact.at(d), area * pressures.contact);
            QCOMPARE(forces.adhesion.at(d), area * pressures.adhesion);
            QCOMPARE(forces.area, area * pressures.area);
            QCOMPARE(forces.storedEnergy, area * pressures.energy);
            const double change = area * std::abs(beside.total() - pressures.total());
            QVERIFY(std::abs(forces.netAt(d + step) - area * beside.total()) < 1e-3 * change + 1e-18);
        }
        QVERIFY(law.outOfReach(1.01 * law.reach()));
        QCOMPARE(law.at(1.01 * law.reach()).contact.at(1.01 * law.reach()), 0.0);
        QVERIFY(!law.outOfReach(0.99 * law.reach()));
    }

    /// Moved in and out in small steps it has the forces of the model that it is made of, also across its jumps.
    void manyAsperitiesFollowTheModel()
    {
        const MultiAsperity model = jumping();
        MultiAsperityLaw law(model);
        MultiAsperityState state = model.start(model.reach());
        int switches = 0;
        const auto go = [&](double from, double to) {
            constexpr int steps = 400;
            for (int i = 1; i <= steps; ++i) {
                const double d = std::lerp(from, to, double(i) / steps);
                while (d <= law.interval().lower || d >= law.interval().upper) {
                    law.cross(d >= law.interval().upper);
                    ++switches;
                }
                state = model.advance(state, d);
                const MultiAsperityForces forces = model.forces(state);
                QVERIFY2(std::abs(net(law, d) - forces.total()) < 1e-9 * model.largestAdhesion(),
                         qPrintable(QString::number(d)));
                QCOMPARE(law.at(d).area, forces.contactArea);
                law.accept(d);
            }
        };
        go(model.reach(), 0.5e-9);
        go(0.5e-9, model.reach());
        QCOMPARE(switches, 2);
    }

    /// Slopes against differences over 1e-14 m, on the side to which the pad moves; a force of some mN is known to
    /// 1e-18 N.
    void slopesAreTheForces()
    {
        const MultiAsperity model = test::AsperityPad{}.model();
        for (const double accepted : {3.2e-9, 2.4e-9, 1.8e-9}) {
            MultiAsperityLaw law(model);
            law.begin(ContactBranch::TouchDown, accepted);
            for (const double d : {accepted - 0.1e-9, accepted + 0.1e-9}) {
                const double h = 1e-14, slope = (net(law, d + h) - net(law, d - h)) / (2.0 * h);
                const SeparationForces forces = law.at(d);
                QVERIFY2(std::abs(slope - forces.contact.slope - forces.adhesion.slope) < 1e-5 * model.bulkStiffness(),
                         qPrintable(
                             QString("%1: %2 %3").arg(d).arg(slope).arg(forces.contact.slope + forces.adhesion.slope)));
            }
        }
    }

    /// The slopes of the way in and of the way out differ; those at the accepted state do not hang on its last digits.
    void roundingChoosesNoSlope()
    {
        const MultiAsperity model = test::AsperityPad{}.model();
        for (const double accepted : {3.2e-9, 2.4e-9, 1.8e-9}) {
            MultiAsperityLaw law(model);
            law.begin(ContactBranch::TouchDown, accepted);
            const double here = law.at(accepted).adhesion.slope;
            for (const double digits : {-4e-16, -1e-16, 1e-16, 4e-16}) {
                const double near = law.at(accepted * (1.0 + digits)).adhesion.slope;
                QVERIFY2(std::abs(near - here) < 1e-6 * model.bulkStiffness(),
                         qPrintable(QString::number(near / here)));
            }
            QVERIFY(std::abs(law.at(accepted - 1e-12).adhesion.slope - here) > 1e-4 * model.bulkStiffness());
        }
    }

    /// Beyond a fold no state continues: the force stays that of the fold until the law is crossed.
    void forcesStayBeyondAFold()
    {
        const MultiAsperity model = jumping();
        MultiAsperityLaw law(model);
        law.begin(ContactBranch::TouchDown, model.reach());
        const double fold = law.interval().lower;
        QVERIFY(std::isfinite(fold));
        QCOMPARE(net(law, fold - 0.2e-9), net(law, fold));
        QCOMPARE(law.at(fold - 0.2e-9).contact.slope, 0.0);
        const double before = net(law, fold);
        QCOMPARE(QString::fromStdString(law.cross(false)), QStringLiteral("touch-down"));
        QVERIFY(net(law, fold) < before - 1e-6);
    }

    /// Out of a contact more summits are wetted than from afar at the same separation.
    void branchesDiffer()
    {
        MultiAsperityLaw law(test::AsperityPad{}.model());
        constexpr double d = 3e-9;
        law.begin(ContactBranch::TouchDown, d);
        const double fromAfar = net(law, d);
        law.begin(ContactBranch::TakeOff, d);
        QVERIFY(net(law, d) < fromAfar - 1e-6);
    }
};

TOUCHDOWN_TEST(TestSeparationLaw)

} // namespace test_separation_law

#include "test_separation_law.moc"
