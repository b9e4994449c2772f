// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_pane.h"

#include <QDockWidget>
#include <QMessageBox>
#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/case/case_panel.h"
#include "ui/lesson/lesson_text.h"
#include "ui/runs/run_controller.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/style/theme.h"
#include "ui/window/guides.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_lesson_pane {

const LessonRun caught{"Menisci up to 8 nm, and 4 nm.", "fig13a", "", {{"springs.flying_height", "4 nm"}}};
const LessonRun study{"A study.", "hysteresis_flying_height", "hysteresis", {}};

std::vector<LessonStep> sampleSteps()
{
    return {{"First",
             "It flies at 7 nm with f_m.\nP >= 0 at -5 us.",
             "Why?",
             "Try run.step.",
             "Because.",
             {},
             {caught, study},
             {}},
            {"Second", "More.", "How?", "Nothing.", "So.", {}, {study}, {}}};
}

QPushButton* button(const QWidget& parent, const char* name)
{
    return namedWidget<QPushButton>(parent, QString::fromUtf8(name));
}

QString shownText(const QWidget& parent, const char* name)
{
    const auto* label = namedWidget<QLabel>(parent, QString::fromUtf8(name));
    return label == nullptr || !label->isVisibleTo(&parent) ? QString() : label->text();
}

/// A window with the lesson.
struct Fixture {
    Fixture()
    {
        window.resize(1400, 900);
        window.show();
        window.files().openNow(QStringLiteral("fig10a"));
        window.actions().lesson->trigger();
    }

    QDockWidget* dock() { return window.findChild<QDockWidget*>(QStringLiteral("lesson")); }

    MainWindow window;
};

