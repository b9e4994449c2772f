// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/sample_extremes.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_sample_extremes {

class TestSampleExtremes : public QObject {
    Q_OBJECT

private slots:
    /// A parabola through any three points of a parabola is that parabola: f = 3 + (t - 0.3)^2, least 3 at 0.3.
    void aParabolaIsExact()
    {
        SampleExtremes extremes(2);
        for (const double t : {0.0, 0.25, 1.0}) {
            const double f = 3.0 + (t - 0.3) * (t - 0.3);
            extremes.add(t, std::vector{f, -f}, true);
        }
        QVERIFY(std::abs(extremes.least()[0] - 3.0) < 1e-15);
        QVERIFY(std::abs(extremes.most()[1] + 3.0) < 1e-15);
        QCOMPARE(extremes.most()[0], 3.0 + 0.7 * 0.7);
    }
    /// Points h = 2 pi/n apart, the extreme at worst in the middle between two of them: the parabola through -3/2 h,
    /// -1/2 h and 1/2 h has at 0 the value -9/16 h^4 for x^4, so that it is off by 9/16 h^4/24 for cos x.
    void aSine_data()
    {
        QTest::addColumn<int>("n");
        for (const int n : {8, 16, 32}) QTest::newRow(qPrintable(QString::number(n))) << n;
    }
    void aSine()
    {
        QFETCH(int, n);
        double worst = 0.0;
        for (int phase = 0; phase < 50; ++phase) {
            SampleExtremes extremes(1);
            for (int i = 0; i <= 2 * n; ++i) {
                const double t = 2.0 * std::numbers::pi * (i + phase / 50.0) / n;
                extremes.add(t, std::vector{std::sin(t)}, true);
            }
            worst = std::max({worst, std::abs(extremes.most()[0] - 1.0), std::abs(extremes.least()[0] + 1.0)});
        }
        const double bound = std::pow(2.0 * std::numbers::pi / n, 4) * 9.0 / 384.0;
        QVERIFY2(worst < bound, qPrintable(QString("%1 of %2").arg(worst).arg(bound)));
        QVERIFY(worst > 0.8 * bound);
    }
    /// Across a jump no parabola: 0, 0.1 | 5 would dip below zero.
    void aJumpBendsNothing()
    {
        SampleExtremes extremes(1);
        extremes.add(0.0, std::vector{0.2}, true);
        extremes.add(1.0, std::vector{0.1}, true);
        extremes.add(1.0, std::vector{5.0}, false);
        extremes.add(2.0, std::vector{4.0}, true);
        QCOMPARE(extremes.least()[0], 0.1);
        QCOMPARE(extremes.most()[0], 5.0);
    }
    /// Where contact begins, 0, 0, 1, a parabola would dip below zero.
    void keepsItsSign()
    {
        SampleExtremes extremes(2);
        for (const double t : {0.0, 1.0, 2.0}) {
            const double force = t == 2.0 ? 1.0 : 0.0;
            extremes.add(t, std::vector{force, -force}, true);
        }
        QCOMPARE(extremes.least()[0], 0.0);
        QCOMPARE(extremes.most()[1], 0.0);
    }
    void restartsAtTheLastPoint()
    {
        SampleExtremes extremes(1);
        extremes.add(0.0, std::vector{1.0}, true);
        extremes.add(1.0, std::vector{3.0}, true);
        extremes.restart();
        extremes.add(2.0, std::vector{3.5}, true);
        QCOMPARE(extremes.least()[0], 3.0);
        QCOMPARE(extremes.most()[0], 3.5);
        // The parabola still knows the points before the restart: 1, 3, 3.5, 3.4 turns between the last ones.
        extremes.restart();
        extremes.add(3.0, std::vector{3.4}, true);
        QVERIFY(extremes.most()[0] > 3.5);
    }
    /// Values known to 1e-6 at two times 1e-9 apart have no slope that is worth a parabola: its vertex would be far
    /// below.
    void pointsAtNearlyOneTimeBendNothing()
    {
        SampleExtremes extremes(1);
        extremes.add(0.0, std::vector{1.0 + 1e-6}, true);
        extremes.add(1e-9, std::vector{1.0}, true);
        extremes.add(1.0, std::vector{1.1}, true);
        QVERIFY(std::abs(extremes.least()[0] - 1.0) < 1e-12);
    }
    void noNumberDoesNotSpread()
    {
        SampleExtremes extremes(1);
        const double none = std::numeric_limits<double>::quiet_NaN();
        double time = 0.0;
        for (const double value : {1.0, none, 2.0, none, 1.5}) extremes.add(time++, std::vector{value}, true);
        QCOMPARE(extremes.least()[0], 1.0);
        QCOMPARE(extremes.most()[0], 2.0);
    }
};

TOUCHDOWN_TEST(TestSampleExtremes)

} // namespace test_sample_extremes

#include "test_sample_extremes.moc"
