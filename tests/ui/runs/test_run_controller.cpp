// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <functional>
#include <stdexcept>
#include <thread>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/results/results_reader.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "ui/runs/run_controller.h"

using namespace touchdown;

namespace test_run_controller {

using State = RunController::State;

constexpr double microsecond = 1e-6; // [s]

/// Samples at 0, 1, 2, ... us in batches; the value of each is its number. An event with every hundredth.
struct Counter {
    long long samples = 1000;
    long long perBatch = 100;

    Summary operator()(const Case&, const RunCallback& callback, const RunOptions&) const
    {
        Summary summary;
        const double duration = static_cast<double>(samples - 1) * microsecond;
        for (long long k = 0; k < samples;) {
            SampleBatch batch;
            batch.columns.resize(1);
            std::vector<RunEvent> events;
            for (long long i = 0; i < perBatch && k < samples; ++i, ++k) {
                batch.time.push_back(static_cast<double>(k) * microsecond);
                batch.columns[0].push_back(static_cast<double>(k));
                if (k % 100 == 0) events.push_back({batch.time.back(), "touch-down"});
            }
            summary.endTime = batch.time.back();
            if (!callback({summary.endTime, duration, batch, events, {}})) {
                summary.status = RunStatus::Cancelled;
                return summary;
            }
        }
        return summary;
    }
};

/// Collects what arrives, and checks that it is in order and belongs to the run that is under way.
struct Received {
    explicit Received(RunController& controller)
    {
        QObject::connect(&controller, &RunController::delivered, &controller,
                         [this, &controller](const RunDelivery& delivery) {
                             ++deliveries;
                             foreign += delivery.run != controller.current();
                             for (std::size_t i = 0; i < delivery.samples.size(); ++i) {
                                 disordered += !times.empty() && delivery.samples.time[i] <= times.back();
                                 times.push_back(delivery.samples.time[i]);
                             }
                             for (const RunEvent& event : delivery.events) early += event.time > delivery.time;
                             events += delivery.events.size();
                         });
        QObject::connect(&controller, &RunController::finished, &controller, [this](int run, const Summary& ended) {
            finishedRuns.push_back(run);
            summary = ended;
        });
    }

    std::vector<double> times;
    std::size_t events = 0;
    int deliveries = 0, foreign = 0, disordered = 0, early = 0;
    std::vector<int> finishedRuns;
    Summary summary;
};

RunRequest sampleRequest(const char* name)
{
    const CaseDocument document = openCase(name);
    return {document.value, document.text, {}};
}

class TestRunController : public QObject {
    Q_OBJECT

private slots:
    void deliversEverySample();
    void deliversEverySampleOfARealRun();
    void coalescesDeliveries();
    void keepsEventsWithTheirSamples();
    void deliversEveryField();
    void keepsFieldsWithTheirSamples();
    void stopsAnEndlessRunInSlowMotion();
    void stopsWhilePaused();
    void endsAStoppedRunWhereItWasSeen();
    void stepsByOnePicture();
    void changesPaceWhileRunning();
    void startsAgainWhileRunning();
    void turnsAnExceptionIntoAFailure();
    void joinsWhenDestroyed();
    void recordsToAFile();
    void recordsFieldsToAFile();
    void saysWhyAFileCannotBeRecorded();
};

void TestRunController::deliversEverySample()
{
    RunController controller(Counter{2'000'000, 1000});
    Received received(controller);
    controller.start({});
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), State::Idle, 30000);
    QCOMPARE(received.times.size(), std::size_t(2'000'000));
    QCOMPARE(received.disordered, 0);
    QCOMPARE(received.foreign, 0);
    // One event with each hundredth sample.
    QCOMPARE(received.events, std::size_t(20'000));
}

void TestRunController::deliversEverySampleOfARealRun()
{
    RunController controller;
    Received received(controller);
    RunRequest request = sampleRequest("fig10a");
    const double intervals = request.value.run.duration / request.value.run.sampleInterval;
    controller.start(std::move(request));
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.summary.status, RunStatus::Completed);
    // A sample at the start and one at the end of each interval.
    QCOMPARE(received.times.size(), static_cast<std::size_t>(std::llround(intervals)) + 1);
    QCOMPARE(received.times.back(), 2e-3);
}

