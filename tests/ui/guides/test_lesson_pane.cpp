// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/lesson_pane.h"

#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "ui/guides/lesson_text.h"
#include "ui/style/theme.h"

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

class TestLessonPane : public QObject {
    Q_OBJECT

private slots:
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
        QVERIFY(shownText(pane, "What to change").contains(QStringLiteral("<a href='run.step'>time step</a>")));
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
