// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/lesson_print.h"

#include <QFile>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTextDocument>
#include <QtTest>

#include "tests/support/test_program.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/guides/lesson_text.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/run_view.h"
#include "ui/style/message_strip.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace test_lesson_print {

/// The springs alone, for 0.3 ms.
std::vector<LessonStep> shortSteps()
{
    std::vector<LessonStep> steps(lessonSteps().begin(), lessonSteps().begin() + 5);
    steps.push_back(lessonSteps().back());
    steps.back().runs.resize(2);
    for (LessonStep& step : steps)
        for (LessonRun& run : step.runs)
            if (run.kind.empty()) run.settings.push_back({"run.duration", "0.3 ms"});
    return steps;
}

QString plain(const QString& html)
{
    QTextDocument document;
    document.setHtml(html);
    return document.toPlainText().simplified();
}

class TestLessonPrint : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_lesson_print"));
        QSettings().clear();
    }

    /// Every text, the command of every study, a picture for every step, on at most eight pages.
    void holdsTheLesson()
    {
        const std::vector<LessonStep> steps = shortSteps();
        LessonPrint print(steps, QStringLiteral("The lesson"), nullptr);
        QSignalSpy ended(&print, &LessonPrint::ended), performed(&print, &LessonPrint::performed);
        print.start();
        QVERIFY(ended.wait(120000));
        QVERIFY2(ended[0][0].toBool(), qPrintable(ended[0][1].toString()));
        QCOMPARE(performed.size(), print.runs());
        const QString text = plain(print.html());
        std::size_t runs = 0;
        for (const LessonStep& step : steps) {
            for (const std::string& part : {step.title, step.text, step.question, step.answer, step.change}) {
                const QString words = plain(lessonHtml(part)).left(60);
                QVERIFY2(text.contains(words), qPrintable(words));
            }
            for (const LessonRun& run : step.runs) {
                runs += run.kind.empty();
                if (!run.kind.empty()) QVERIFY(text.contains(QString::fromStdString(commandOf(run))));
            }
        }
        QCOMPARE(print.runs(), static_cast<int>(runs));
        QVERIFY(text.contains("ends at 7.0"));
        QVERIFY2(text.contains("standard deviation"), qPrintable(text));
        QCOMPARE(print.html().count("<img "), 9); // the energy and the forces have pictures of their own
        for (const char* which :
             {"Run 1:", "Run 2:", "Run 8:"}) // of steps 1 and 2 the stage names it, of step 4 the last
            QVERIFY2(text.contains(which), which);
        QVERIFY2(print.pages() >= 6 && print.pages() <= 8, qPrintable(QString::number(print.pages())));
        const QByteArray pdf = print.pdf();
        QVERIFY(pdf.startsWith("%PDF-") && pdf.size() > 100000);
        QCOMPARE(pdf.count("/Type /Page\n"), print.pages());
    }

    /// Runs of a second model have a picture of their own, also where that model has no spectrum to wait for.
    void modelsHavePicturesOfTheirOwn()
    {
        std::vector<LessonStep> steps{lessonSteps().back()};
        std::vector<LessonRun>& runs = steps[0].runs;
        runs.resize(2);
        for (LessonRun& run : runs) run.settings.push_back({"run.duration", "0.3 ms"});
        runs.push_back({"A pad in contact.", "contact_hertz", "", {}});
        LessonPrint print(steps, QStringLiteral("The lesson"), nullptr);
        QSignalSpy ended(&print, &LessonPrint::ended);
        print.start();
        QVERIFY(ended.wait(60000));
        QVERIFY2(ended[0][0].toBool(), qPrintable(ended[0][1].toString()));
        QCOMPARE(print.html().count("<img "), 2);
        const QString text = plain(print.html());
        QVERIFY(text.contains("Runs 1, 2:") && text.contains("Run 3:"));
    }

    void endsWhenItIsCancelled()
    {
        LessonPrint print(shortSteps(), QStringLiteral("The lesson"), nullptr);
        QSignalSpy ended(&print, &LessonPrint::ended);
        print.start();
        connect(&print, &LessonPrint::performed, &print, &LessonPrint::cancel);
        QVERIFY(ended.wait(60000));
        QVERIFY(!ended[0][0].toBool() && ended[0][1].toString().isEmpty());
        LessonPrint left(shortSteps(), QStringLiteral("The lesson"), nullptr);
        left.start(); // and nobody waits for it
        QCoreApplication::processEvents();
    }

    /// Its own runs, plots and case stay; a print that is cancelled leaves no file.
    void leavesTheWindowAlone()
    {
        const QTemporaryDir folder;
        MainWindow window;
        window.show();
        window.files().openNow("fig12a");
        const Case before = window.edits().value();
        window.printLessonTo(folder.filePath("a.pdf"));
        auto* progress = window.findChild<QProgressDialog*>();
        QVERIFY(progress && !progress->isModal());
        QTRY_VERIFY_WITH_TIMEOUT(progress->value() >= 2, 60000);
        progress->findChild<QPushButton*>()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!window.findChild<QProgressDialog*>(), 60000);
        QVERIFY(!QFile::exists(folder.filePath("a.pdf")));
        QVERIFY(window.messages().text().isEmpty());
        QCOMPARE(window.runs().count(), 0);
        QVERIFY(!window.runView().stage() && window.edits().value() == before);
    }
};

TOUCHDOWN_TEST(TestLessonPrint)

} // namespace test_lesson_print

#include "test_lesson_print.moc"
