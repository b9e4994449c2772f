// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/steady_controller.h"

#include <atomic>
#include <stdexcept>
#include <thread>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_steady_controller {

using State = SteadyController::State;

/// The root of h^2 = 2 nm^2 by Newton from the start's height: 12, 6.0833, 3.2061, ... nm.
SteadyResult squareRoot(const Case& c, const SteadyCallback& callback)
{
    SteadyResult result;
    double h = c.initial.nominalTrailingEdgeHeight / 1e-9;
    while (std::abs(h * h - 2.0) > 1e-12) {
        h = 0.5 * (h + 2.0 / h);
        ++result.iterations;
        if (!callback({"grid 1 x 1", result.iterations, std::abs(h * h - 2.0), 0.0, {h * 1e-9, 0.0, 0.0}})) {
            result.status = SteadyStatus::Cancelled;
            return result;
        }
    }
    result.status = SteadyStatus::Converged;
    result.attitude.height = h * 1e-9;
    return result;
}

/// Goes on until it is stopped, one iteration after the other.
SteadyResult endless(const Case&, const SteadyCallback& callback)
{
    SteadyResult result;
    while (callback({"grid 1 x 1", ++result.iterations, 1.0, 1.0, {}})) std::this_thread::yield();
    result.status = SteadyStatus::Cancelled;
    return result;
}

struct Received {
    explicit Received(SteadyController& controller)
    {
        QObject::connect(&controller, &SteadyController::progressed, &controller,
                         [this](int number, const Progress& progress) {
                             ++deliveries;
                             numbers.push_back(number);
                             const int iteration = static_cast<int>(progress.figures.front().value);
                             disordered += iteration <= lastIteration && number == numbers.front();
                             lastIteration = iteration;
                         });
        QObject::connect(&controller, &SteadyController::finished, &controller,
                         [this](int number, const SteadyResult& ended) {
                             finished.push_back(number);
                             result = ended;
                         });
    }
    int deliveries = 0, disordered = 0;
    std::vector<int> numbers, finished;
    int lastIteration = 0;
    SteadyResult result;
};

Case sampleCase()
{
    Case c;
    c.initial.nominalTrailingEdgeHeight = 12e-9;
    return c;
}

class TestSteadyController : public QObject {
    Q_OBJECT

private slots:
    void deliversTheResult();
    void handsTheCaseOver();
    void deliversTheLatestProgressFirst();
    void coalescesProgress();
    void stopsAnEndlessSolution();
    void startsAgainWhileSolving();
    void turnsAnExceptionIntoAFailure();
    void joinsWhenDestroyed();
    void stoppingWhenIdleDoesNothing();
};

// sqrt(2) nm.
void TestSteadyController::deliversTheResult()
{
    SteadyController controller(squareRoot);
    Received received(controller);
    QSignalSpy states(&controller, &SteadyController::stateChanged);
    QCOMPARE(controller.start(sampleCase()), 1);
    QCOMPARE(controller.state(), State::Running);
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.result.status, SteadyStatus::Converged);
    QVERIFY(std::abs(received.result.attitude.height - 1.4142135623730951e-9) < 1e-20);
    QCOMPARE(received.finished, std::vector<int>{1});
    QCOMPARE(states.count(), 2);
}

void TestSteadyController::handsTheCaseOver()
{
    double seen = 0.0;
    SteadyController controller([&seen](const Case& c, const SteadyCallback&) {
        seen = c.initial.nominalTrailingEdgeHeight;
        return SteadyResult{};
    });
    controller.start(sampleCase());
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(seen, 12e-9);
}

void TestSteadyController::deliversTheLatestProgressFirst()
{
    SteadyController controller(squareRoot);
    Received received(controller);
    controller.start(sampleCase());
    QTRY_COMPARE(controller.state(), State::Idle);
    // The last iteration is never lost: it comes before the result.
    QCOMPARE(received.lastIteration, received.result.iterations);
    QCOMPARE(received.disordered, 0);
}

void TestSteadyController::coalescesProgress()
{
    std::atomic<int> told = 0;
    SteadyController controller([&told](const Case&, const SteadyCallback& callback) {
        SteadyResult result;
        for (int i = 1; i <= 200'000; ++i) {
            callback({"grid 1 x 1", i, 1.0, 1.0, {}});
            told = i;
        }
        result.iterations = 200'000;
        return result;
    });
    Received received(controller);
    controller.start(sampleCase());
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), State::Idle, 30000);
    QCOMPARE(told.load(), 200'000);
    QVERIFY2(received.deliveries < 2000, qPrintable(QString::number(received.deliveries)));
    QCOMPARE(received.lastIteration, 200'000);
}

void TestSteadyController::stopsAnEndlessSolution()
{
    SteadyController controller(endless);
    Received received(controller);
    controller.start(sampleCase());
    QTRY_VERIFY(received.deliveries > 0);
    controller.stop();
    QCOMPARE(controller.state(), State::Stopping);
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.result.status, SteadyStatus::Cancelled);
}

void TestSteadyController::startsAgainWhileSolving()
{
    SteadyController controller(endless);
    Received received(controller);
    controller.start(sampleCase());
    QTRY_VERIFY(received.deliveries > 0);
    QCOMPARE(controller.start(sampleCase()), 2);
    // The first ended, and said so, before the second began.
    QCOMPARE(received.finished, std::vector<int>{1});
    QTRY_VERIFY(received.numbers.back() == 2);
    controller.stopAndWait();
    QCOMPARE(received.finished, (std::vector<int>{1, 2}));
    QCOMPARE(controller.state(), State::Idle);
}

void TestSteadyController::turnsAnExceptionIntoAFailure()
{
    SteadyController controller(
        [](const Case&, const SteadyCallback&) -> SteadyResult { throw std::runtime_error("no memory"); });
    Received received(controller);
    controller.start(sampleCase());
    QTRY_COMPARE(controller.state(), State::Idle);
    QCOMPARE(received.result.status, SteadyStatus::Failed);
    QCOMPARE(QString::fromStdString(received.result.message),
             QStringLiteral("The calculation stopped with an error: no memory"));
}

void TestSteadyController::joinsWhenDestroyed()
{
    std::atomic<bool> ended = false;
    {
        SteadyController controller([&ended](const Case& c, const SteadyCallback& callback) {
            const SteadyResult result = endless(c, callback);
            ended = true;
            return result;
        });
        controller.start(sampleCase());
    }
    QVERIFY(ended);
}

void TestSteadyController::stoppingWhenIdleDoesNothing()
{
    SteadyController controller(squareRoot);
    QSignalSpy states(&controller, &SteadyController::stateChanged);
    controller.stop();
    controller.stopAndWait();
    QCOMPARE(states.count(), 0);
}

TOUCHDOWN_TEST(TestSteadyController)

} // namespace test_steady_controller

#include "test_steady_controller.moc"