void TestRunController::coalescesDeliveries()
{
    // 20 000 batches at once are far more than pictures.
    RunController controller(Counter{200'000, 10});
    Received received(controller);
    controller.start({});
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), State::Idle, 30000);
    QCOMPARE(received.times.size(), std::size_t(200'000));
    QVERIFY2(received.deliveries < 2000, qPrintable(QString::number(received.deliveries)));
}

void TestRunController::keepsEventsWithTheirSamples()
{
    // 999 us at 10 ms/s take 0.1 s of slices.
    RunController controller(Counter{1000, 1000});
    Received received(controller);
    controller.setPace(1e-2);
    controller.start({});
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.times.size(), std::size_t(1000));
    QCOMPARE(received.events, std::size_t(10));
    QCOMPARE(received.early, 0);
    QVERIFY(received.deliveries > 1);
}

/// Snapshots of a given number of values with every tenth sample, all in one update.
struct Photographer {
    std::size_t values = 1000;

    Summary operator()(const Case&, const RunCallback& callback, const RunOptions&) const
    {
        SampleBatch batch;
        batch.columns.resize(1);
        std::vector<FieldSnapshot> fields;
        for (int k = 0; k < 200; ++k) {
            batch.time.push_back(k * microsecond);
            batch.columns[0].push_back(k);
            if (k % 10 == 0) fields.push_back({batch.time.back(), 0, {std::vector<double>(values, k)}});
        }
        callback({199 * microsecond, 199 * microsecond, batch, {}, fields});
        return {};
    }
};

void TestRunController::deliversEveryField()
{
    // 20 snapshots of 2^18 values are more than the mailbox holds of them: the solver waits, and nothing is lost.
    RunController controller(Photographer{std::size_t(1) << 18});
    std::vector<FieldSnapshot> received;
    connect(&controller, &RunController::delivered, this, [&](const RunDelivery& delivery) {
        received.insert(received.end(), delivery.fields.begin(), delivery.fields.end());
    });
    controller.start({});
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), State::Idle, 30000);
    QCOMPARE(received.size(), std::size_t(20));
    for (std::size_t i = 0; i < received.size(); ++i) {
        QCOMPARE(received[i].time, 10.0 * static_cast<double>(i) * microsecond);
        QCOMPARE(received[i].values[0].back(), 10.0 * static_cast<double>(i));
    }
}

void TestRunController::keepsFieldsWithTheirSamples()
{
    RunController controller(Photographer{});
    controller.setPace(2e-3); // 200 us of the run in 0.1 s: several deliveries
    int early = 0;
    std::size_t fields = 0;
    connect(&controller, &RunController::delivered, this, [&](const RunDelivery& delivery) {
        for (const FieldSnapshot& snapshot : delivery.fields) early += snapshot.time > delivery.time;
        fields += delivery.fields.size();
    });
    controller.start({});
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), State::Idle, 30000);
    QCOMPARE(fields, std::size_t(20));
    QCOMPARE(early, 0);
}

void TestRunController::stopsAnEndlessRunInSlowMotion()
{
    RunController controller(Counter{std::numeric_limits<int>::max(), 100});
    Received received(controller);
    controller.setPace(1e-9); // the second sample would come after 1000 s
    controller.start({});
    QTRY_COMPARE(received.times.size(), std::size_t(1));
    controller.stop();
    QCOMPARE(controller.state(), State::Stopping);
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.summary.status, RunStatus::Cancelled);
    QCOMPARE(received.times.size(), std::size_t(1));
}

void TestRunController::stopsWhilePaused()
{
    RunController controller(Counter{});
    Received received(controller);
    controller.setPace(1e-9);
    controller.start({});
    QTRY_COMPARE(received.times.size(), std::size_t(1));
    controller.pause();
    QCOMPARE(controller.state(), State::Paused);
    controller.stop();
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.summary.status, RunStatus::Cancelled);
}

void TestRunController::endsAStoppedRunWhereItWasSeen()
{
    RunController controller;
    Received received(controller);
    std::vector<double> heights;
    QObject::connect(&controller, &RunController::delivered, &controller, [&heights](const RunDelivery& delivery) {
        if (delivery.samples.size() == 0) return;
        heights.insert(heights.end(), delivery.samples.columns[0].begin(), delivery.samples.columns[0].end());
    });
    controller.setPace(1e-4);
    controller.start(sampleRequest("fig10a"));
    QTRY_VERIFY(received.times.size() > 100);
    controller.stop();
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.summary.status, RunStatus::Cancelled);
    QVERIFY(received.times.size() < 20'001);
    QCOMPARE(received.summary.endTime, received.times.back());
    QCOMPARE(received.summary.final.front().first, std::string("flying_height"));
    QCOMPARE(received.summary.final.front().second, heights.back());
}

void TestRunController::stepsByOnePicture()
{
    RunController controller(Counter{1001, 1001});
    Received received(controller);
    controller.setPace(1e-9);
    controller.start({});
    QTRY_COMPARE(received.times.size(), std::size_t(1));
    controller.pause();
    controller.setPace(RunController::fullSpeed);
    // At full speed a step is 1/200 of the duration: 5 us, so 5 samples.
    controller.step();
    QTRY_COMPARE(received.times.size(), std::size_t(6));
    controller.step();
    QTRY_COMPARE(received.times.size(), std::size_t(11));
    QCOMPARE(controller.state(), State::Paused);
    // At 0.6 ms/s it is what a sixtieth of a second brings: 10 us.
    controller.setPace(6e-4);
    controller.step();
    QTRY_COMPARE(received.times.size(), std::size_t(21));
    controller.setPace(RunController::fullSpeed);
    controller.resume();
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.times.size(), std::size_t(1001));
    QCOMPARE(received.disordered, 0);
}

