// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lists/record_panel.h"

#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "tests/ui/question.h"
#include "ui/film/solution_files.h"
#include "ui/film/solutions_model.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"

using namespace touchdown;

namespace test_record_panel {

/// A run with one sample.
std::unique_ptr<RunRecord> shortRun(int number)
{
    auto record = std::make_unique<RunRecord>(number, Case{}, "", std::vector<Quantity>{{"pitch", "rad", "urad", ""}});
    record->append({{0.0}, {{1e-6}}}, {});
    record->finish(Summary{});
    return record;
}

void pressDelete(const RecordPanel& panel) { namedWidget<QAbstractButton>(panel, QStringLiteral("Delete"))->click(); }

class TestRecordPanel : public QObject {
    Q_OBJECT

private slots:
    void asksBeforeAnUnsavedRunIsDeleted()
    {
        RunsModel runs;
        runs.add(shortRun(1));
        runs.add(shortRun(2));
        RecordPanel panel(runs, RecordPanel::wordsOfRuns());
        panel.show();
        panel.choose(1);
        pressDelete(panel);
        QMessageBox* box = question(panel, "unsavedRecord");
        QVERIFY(box);
        QVERIFY2(box->text().startsWith(QStringLiteral("Run 1 “")), qPrintable(box->text()));
        QCOMPARE(box->defaultButton(), box->button(QMessageBox::Cancel));
        QTest::keyClick(box, Qt::Key_Escape);
        QCOMPARE(runs.count(), 2);
        pressDelete(panel);
        answer(panel, "unsavedRecord", QStringLiteral("Delete"));
        QCOMPARE(runs.count(), 1);
        QCOMPARE(runs.record(0).number, 2);
    }
    void asksBeforeAnUnsavedSolutionIsDeleted()
    {
        SolutionsModel solutions;
        solutions.add(test::sampleFilmCase(), test::sampleSteady());
        RecordPanel panel(solutions, RecordPanel::wordsOfSolutions());
        panel.show();
        panel.choose(1);
        pressDelete(panel);
        answer(panel, "unsavedRecord", QStringLiteral("Cancel"));
        QCOMPARE(solutions.count(), 1);
        pressDelete(panel);
        answer(panel, "unsavedRecord", QStringLiteral("Delete"));
        QCOMPARE(solutions.count(), 0);
    }
    /// Unless the file is another one by now.
    void deletesWhatAFileHolds()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("st.h5"));
        SolutionsModel solutions;
        solutions.add(test::sampleFilmCase(), test::sampleSteady());
        QCOMPARE(saveSolution(solutions.record(0), file), QString());
        solutions.setFile(1, file);
        RecordPanel panel(solutions, RecordPanel::wordsOfSolutions());
        panel.show();
        panel.choose(1);
        QVERIFY(QFile::rename(file, file + QStringLiteral(".away")));
        pressDelete(panel);
        answer(panel, "unsavedRecord", QStringLiteral("Cancel"));
        QVERIFY(QFile::rename(file + QStringLiteral(".away"), file));
        pressDelete(panel);
        QVERIFY(!question(panel, "unsavedRecord"));
        QCOMPARE(solutions.count(), 0);
    }
    /// A guide makes its runs anew, unless the reader wrote a note on one.
    void runsOfAGuideAreNoWork()
    {
        RunsModel runs;
        for (int number = 1; number <= 2; ++number) runs.add(shortRun(number)).ofGuide = true;
        runs.setData(runs.index(1), QStringLiteral("the best"), RecordList::NoteRole);
        RecordPanel panel(runs, RecordPanel::wordsOfRuns());
        panel.show();
        panel.choose(1);
        pressDelete(panel);
        QCOMPARE(runs.count(), 1);
        pressDelete(panel);
        QVERIFY(question(panel, "unsavedRecord"));
        QCOMPARE(runs.count(), 1);
    }
};

TOUCHDOWN_TEST(TestRecordPanel)

} // namespace test_record_panel

#include "test_record_panel.moc"
