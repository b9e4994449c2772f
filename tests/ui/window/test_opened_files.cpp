// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window opens whatever kind of file the program writes, and says in the window why it cannot open another.
#include <QFileDialog>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/studies/study/study_file.h"
#include "core/studies/study/study_file_reader.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "tests/ui/sample_study.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/lists/record_panel.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/runs/runs_model.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_results.h"
#include "ui/studies/study_window.h"
#include "ui/style/message_strip.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace test_opened_files {

class TestOpenedFiles : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_opened_files"));
    }
    void init()
    {
        QSettings().clear();
        window_ = std::make_unique<MainWindow>();
        window_->files().openNow(QStringLiteral("fig10a"));
        window_->show();
    }
    void cleanup() { window_.reset(); }
    void aCaseThatIsNone()
    {
        window_->files().open(QStringLiteral("nonsuch"));
        QVERIFY(question(*window_, "problems") != nullptr);
        QVERIFY(window_->edits().value().title.starts_with("Fig. 10 (a)"));
    }
    void aResultsFileThatIsNone()
    {
        window_->files().open(folder_.filePath(QStringLiteral("missing.h5")));
        QCOMPARE(window_->messages().kind(), MessageStrip::Kind::Failure);
        QVERIFY(window_->messages().text().contains(QStringLiteral("missing.h5")));
    }
    void theTextOfAStudy()
    {
        const QString file = folder_.filePath(QStringLiteral("mine.toml"));
        QFile text(file);
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write("kind = \"hysteresis\"\ncase = \"fig10a\"\nsteps = 3\n");
        text.close();
        window_->files().open(file);
        QCOMPARE(page(), static_cast<int>(MainWindow::Page::Studies));
        QCOMPARE(window_->studies().editor()->kind(), QStringLiteral("hysteresis"));
        QVERIFY(window_->studies().editor()->toText().contains(QStringLiteral("steps = 3")));
        QVERIFY(question(*window_, "problems") == nullptr);
    }
    /// There is one report of each kind.
    void aReportInThePlaceOfAnUnsavedOne()
    {
        const QString file = folder_.filePath(QStringLiteral("other.h5"));
        StudyReport report = sampleReport();
        report.title = "the opened one";
        QCOMPARE(writeStudy(file.toStdString(), report, Case{}, "", ""), std::string());
        const StudyReport unsaved = sampleReport();
        window_->studies().restore({unsaved, "", "", ""});
        const auto title = [this, &report] { return window_->studies().outcome(report.kind)->report->title; };
        window_->files().open(file);
        auto* box = question(*window_, "unsavedReport");
        QVERIFY(box != nullptr);
        QCOMPARE(title(), sampleReport().title);
        for (QAbstractButton* button : box->buttons())
            if (box->buttonRole(button) == QMessageBox::DestructiveRole) button->click();
        QCOMPARE(title(), report.title);
    }
    void theReportOfAStudy()
    {
        const QString file = folder_.filePath(QStringLiteral("study.h5"));
        StudyReport report = sampleReport();
        report.kind = "work-precision";
        const CaseDocument c = openCase("fig10a");
        QCOMPARE(writeStudy(file.toStdString(), report, c.value, c.text, "kind = \"work-precision\"\n"), std::string());
        window_->files().open(file);
        QCOMPARE(page(), static_cast<int>(MainWindow::Page::Studies));
        QVERIFY2(window_->studies().results()->report().has_value(), qPrintable(window_->messages().text()));
        QCOMPARE(window_->studies().results()->report()->title, report.title);
    }
    /// The parameters of another case do not come into the file that is open.
    void theCaseOfAnotherRunHasNoFile()
    {
        const QString mine = folder_.filePath(QStringLiteral("own.toml"));
        const std::string text = "# my own comment\ntitle = \"mine\"\nmodel = \"springs\"\n";
        QCOMPARE(writeCaseFile(mine.toStdString(), text), std::string());
        window_->files().openNow(mine);
        Case other = openCase("fig12a").value, same = window_->edits().value();
        same.springs.flyingHeight = 5e-9;
        for (const Case& c : {other, same})
            window_->runs().add(
                std::make_unique<RunRecord>(window_->runs().nextNumber(), c, formatCase(c), std::vector<Quantity>()));
        emit window_->runWindow().panel()->parametersRequested(2);
        QCOMPARE(window_->files().file(), mine);
        QVERIFY(window_->files().modified());
        emit window_->runWindow().panel()->parametersRequested(1);
        QCOMPARE(window_->edits().value(), same);
        answer(*window_, "unsavedChanges", QStringLiteral("Discard"));
        QCOMPARE(window_->edits().value(), other);
        QCOMPARE(window_->files().file(), QString());
        QCOMPARE(window_->files().shortName(), QStringLiteral("run 1"));
        window_->files().save();
        QVERIFY(window_->findChild<QFileDialog*>() != nullptr);
        QCOMPARE(openCase(mine.toStdString()).text, text);
    }
    void aMessageLeavesWithItsPage()
    {
        window_->messages().show(MessageStrip::Kind::Success, QStringLiteral("Run 1: at rest"));
        window_->setPage(MainWindow::Page::Run);
        QCOMPARE(window_->messages().text(), QStringLiteral("Run 1: at rest"));
        window_->setPage(MainWindow::Page::Studies);
        QCOMPARE(window_->messages().text(), QString());
    }

private:
    int page() const { return window_->findChild<QTabBar*>(QStringLiteral("pages"))->currentIndex(); }

    QTemporaryDir folder_;
    std::unique_ptr<MainWindow> window_;
};

TOUCHDOWN_TEST(TestOpenedFiles)

} // namespace test_opened_files

#include "test_opened_files.moc"
