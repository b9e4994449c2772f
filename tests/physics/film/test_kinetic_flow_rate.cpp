// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/kinetic_flow_rate.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_kinetic_flow_rate {

double below(double d) { return std::nextafter(d, 0.0); }

class TestKineticFlowRate : public QObject {
    Q_OBJECT

private slots:
    /// The tabulated kinetic values (BGK, variational), to half their last digit. At D = 2 and 3 the table
    /// (1.59403, 1.70922) is 1.2e-4 and 2.4e-5 below what the principle gives: by tests/support/kinetic_flow_rate.py,
    /// and by its double integrals on 160 Gauss points, 1.594146 and 1.709245.
    void tabulatedValues_data()
    {
        QTest::addColumn<double>("d");
        QTest::addColumn<double>("expected");
        const double table[][2] = {{.01, 3.04965}, {.02, 2.71114}, {.05, 2.30225}, {.1, 2.03270},
                                   {.15, 1.89519}, {.2, 1.80818},  {.3, 1.70243},  {.5, 1.60178},
                                   {1., 1.53842},  {2., 1.594146}, {3., 1.709245}, {5., 1.98833},
                                   {10., 2.76384}, {20., 4.39048}, {50., 9.36169}, {100., 17.68468}};
        for (const auto& row : table) QTest::addRow("D = %g", row[0]) << row[0] << row[1];
    }
    void tabulatedValues()
    {
        QFETCH(double, d);
        QFETCH(double, expected);
        QVERIFY2(std::abs(kineticFlowRate(d).value - expected) <= 0.0000052,
                 qPrintable(QString::number(kineticFlowRate(d).value, 'g', 9)));
    }

    /// Half-way between the stored values, where the cubic pieces err most: 40 digits of
    /// tests/support/kinetic_flow_rate.py.
    void betweenTheStoredValues_data()
    {
        QTest::addColumn<double>("d");
        QTest::addColumn<double>("expected");
        const double exact[][2] = {
            {0.000115478198, 5.4764814481}, {0.00115478198, 4.1945022103}, {0.0115478198, 2.9777161783},
            {0.115478198, 1.9820252554},    {0.205352503, 1.8006727752},   {0.649381632, 1.5667488452},
            {1.15478198, 1.5384788279},     {2.73841963, 1.6765252347},    {3.65174127, 1.7957146738},
            {4.86967525, 1.9691634082},     {6.49381632, 2.2134463604},    {11.5478198, 3.01201214},
            {15.3992653, 3.6366811136},     {36.5174127, 7.1220057245},    {86.5964323, 15.452373242}};
        for (const auto& row : exact) QTest::addRow("D = %g", row[0]) << row[0] << row[1];
    }
    void betweenTheStoredValues()
    {
        QFETCH(double, d);
        QFETCH(double, expected);
        const double error = kineticFlowRate(d).value / expected - 1.0;
        QVERIFY2(std::abs(error) < 4e-7, qPrintable(QString::number(error)));
    }

    /// 40 digits give 6.85374154976 at 1e-5 and 9.45146641727 at 1e-7; Q_P + ln(D)/sqrt(pi) becomes a constant.
    void freeMolecules()
    {
        QVERIFY(std::abs(kineticFlowRate(1e-5).value / 6.85374154976 - 1.0) < 1e-4);
        QVERIFY(std::abs(kineticFlowRate(1e-7).value / 9.45146641727 - 1.0) < 1e-4);
        const auto constant = [](double d) {
            return kineticFlowRate(d).value + std::log(d) * std::numbers::inv_sqrtpi;
        };
        QVERIFY(std::abs(constant(1e-100) - constant(1e-200)) < 1e-12);
        QVERIFY(std::isfinite(kineticFlowRate(std::numeric_limits<double>::denorm_min()).value));
    }

