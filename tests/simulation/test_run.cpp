// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run.h"

#include <cmath>

#include <QTest>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "tests/simulation/run_trace.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_run {

class TestRun : public QObject {
    Q_OBJECT

private slots:
    void everySampleArrives_data() { integratorRows(); }
    void everySampleArrives()
    {
        QFETCH(int, integrator);
        Case c;
        c.run.integrator = IntegratorKind(integrator);
        c.run.step = 7e-9; // not a divisor of the sample interval
        c.run.duration = 100e-6;
        c.run.stepCheck = false;
        Trace trace;
        const Summary summary = run(c, trace.recorder(c));
        QCOMPARE(summary.status, RunStatus::Completed);
        QCOMPARE(trace.time.size(), std::size_t{1001});
        for (std::size_t i = 0; i < trace.time.size(); ++i) QVERIFY(std::abs(trace.time[i] - 1e-7 * double(i)) < 1e-18);
        QCOMPARE(summary.endTime, 100e-6);
        QCOMPARE(trace.flyingHeight.front(), 250e-9);
    }

    /// Rounding of sample times near the end of millions of samples loses none: as numbers, 9100000 * 0.11e-6 > 1.001.
    void everyOneOfMillionsOfSamplesArrives()
    {
        Case c = massOnASpring();
        c.suspension.stiffness = 0.0;
        c.run.duration = 1.001;
        c.run.sampleInterval = 0.11e-6;
        long long count = 0;
        run(c, [&](const RunUpdate& update) {
            count += static_cast<long long>(update.samples.size());
            return true;
        });
        QCOMPARE(count, 9100001LL);
    }

    /// Free flight is one step with a million samples in it: it stops at the batch at which it is told to.
    void cancellingWithinAStep()
    {
        Case c = massOnASpring();
        c.suspension.stiffness = 0.0;
        c.run.sampleInterval = 1e-6 * c.run.duration;
        int updates = 0;
        std::size_t samples = 0;
        const Summary summary = run(c, [&](const RunUpdate& update) {
            samples += update.samples.size();
            return ++updates < 3;
        });
        QCOMPARE(summary.status, RunStatus::Cancelled);
        QCOMPARE(updates, 4); // the last one hands on what was left
        QVERIFY(samples < 4 * 1024);
        QVERIFY(summary.endTime >= double(samples - 1) * c.run.sampleInterval &&
                summary.endTime < 0.01 * c.run.duration);
    }

    void cancelling()
    {
        Case c;
        c.run.duration = 10.0;
        c.run.sampleInterval = 1e-6;
        int updates = 0;
        bool behind = true; // no sample is of a time not yet reached
        const Summary summary = run(c, [&](const RunUpdate& update) {
            for (const double t : update.samples.time) behind = behind && t <= update.time;
            return ++updates < 3;
        });
        QVERIFY(behind);
        QCOMPARE(summary.status, RunStatus::Cancelled);
        QCOMPARE(updates, 4); // the last one hands on what was left
        QVERIFY(summary.endTime > 0.0 && summary.endTime < 10.0);
    }

    void repeatsToTheBit()
    {
        const Case c = sample("fig14b");
        Trace a, b;
        run(c, a.recorder(c));
        run(c, b.recorder(c));
        QVERIFY(a.flyingHeight == b.flyingHeight);
        QVERIFY(a.pitch == b.pitch);
    }

    void everySampleCaseRuns_data()
    {
        QTest::addColumn<QString>("name");
        for (const SampleCase& sample : sampleCases())
            if (parseCase(sample.text, sample.name).value.model == ModelKind::Springs)
                QTest::newRow(sample.name.c_str()) << QString::fromStdString(sample.name);
    }
    void everySampleCaseRuns()
    {
        QFETCH(QString, name);
        const Case c = sample(qPrintable(name));
        Trace trace;
        const Summary summary = run(c, trace.recorder(c));
        QCOMPARE(summary.status, name == "fig12b" ? RunStatus::Failed : RunStatus::Completed);
        QCOMPARE(summary.endTime, c.run.duration);
        QVERIFY(trace.finite);
        QVERIFY(!summary.tail.empty());
        // No sustained bouncing on a flat disk, as the paper found; the undamped textbook bounce is meant to go on.
        QCOMPARE(summary.bouncing(), name == "textbook_bounce");
        QCOMPARE(summary.verdict.motion == Motion::NotJudged, summary.status == RunStatus::Failed);
    }

    void aFilmCaseRecordsItsAttitude()
    {
        const Case c = sample("film_plane");
        QVERIFY(reasonNotToRun(c).empty());
        for (const char* name : {"flying_height", "minimum_spacing", "pitch", "roll", "air_bearing_force", "energy"})
            QVERIFY2(findQuantity(recordedQuantities(c), name) >= 0, name);
        QCOMPARE(recordedFields(c).size(), std::size_t(1)); // of the film; there is no contact
    }
};

TOUCHDOWN_TEST(TestRun)

} // namespace test_run

#include "test_run.moc"
