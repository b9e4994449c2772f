// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/coulomb_friction.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_coulomb_friction {

class TestCoulombFriction : public QObject {
    Q_OBJECT

private slots:
    /// mu = 0.3, N = 5 mN: 1.5 mN at full speed either way, nothing at rest; tanh(1/2) = (e - 1)/(e + 1) = 0.46211716
    /// at v_r/2.
    void followsTheDisk_data()
    {
        QTest::addColumn<double>("velocity");
        QTest::addColumn<double>("expected");
        QTest::newRow("disk at full speed") << 12.0 << 1.5e-3;
        QTest::newRow("disk turning backwards") << -12.0 << -1.5e-3;
        QTest::newRow("disk at rest") << 0.0 << 0.0;
        QTest::newRow("disk coming to rest") << 0.5e-3 << 1.5e-3 * 0.46211715726;
        QTest::newRow("ten regularising speeds") << 10e-3 << 1.5e-3 * (1.0 - 4.1e-9);
    }
    void followsTheDisk()
    {
        QFETCH(double, velocity);
        QFETCH(double, expected);
        const CoulombFriction friction{.coefficient = 0.3, .arm = 0.15e-3, .regularisingSpeed = 1e-3};
        QVERIFY(std::abs(friction.force(5e-3, velocity) - expected) < 1e-13);
        QVERIFY(std::abs(friction.pitchMoment(5e-3, velocity) + 0.15e-3 * expected) < 1e-16);
    }

    /// Without contact there is none.
    void nothingWithoutContact() { QCOMPARE(CoulombFriction{}.force(0.0, 12.0), 0.0); }
};

TOUCHDOWN_TEST(TestCoulombFriction)

} // namespace test_coulomb_friction

#include "test_coulomb_friction.moc"