class TestLessonPane : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_lesson_pane"));
    }
    void init() { QSettings().clear(); }

    void goesThroughTheSteps()
    {
        LessonPane pane(LessonPane::Kind::Lesson, sampleSteps());
        QVERIFY(shownText(pane, "Place in the lesson").contains(QStringLiteral("Step 1 of 2")));
        QVERIFY(shownText(pane, "Title of the step").contains(QStringLiteral("1. First")));
        QVERIFY(!button(pane, "Back")->isEnabled());
        QVERIFY(button(pane, "Run: Menisci up to 8 nm, and 4 nm."));
        button(pane, "Next")->click();
        QCOMPARE(pane.step(), std::size_t(1));
        QVERIFY(shownText(pane, "Question").contains(QStringLiteral("How?")));
        QVERIFY(!button(pane, "Run: Menisci up to 8 nm, and 4 nm."));
        QVERIFY(!button(pane, "Next")->isEnabled());
        button(pane, "Back")->click();
        QCOMPARE(pane.step(), std::size_t(0));
    }

    void showsTheAnswerWhenAsked()
    {
        LessonPane pane(LessonPane::Kind::Lesson, sampleSteps());
        QVERIFY(shownText(pane, "Answer").isEmpty());
        button(pane, "Show the answer")->click();
        QVERIFY(shownText(pane, "Answer").contains(QStringLiteral("Because.")));
        button(pane, "Hide the answer")->click();
        QVERIFY(shownText(pane, "Answer").isEmpty());
        // The answer of the next step is not given away.
        button(pane, "Show the answer")->click();
        button(pane, "Next")->click();
        QVERIFY(shownText(pane, "Answer").isEmpty());
    }

    void typesetsTheTexts()
    {
        const LessonPane pane(LessonPane::Kind::Lesson, sampleSteps());
        const QString text = shownText(pane, "Text of the step");
        for (const char* part : {"7\u00a0nm", "f<sub>m</sub>", "P ≥ 0", "−5\u00a0µs"})
            QVERIFY2(text.contains(QString::fromUtf8(part)), qPrintable(text));
        QVERIFY(shownText(pane, "What to change").contains(QStringLiteral("<a href='run.step'>run.step</a>")));
    }

    void writesSymbols()
    {
        QCOMPARE(lessonHtml("With mu = 2.0, f_m is 10 mN and d_e = 3 um."),
                 QStringLiteral("With μ = 2.0, f<sub>m</sub> is 10\u00a0mN and d<sub>e</sub> = 3\u00a0µm."));
        QCOMPARE(lessonHtml("mud"), QStringLiteral("mud"));
    }

    void showsResults()
    {
        LessonPane pane(LessonPane::Kind::Lesson, sampleSteps());
        const auto purposes = [&pane] {
            QString all;
            for (const QLabel* label : pane.findChildren<QLabel*>())
                if (label->text().contains(QStringLiteral("Menisci"))) all += label->text();
            return all;
        };
        QVERIFY(!purposes().contains(QStringLiteral("→")));
        const auto has = [&pane](const QColor& colour) {
            return std::ranges::any_of(pane.findChildren<QLabel*>(),
                                       [&](const QLabel* label) { return label->text().contains(colour.name()); });
        };
        const QColor failure = meaningColours(pane.palette()).failure;
        pane.showResult(0, QStringLiteral("fails"), false);
        QVERIFY(has(failure));
        pane.showResult(0, QStringLiteral("ends at 7 nm"));
        QVERIFY(!has(failure));
        QVERIFY(purposes().contains(QStringLiteral("→ ends at 7 nm")));
        pane.showResult(0, QString());
        QVERIFY(!purposes().contains(QStringLiteral("→")));
    }

    /// A key in the text leads to its field; each step shows what its runs gave.
    void leadsToFieldsAndResults()
    {
        Fixture f;
        LessonPane* pane = f.window.guides().pane(LessonPane::Kind::Lesson);
        f.window.casePanel().search()->setText(QStringLiteral("friction"));
        emit pane->keyChosen(QStringLiteral("springs.front_damping_ratio"));
        const ParameterEditor* editor = f.window.casePanel().editor("springs.front_damping_ratio");
        QVERIFY(f.window.casePanel().search()->text().isEmpty());
        QVERIFY(editor->isVisible() && !editor->visibleRegion().isEmpty());
        QVERIFY(editor->input()->hasFocus() || editor->isAncestorOf(f.window.focusWidget()));
        QVERIFY(!f.window.casePanel().showParameter("film.nodes")); // not of this case

        QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
        button(*pane, "Run: A lower start, with the static pitch.")->click();
        QVERIFY(!ended.isEmpty() || ended.wait(30000));
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

    void followsTheTheme()
    {
        LessonPane pane(LessonPane::Kind::Lesson, sampleSteps());
        pane.show();
        applyTheme(Theme::Light);
        const QString lightColour = meaningColours(QApplication::palette()).change.name();
        QTRY_VERIFY(shownText(pane, "Question").contains(lightColour));
        applyTheme(Theme::Dark);
        QTRY_VERIFY(!shownText(pane, "Question").contains(lightColour));
        applyTheme(Theme::System);
    }

    /// It takes no place before it is asked for, and stays when the page changes.
    void opensFromTheMenu()
    {
        MainWindow closed;
        closed.show();
        QVERIFY(!closed.findChild<QDockWidget*>(QStringLiteral("lesson")));

        Fixture f;
        QVERIFY(f.dock() && f.dock()->isVisible());
        QTRY_VERIFY(!f.dock()->visibleRegion().isEmpty());
        for (const MainWindow::Page page : {MainWindow::Page::Studies, MainWindow::Page::Run}) {
            f.window.setPage(page);
            QTRY_VERIFY(!f.dock()->visibleRegion().isEmpty());
        }
        f.dock()->close();
        QVERIFY(f.dock()->isHidden());
        f.window.actions().lesson->trigger();
        QVERIFY(f.dock()->isVisible());
    }

    void runsACaseWithItsSettings()
    {
        Fixture f;
        const QSignalSpy finished(&f.window.controller(), &RunController::finished);
        f.window.performLessonRun(caught);
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60'000);
        QCOMPARE(f.window.files().sample(), QStringLiteral("fig13a"));
        QCOMPARE(f.window.runs().record(0).value.springs.flyingHeight, 4e-9);
        QVERIFY(f.window.edits().anyChanged()); // marked
        QVERIFY(!f.window.files().modified());  // nothing to save
        QVERIFY(f.window.files().text().find("flying_height = \"4 nm\"") != std::string::npos);
        // The next one does not ask about the settings of the last one.
        f.window.performLessonRun({"", "fig10a", "", {}});
        QVERIFY(!f.window.findChild<QMessageBox*>(QStringLiteral("unsavedChanges")));
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 2, 60'000);
        QCOMPARE(f.window.files().sample(), QStringLiteral("fig10a"));
    }

    void asksAboutUnsavedChanges()
    {
        Fixture f;
        const QSignalSpy finished(&f.window.controller(), &RunController::finished);
        f.window.edits().enter(*findParameter("springs.flying_height"), QStringLiteral("5"));
        f.window.performLessonRun(caught);
        auto* box = f.window.findChild<QMessageBox*>(QStringLiteral("unsavedChanges"));
        QVERIFY(box);
        QVERIFY(!f.window.controller().active());
        QCOMPARE(f.window.files().sample(), QStringLiteral("fig10a"));
        box->button(QMessageBox::Discard)->click();
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60'000);
        QCOMPARE(f.window.files().sample(), QStringLiteral("fig13a"));
    }

    void performsAStudy()
    {
        Fixture f;
        f.window.performLessonRun(study);
        QVERIFY(f.window.studies().controller().active());
        QCOMPARE(f.window.studies().editor()->kind(), QStringLiteral("hysteresis"));
        QVERIFY(f.window.studies().editor()->toText().contains(QStringLiteral("springs.flying_height")));
        f.window.studies().controller().stopAndWait();
    }

    void namesEveryControl()
    {
        const LessonPane pane(LessonPane::Kind::Lesson, lessonSteps());
        for (const QPushButton* each : pane.findChildren<QPushButton*>())
            QVERIFY(!each->accessibleName().isEmpty() || !each->text().isEmpty());
        for (const QLabel* each : pane.findChildren<QLabel*>()) QVERIFY(each->wordWrap());
    }
};

TOUCHDOWN_TEST(TestLessonPane)

} // namespace test_lesson_pane

#include "test_lesson_pane.moc"