void TestRunController::changesPaceWhileRunning()
{
    RunController controller(Counter{});
    Received received(controller);
    controller.setPace(1e-9);
    controller.start({});
    QTRY_COMPARE(received.times.size(), std::size_t(1));
    controller.setPace(RunController::fullSpeed);
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.times.size(), std::size_t(1000));
    QCOMPARE(received.summary.status, RunStatus::Completed);
}

void TestRunController::startsAgainWhileRunning()
{
    RunController controller(Counter{});
    Received received(controller);
    controller.setPace(1e-9);
    QCOMPARE(controller.start({}), 1);
    QTRY_COMPARE(received.times.size(), std::size_t(1));
    received.times.clear();
    controller.setPace(RunController::fullSpeed);
    controller.setPace(1e-9);
    QCOMPARE(controller.start({}), 2);
    // The first has ended before the second has begun.
    QCOMPARE(received.finishedRuns, std::vector<int>{1});
    received.times.clear();
    controller.setPace(RunController::fullSpeed);
    QTRY_COMPARE(received.finishedRuns, (std::vector<int>{1, 2}));
    QCOMPARE(received.times.size(), std::size_t(1000));
    QCOMPARE(received.foreign, 0);
}

void TestRunController::turnsAnExceptionIntoAFailure()
{
    RunController controller([](const Case&, const RunCallback&, const RunOptions&) -> Summary {
        throw std::runtime_error("out of cheese");
    });
    Received received(controller);
    controller.start({});
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.summary.status, RunStatus::Failed);
    QVERIFY(received.summary.message.find("out of cheese") != std::string::npos);
}

void TestRunController::joinsWhenDestroyed()
{
    std::atomic<bool> returned = false;
    {
        RunController controller([&returned](const Case& c, const RunCallback& callback, const RunOptions& options) {
            const Summary summary = Counter{std::numeric_limits<int>::max(), 100}(c, callback, options);
            returned = true;
            return summary;
        });
        Received received(controller);
        controller.setPace(1e-9);
        controller.start({});
        QTRY_COMPARE(received.times.size(), std::size_t(1));
    }
    QVERIFY(returned);
}

void TestRunController::recordsToAFile()
{
    const QTemporaryDir folder;
    const std::string file = folder.filePath(QStringLiteral("run.h5")).toStdString();
    RunController controller;
    Received received(controller);
    RunRequest request = sampleRequest("fig10a");
    request.recordTo = file;
    const std::string text = request.caseText;
    controller.start(std::move(request));
    QTRY_COMPARE(controller.state(), State::Idle);
    const StoredRun stored = readResults(file);
    QCOMPARE(stored.problem, std::string());
    QCOMPARE(stored.status, std::string("completed"));
    QCOMPARE(stored.caseText, text);
    QCOMPARE(stored.samples.time, received.times);
}

void TestRunController::recordsFieldsToAFile()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("contact.h5"));
    RunRequest request = sampleRequest("contact_hertz");
    request.value.elastic.cell = 1e-6;
    request.value.run.fieldSnapshots = 9;
    request.recordTo = file.toStdString();
    RunController controller;
    std::vector<FieldSnapshot> seen;
    connect(&controller, &RunController::delivered, this, [&seen](const RunDelivery& delivery) {
        seen.insert(seen.end(), delivery.fields.begin(), delivery.fields.end());
    });
    const QSignalSpy failed(&controller, &RunController::recordingFailed);
    controller.start(request);
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), State::Idle, 30000);
    QCOMPARE(failed.count(), 0);
    const StoredRun stored = readResults(file.toStdString());
    QCOMPARE(stored.problem, std::string());
    QVERIFY(seen.size() >= 9);
    QCOMPARE(stored.fields.size(), seen.size());
    for (std::size_t i = 0; i < seen.size(); ++i) QCOMPARE(stored.fields[i].values, seen[i].values);
}

void TestRunController::saysWhyAFileCannotBeRecorded()
{
    const QTemporaryDir folder;
    RunController controller;
    const QSignalSpy failures(&controller, &RunController::recordingFailed);
    Received received(controller);
    RunRequest request = sampleRequest("fig10a");
    request.recordTo = folder.filePath(QStringLiteral("missing/run.h5")).toStdString();
    controller.start(std::move(request));
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(failures.count(), 1);
    QVERIFY2(failures[0][1].toString().contains(QStringLiteral("missing")), qPrintable(failures[0][1].toString()));
    // The run itself goes on.
    QCOMPARE(received.times.size(), std::size_t(20'001));
}

TOUCHDOWN_TEST(TestRunController)

} // namespace test_run_controller

#include "test_run_controller.moc"
