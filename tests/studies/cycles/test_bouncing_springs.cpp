// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/bouncing_springs.h"

#include <QTest>

#include "tests/support/bouncing_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_bouncing_springs {

class TestBouncingSprings : public QObject {
    Q_OBJECT

private slots:
    void coordinatesOfAStateAreItsOwn()
    {
        const Case c = bouncingSlider();
        const BouncingSprings map(c, sectionUnits(c));
        const Vector3 x{16.0, -3.0, 2.0};
        const SpringModel::State y = map.state(x);
        QVERIFY((map.coordinates(y) - x).norm() < 1e-12);
        QVERIFY(std::abs(map.model().guards(y.head<2>())[SpringModel::Pad] - 3e-9) < 1e-20);
    }

    /// The derivative by the variational equation and the saltation matrices against central differences.
    void derivative_data()
    {
        QTest::addColumn<int>("crossings");
        QTest::addColumn<double>("friction");
        QTest::newRow("one crossing") << 1 << 0.0;
        QTest::newRow("two crossings") << 2 << 0.0;
        QTest::newRow("with friction") << 1 << 0.8;
    }
    void derivative()
    {
        QFETCH(int, crossings);
        QFETCH(double, friction);
        Case c = bouncingSlider();
        c.onoYamane.friction = friction;
        const BouncingSprings map(c, sectionUnits(c));
        const Vector3 x{map.coordinates(map.model().staticState())[0], -1.5, 0.1};
        const ReturnRequest request{.crossings = crossings, .limit = 1e-4, .derivative = true};
        const Return at = map.apply(x, request);
        QVERIFY(at.returned);
        QCOMPARE(at.passed.size(), std::size_t(crossings));
        constexpr double step = 1e-5;
        for (int k = 0; k < 3; ++k) {
            const Vector3 way = step * Vector3::Unit(k);
            const Return after = map.apply(x + way, request), before = map.apply(x - way, request);
            const Eigen::VectorXd difference = (after.x - before.x) / (2.0 * step);
            QVERIFY2((difference - at.derivative.col(k)).norm() < 1e-5 * at.derivative.norm(),
                     qPrintable(QString::number(k)));
        }
    }

    void noReturn()
    {
        const Case c = bouncingSlider(10e-3); // W > 0: caught
        const BouncingSprings map(c, sectionUnits(c));
        const Vector3 x{map.coordinates(map.model().staticState())[0], -1.0, 0.0};
        QVERIFY(!map.apply(x, {.crossings = 200, .limit = 1e-3}).returned);
        QVERIFY(!map.apply(Vector3(x[0], 1.0, 0.0), {.limit = 1e-3}).returned); // upwards
        QVERIFY(!map.apply(Vector3::Constant(NAN), {.limit = 1e-3}).returned);
    }
};

TOUCHDOWN_TEST(TestBouncingSprings)

} // namespace test_bouncing_springs

#include "test_bouncing_springs.moc"
