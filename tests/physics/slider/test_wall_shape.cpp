// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/rail_wall.h"

#include <algorithm>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_wall_shape {

const WallShape shape({{-2.0, 0.0, 4.0, 4.0, 6.0}, {1.0, 3.0, 2.0, 5.0, 4.0}});

class TestWallShape : public QObject {
    Q_OBJECT

private slots:
    void linearBetweenThePoints_data()
    {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("recess");
        QTest::newRow("first point") << -2.0 << 1.0;
        QTest::newRow("half way up") << -1.0 << 2.0;
        QTest::newRow("at a point") << 0.0 << 3.0;
        QTest::newRow("a quarter down") << 1.0 << 2.75;
        QTest::newRow("vertical: the farther point") << 4.0 << 5.0;
        QTest::newRow("beyond the vertical part") << 5.0 << 4.5;
        QTest::newRow("last point") << 6.0 << 4.0;
    }
    void linearBetweenThePoints()
    {
        QFETCH(double, distance);
        QFETCH(double, recess);
        QCOMPARE(shape.at(distance), recess);
    }
    void ends()
    {
        QCOMPARE(shape.inner(), -2.0);
        QCOMPARE(shape.outer(), 6.0);
        QCOMPARE(shape.maximum(), 5.0);
    }
    /// Just before the vertical part at 4 the recess tends to 2.
    void minimumFromHereOn()
    {
        QCOMPARE(shape.minimumFrom(-9.0), 1.0);
        QCOMPARE(shape.minimumFrom(-1.5), 1.5);
        QCOMPARE(shape.minimumFrom(-0.5), 2.0);
        QCOMPARE(shape.minimumFrom(3.0), 2.0);
        QCOMPARE(shape.minimumFrom(4.0), 4.0);
        QCOMPARE(shape.minimumFrom(5.5), 4.0);
        QCOMPARE(shape.minimumFrom(9.0), 4.0);
        for (double d = -2.0; d <= 6.0; d += 0.25) {
            for (double beyond = d; beyond <= 6.0; beyond += 0.25) QVERIFY(shape.minimumFrom(d) <= shape.at(beyond));
        }
    }
};

TOUCHDOWN_TEST(TestWallShape)

} // namespace test_wall_shape

#include "test_wall_shape.moc"
