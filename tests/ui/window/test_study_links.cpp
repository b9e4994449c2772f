// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/calculation/progress_strip.h"
#include "ui/case/case_panel.h"
#include "ui/case/parameter_editor.h"
#include "ui/studies/engine_dialog.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_results.h"
#include "ui/studies/study_window.h"
#include "ui/style/result_table.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace test_study_links {

using Fixture = test::WindowFixture;

class TestStudyLinks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_study_links"));
    }
    void init() { QSettings().clear(); }

    void aFieldIsVariedAndARowOpensItsCase()
    {
        Fixture f;
        vary(f, "slider.mass");
        StudyEditor& editor = *f.window.findChild<StudyEditor*>();
        QCOMPARE(editor.kind(), QStringLiteral("sweep"));
        QVERIFY2(editor.plan().valid(), qPrintable(editor.problems()));
        QCOMPARE(editor.plan().items, std::size_t(7));
        f.toEnd([&] { f.window.performStudy(); });
        StudyResults& results = *f.window.findChild<StudyResults*>();
        auto* table = results.findChild<ResultTable*>();
        QVERIFY(table);
        auto* open = button(results, QStringLiteral("Open the case"));
        QVERIFY(open && !open->isEnabled());
        table->selectRow(6);
        QVERIFY(open->isEnabled());
        open->click();
        QCOMPARE(f.window.edits().value().slider.mass, 1.5 * 1.6e-6);
        // The order that was chosen, too.
        table->sortByColumn(0, Qt::DescendingOrder);
        table->selectRow(6);
        open->click();
        QCOMPARE(f.window.edits().value().slider.mass, 0.5 * 1.6e-6);
    }

    void aChoiceIsVaried()
    {
        Fixture f;
        vary(f, "run.integrator");
        StudyEditor& editor = *f.window.findChild<StudyEditor*>();
        QVERIFY2(editor.plan().valid(), qPrintable(editor.problems()));
        QVERIFY(editor.plan().items >= 4);
    }

    /// Stopped, it continues with its rows and without a question; another value asks for new rows alone.
    void aListGoesOn()
    {
        Fixture f;
        StudyEditor& editor = *f.window.findChild<StudyEditor*>();
        editor.setKind(QStringLiteral("sweep"));
        editor.setText(slow(40));
        QVERIFY2(editor.plan().valid(), qPrintable(editor.problems()));
        QCOMPARE(editor.run()->text(), QStringLiteral("Perform"));
        StudyWindow& studies = f.window.studies();
        const auto stops = QObject::connect(&studies.controller(), &StudyController::partial, &f.window,
                                            [&](int, const StudyReport& report) {
                                                if (!report.items.empty()) studies.controller().stop();
                                            });
        f.toEnd([&] { f.window.performStudy(); });
        QObject::disconnect(stops);
        const std::size_t there = studies.outcome("sweep")->report->items.size();
        QVERIFY2(there > 0 && there < 40, std::to_string(there).c_str());
        QCOMPARE(editor.run()->text(), QStringLiteral("Continue"));
        f.toEnd([&] { f.window.performStudy(); });
        QCOMPARE(studies.outcome("sweep")->report->status, StudyStatus::Completed);
        QCOMPARE(studies.outcome("sweep")->report->items.size(), std::size_t(40));
        QVERIFY2(concluded(f).contains(QStringLiteral("%1 of 40 rows were there already").arg(there)),
                 qPrintable(concluded(f)));
        QCOMPARE(editor.run()->text(), QStringLiteral("Perform"));
    }

    /// Opened from its file, too; and with keep = "all" a row opens its run.
    void rowsOfAnOpenedReport()
    {
        const QTemporaryDir folder;
        const QString study = folder.filePath(QStringLiteral("a.toml")),
                      report = folder.filePath(QStringLiteral("a.h5"));
        {
            Fixture f;
            StudyEditor& editor = *f.window.findChild<StudyEditor*>();
            editor.setKind(QStringLiteral("sweep"));
            editor.setText(QStringLiteral("keep = \"all\"\n") + slow(3));
            f.window.performStudy();
            QCOMPARE(f.window.studies().controller().active(), false); // it has no folder yet
            QCOMPARE(editor.save(study), QString());
            f.toEnd([&] { f.window.performStudy(); });
            QVERIFY(QFile::exists(folder.filePath(QStringLiteral("runs"))));
            openRow(f, 1);
            QTRY_COMPARE(f.window.runs().count(), 1);
            QCOMPARE(f.window.studies().save("sweep", report), QString());
        }
        Fixture f;
        f.window.files().open(report);
        QTRY_VERIFY(f.window.studies().outcome("sweep") != nullptr);
        QVERIFY(f.window.findChild<StudyEditor*>()->toText().contains(slow(3))); // it can be performed again
        openRow(f, 2);
        QTRY_COMPARE(f.window.runs().count(), 1);
        QVERIFY(QDir(folder.filePath(QStringLiteral("runs"))).removeRecursively());
        openRow(f, 2);
        QCOMPARE(f.window.edits().value().initial.flyingHeight, 30e-9);
    }

    /// By other processes: the same table, and what the engine tells stands below it.
    void aListIsPerformedElsewhere()
    {
        const QTemporaryDir folder;
        Fixture f;
        StudyEditor& editor = *f.window.findChild<StudyEditor*>();
        editor.setKind(QStringLiteral("sweep"));
        editor.setText(slow(6));
        auto* dialog = new EngineDialog(folder.path(), &editor);
        EngineTask task;
        connect(dialog, &EngineDialog::taken, [&](const EngineTask& taken) { task = taken; });
        dialog->findChildren<QSpinBox*>().at(0)->setValue(3);
        dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
        QCOMPARE(task.kind, EngineKind::Slurm);
        QCOMPARE(task.parts, std::size_t(3));
        QCOMPARE(task.jobs, 1);
        QCOMPARE(task.folder, std::filesystem::path(folder.filePath(QStringLiteral("cluster")).toStdString()));
        task.kind = EngineKind::Command;
        task.program = TOUCHDOWN_COMMAND;
        task.submit = "sh -c 'for k in {parts}; do {script} $k; done'";
        f.toEnd([&] { QVERIFY(f.window.studies().perform(task)); });
        const StudyReport there = *f.window.studies().outcome("sweep")->report;
        QVERIFY2(there.status == StudyStatus::Completed, there.message.c_str());
        const StudyReport here = editor.plan().perform(1, {});
        QVERIFY(there.tables.front().rows == here.tables.front().rows);
        QVERIFY(QFile::exists(folder.filePath(QStringLiteral("cluster/part.sh"))));
    }

    void textsAndListsAreNot()
    {
        Fixture f;
        for (const char* key : {"title", "abs.wall_profiles", "degrees_of_freedom"})
            if (const ParameterEditor* field = f.window.casePanel().editor(key))
                QVERIFY(!field->findChild<QAction*>(QStringLiteral("vary")));
    }

