// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/strongest_pull.h"

#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_strongest_pull {

class TestStrongestPull : public QObject {
    Q_OBJECT

private slots:
    void between_data()
    {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<double>("at");
        QTest::newRow("inside") << 1e-9 << 4e-9 << 3e-9;
        QTest::newRow("the other way") << 4e-9 << 1e-9 << 3e-9;
        QTest::newRow("at the end") << 1e-9 << 2e-9 << 2e-9;
        QTest::newRow("at the beginning") << 3.5e-9 << 4e-9 << 3.5e-9;
    }
    /// F = -1 mN + k (d - 3 nm)^2; each try starts from the remembered state.
    void between()
    {
        QFETCH(double, from);
        QFETCH(double, to);
        QFETCH(double, at);
        int tries = 0, recalls = 0;
        const auto force = [&](double d) {
            ++tries;
            return -1e-3 + 1e14 * (d - 3e-9) * (d - 3e-9);
        };
        const PullPoint found = strongestPull({force, {}, [&] { ++recalls; }, {}}, from, to, 1e-12);
        QVERIFY(std::abs(found.separation - at) <= 1e-12);
        QCOMPARE(found.force, force(found.separation));
        QCOMPARE(tries, recalls + 1);
    }
};

TOUCHDOWN_TEST(TestStrongestPull)

} // namespace test_strongest_pull

#include "test_strongest_pull.moc"
