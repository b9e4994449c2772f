// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lesson and the demonstrations in the window: their panes, its panels, its end.
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSplitter>
#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "tests/ui/window_fixture.h"
#include "ui/case/case_panel.h"
#include "ui/guides/guides.h"
#include "ui/guides/lesson_pane.h"
#include "ui/guides/live_runs.h"
#include "ui/guides/live_values.h"
#include "ui/guides/marked_slider.h"
#include "ui/runs/run_view.h"
#include "ui/studies/study_form_view.h"
#include "ui/studies/study_window.h"

using namespace touchdown;

namespace test_main_window_guides {

using Fixture = test::WindowFixture;

QPushButton* button(const QWidget& parent, const char* name)
{
    return namedWidget<QPushButton>(parent, QString::fromUtf8(name));
}

class TestMainWindowGuides : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_main_window_guides"));
    }
    void init() { QSettings().clear(); }

    /// Beside the lesson the form of a study can be read.
    void leavesRoomForTheFormOfAStudy_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("least");
        QTest::newRow("desktop") << QSize(1600, 960) << 250;
        QTest::newRow("laptop") << QSize(1280, 690) << 150;
    }
    void leavesRoomForTheFormOfAStudy()
    {
        QFETCH(const QSize, size);
        QFETCH(const int, least);
        Fixture f;
        f.window.resize(size);
        f.window.actions().lesson->trigger(); // shows the page of runs
        f.window.setPage(MainWindow::Page::Studies);
        const QWidget* form = f.window.studies().editor()->form();
        const QWidget* lesson = f.window.guides().pane(LessonPane::Kind::Lesson);
        QTRY_VERIFY2(form->isVisible() && form->height() >= least, qPrintable(QString::number(form->height())));
        QVERIFY(lesson->isVisible() && lesson->height() >= 150);
        QCOMPARE(f.window.size(), size);
    }
    /// A key in the text leads to its field; each step shows what its runs gave.
    void leadsToFieldsAndResults()
    {
        Fixture f;
        f.window.actions().lesson->trigger();
        LessonPane* pane = f.window.guides().pane(LessonPane::Kind::Lesson);
        f.window.casePanel().search()->setText(QStringLiteral("friction"));
        emit pane->keyChosen(QStringLiteral("springs.front_damping_ratio"));
        const ParameterEditor* editor = f.window.casePanel().editor("springs.front_damping_ratio");
        QVERIFY(f.window.casePanel().search()->text().isEmpty());
        QVERIFY(editor->isVisible() && !editor->visibleRegion().isEmpty());
        QVERIFY(editor->input()->hasFocus() || editor->isAncestorOf(f.window.focusWidget()));
        QVERIFY(!f.window.casePanel().showParameter("film.nodes")); // not of this case

        f.toEnd([pane] { button(*pane, "Run: A lower start, with the static pitch.")->click(); });
        const auto text = [pane] {
            QString all;
            for (const QLabel* label : pane->findChildren<QLabel*>()) all += label->text();
            return all;
        };
        static const QRegularExpression result(QStringLiteral("→ ends at 7\\.000.nm · 1 touch · W = 18\\.9 pJ<"));
        QVERIFY2(result.match(text()).hasMatch(), qPrintable(text().mid(text().indexOf(u'→'), 80)));
        button(*pane, "Next")->click();
        QVERIFY(!text().contains(u'→'));
        button(*pane, "Back")->click();
        QVERIFY(text().contains(u'→'));
        f.window.runs().remove(0);
        QVERIFY(!text().contains(u'→'));
    }

    /// It takes no place before it is asked for, and stays when the page changes.
    void opensFromTheMenu()
    {
        MainWindow closed;
        closed.show();
        QVERIFY(!closed.findChild<QDockWidget*>(QStringLiteral("lesson")));

        Fixture f;
        f.window.actions().lesson->trigger();
        QVERIFY(f.dock("lesson") && f.dock("lesson")->isVisible());
        QTRY_VERIFY(!f.dock("lesson")->visibleRegion().isEmpty());
        for (const MainWindow::Page page : {MainWindow::Page::Studies, MainWindow::Page::Run}) {
            f.window.setPage(page);
            QTRY_VERIFY(!f.dock("lesson")->visibleRegion().isEmpty());
        }
        f.dock("lesson")->close();
        QVERIFY(f.dock("lesson")->isHidden());
        f.window.actions().lesson->trigger();
        QVERIFY(f.dock("lesson")->isVisible());
    }

    /// One pane is open; closing it ends its stage, and the menu begins it anew.
    void closingAPaneEndsItsStage()
    {
        Fixture f;
        f.window.actions().lesson->trigger();
        f.window.actions().demonstrations->trigger();
        QVERIFY(f.dock("lesson")->isHidden() && f.dock("demonstrations")->isVisible());
        QVERIFY(f.window.runView().stage());
        f.dock("demonstrations")->close();
        QVERIFY(!f.window.runView().stage());
        f.window.actions().lesson->trigger();
        QVERIFY(f.window.runView().stage());
    }

    /// The action stops the run that follows a movement, too.
    void theUserStopsALiveRun()
    {
        Fixture f;
        f.edit("run.duration", QStringLiteral("1"));
        LiveRuns& live = f.window.guides().live();
        live.move({{"initial.flying_height"}, 100e-9, 400e-9, {}}, "300 nm");
        QVERIFY(live.busy());
        emit f.window.actions().stop->triggered();
        QVERIFY(!live.busy());
    }

    /// What a step made it can make again; the parts have the sizes that the reader gave them.
    void closesWithoutAQuestion()
    {
        Fixture f;
        RunView& view = f.window.runView();
        view.splitter()->setSizes({0, 500, 100});
        const QByteArray own = view.splitter()->saveState();
        f.window.actions().lesson->trigger();
        f.toEnd([&f] { f.window.guides().perform(lessonSteps()[0].runs[0]); });
        Case tried = f.window.edits().value();
        tried.initial.flyingHeight = 30e-9;
        f.window.edits().setAll(tried, "tried");
        QVERIFY(!f.window.close()); // the reader's own value
        for (QDialog* question : f.window.findChildren<QDialog*>()) question->reject();
        f.window.edits().undoStack().undo();
        QVERIFY(f.window.close());
        QCOMPARE(QSettings().value("window/parts").toByteArray(), own);
    }

    /// The window goes with its live runs after a movement.
    void endsWithALiveRun()
    {
        QSettings().setValue("demonstrations/step", 5); // Fig. 10
        Fixture f;
        f.toEnd([&f] { f.window.actions().demonstrations->trigger(); });
        LessonPane* pane = f.window.guides().pane(LessonPane::Kind::Demonstrations);
        static_cast<MarkedSlider*>(pane->live().inputs().at(0))->setValue(900);
        QTRY_COMPARE_WITH_TIMEOUT(f.window.runs().count(), 2, 60'000);
    }
};

TOUCHDOWN_TEST(TestMainWindowGuides)

} // namespace test_main_window_guides

#include "test_main_window_guides.moc"
