// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/pad_contact.h"

#include <cmath>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_pad_contact {

constexpr double length = 1.25e-3, width = 1.0e-3;
constexpr double pitch = 100e-6;
/// The pad's trailing edge, which is nearest with any pitch.
constexpr double edge = 1.2e-3;

/// One pad of 0.1 x 0.04 mm near the trailing edge, in the middle.
Case withPad()
{
    Case c = defaultsOf(ModelKind::Film);
    c.contact = ContactKind::OnoYamane;
    c.onoYamane = {.meniscusForce = 10e-3,
                   .contactStiffness = 5e6,
                   .initialContactForce = 5e-3,
                   .touchDown = 3e-9,
                   .takeOff = 5e-9,
                   .friction = 0.3};
    c.surface.baseRecess = 2e-6;
    c.surface.rails = {{.points = {{1.1e-3, 0.48e-3}, {edge, 0.48e-3}, {edge, 0.52e-3}, {1.1e-3, 0.52e-3}}}};
    return c;
}

/// With the pad's trailing edge at `spacing` over the disk where the roll is zero.
Attitude at(double spacing, double roll = 0.0) { return {spacing - pitch * (length - edge), pitch, roll}; }

struct Contact {
    explicit Contact(const Case& c)
        : recess(c.surface, length, width), spacing(c.surface, recess), law(c, makeSeparationLaw(c), spacing)
    {}
    Recess recess;
    MinimumSpacing spacing;
    PadContact law;
};

