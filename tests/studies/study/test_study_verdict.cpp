// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_verdict.h"

#include "core/studies/study/study.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace touchdown;

namespace test_study_verdict {

class TestStudyVerdict : public QObject {
    Q_OBJECT

private slots:
    void countsTheRowsThatHold_data()
    {
        QTest::addColumn<QStringList>("holds");
        QTest::addColumn<int>("verdict");
        const auto row = [](const char* name, const QStringList& holds, StudyVerdict verdict) {
            QTest::newRow(name) << holds << static_cast<int>(verdict);
        };
        row("all", {"yes", "yes"}, StudyVerdict::Holds);
        row("some", {"yes", "no"}, StudyVerdict::HoldsPartly);
        row("none", {"no"}, StudyVerdict::HoldsNot);
        row("stopped before the first", {}, StudyVerdict::HoldsNot);
    }
    void countsTheRowsThatHold()
    {
        QFETCH(QStringList, holds);
        QFETCH(int, verdict);
        StudyReport report;
        report.findings = {"All of them hold."}; // words decide nothing
        report.tables = {{"statements", {{"figure"}, {"holds"}}, {}}};
        for (const QString& each : holds) report.tables[0].rows.push_back({std::string("1"), each.toStdString()});
        QCOMPARE(static_cast<int>(verdictOf(report)), verdict);
        report.findings.clear(); // of a part
        QCOMPARE(verdictOf(report), StudyVerdict::None);
    }
    void othersHaveNone()
    {
        StudyReport report;
        QCOMPARE(verdictOf(report), StudyVerdict::None);
        report.tables = {{"runs", {{"method"}}, {{std::string("rk4")}}}};
        QCOMPARE(verdictOf(report), StudyVerdict::None);
    }
};

TOUCHDOWN_TEST(TestStudyVerdict)

} // namespace test_study_verdict

#include "test_study_verdict.moc"
