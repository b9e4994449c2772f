// SPDX-License-Identifier: GPL-3.0-or-later
//
// The memory of the runs in the status bar, and its limit in the menu.
#include <QSettings>
#include <QtTest>

#include "tests/support/test_program.h"
#include "ui/case/case_files.h"
#include "ui/runs/run_controller.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/runs/runs_model.h"
#include "ui/style/message_strip.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_window_memory {

class TestWindowMemory : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QCoreApplication::setApplicationName(QStringLiteral("test_window_memory")); }
    void init() { QSettings().clear(); }
    void cleanup() { QSettings().clear(); }

    void theStatusBarSaysWhatRunsTake()
    {
        MainWindow window;
        window.files().openNow(QStringLiteral("fig10a"));
        window.show();
        auto* label = window.findChild<QLabel*>(QStringLiteral("runMemory"));
        QVERIFY(label);
        QVERIFY(!label->isVisible());
        run(window);
        QTRY_VERIFY(label->isVisible());
        QCOMPARE(label->text(), window.runWindow().memory().text());
        QVERIFY(label->text().startsWith(QStringLiteral("Runs: ")));
        QVERIFY(!label->toolTip().isEmpty());
        window.runs().remove(0);
        QTRY_VERIFY(!label->isVisible());
    }

    void theMenuSetsTheLimit()
    {
        MainWindow window;
        window.files().openNow(QStringLiteral("fig10a"));
        window.show();
        QVERIFY(window.actions().runMemory->checkedAction());
        QCOMPARE(window.actions().runMemory->checkedAction()->data().toLongLong(), qint64(0));
        for (QAction* action : window.actions().runMemory->actions())
            if (action->data().toLongLong() == qint64(500) << 20) action->trigger();
        QCOMPARE(window.runWindow().memory().budget(), qint64(500) << 20);
        MainWindow next;
        QCOMPARE(next.runWindow().memory().budget(), qint64(500) << 20);
        QCOMPARE(next.actions().runMemory->checkedAction()->data().toLongLong(), qint64(500) << 20);
    }

    void aDiskThatFailsIsSaid()
    {
        MainWindow window;
        window.files().openNow(QStringLiteral("fig10a"));
        window.show();
        window.runWindow().memory().setFolder(QStringLiteral("/dev/null/full"));
        run(window);
        const double last = *window.runs().record(0).last("flying_height");
        window.runWindow().memory().setBudget(1);
        window.runWindow().memory().settle();
        QTRY_VERIFY(window.messages().isVisible());
        QTRY_VERIFY(window.messages().text().contains(QStringLiteral("/dev/null/full")));
        QCOMPARE(window.runs().record(0).last("flying_height"), std::optional(last));
    }

private:
    static void run(MainWindow& window)
    {
        const QSignalSpy finished(&window.controller(), &RunController::finished);
        window.startRun();
        QTRY_COMPARE(finished.count(), 1);
    }
};

TOUCHDOWN_TEST(TestWindowMemory)

} // namespace test_window_memory

#include "test_window_memory.moc"
