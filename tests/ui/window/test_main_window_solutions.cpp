// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static solutions in the whole window: used, run from, saved and read again.
#include <cmath>

#include <QSettings>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "tests/support/test_program.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/solution_files.h"
#include "ui/lists/record_panel.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace test_main_window_solutions {

/// A window on a film case with a coarse grid.
struct Solved {
    Solved()
    {
        window.files().openNow(QStringLiteral("film_pico"));
        edit("film.nodes", QStringLiteral("33, 33"));
    }

    void edit(const char* key, const QString& text) { window.edits().enter(*findParameter(key), text); }
    void solve()
    {
        const QSignalSpy ended(&window, &MainWindow::calculationEnded);
        window.solveStaticState();
        if (!QTest::qWaitFor([&] { return ended.count() == 1; }, 60'000)) qFatal("the solution does not end");
    }
    void click(const QString& text)
    {
        for (QToolButton* button : window.film().panel()->findChildren<QToolButton*>())
            if (button->text() == text) button->click();
    }
    SolutionsModel& solutions() { return window.film().solutions(); }

    MainWindow window;
};

class TestMainWindowSolutions : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_main_window_solutions"));
        QLocale::setDefault(QLocale::c());
    }
    void init() { QSettings().clear(); }

    /// The run starts in the solution that was chosen and stays there: it is the balance.
    void runsFromASolution()
    {
        Solved f;
        f.edit("run.duration", QStringLiteral("20 us"));
        f.edit("run.sample_interval", QStringLiteral("1 us"));
        f.solve();
        f.edit("suspension.preload", QStringLiteral("3 gf"));
        f.solve();
        f.window.film().panel()->choose(1);
        const double pitch = f.window.film().result()->attitude.pitch;
        const QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
        f.click(QStringLiteral("Run from here"));
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 60'000);
        const RunRecord& run = f.window.runs().record(0);
        QCOMPARE(run.value.suspension.preload, f.solutions().record(0).value.suspension.preload);
        QCOMPARE(run.value.initial.state, InitialState::Static);
        QCOMPARE(run.value.initial.pitch, pitch);
        QVERIFY2(std::abs(*run.last("pitch") - pitch) < 1e-8, qPrintable(QString::number(*run.last("pitch") - pitch)));
        f.window.edits().undoStack().undo();
        QCOMPARE(f.window.edits().value().suspension.preload, f.solutions().record(1).value.suspension.preload);
    }

    /// Where the attitude was held there is no balance to start from.
    void runsFromAHeldAttitude()
    {
        Solved f;
        f.edit("run.duration", QStringLiteral("5 us"));
        f.edit("run.sample_interval", QStringLiteral("1 us"));
        const QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
        f.window.solveStaticState(true);
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 60'000);
        f.click(QStringLiteral("Run from here"));
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, 60'000);
        QCOMPARE(f.window.runs().record(0).value.initial.state, InitialState::Given);
    }

    void useTakesTheParameters()
    {
        Solved f;
        f.solve();
        const Case solved = f.window.edits().value();
        f.edit("suspension.preload", QStringLiteral("3 gf"));
        QVERIFY(f.window.film().stale());
        f.click(QStringLiteral("Use"));
        QCOMPARE(f.window.edits().value(), solved);
        QVERIFY(!f.window.film().stale());
    }

    /// Also where the open case has no page for them.
    void reopensASavedSolution()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("solution.h5"));
        Solved f;
        f.solve();
        QCOMPARE(saveSolution(f.solutions().record(0), file), QString());
        MainWindow window;
        window.files().openNow(QStringLiteral("fig10a"));
        window.openResults(file);
        QCOMPARE(window.film().solutions().count(), 1);
        QCOMPARE(window.film().result()->pressure, f.window.film().result()->pressure);
        QCOMPARE(static_cast<QStackedWidget*>(window.page())->currentWidget(), window.film().view());
        QVERIFY(!window.film().stale());
        window.edits().undoStack().undo();
        QCOMPARE(window.edits().value().model, ModelKind::Springs);
    }
};

TOUCHDOWN_TEST(TestMainWindowSolutions)

} // namespace test_main_window_solutions

#include "test_main_window_solutions.moc"
