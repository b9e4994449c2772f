// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/slip.h"

#include <cmath>

#include <QTest>

#include "core/physics/film/slip_model.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_slip {

class TestSlip : public QObject {
    Q_OBJECT

private slots:
    /// At Kn = 1.25 and 0.1; alpha = 0.8 makes a = 1.5.
    void flowFactors_data()
    {
        QTest::addColumn<SlipModel>("model");
        QTest::addColumn<double>("accommodation");
        QTest::addColumn<double>("knudsen");
        QTest::addColumn<double>("expected");
        QTest::newRow("continuum") << SlipModel::Continuum << 1.0 << 1.25 << 1.0;
        QTest::newRow("first order") << SlipModel::FirstOrder << 1.0 << 1.25 << 8.5;
        QTest::newRow("first order, alpha 0.8") << SlipModel::FirstOrder << 0.8 << 0.1 << 1.9;
        QTest::newRow("second order") << SlipModel::SecondOrder << 1.0 << 1.25 << 17.875;
        QTest::newRow("1.5 order") << SlipModel::OnePointFiveOrder << 1.0 << 1.25 << 8.5 + 8.0 / 3.0 * 1.5625;
        QTest::newRow("1.5 order, alpha 0.8") << SlipModel::OnePointFiveOrder << 0.8 << 0.1 << 1.9 + 0.08 / 3.0;
        QTest::newRow("new first order") << SlipModel::NewFirstOrder << 1.0 << 1.25 << 6.0;
        QTest::newRow("new first order, alpha 0.8") << SlipModel::NewFirstOrder << 0.8 << 0.1 << 1.6;
        QTest::newRow("new second order") << SlipModel::NewSecondOrder << 1.0 << 1.25 << 10.6875;
        QTest::newRow("new second order, alpha 0.8") << SlipModel::NewSecondOrder << 0.8 << 0.1 << 1.63;
    }
    void flowFactors()
    {
        QFETCH(SlipModel, model);
        QFETCH(double, accommodation);
        QFETCH(double, knudsen);
        QFETCH(double, expected);
        QVERIFY(std::abs(flowFactor({.model = model, .accommodation = accommodation}, knudsen) / expected - 1.0) <
                1e-15 * 4.0);
    }

    /// D = 1, Kn = sqrt(pi)/2: the kinetic value 1.53842, the fit's 0.13852 + 1.25087 + 0.15653 - 0.00969 = 1.53623.
    void fukuiKaneko()
    {
        const double knudsen = 0.88622692545275801;
        QVERIFY(std::abs(inverseKnudsen(knudsen) - 1.0) < 1e-15);
        QVERIFY(std::abs(flowFactor({.model = SlipModel::FukuiKaneko}, knudsen) - 6.0 * 1.53842) < 6.0 * 0.000005);
        QVERIFY(std::abs(flowFactor({.model = SlipModel::FukuiKanekoFit}, knudsen) - 6.0 * 1.53623) < 1e-13);
    }

    /// Without rarefaction all models are the continuum's, and to first order in Kn they differ as their first
    /// coefficients.
    void thinSlip_data()
    {
        QTest::addColumn<SlipModel>("model");
        QTest::addColumn<double>("first");
        QTest::newRow("first order") << SlipModel::FirstOrder << 6.0;
        QTest::newRow("second order") << SlipModel::SecondOrder << 6.0;
        QTest::newRow("1.5 order") << SlipModel::OnePointFiveOrder << 6.0;
        QTest::newRow("new first order") << SlipModel::NewFirstOrder << 4.0;
        QTest::newRow("new second order") << SlipModel::NewSecondOrder << 4.0;
        // 6 * 1.0162/D = 6 * 1.0162 * 2/sqrt(pi) Kn
        QTest::newRow("Fukui-Kaneko") << SlipModel::FukuiKaneko << 6.0 * 1.0162 * 1.1283791670955126;
        QTest::newRow("Fukui-Kaneko fit") << SlipModel::FukuiKanekoFit << 6.0 * 1.0162 * 1.1283791670955126;
    }
    void thinSlip()
    {
        QFETCH(SlipModel, model);
        QFETCH(double, first);
        const double knudsen = 1e-6;
        QVERIFY(std::abs((flowFactor({.model = model}, knudsen) - 1.0) / knudsen / first - 1.0) < 3e-6);
    }

    void namesFollowTheEnumerators()
    {
        QCOMPARE(slipLaw(SlipModel::Continuum).name, std::string_view("continuum"));
        QCOMPARE(slipLaw(SlipModel::OnePointFiveOrder).name, std::string_view("1.5-order"));
        QCOMPARE(slipLaw(SlipModel::FukuiKaneko).name, std::string_view("fukui-kaneko"));
        QCOMPARE(slipLaw(SlipModel::FukuiKanekoFit).name, std::string_view("fukui-kaneko-fit"));
        QCOMPARE(slipLaw(SlipModel::NewSecondOrder).name, std::string_view("new-second-order"));
        QCOMPARE(slipLaw(SlipModel::Combination).name, std::string_view("combination"));
    }
};

TOUCHDOWN_TEST(TestSlip)

} // namespace test_slip

#include "test_slip.moc"
