// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window opens whatever kind of file the program writes, and says in the window why it cannot open another.
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/studies/study/study_file.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "tests/ui/sample_study.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
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
        window_->openFile(QStringLiteral("nonsuch"));
        QVERIFY(question(*window_, "problems") != nullptr);
        QVERIFY(window_->edits().value().title.starts_with("Fig. 10 (a)"));
    }
    void aResultsFileThatIsNone()
    {
        window_->openResults(folder_.filePath(QStringLiteral("missing.h5")));
        QCOMPARE(window_->messages().kind(), MessageStrip::Kind::Failure);
        QVERIFY(window_->messages().text().contains(QStringLiteral("missing.h5")));
    }
    void theTextOfAStudy_data()
    {
        QTest::addColumn<bool>("asCase");
        QTest::newRow("as an argument") << false;
        QTest::newRow("by File, Open or dropping") << true;
    }
    void theTextOfAStudy()
    {
        QFETCH(bool, asCase);
        const QString file = folder_.filePath(QStringLiteral("mine.toml"));
        QFile text(file);
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write("kind = \"hysteresis\"\ncase = \"fig10a\"\nsteps = 3\n");
        text.close();
        asCase ? window_->files().open(file) : window_->openFile(file);
        QCOMPARE(page(), static_cast<int>(MainWindow::Page::Studies));
        QCOMPARE(window_->studies().editor()->kind(), QStringLiteral("hysteresis"));
        QVERIFY(window_->studies().editor()->toText().contains(QStringLiteral("steps = 3")));
        QVERIFY(question(*window_, "problems") == nullptr);
    }
    void theReportOfAStudy()
    {
        const QString file = folder_.filePath(QStringLiteral("study.h5"));
        StudyReport report = sampleReport();
        report.kind = "work-precision";
        const CaseDocument c = openCase("fig10a");
        QCOMPARE(writeStudy(file.toStdString(), report, c.value, c.text, "kind = \"work-precision\"\n"), std::string());
        window_->openResults(file);
        QCOMPARE(page(), static_cast<int>(MainWindow::Page::Studies));
        QVERIFY2(window_->studies().results()->report().has_value(), qPrintable(window_->messages().text()));
        QCOMPARE(window_->studies().results()->report()->title, report.title);
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