private:
    /// So many drops from 10 to 30 nm.
    static QString slow(int count)
    {
        return QStringLiteral("case = \"fig10a\"\nset = { \"run.duration\" = \"1 ms\" }\n[[axis]]\nkey = "
                              "\"initial.flying_height\"\nfrom = \"10 nm\"\nto = \"30 nm\"\ncount = %1\n[[reading]]\n"
                              "quantity = \"flying_height\"\n")
            .arg(count);
    }
    static QString concluded(Fixture& f)
    {
        QString all;
        for (const QLabel* label : f.window.studies().progress()->findChildren<QLabel*>()) all += label->text() + u'\n';
        return all;
    }
    static void openRow(Fixture& f, int row)
    {
        StudyResults& results = *f.window.findChild<StudyResults*>();
        auto* table = results.findChild<ResultTable*>();
        QVERIFY(table);
        table->selectRow(row);
        for (QToolButton* open : results.findChildren<QToolButton*>()) {
            if (open->accessibleName() != QStringLiteral("Open the chosen row")) continue;
            QVERIFY(open->isEnabled());
            open->click();
        }
    }
    static void vary(Fixture& f, const char* key)
    {
        const ParameterEditor* field = f.window.casePanel().editor(key);
        QVERIFY(field);
        auto* action = field->findChild<QAction*>(QStringLiteral("vary"));
        QVERIFY(action);
        action->trigger();
    }
    static QToolButton* button(const QWidget& in, const QString& text)
    {
        for (QToolButton* each : in.findChildren<QToolButton*>())
            if (each->text() == text) return each;
        return nullptr;
    }
};

} // namespace test_study_links

using test_study_links::TestStudyLinks;
TOUCHDOWN_TEST(TestStudyLinks)
#include "test_study_links.moc"
