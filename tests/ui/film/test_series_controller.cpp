// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_controller.h"

#include <atomic>
#include <stdexcept>
#include <thread>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_series_controller {

/// A state whose height is a millionth of the radius; 30 mm has none.
SteadyResult millionth(const Case& c, const SteadyCallback& callback)
{
    SteadyResult result;
    if (!callback({"grid 1 x 1", 1, 0.0, 0.0, {}})) {
        result.status = SteadyStatus::Cancelled;
        return result;
    }
    if (c.disk.radius == 30e-3) {
        result.message = "no flying attitude was found";
        return result;
    }
    result.status = SteadyStatus::Converged;
    result.attitude.height = 1e-6 * c.disk.radius;
    return result;
}

std::vector<SteadySeriesPoint> radii(const Case& c, const std::vector<double>& values)
{
    std::vector<SteadySeriesPoint> points;
    for (const double radius : values) points.push_back({radius, c.disk.skew, c.disk.speed, {}});
    return points;
}

struct Received {
    explicit Received(SeriesController& controller)
    {
        QObject::connect(&controller, &SeriesController::solved, &controller,
                         [this](std::size_t index, const SteadyResult& result) {
                             indices.push_back(index);
                             results.push_back(result);
                         });
        QObject::connect(&controller, &SeriesController::finished, &controller, [this](int, bool byUser) {
            ++finished;
            stopped = byUser;
        });
        QObject::connect(&controller, &SeriesController::progressed, &controller,
                         [this](int, const Progress& progress) {
                             ++deliveries;
                             activity = progress.activity;
                         });
    }
    std::vector<std::size_t> indices;
    std::vector<SteadyResult> results;
    int finished = 0, deliveries = 0;
    bool stopped = false;
    std::string activity;
};

class TestSeriesController : public QObject {
    Q_OBJECT

private slots:
    void solvesOneAfterTheOther();
    void isTheCommandsSeries();
    void aStopKeepsWhatIsSolved();
    void aContradictionIsAFailedState();
    void turnsAnExceptionIntoAFailure();
    void joinsWhenDestroyed();
};

void TestSeriesController::solvesOneAfterTheOther()
{
    SeriesController controller(millionth);
    Received received(controller);
    const Case c = test::smallSlider();
    controller.start(c, radii(c, {20e-3, 25e-3, 30e-3, 35e-3}));
    QTRY_COMPARE(received.finished, 1);
    QVERIFY(!received.stopped);
    QCOMPARE(received.indices, (std::vector<std::size_t>{0, 1, 2, 3}));
    QCOMPARE(received.results[3].attitude.height, 35e-9);
    QCOMPARE(received.results[2].status, SteadyStatus::Failed);
    QCOMPARE(received.activity, std::string("state 4 of 4, grid 1 x 1"));
}

/// Each state is the case at its point, solved as alone.
void TestSeriesController::isTheCommandsSeries()
{
    Case c = test::smallSlider(33);
    c.steady.radii = {20e-3, 25e-3};
    SeriesController controller(steady);
    Received received(controller);
    controller.start(c, seriesOf(c));
    QTRY_COMPARE_WITH_TIMEOUT(received.finished, 1, 60000);
    for (std::size_t i = 0; i < 2; ++i) {
        const SteadyResult alone = steady(caseAt(c, seriesOf(c)[i]));
        QCOMPARE(received.results[i].minimumSpacing, alone.minimumSpacing);
        QCOMPARE(received.results[i].grid.x, alone.grid.x);
    }
}

void TestSeriesController::aStopKeepsWhatIsSolved()
{
    SeriesController controller([](const Case& c, const SteadyCallback& callback) {
        if (c.disk.radius > 22e-3)
            while (callback({"grid 1 x 1", 1, 0.0, 0.0, {}})) std::this_thread::yield();
        return millionth(c, callback);
    });
    Received received(controller);
    const Case c = test::smallSlider();
    controller.start(c, radii(c, {20e-3, 25e-3, 30e-3}));
    QTRY_COMPARE(received.indices.size(), std::size_t(1));
    controller.stop();
    QTRY_COMPARE(received.finished, 1);
    QVERIFY(received.stopped);
    QCOMPARE(received.indices.size(), std::size_t(1));
}

void TestSeriesController::aContradictionIsAFailedState()
{
    std::atomic<int> asked = 0;
    SeriesController controller([&](const Case& c, const SteadyCallback& callback) {
        ++asked;
        return millionth(c, callback);
    });
    Received received(controller);
    Case c = test::smallSlider();
    c.surface.rails.front().points.front().wall = 3; // there is no wall 3
    controller.start(c, radii(c, {20e-3}));
    QTRY_COMPARE(received.finished, 1);
    QCOMPARE(asked.load(), 0);
    QCOMPARE(received.results.front().status, SteadyStatus::Failed);
    QVERIFY(!received.results.front().message.empty());
}

void TestSeriesController::turnsAnExceptionIntoAFailure()
{
    SeriesController controller(
        [](const Case&, const SteadyCallback&) -> SteadyResult { throw std::runtime_error("no memory"); });
    Received received(controller);
    const Case c = test::smallSlider();
    controller.start(c, radii(c, {20e-3, 25e-3}));
    QTRY_COMPARE(received.finished, 1);
    QCOMPARE(received.results.size(), std::size_t(2));
    QVERIFY(received.results.back().message.ends_with("no memory"));
}

void TestSeriesController::joinsWhenDestroyed()
{
    std::atomic<int> active = 0;
    {
        SeriesController controller([&](const Case& c, const SteadyCallback& callback) {
            ++active;
            while (callback({"grid 1 x 1", 1, 0.0, 0.0, {}})) std::this_thread::yield();
            --active;
            return millionth(c, callback);
        });
        Received received(controller);
        const Case c = test::smallSlider();
        controller.start(c, radii(c, {20e-3}));
        QTRY_VERIFY(received.deliveries > 0);
        QCOMPARE(active.load(), 1);
    }
    QCOMPARE(active.load(), 0);
}

TOUCHDOWN_TEST(TestSeriesController)

} // namespace test_series_controller

#include "test_series_controller.moc"