    void slipFlow()
    {
        // 1000/6 + 1.0162 + 0.0010653
        QVERIFY(std::abs(kineticFlowRate(1000.0).value - 167.68393196666667) < 1e-12);
        QVERIFY(std::abs(kineticFlowRate(1e6).value - (1e6 / 6.0 + 1.0162 + 1.0653e-6)) < 1e-9);
        // On the way there it stays between the two laws: 34.346033 by 40 digits, 200/6 + 1.0162 + 1.0653/200
        // = 34.354860.
        const double between = kineticFlowRate(200.0).value;
        QVERIFY(between > 34.346033 && between < 34.354860);
    }

    /// Values and slopes meet where the laws do and where cubic pieces meet.
    void continuouslyDifferentiable()
    {
        for (double d = 1e-4; d < 2000.0; d *= std::pow(10.0, 0.125)) {
            for (const double at : {d * (1.0 - 1e-13), d, d * (1.0 + 1e-13)}) {
                const FlowRate left = kineticFlowRate(at * (1.0 - 1e-12)), right = kineticFlowRate(at * (1.0 + 1e-12));
                QVERIFY(std::abs(left.value - right.value) < 1e-11 * right.value);
                QVERIFY(std::abs(left.logSlope - right.logSlope) < 1e-11 * right.value);
            }
        }
    }

    /// The slope is the values' own; 6 Q_P/D falls: dQ_P/d ln D < Q_P.
    void slopeAndMonotony_data()
    {
        QTest::addColumn<bool>("fitted");
        QTest::newRow("kinetic values") << false;
        QTest::newRow("fit") << true;
    }
    void slopeAndMonotony()
    {
        QFETCH(bool, fitted);
        const auto flowRate = fitted ? fittedFlowRate : kineticFlowRate;
        for (double d = 1e-9; d < 1e6; d *= 1.0372) {
            const FlowRate q = flowRate(d);
            const double e = 1e-5;
            const double slope = (flowRate(d * std::exp(e)).value - flowRate(d * std::exp(-e)).value) / (2.0 * e);
            QVERIFY2(std::abs(q.logSlope - slope) < 1e-8 * q.value, qPrintable(QString::number(d)));
            QVERIFY(q.value > 0.0 && q.logSlope < q.value);
        }
    }

    /// By hand. D = 5: 5/6 + 1.0162 + 0.21306 - 0.085416 = 1.977177 and 0.6926 + 1.25087 + 0.031306 - 0.0003876
    /// = 1.9743884 below; D = 0.15: 0.020778 + 1.25087 + 1.0435333 - 0.4306667 = 1.8845147 and -0.3343785 + 2.10673 +
    /// 0.1102 - 0.0030844 = 1.8794671 below; D = 0.01: -0.0222919 + 2.10673 + 1.653 - 0.694 = 3.0434381, and e times
    /// less D is 1/sqrt(pi) more.
    void fit()
    {
        QVERIFY(std::abs(fittedFlowRate(5.0).value - 1.9771773) < 1e-7);
        QVERIFY(std::abs(fittedFlowRate(below(5.0)).value - 1.9743884) < 1e-7);
        QVERIFY(std::abs(fittedFlowRate(0.15).value - 1.8845147) < 1e-7);
        QVERIFY(std::abs(fittedFlowRate(below(0.15)).value - 1.8794671) < 1e-7);
        QVERIFY(std::abs(fittedFlowRate(0.01).value - 3.0434381) < 1e-12);
        QVERIFY(std::abs(fittedFlowRate(0.01 / std::numbers::e).value - 3.0434381 - 0.5641895835) < 1e-9);
    }

    /// What the fit is worth: within 0.9 % of the kinetic values in its range, and that far at D = 0.15.
    void fitAgainstTheKineticValues()
    {
        double worst = 0.0;
        for (double d = 0.01; d < 100.0; d *= 1.001)
            worst = std::max(worst, std::abs(fittedFlowRate(d).value / kineticFlowRate(d).value - 1.0));
        QVERIFY2(worst > 0.008 && worst < 0.009, qPrintable(QString::number(worst)));
    }
};

TOUCHDOWN_TEST(TestKineticFlowRate)

} // namespace test_kinetic_flow_rate

#include "test_kinetic_flow_rate.moc"
