// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/contact_lever.h"

#include <cmath>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_lever {

/// 1.25 x 1.00 x 0.30 mm.
Case pico()
{
    Case c = defaultsOf(ModelKind::Film);
    c.contact = ContactKind::OnoYamane;
    c.onoYamane.friction = 0.4;
    return c;
}

class TestContactLever : public QObject {
    Q_OBJECT

private slots:
    /// Near the trailing edge, 0.575 mm behind the middle, a force presses the nose down; 0.3 mm inside of it, it lifts
    /// the inner edge.
    void aForceTurnsTheSlider()
    {
        const Vector3 arms = ContactLever(pico()).arms(1.2e-3, 0.2e-3);
        QCOMPARE(arms[0], 1.0);
        QVERIFY(std::abs(arms[1] - -0.575e-3) < 1e-15);
        QVERIFY(std::abs(arms[2] - 0.3e-3) < 1e-15);
    }
    /// Without skew the disk runs along x under the slider's middle: mu N, with half the thickness, 0.15 mm, below the
    /// mass centre.
    void frictionPressesTheNoseDown()
    {
        const auto rubbing = ContactLever(pico()).rubbing(0.625e-3, 0.5e-3);
        QVERIFY(std::abs(rubbing.force - 0.4) < 1e-12);
        QVERIFY(std::abs(rubbing.pitchTorque - -0.4 * 0.15e-3) < 1e-16);
        QVERIFY(std::abs(rubbing.rollTorque) < 1e-16);
    }
    /// With a skew of 30 degrees the disk runs with (cos 30, -sin 30) of its speed: the part towards the inner edge
    /// lifts that edge.
    void skewedFrictionRollsTheSlider()
    {
        Case c = pico();
        c.disk.skew = std::acos(-1.0) / 6.0;
        const auto rubbing = ContactLever(c).rubbing(0.625e-3, 0.5e-3);
        QVERIFY(std::abs(rubbing.pitchTorque - -0.4 * 0.15e-3 * std::cos(c.disk.skew)) < 1e-14);
        QVERIFY(std::abs(rubbing.rollTorque - 0.4 * 0.15e-3 * 0.5) < 1e-14);
    }
    void nothingRubsOnADiskAtRest()
    {
        Case c = pico();
        c.disk.speed = 0.0;
        const auto rubbing = ContactLever(c).rubbing(1e-3, 0.1e-3);
        QCOMPARE(rubbing.force, 0.0);
        QCOMPARE(rubbing.pitchTorque, 0.0);
    }
};

TOUCHDOWN_TEST(TestContactLever)

} // namespace test_contact_lever

#include "test_contact_lever.moc"
