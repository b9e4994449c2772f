// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/growing_report.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_growing_report {

StudyReport oneFinding()
{
    StudyReport report;
    report.title = "so far";
    report.findings = {"A sentence."};
    return report;
}

class TestGrowingReport : public QObject {
    Q_OBJECT

private slots:
    void isMadeWhereThereAreNews()
    {
        int made = 0, called = 0, shown = 0;
        const auto report = [&] {
            ++made;
            return oneFinding();
        };
        const StudyCallback callback = [&](const StudyProgress& progress) {
            ++called;
            if (progress.soFar != nullptr && progress.soFar->title == "so far") ++shown;
            return progress.share < 0.5;
        };
        QVERIFY(tellProgress(callback, {0.25, "run 1"}, true, report));
        QVERIFY(!tellProgress(callback, {0.75, "run 2"}, false, report));
        QVERIFY(tellProgress({}, {0.75, "run 2"}, true, report)); // nobody stops it
        QCOMPARE(called, 2);
        QCOMPARE(made, 1);
        QCOMPARE(shown, 1);
    }
    void findsNothingWhereItEndsEarly()
    {
        const StudyReport report = ended(oneFinding(), StudyStatus::Cancelled, "stopped");
        QCOMPARE(report.status, StudyStatus::Cancelled);
        QCOMPARE(report.message, std::string("stopped"));
        QVERIFY(report.findings.empty());
        QCOMPARE(report.title, std::string("so far"));
    }
};

TOUCHDOWN_TEST(TestGrowingReport)

} // namespace test_growing_report

#include "test_growing_report.moc"