class TestPadContact : public QObject {
    Q_OBJECT

private slots:
    /// At 2 nm: F_cr = 5 mN + 5e6 N/m 1 nm = 10 mN, F_m = -10 mN; friction 3 mN with an arm of 0.15 mm. Forces of zero
    /// sum have no torque of their own. The pad is 0.575 mm behind the middle, R = 23 mm: the disk runs 1/40 off x,
    /// whose cosine is 1 - 3.1e-4.
    void pressed()
    {
        Contact contact(withPad());
        const SliderContactForces& f = contact.law.at(at(2e-9), 0.0);
        // Sides of edges are sampled 1e-10 m away, which 100 urad turn into 1e-14 m: 5e-8 N.
        QVERIFY(std::abs(f.contact - 10e-3) < 1e-7);
        QVERIFY(std::abs(f.adhesion - -10e-3) < 1e-15);
        QVERIFY(std::abs(f.friction - 3e-3) < 1e-7);
        QVERIFY(std::abs(f.pitchTorque - -3e-3 * 0.15e-3 * (1.0 - 3.1e-4)) < 5e-11);
    }
    /// Deeper by 1 nm the net force is 5 mN, 0.575 mm behind the middle: nose down. A symmetric pad rolls by friction
    /// alone, 1/40 of whose 4.5 mN points to the inner edge.
    void netForceTurnsTheNoseDown()
    {
        Contact contact(withPad());
        const SliderContactForces& f = contact.law.at(at(1e-9), 0.0);
        const double expected = -5e-3 * (edge - 0.5 * length) - 0.3 * 15e-3 * 0.15e-3;
        QVERIFY(std::abs(f.pitchTorque - expected) < 1e-3 * std::abs(expected));
        QVERIFY(std::abs(f.rollTorque - 4.5e-3 * 0.15e-3 / 40.0) < 1e-10);
    }
    /// Rolled by 2 urad the outer corner, 20 um from the middle, is 0.04 nm lower and bears alone: 5 mN + 5e6 N/m 1.04
    /// nm less 10 mN, 20 um outside: outer edge up. Friction rolls as above.
    void theLowerCornerBears()
    {
        Contact contact(withPad());
        const SliderContactForces& f = contact.law.at(at(2e-9, 2e-6), 0.0);
        const double net = 5e6 * 0.04e-9;
        QVERIFY(std::abs(f.contact + f.adhesion - net) < 1e-7);
        // The weighted mean of all that is within 0.01 nm lies within 5 um of the corner; friction adds 0.3 10.2 mN
        // 0.15 mm/40.
        const double friction = 0.3 * 10.2e-3 * 0.15e-3 / 40.0;
        QVERIFY(f.rollTorque > -net * 20e-6 + 0.95 * friction);
        QVERIFY(f.rollTorque < -net * 15e-6 + 1.05 * friction);
    }
    void theTorqueIsContinuousWhereTheNearestCornerChanges()
    {
        Contact contact(withPad());
        double last = contact.law.at(at(1e-9, -1e-6), 0.0).rollTorque, largest = 0.0;
        for (int k = -99; k <= 100; ++k) {
            const double now = contact.law.at(at(1e-9, k * 1e-8), 0.0).rollTorque;
            largest = std::max(largest, std::abs(now - last));
            last = now;
        }
        // Between the corners it changes by 5 mN 40 um in all; a jump would be all of it at once.
        QVERIFY(largest < 0.1 * 5e-3 * 40e-6);
    }
    /// The accepted region's law counts until the run crosses its end, whatever was tried.
    void keepsItsLawUntilItIsCrossed()
    {
        Contact contact(withPad());
        QCOMPARE(contact.law.at(at(10e-9), 0.0).contact, 0.0);
        contact.law.accept();
        QCOMPARE(contact.law.interval().lower, 3e-9);
        QCOMPARE(contact.law.at(at(2e-9), 0.0).contact, 0.0);
        QVERIFY(std::abs(contact.law.separation(at(2e-9)) - 2e-9) < 2e-14);
        QCOMPARE(contact.law.cross(false), std::string("touch-down"));
        QVERIFY(contact.law.at(at(3e-9), 0.0).contact > 4.9e-3);
        // Pressed and lifting have the same law: it holds up to d_s + f_c0/k_c = 4 nm.
        QVERIFY(std::abs(contact.law.interval().upper - 4e-9) < 1e-18);
        QCOMPARE(contact.law.cross(true), std::string("held by menisci"));
        QCOMPARE(contact.law.at(at(4.5e-9), 0.0).adhesion, -10e-3);
        QCOMPARE(contact.law.interval().upper, 5e-9);
        QCOMPARE(contact.law.cross(true), std::string("take-off"));
        QCOMPARE(contact.law.at(at(4.5e-9), 0.0).adhesion, 0.0);
    }
    void beginsOnTheBranchOfTheCase_data()
    {
        QTest::addColumn<int>("branch");
        QTest::addColumn<double>("spacing");
        QTest::addColumn<double>("adhesion");
        const int down = static_cast<int>(ContactBranch::TouchDown), up = static_cast<int>(ContactBranch::TakeOff);
        QTest::newRow("between, touching down") << down << 4.5e-9 << 0.0;
        QTest::newRow("between, taking off") << up << 4.5e-9 << -10e-3;
        QTest::newRow("above, taking off") << up << 6e-9 << 0.0;
        QTest::newRow("below, touching down") << down << 2.5e-9 << -10e-3;
    }
    void beginsOnTheBranchOfTheCase()
    {
        QFETCH(int, branch);
        QFETCH(double, spacing);
        Case c = withPad();
        c.initial.branch = static_cast<ContactBranch>(branch);
        Contact contact(c);
        QTEST(contact.law.at(at(spacing), 0.0).adhesion, "adhesion");
    }
    /// No force acts where it is out of reach; between d_s and d_e one may, by the branch.
    void tellsWhereNothingActs()
    {
        Contact contact(withPad());
        QVERIFY(contact.law.outOfReach(at(5.1e-9)));
        QVERIFY(!contact.law.outOfReach(at(4.9e-9)));
        contact.law.at(at(2e-9), 0.0);
        contact.law.accept();
        QVERIFY(!contact.law.outOfReach(at(50e-9)));
    }
    /// k_c at its arms, and friction's moment with it, by d = z + (L/2 - x) pitch + (W/2 - y) roll.
    void stiffnessIsThatOfThePad()
    {
        Contact contact(withPad());
        contact.law.at(at(1e-9, 2e-6), 0.0); // one corner bears, so that roll does not move the force much
        const Matrix3 k = contact.law.stiffness();
        const double arm = 0.5 * length - edge;
        QVERIFY(std::abs(k(0, 0) / 5e6 - 1.0) < 1e-3);
        QVERIFY(std::abs(k(0, 1) / (5e6 * arm) - 1.0) < 1e-3);
        QVERIFY(std::abs(k(1, 0) / (5e6 * (arm - 0.3 * 0.15e-3)) - 1.0) < 1e-3);
        QVERIFY(std::abs(k(0, 2) / (5e6 * -20e-6) - 1.0) < 1e-3);
    }
    /// 1/2 k_c (d_s + f_c0/k_c - d)^2 = 1/2 5e6 (2 nm)^2 at 2 nm.
    void storesItsElasticEnergy()
    {
        Contact contact(withPad());
        QVERIFY(std::abs(contact.law.at(at(2e-9), 0.0).storedEnergy - 1e-11) < 1e-15);
    }
};

TOUCHDOWN_TEST(TestPadContact)

} // namespace test_pad_contact

#include "test_pad_contact.moc"
