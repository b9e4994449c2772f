// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/multi_asperity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/support/asperity_pad.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_multi_asperity_curve {

using std::numbers::pi;

using Setting = test::AsperityPad;
using test::stiffBulk;

bool near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

double worstSpacing(const MultiAsperityCurve& curve, const MultiAsperity& model)
{
    double worst = 0.0;
    for (const auto* way : {&curve.towards, &curve.away})
        for (const MultiAsperityPoint& point : *way)
            worst = std::max(worst, std::abs(model.padSeparation(point.state) - point.padSeparation));
    return worst;
}

class TestMultiAsperityCurve : public QObject {
    Q_OBJECT

private slots:
    /// Each meniscus that forms at gap t and breaks at h_b loses 2 pi R gamma (1 + cos theta)(h_b - t). With a stiff
    /// bulk, and every summit wetted (d_min - t five deviations below their plane), the loop's area is that of all of
    /// them.
    void workLostIsTheMenisci()
    {
        const Setting s = stiffBulk();
        const auto curve = multiAsperityCurve(s.model(), 6e-9, 1.5e-9, 2001);
        const double expected = s.adhesion() * 1e-9;
        QVERIFY2(near(curve.work, expected, 1e-5 * expected),
                 qPrintable(QString::number(curve.work / expected, 'g', 9)));
    }

    /// Without surface tension the way out retraces the way in and nothing is lost, soft as the bulk may be; d = s - A
    /// p(s)/k_b.
    void withoutSurfaceTensionReversible()
    {
        Setting s;
        s.meniscus.surfaceTension = 0.0;
        const MultiAsperity model = s.model();
        const auto curve = multiAsperityCurve(model, 6e-9, 0.5e-9, 301);
        QVERIFY(curve.touchDowns.empty() && curve.takeOffs.empty());
        QCOMPARE(curve.towards.size(), curve.away.size());
        const double largest = curve.away.front().forces.contact;
        for (std::size_t i = 0; i < curve.away.size(); ++i) {
            const auto& in = curve.towards[curve.towards.size() - 1 - i];
            const auto& out = curve.away[i];
            QVERIFY(near(in.padSeparation, out.padSeparation, 1e-22));
            QVERIFY(near(in.forces.contact, out.forces.contact, 1e-9 * largest));
            QCOMPARE(out.forces.adhesion, 0.0);
        }
        QVERIFY(worstSpacing(curve, model) < 1e-20);
        QVERIFY(std::abs(curve.work) < 1e-9 * largest * 5.5e-9);
    }

    /// A cycle never yields work, whatever the model: soft and stiff, sparse and dense, tall and low.
    void noWorkIsGained_data()
    {
        QTest::addColumn<double>("density");
        QTest::addColumn<double>("deviation");
        QTest::addColumn<double>("area");
        QTest::newRow("dense and low") << 20e12 << 0.1e-9 << 4e-9;
        QTest::newRow("dense and tall") << 20e12 << 1e-9 << 4e-9;
        QTest::newRow("sparse and low") << 0.5e12 << 0.1e-9 << 4e-9;
        QTest::newRow("sparse and tall") << 0.5e12 << 1e-9 << 4e-9;
        QTest::newRow("small pad") << 5e12 << 0.3e-9 << 4e-11;
        QTest::newRow("large pad") << 5e12 << 0.3e-9 << 4e-8;
    }
    void noWorkIsGained()
    {
        QFETCH(double, density);
        QFETCH(double, deviation);
        QFETCH(double, area);
        Setting s;
        s.asperities.density = density;
        s.asperities.heightDeviation = deviation;
        s.area = area;
        const MultiAsperity model = s.model();
        const double closest = s.asperities.planeHeight - 2.0 * deviation;
        const auto curve = multiAsperityCurve(model, model.reach(), closest, 2001);
        QVERIFY(curve.work > 0.0);
        QVERIFY(worstSpacing(curve, model) < 1e-18);
        for (const auto* way : {&curve.towards, &curve.away}) {
            for (const MultiAsperityPoint& point : *way) {
                const MultiAsperityForces& f = point.forces;
                QVERIFY(std::isfinite(f.total()) && f.contact >= 0.0 && f.adhesion <= 0.0);
                QVERIFY(f.menisci <= density * area * 1.0000001 && f.contacts <= density * area * 1.0000001);
                QVERIFY(f.storedEnergy >= 0.0);
                // zeta within its play.
                QVERIFY(point.state.wettedAbove <= point.state.separation - 0.5e-9 + 1e-21);
                QVERIFY(point.state.wettedAbove >= point.state.separation - 1.5e-9 - 1e-21);
            }
        }
        QCOMPARE(curve.towards.front().forces.total(), 0.0);
        QCOMPARE(curve.away.back().forces.total(), 0.0);
        // Two samplings agree: the trapezoid's area has settled.
        const auto finer = multiAsperityCurve(model, model.reach(), closest, 4001);
        QVERIFY2(near(finer.work, curve.work, 1e-3 * curve.work),
                 qPrintable(QString("%1 %2").arg(finer.work).arg(curve.work)));
    }
};

TOUCHDOWN_TEST(TestMultiAsperityCurve)

} // namespace test_multi_asperity_curve

#include "test_multi_asperity_curve.moc"
