// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/modes_controller.h"

#include <stdexcept>
#include <thread>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_modes_controller {

ModesResult endless(const Case&, const SteadyCallback& callback)
{
    while (callback({"mode 1", 0, 0.0, 0.0, {}})) std::this_thread::yield();
    ModesResult result;
    result.status = SteadyStatus::Cancelled;
    return result;
}

ModesResult resultOf(const QSignalSpy& finished) { return finished.back()[1].value<ModesResult>(); }

class TestModesController : public QObject {
    Q_OBJECT

private slots:
    /// As the core finds them.
    void deliversTheModes()
    {
        const Case c = test::smallSlider(33);
        ModesController controller(modes);
        QSignalSpy finished(&controller, &ModesController::finished);
        QSignalSpy progressed(&controller, &ModesController::progressed);
        QCOMPARE(controller.start(c), 1);
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
        const ModesResult found = resultOf(finished), expected = modes(c);
        QCOMPARE(found.status, SteadyStatus::Converged);
        QCOMPARE(found.modes.size(), expected.modes.size());
        for (std::size_t i = 0; i < expected.modes.size(); ++i)
            QCOMPARE(found.modes[i].frequency, expected.modes[i].frequency);
        QVERIFY(progressed.count() > 0);
        QVERIFY(!controller.active());
    }

    void stops()
    {
        ModesController controller(endless);
        QSignalSpy finished(&controller, &ModesController::finished);
        QSignalSpy progressed(&controller, &ModesController::progressed);
        controller.start(Case{});
        QTRY_VERIFY(progressed.count() > 0);
        controller.stop();
        QTRY_COMPARE(finished.count(), 1);
        QCOMPARE(resultOf(finished).status, SteadyStatus::Cancelled);
    }

    void aNewerSearchReplaces()
    {
        ModesController controller(endless);
        QSignalSpy finished(&controller, &ModesController::finished);
        controller.start(Case{});
        QCOMPARE(controller.start(Case{}), 2);
        QCOMPARE(finished.count(), 1); // the first one
        QCOMPARE(finished.back()[0].toInt(), 1);
        controller.stopAndWait();
        QCOMPARE(finished.count(), 2);
    }

    void turnsAnExceptionIntoAFailure()
    {
        ModesController controller(
            [](const Case&, const SteadyCallback&) -> ModesResult { throw std::runtime_error("no memory"); });
        QSignalSpy finished(&controller, &ModesController::finished);
        controller.start(Case{});
        QTRY_COMPARE(finished.count(), 1);
        QCOMPARE(resultOf(finished).status, SteadyStatus::Failed);
        QVERIFY(resultOf(finished).message.ends_with("no memory"));
    }
};

TOUCHDOWN_TEST(TestModesController)

} // namespace test_modes_controller

#include "test_modes_controller.moc"
