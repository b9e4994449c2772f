// SPDX-License-Identifier: GPL-3.0-or-later
//
// A study that completes has not succeeded where what it checks does not hold.
#include <QSettings>
#include <QSignalSpy>
#include <QTextBrowser>
#include <QtTest>

#include "core/case_files/case_text.h"
#include "tests/support/test_program.h"
#include "ui/case/case_files.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_results.h"
#include "ui/studies/study_window.h"
#include "ui/style/message_strip.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace test_study_verdict_page {

/// Statements of which these hold: the words of the finding are the same for all.
StudyCatalogue checking(const std::vector<std::string>& holds)
{
    return {{{"statements", "Statements", "checks them", nullptr, nullptr}},
            {},
            [](const std::string&, const Case&) { return std::string("kind = \"statements\"\n"); },
            [holds](const std::string& kind, const std::string& text, const std::string& name,
                    const std::filesystem::path&, const Case& c) {
                StudyPlan plan;
                plan.kind = kind;
                plan.name = name;
                plan.text = text;
                plan.start.value = c;
                plan.start.text = formatCase(c);
                plan.perform = [holds](int, const StudyCallback&) {
                    StudyReport report;
                    report.kind = "statements";
                    report.title = "Statements";
                    report.findings = {"This is what was found."};
                    report.tables = {{"statements", {{"figure"}, {"holds"}}, {}}};
                    for (const std::string& each : holds) report.tables[0].rows.push_back({std::string("1"), each});
                    return report;
                };
                return plan;
            }};
}

class TestStudyVerdictPage : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_study_verdict_page"));
    }
    void init() { QSettings().clear(); }

    void kindOfTheMessage_data()
    {
        QTest::addColumn<QStringList>("holds");
        QTest::addColumn<MessageStrip::Kind>("kind");
        QTest::addColumn<QString>("mark");
        QTest::newRow("all") << QStringList{"yes", "yes"} << MessageStrip::Kind::Success << "✓";
        QTest::newRow("some") << QStringList{"yes", "no"} << MessageStrip::Kind::Information << "⚠";
        QTest::newRow("none") << QStringList{"no"} << MessageStrip::Kind::Warning << "⚠";
    }
    void kindOfTheMessage()
    {
        QFETCH(QStringList, holds);
        QFETCH(MessageStrip::Kind, kind);
        QFETCH(QString, mark);
        std::vector<std::string> rows;
        for (const QString& each : holds) rows.push_back(each.toStdString());
        MainWindow window{checking(rows)};
        window.show();
        window.files().openNow(QStringLiteral("fig10a"));
        window.setPage(MainWindow::Page::Studies);
        const QSignalSpy ended(&window, &MainWindow::calculationEnded);
        window.performStudy();
        QTRY_COMPARE(ended.count(), 1);
        QCOMPARE(window.messages().kind(), kind);
        const auto* findings = window.studies().results()->findChild<QTextBrowser*>();
        QVERIFY2(findings->toPlainText().contains(mark), qPrintable(findings->toPlainText()));
    }
};

TOUCHDOWN_TEST(TestStudyVerdictPage)

} // namespace test_study_verdict_page

#include "test_study_verdict_page.moc"
