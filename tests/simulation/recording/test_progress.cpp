// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/progress.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_progress {

class TestProgress : public QObject {
    Q_OBJECT

private slots:
    /// 20 % in 10 s, so that the remaining 80 % take 40 s.
    void timeLeftFollowsTheMeanRate()
    {
        TimeLeft timeLeft;
        QVERIFY(!timeLeft.at(0.0, 100.0));
        QVERIFY(!timeLeft.at(0.005, 110.0)); // below 1 %
        QCOMPARE(timeLeft.at(0.2, 110.0).value(), 40.0);
        QVERIFY(!timeLeft.at(1.0, 120.0));
    }

    /// The preparation takes 30 s and does not count; then 10 % take 2 s.
    void timeLeftIgnoresAnUnknownShare()
    {
        TimeLeft timeLeft;
        timeLeft.at({}, 0.0);
        timeLeft.at({}, 30.0);
        timeLeft.at(0.0, 30.0);
        QVERIFY(!timeLeft.at(0.05, 30.4)); // less than 0.5 s
        QCOMPARE(timeLeft.at(0.1, 32.0).value(), 18.0);
    }

    /// 50 % before a pause of an hour; after it 25 % take 5 s.
    void timeLeftIgnoresAPause()
    {
        TimeLeft timeLeft;
        timeLeft.at(0.0, 0.0);
        timeLeft.at(0.5, 10.0);
        timeLeft.restart();
        timeLeft.at(0.5, 3610.0);
        QCOMPARE(timeLeft.at(0.75, 3615.0).value(), 5.0);
    }

    void aRunPreparesBeforeItsFirstStep()
    {
        const Progress before = runProgress(0.0, 2e-3), later = runProgress(1e-3, 2e-3, 5e-9);
        QVERIFY(!before.share && before.activity == "preparing");
        QVERIFY(later.share == 0.5 && later.activity.empty());
        QCOMPARE(later.figures.back().value, 5e-9);
    }
};

TOUCHDOWN_TEST(TestProgress)

} // namespace test_progress

#include "test_progress.moc"
