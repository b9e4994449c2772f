// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/run_recorder.h"

#include <QTest>

#include "core/simulation/run.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_run_recorder {

class TestRunRecorder : public QObject {
    Q_OBJECT

private slots:
    /// 100,002 switches: the last two are told, not kept.
    void tellsOfSwitchesThatItDoesNotKeep()
    {
        const Case c = sample("fig10a");
        const RunCallback callback;
        RunRecorder recorder(c, recordedQuantities(c), callback);
        for (int i = 0; i < 100000; ++i) recorder.addEvent(1e-9 * i, "touch-down");
        QVERIFY(recorder.send(1e-4, 0.0));
        QVERIFY(recorder.summary({}, 1e-4).warnings.empty());
        recorder.addEvent(1e-4, "touch-down");
        recorder.addEvent(2e-4, "take-off");
        const Summary summary = recorder.summary({}, 2e-4);
        QCOMPARE(summary.events.size(), std::size_t(100000));
        QCOMPARE(summary.warnings.size(), std::size_t(1));
        QCOMPARE(summary.warnings.front(),
                 std::string("only the first 100000 switches are listed and counted; there are 2 more after 0.1 ms"));
    }

    /// A slider that bounces at 270 kHz, with samples each 5 us and 1.8 us: more and less than a period.
    void warnsOfSamplesTooFarApart()
    {
        Case c = sample("fig10a");
        c.springs.flyingHeight = 3.2e-9;
        c.onoYamane.takeOff = 4e-9;
        c.onoYamane.meniscusForce = 1e-3;
        const Summary fine = run(c);
        QCOMPARE(fine.verdict.motion, Motion::Bounces);
        QVERIFY(fine.verdict.frequency > 260e3 && fine.verdict.frequency < 280e3);
        for (const double interval : {5e-6, 1.8e-6}) {
            c.run.sampleInterval = interval;
            const Summary coarse = run(c);
            QCOMPARE(coarse.verdict.motion, Motion::Bounces);
            QCOMPARE(coarse.verdict.frequency, 0.0);
            QCOMPARE(textOf(coarse.verdict), std::string("bounces"));
            QVERIFY(!coarse.warnings.empty());
            QVERIFY(coarse.warnings.front().find("run.sample_interval") != std::string::npos);
        }
    }
};

TOUCHDOWN_TEST(TestRunRecorder)

} // namespace test_run_recorder

#include "test_run_recorder.moc"
