// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static solutions in the whole window: used, run from, saved and read again.
#include <algorithm>
#include <cmath>

#include <QAccessible>
#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/case/contact_kind.h"
#include "core/case_files/case_file.h"
#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/film/compare_page.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/solution_files.h"
#include "ui/film/surface_page.h"
#include "ui/lists/record_panel.h"
#include "ui/runs/about_case_pane.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/message_strip.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

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
        const long long before = staticSolutions();
        const QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
        f.click(QStringLiteral("Run from here"));
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 60'000);
        const RunRecord& run = f.window.runs().record(0);
        QCOMPARE(run.value.suspension.preload, f.solutions().record(0).value.suspension.preload);
        QCOMPARE(run.value.initial.state, InitialState::Static);
        QCOMPARE(run.value.initial.pitch, pitch);
        QCOMPARE(staticSolutions(), before);
        QVERIFY2(std::abs(*run.last("pitch") - pitch) < 1e-8, qPrintable(QString::number(*run.last("pitch") - pitch)));
        f.window.edits().undoStack().undo();
        QCOMPARE(f.window.edits().value().suspension.preload, f.solutions().record(1).value.suspension.preload);
    }

    /// A run that was started in the disk begins where the slider flies, by one click.
    void aRunThatStartsInTheDiskCanStartInTheAir()
    {
        Solved f;
        f.edit("run.duration", QStringLiteral("5 us"));
        f.edit("run.sample_interval", QStringLiteral("1 us"));
        f.edit("initial.nominal_trailing_edge_height", QStringLiteral("-100 nm"));
        const QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
        f.window.startRun();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 60'000);
        QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Failure);
        const auto buttons = f.window.messages().findChildren<QPushButton*>();
        const auto start = std::ranges::find(buttons, QStringLiteral("Start where it flies"), &QPushButton::text);
        QVERIFY(start != buttons.end() && !(*start)->isHidden());
        (*start)->click();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, 60'000);
        QVERIFY(ended[1][0].toBool());
        f.window.edits().undoStack().undo();
        QCOMPARE(f.window.edits().value().initial.state, InitialState::Given);
    }

    void noRunStartsFromWhatDidNotConverge()
    {
        Solved f;
        f.edit("suspension.preload", QStringLiteral("2000 gf"));
        f.solve();
        QVERIFY(f.solutions().record(0).result.status != SteadyStatus::Converged);
        f.click(QStringLiteral("Run from here"));
        QCOMPARE(f.window.runs().count(), 0);
        QVERIFY(f.window.messages().text().contains(QStringLiteral("did not converge")));
    }

    /// A run of the case whose static state the page shows solves for nothing again, however it starts.
    void aRunTakesTheStateThatThePageShows_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::addColumn<int>("solved");
        QTest::newRow("as it is") << "run.duration"
                                  << "1 us" << 0;
        QTest::newRow("from the static state") << "initial.state"
                                               << "static" << 0;
        QTest::newRow("over a rough disk") << "disk.surface.kind"
                                           << "rough" << 0;
        QTest::newRow("another case") << "disk.skew"
                                      << "1 deg" << 1;
    }
    void aRunTakesTheStateThatThePageShows()
    {
        QFETCH(QString, key);
        QFETCH(QString, value);
        QFETCH(int, solved);
        Solved f;
        f.edit("run.duration", QStringLiteral("2 us"));
        f.solve();
        f.edit(key.toUtf8().constData(), value);
        const long long before = staticSolutions();
        const QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
        f.window.startRun();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 60'000);
        QCOMPARE(f.window.runs().record(0).summary->status, RunStatus::Completed);
        QCOMPARE(staticSolutions(), before + solved);
    }

    /// The message at the foot is of the case as it is edited: that no attitude was found leaves with undo and comes
    /// back with redo, which solves nothing. A preload of 200 gf is far more than the film carries; a disk at rest has
    /// no state at all, and none in the list.
    void theMessageFollowsUndo()
    {
        Solved f;
        f.window.show();
        f.edit("film.maximum_iterations", QStringLiteral("12"));
        f.solve();
        QVERIFY(f.window.messages().kind() != MessageStrip::Kind::Failure);
        for (const auto& [key, value] : {std::pair("suspension.preload", "200 gf"), std::pair("disk.speed", "0")}) {
            f.edit(key, QString::fromLatin1(value));
            QVERIFY(f.window.messages().kind() != MessageStrip::Kind::Failure || f.window.messages().text().isEmpty());
            f.solve();
            QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Failure);
            const QString why = f.window.messages().text();
            QVERIFY(!why.isEmpty());
            const int listed = f.solutions().count();
            f.window.edits().undoStack().undo();
            QCOMPARE(f.window.messages().text(), QString());
            f.window.edits().undoStack().redo();
            const bool inList = f.window.film().result()->status != SteadyStatus::Converged;
            QCOMPARE(f.window.messages().text(), inList ? why : QString());
            QVERIFY(!f.window.film().controller().active());
            QCOMPARE(f.solutions().count(), listed);
            f.window.edits().undoStack().undo();
            // Another edit is of another case, too.
            f.window.messages().show(MessageStrip::Kind::Failure, QStringLiteral("a message of something else"));
            f.edit("suspension.preload", QStringLiteral("1.6 gf"));
            QCOMPARE(f.window.messages().text(), QStringLiteral("a message of something else"));
            f.window.edits().undoStack().undo();
            f.window.messages().clear();
        }
    }

    /// A roll torque that two degrees of freedom leave is a warning.
    void saysThatATorqueIsLeft()
    {
        Solved f;
        f.edit("disk.skew", QStringLiteral("5 deg"));
        f.solve();
        QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Success);
        f.edit("degrees_of_freedom", QStringLiteral("2"));
        f.solve();
        QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Warning);
        QVERIFY(f.window.messages().text().contains(QStringLiteral("roll torque")));
    }

    /// A new case is one of springs. As a film it has three degrees of freedom and no contact law, which is said; both
    /// are one step of undo.
    void aFilmFromSprings()
    {
        MainWindow window;
        window.show();
        window.files().newCase();
        const Case springs = window.edits().value();
        QCOMPARE(springs.model, ModelKind::Springs);
        window.edits().enter(*findParameter("model"), QStringLiteral("film"));
        QCOMPARE(window.edits().value().degreesOfFreedom, 3);
        QCOMPARE(window.edits().value().contact, ContactKind::None);
        QCOMPARE(window.edits().value().initial.state, InitialState::Static);
        QCOMPARE(window.messages().kind(), MessageStrip::Kind::Information);
        QVERIFY2(window.messages().text().contains(QStringLiteral("egrees of freedom 2 → 3")),
                 qPrintable(window.messages().text()));
        window.edits().undoStack().undo();
        QVERIFY(window.edits().value() == springs);
        // What was chosen stays.
        window.edits().enter(*findParameter("contact"), QStringLiteral("none"));
        window.edits().enter(*findParameter("model"), QStringLiteral("film"));
        window.edits().enter(*findParameter("degrees_of_freedom"), QStringLiteral("2"));
        window.edits().enter(*findParameter("contact"), QStringLiteral("ono-yamane"));
        window.edits().enter(*findParameter("model"), QStringLiteral("springs"));
        QCOMPARE(window.edits().value().contact, ContactKind::OnoYamane);
        window.edits().undoStack().setClean();
    }

    /// The static state holds over any moving disk surface: no other is solved, and the run takes the surface that is
    /// set.
    void runsOverTheDiskThatIsSet()
    {
        Solved f;
        f.edit("run.sample_interval", QStringLiteral("1 us"));
        f.solve();
        f.edit("suspension.preload", QStringLiteral("3 gf"));
        f.solve();
        f.edit("disk.surface.kind", QStringLiteral("rough"));
        f.edit("run.duration", QStringLiteral("2 us"));
        QVERIFY(!f.window.film().stale());
        f.window.film().panel()->choose(1);
        const QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
        f.click(QStringLiteral("Run from here"));
        QVERIFY(!f.window.film().stale());
        QCOMPARE(f.window.edits().reasonNotToRun(), QString());
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 60'000);
        const Case& run = f.window.runs().record(0).value;
        QCOMPARE(run.diskSurface.kind, DiskSurfaceKind::Rough);
        QCOMPARE(run.run.duration, 2e-6);
        QCOMPARE(run.suspension.preload, f.solutions().record(0).value.suspension.preload);
        QCOMPARE(f.solutions().count(), 2);
    }

    /// On which `withRunOf` relies: the same bits over a rough disk, be it moving or still.
    void aStaticStateIsOverAFlatDisk()
    {
        Solved f;
        Case c = f.window.edits().value();
        const SteadyResult flat = steady(c);
        QCOMPARE(flat.status, SteadyStatus::Converged);
        c.diskSurface.kind = DiskSurfaceKind::Rough;
        for (const SurfaceMotion motion : {SurfaceMotion::Moving, SurfaceMotion::Still}) {
            c.diskSurface.motion = motion;
            const SteadyResult rough = steady(c);
            QCOMPARE(rough.attitude.height, flat.attitude.height);
            QCOMPARE(rough.pressure, flat.pressure);
        }
    }

    /// No number stays that the plan does not show.
    void theMessageIsOfTheShownSolution()
    {
        Solved f;
        f.solve();
        const auto* strip = f.window.findChild<MessageStrip*>();
        f.edit("suspension.preload", QStringLiteral("3 gf"));
        f.solve();
        QVERIFY(!strip->text().isEmpty());
        f.window.film().panel()->choose(1);
        QVERIFY(strip->text().isEmpty());
    }

    void aMessageLeavesThePageInItsPlace()
    {
        Solved f;
        f.window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&f.window));
        auto* strip = f.window.findChild<MessageStrip*>();
        const QSize before = f.window.film().view()->size();
        strip->show(MessageStrip::Kind::Success, QStringLiteral("One line"));
        QTRY_VERIFY(strip->isVisible());
        QCoreApplication::sendPostedEvents();
        QCOMPARE(f.window.film().view()->size(), before);
    }

    /// A rail has no field in the panel of parameters.
    void showsTheSurfaceThatPreventsARun()
    {
        Solved f;
        f.window.film().view()->setPage(FilmView::Page::Gap);
        AirBearingSurface crossing = f.window.edits().value().surface;
        std::swap(crossing.rails[0].points[0], crossing.rails[0].points[1]);
        f.window.edits().setSurface(crossing, QStringLiteral("cross"), 0);
        for (auto* button : f.window.findChild<MessageStrip*>()->findChildren<QPushButton*>()) button->click();
        QCOMPARE(f.window.film().view()->page(), FilmView::Page::Surface);
    }

    /// The letters of the tools work at once, without a walk through all parameters.
    void oneKeyGoesToThePlan()
    {
        Solved f;
        SurfaceEditor* plan = f.window.film().view()->shape()->editor();
        f.window.film().view()->setPage(FilmView::Page::Gap);
        QVERIFY(f.window.focusWidget() != plan);
        QAction* go = nullptr;
        for (QAction* action : f.window.findChildren<QAction*>())
            if (action->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_G)) go = action;
        QVERIFY(go && go->isEnabled());
        f.window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&f.window));
        go->trigger();
        QCOMPARE(f.window.film().view()->page(), FilmView::Page::Surface);
        QCOMPARE(f.window.focusWidget(), plan);
        auto* tabs = f.window.film().view()->findChild<QTabBar*>();
        tabs->setFocus();
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(0).center());
        QCOMPARE(f.window.focusWidget(), plan);
        f.window.files().openNow(QStringLiteral("fig10a"));
        QVERIFY(!go->isEnabled());
    }

    /// On all pages of the static state, and in the panes beside them; parts of a control have none.
    void everyControlHasAName()
    {
        Solved f;
        f.solve();
        QStringList nameless;
        for (int page = 0; page <= static_cast<int>(FilmView::Page::Series); ++page) {
            f.window.film().view()->setPage(static_cast<FilmView::Page>(page));
            for (QWidget* control : f.window.findChildren<QWidget*>()) {
                const QObject* parent = control->parent();
                if (control->focusPolicy() == Qt::NoFocus || !control->isVisibleTo(&f.window) ||
                    qobject_cast<QScrollArea*>(control) || parent->inherits("QAbstractSpinBox") ||
                    parent->inherits("QComboBox") || parent->inherits("QAbstractScrollArea"))
                    continue;
                const QAccessibleInterface* known = QAccessible::queryAccessibleInterface(control);
                if (control->accessibleName().isEmpty() && (!known || known->text(QAccessible::Name).isEmpty()))
                    nameless << QStringLiteral("%1 in %2")
                                    .arg(QLatin1String(control->metaObject()->className()),
                                         QLatin1String(parent->metaObject()->className()));
            }
        }
        QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(QStringLiteral(", "))));
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

    /// From the plan by Tab to the list, along it, to its buttons and to the pages: compared and run without a pointer.
    void byKeyboardAlone()
    {
        Solved f;
        f.edit("run.duration", QStringLiteral("5 us"));
        f.edit("run.sample_interval", QStringLiteral("1 us"));
        f.solve();
        f.edit("suspension.preload", QStringLiteral("3 gf"));
        f.solve();
        f.window.resize(1500, 940);
        f.window.show();
        f.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&f.window));
        const auto focused = [&f] { return f.window.focusWidget(); };
        const auto tabTo = [&](const auto& reached) {
            for (int i = 0; i < 200 && !reached(); ++i) QTest::keyClick(focused(), Qt::Key_Tab);
            return reached();
        };
        RecordPanel* panel = f.window.film().panel();
        const auto button = [&](const QString& text) {
            return [&, text] {
                const auto* made = qobject_cast<QToolButton*>(focused());
                return made && panel->isAncestorOf(made) && made->text() == text;
            };
        };
        f.window.film().view()->shape()->editor()->setFocus();
        QVERIFY(tabTo([&] { return focused() == panel->list(); }));
        QTest::keyClick(focused(), Qt::Key_Up);
        QCOMPARE(panel->chosen(), 1);
        QVERIFY(tabTo(button(QStringLiteral("Baseline"))));
        QTest::keyClick(focused(), Qt::Key_Space);
        QCOMPARE(f.solutions().baseline(), 1);
        auto* tabs = f.window.film().view()->findChild<QTabBar*>();
        QVERIFY(tabTo([&] { return focused() == tabs; }));
        while (f.window.film().view()->page() != FilmView::Page::Compare) {
            const int before = tabs->currentIndex();
            QTest::keyClick(focused(), Qt::Key_Right);
            QVERIFY(tabs->currentIndex() > before);
        }
        QCOMPARE(f.window.film().view()->comparison()->comparison().columns.size(), 2);
        const QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
        QVERIFY(tabTo(button(QStringLiteral("Run from here"))));
        QTest::keyClick(focused(), Qt::Key_Space);
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 60'000);
        QCOMPARE(f.window.runs().record(0).value.suspension.preload, f.solutions().record(0).value.suspension.preload);
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
        window.files().open(file);
        QCOMPARE(window.film().solutions().count(), 1);
        QCOMPARE(window.film().result()->pressure, f.window.film().result()->pressure);
        QCOMPARE(static_cast<QStackedWidget*>(window.page())->currentWidget(), window.film().view());
        QVERIFY(!window.film().stale());
        QVERIFY(window.aboutCase().toPlainText().contains(QStringLiteral("Result of this run")));
    }

    /// Its case is another one: it has no file until it is saved, and the file that was open stays as it is.
    void theCaseOfASolutionHasNoFile_data()
    {
        QTest::addColumn<bool>("edited");
        QTest::newRow("saved") << false;
        QTest::newRow("with edits") << true;
    }
    void theCaseOfASolutionHasNoFile()
    {
        QFETCH(const bool, edited);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("st.h5")),
                      mine = folder.filePath(QStringLiteral("mine.toml"));
        SolutionsModel solutions;
        const Case c = test::sampleFilmCase();
        QCOMPARE(saveSolution(solutions.record(solutions.rowOf(solutions.add(c, test::sampleSteady()))), file),
                 QString());
        const std::string text = "# my own comment\ntitle = \"mine\"\nmodel = \"springs\"\n";
        QCOMPARE(writeCaseFile(mine.toStdString(), text), std::string());
        MainWindow window;
        window.show();
        window.files().openNow(mine);
        if (edited) window.edits().enter(*findParameter("springs.flying_height"), QStringLiteral("4"));
        window.files().open(file);
        QCOMPARE(window.film().solutions().count(), 1);
        QCOMPARE(question(window, "unsavedChanges") != nullptr, edited);
        QCOMPARE(window.edits().value().model, edited ? ModelKind::Springs : ModelKind::Film);
        if (edited) {
            QVERIFY(!window.aboutCase().toPlainText().contains(QStringLiteral("Result of this run")));
            answer(window, "unsavedChanges", QStringLiteral("Discard"));
        }
        QCOMPARE(window.edits().value().model, ModelKind::Film);
        QCOMPARE(window.files().file(), QString());
        QCOMPARE(window.files().shortName(), QStringLiteral("st.h5"));
        window.actions().save->trigger();
        const auto* dialog = window.findChild<QFileDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        QFile read(mine);
        QVERIFY(read.open(QIODevice::ReadOnly));
        QCOMPARE(read.readAll().toStdString(), text);
    }
};

TOUCHDOWN_TEST(TestMainWindowSolutions)

} // namespace test_main_window_solutions

#include "test_main_window_solutions.moc"
