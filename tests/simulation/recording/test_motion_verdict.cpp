// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/motion_verdict.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_motion_verdict {

/// amplitude * exp(-decay i/n) * sin(2 pi periods i/n) + drift i/n, of n = 1000 samples.
std::vector<double> signal(double amplitude, double periods, double decay = 0.0, double drift = 0.0)
{
    std::vector<double> result;
    for (int i = 0; i < 1000; ++i) {
        const double share = i / 1000.0;
        result.push_back(amplitude * std::exp(-decay * share) * std::sin(2 * std::numbers::pi * periods * share) +
                         drift * share);
    }
    return result;
}

class TestMotionVerdict : public QObject {
    Q_OBJECT

private slots:
    /// Within one period: the ends of the window cut up to half a period at each side.
    void periods_data()
    {
        QTest::addColumn<double>("periods");
        for (const double n : {1.0, 2.0, 3.5, 20.0}) QTest::newRow(qPrintable(QString::number(n))) << n;
    }
    void periods()
    {
        QFETCH(double, periods);
        const double found = periodsOf(signal(1e-9, periods));
        QVERIFY2(found <= periods && found > periods - 1.0, qPrintable(QString::number(found)));
    }
    void aDriftHasNoPeriod()
    {
        QVERIFY(periodsOf(signal(0.0, 1.0, 0.0, 1e-9)) < 1.0);
        QCOMPARE(periodsOf(signal(0.0, 1.0)), 0.0);
        QCOMPARE(periodsOf({}), 0.0);
        // A ripple of a tenth of the main motion counts for nothing.
        std::vector<double> both = signal(1e-9, 5.0);
        const std::vector<double> ripple = signal(0.1e-9, 100.0);
        for (std::size_t i = 0; i < both.size(); ++i) both[i] += ripple[i];
        QVERIFY(periodsOf(both) <= 5.0);
    }
    /// A strongly damped swing has come to rest; the turn of a slow and large one has not.
    void whatMovesOn()
    {
        QVERIFY(!movesOn(signal(1e-9, 20.0, 12.0)));
        QVERIFY(!movesOn(signal(0.0, 1.0)));
        QVERIFY(!movesOn(signal(0.0, 1.0, 0.0, 0.05e-9)));
        QVERIFY(movesOn(signal(0.0, 1.0, 0.0, 0.07e-9)));
        QVERIFY(movesOn(signal(1e-9, 0.25)));
        QVERIFY(!movesOn({}));
    }
    void verdicts()
    {
        const MotionEvidence lasting{.swing = 1e-9, .swingBefore = 1e-9, .periods = 3.0};
        QCOMPARE(motionOf(lasting), Motion::Swings);
        const auto with = [&](auto change) {
            MotionEvidence evidence = lasting;
            change(evidence);
            return motionOf(evidence);
        };
        QCOMPARE(with([](MotionEvidence& e) { e.touches = true; }), Motion::Bounces);
        QCOMPARE(with([](MotionEvidence& e) { e.periods = 2.5; }), Motion::TooShort);
        QCOMPARE(with([](MotionEvidence& e) { e.samples = 9; }), Motion::TooShort);
        QCOMPARE(with([](MotionEvidence& e) { e.samples = 9, e.swing = 0.0; }), Motion::TooShort);
        QCOMPARE(with([](MotionEvidence& e) { e.swingBefore = 1.12e-9; }), Motion::Settles);
        QCOMPARE(with([](MotionEvidence& e) { e.swingBefore = 1.10e-9; }), Motion::Swings);
        QCOMPARE(with([](MotionEvidence& e) { e.swing = 0.019e-9; }), Motion::AtRest);
        QCOMPARE(with([](MotionEvidence& e) { e.swing = 0.019e-9, e.movesOn = true; }), Motion::TooShort);
        QCOMPARE(with([](MotionEvidence& e) { e.swing = e.swingBefore = 0.021e-9; }), Motion::Swings);
    }
    void theRuleHasTheFigures()
    {
        const QString rule = QString::fromStdString(
            motionRule({.swing = 1.25e-9, .swingBefore = 1.3e-9, .periods = 20.5, .touches = true}));
        for (const char* part : {"1.25 nm", "1.3 nm", "20.5 periods", "touches", "90 %"})
            QVERIFY2(rule.contains(part), qPrintable(rule));
        QVERIFY(QString::fromStdString(motionRule({.swing = 1e-9, .swingBefore = 1e-9, .periods = 1.0}))
                    .contains("3 periods are needed"));
    }
    void namesAreDifferent()
    {
        std::set<std::string_view> names;
        for (const Motion motion :
             {Motion::NotJudged, Motion::AtRest, Motion::Settles, Motion::Swings, Motion::Bounces, Motion::TooShort})
            names.insert(name(motion));
        QCOMPARE(names.size(), std::size_t(6));
    }
};

TOUCHDOWN_TEST(TestMotionVerdict)

} // namespace test_motion_verdict

#include "test_motion_verdict.moc"
