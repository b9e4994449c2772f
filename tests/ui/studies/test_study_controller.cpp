// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_controller.h"

#include <atomic>
#include <stdexcept>
#include <thread>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_controller {

using State = StudyController::State;

/// Ten steps; after the fifth there is a chart to show.
StudyReport tenSteps(int jobs, const StudyCallback& callback)
{
    StudyReport report;
    report.title = std::to_string(jobs) + " threads";
    for (int i = 1; i <= 10; ++i) {
        if (i == 5) report.charts.resize(1);
        if (callback({i / 10.0, "step " + std::to_string(i), i == 5 ? &report : nullptr})) continue;
        report.status = StudyStatus::Cancelled;
        break;
    }
    return report;
}

/// Until it is stopped.
StudyReport endless(int, const StudyCallback& callback)
{
    StudyReport report;
    while (callback({0.5, "on and on", nullptr})) std::this_thread::yield();
    report.status = StudyStatus::Cancelled;
    return report;
}

struct Received {
    explicit Received(StudyController& controller)
    {
        QObject::connect(&controller, &StudyController::progressed, &controller, [this](int, const Progress& progress) {
            ++deliveries;
            disordered += *progress.share < share;
            share = *progress.share;
            activity = progress.activity;
        });
        QObject::connect(&controller, &StudyController::finished, &controller,
                         [this](int number, const StudyReport& ended) {
                             finished.push_back(number);
                             report = ended;
                         });
    }
    int deliveries = 0, disordered = 0;
    double share = 0.0;
    std::string activity;
    std::vector<int> finished;
    StudyReport report;
};

class TestStudyController : public QObject {
    Q_OBJECT

private slots:
    void deliversProgressAndReport();
    void showsWhatThereIsSoFar();
    void coalescesProgress();
    void stops();
    void startsAgainWhileUnderWay();
    void turnsAnExceptionIntoAFailure();
    void joinsWhenDestroyed();
};

void TestStudyController::deliversProgressAndReport()
{
    StudyController controller;
    Received received(controller);
    QCOMPARE(controller.start(tenSteps, 3), 1);
    QCOMPARE(controller.state(), State::Running);
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.finished, std::vector<int>{1});
    QCOMPARE(received.report.title, std::string("3 threads"));
    QCOMPARE(received.share, 1.0); // the last progress comes before the report
    QCOMPARE(received.activity, std::string("step 10"));
    QCOMPARE(received.disordered, 0);
}

void TestStudyController::showsWhatThereIsSoFar()
{
    StudyController controller;
    int charts = -1;
    connect(&controller, &StudyController::partial, this,
            [&charts](int, const StudyReport& report) { charts = static_cast<int>(report.charts.size()); });
    controller.start(
        [](int jobs, const StudyCallback& callback) {
            StudyReport soFar;
            soFar.charts.resize(2);
            callback({0.5, "", &soFar});
            return endless(jobs, callback);
        },
        1);
    QTRY_COMPARE(charts, 2);
    controller.stopAndWait();
}

void TestStudyController::coalescesProgress()
{
    StudyController controller;
    Received received(controller);
    controller.start(
        [](int, const StudyCallback& callback) {
            for (int i = 1; i <= 200'000; ++i) callback({i / 200'000.0, "", nullptr});
            return StudyReport{};
        },
        1);
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), State::Idle, 30'000);
    QVERIFY2(received.deliveries < 2000, qPrintable(QString::number(received.deliveries)));
    QCOMPARE(received.share, 1.0);
}

void TestStudyController::stops()
{
    StudyController controller;
    Received received(controller);
    controller.start(endless, 1);
    QTRY_VERIFY(received.deliveries > 0);
    controller.stop();
    QCOMPARE(controller.state(), State::Stopping);
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.report.status, StudyStatus::Cancelled);
    controller.stop(); // when idle: nothing
    QCOMPARE(controller.state(), State::Idle);
}

void TestStudyController::startsAgainWhileUnderWay()
{
    StudyController controller;
    Received received(controller);
    controller.start(endless, 1);
    QTRY_VERIFY(received.deliveries > 0);
    QCOMPARE(controller.start(tenSteps, 1), 2);
    QCOMPARE(received.finished, std::vector<int>{1}); // the first ended, and said so, before the second began
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.finished, (std::vector<int>{1, 2}));
    QCOMPARE(received.report.status, StudyStatus::Completed);
}

void TestStudyController::turnsAnExceptionIntoAFailure()
{
    StudyController controller;
    Received received(controller);
    controller.start([](int, const StudyCallback&) -> StudyReport { throw std::runtime_error("no memory"); }, 1);
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.report.status, StudyStatus::Failed);
    QCOMPARE(received.report.message, std::string("The study stopped with an error: no memory"));
}

void TestStudyController::joinsWhenDestroyed()
{
    std::atomic<bool> ended = false;
    {
        StudyController controller;
        controller.start(
            [&ended](int jobs, const StudyCallback& callback) {
                const StudyReport report = endless(jobs, callback);
                ended = true;
                return report;
            },
            1);
    }
    QVERIFY(ended);
}

TOUCHDOWN_TEST(TestStudyController)

} // namespace test_study_controller

#include "test_study_controller.moc"
