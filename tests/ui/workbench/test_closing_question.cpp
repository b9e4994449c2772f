// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/closing_question.h"

#include <QFileDialog>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/results/results_reader.h"
#include "core/results/steady_reader.h"
#include "core/studies/study/study_file_reader.h"
#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "tests/ui/sample_study.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/modes_page.h"
#include "ui/film/series_page.h"
#include "ui/film/solution_files.h"
#include "ui/film/solutions_model.h"
#include "ui/runs/run_files.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_closing_question {

const QString saveAll = QStringLiteral("Save all and close");
const QString leave = QStringLiteral("Close without saving");
const QString goOn = QStringLiteral("Go on working");

class TestClosingQuestion : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup() { window_.reset(); }
    void asksNothingWhenAllIsSaved();
    void asksOnce_data();
    void asksOnce();
    void namesAllKindsAtOnce();
    void goesOnWorking();
    void savesAllIntoAFolder();
    void savesACaseToItsFile();
    void asksForACaseThatAnotherProgramChanged_data();
    void asksForACaseThatAnotherProgramChanged();
    void asksForTheNameOfACaseAlone();
    void staysOpenWhenSomethingIsNotSaved();
    void keepsARunThatIsStopped();
    void asksForARunWhoseFileAnotherTook();
    void asksForAResultWhoseFileIsAnotherByNow_data();
    void asksForAResultWhoseFileIsAnotherByNow();
    void savesTheTextsOfStudies();
    void savesTheSeriesAndTheModes();

private:
    void edit(const char* key, const QString& text) { window_->edits().enter(*findParameter(key), text); }
    void addRuns(int count)
    {
        edit("run.duration", QStringLiteral("10 µs"));
        for (int i = 0; i < count; ++i) {
            window_->startRun();
            QTRY_VERIFY(!window_->controller().active());
        }
        edit("run.duration", QStringLiteral("2 ms")); // as the case has it
    }
    void addSolution() { window_->film().solutions().add(test::sampleFilmCase(), test::sampleSteady()); }
    void addStudy() { window_->studies().restore({sampleReport(), "", "", ""}); }
    void startSlowRun()
    {
        QComboBox* pace = window_->actions().pace;
        pace->setCurrentIndex(pace->findData(1e-5));
        window_->startRun();
        QTRY_VERIFY(window_->runs().record(0).sampleCount() > 1);
    }
    QString lost() { return question(*window_, "closing")->informativeText(); }
    void chooseFolder(const QString& folder)
    {
        auto* dialog = window_->findChild<QFileDialog*>(QStringLiteral("saveAllFolder"));
        QVERIFY(dialog);
        dialog->setDirectory(folder);
        dialog->selectFile(folder);
        QMetaObject::invokeMethod(dialog, "accept");
    }

    std::unique_ptr<MainWindow> window_;
};

void TestClosingQuestion::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("test_closing_question"));
}

void TestClosingQuestion::init()
{
    QSettings().clear();
    window_ = std::make_unique<MainWindow>();
    window_->files().openNow(QStringLiteral("fig10a"));
    window_->show();
}

void TestClosingQuestion::asksNothingWhenAllIsSaved()
{
    const QTemporaryDir folder;
    addRuns(1);
    const QString file = folder.filePath(QStringLiteral("run.h5"));
    QCOMPARE(saveHdf5(window_->runs().record(0), file), QString());
    window_->runs().setFile(1, file);
    window_->files().open(file);
    QCOMPARE(window_->runs().count(), 2);
    window_->close();
    QVERIFY(!window_->isVisible());
}

void TestClosingQuestion::asksOnce_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("line");
    QTest::newRow("an edited case") << "case"
                                    << "the changes of the case “fig10a”";
    QTest::newRow("a run under way") << "run"
                                     << "run 1, which is under way";
    QTest::newRow("22 runs") << "runs"
                             << "22 runs that are not saved: 1 “";
    QTest::newRow("a static solution") << "solution"
                                       << "1 static solution that is not saved: 1 “A plane”";
    QTest::newRow("a study report") << "study"
                                    << "1 study report that is not saved: “Accuracy against speed”";
    QTest::newRow("a solve under way") << "solve"
                                       << "a static solution, which is under way";
    QTest::newRow("a study under way") << "studying"
                                       << "a study, which is under way";
}

void TestClosingQuestion::asksOnce()
{
    QFETCH(const QString, kind);
    QFETCH(const QString, line);
    if (kind == "case") edit("springs.flying_height", QStringLiteral("4"));
    if (kind == "run") startSlowRun();
    if (kind == "runs") addRuns(22);
    if (kind == "solution") addSolution();
    if (kind == "study") addStudy();
    if (kind == "solve") {
        window_->files().openNow(QStringLiteral("film_pico"));
        window_->solveStaticState();
    }
    if (kind == "studying") window_->performStudy();
    window_->close();
    QVERIFY(window_->isVisible());
    QVERIFY2(lost().contains(line), qPrintable(lost()));
    window_->close(); // a second click does not ask again
    QCOMPARE(window_->findChildren<QMessageBox*>(QStringLiteral("closing")).size(), 1);
    answer(*window_, "closing", leave);
    QVERIFY(!window_->isVisible());
    QVERIFY(!question(*window_, "closing") && !question(*window_, "unsavedChanges"));
}

void TestClosingQuestion::namesAllKindsAtOnce()
{
    addRuns(6);
    edit("springs.flying_height", QStringLiteral("4"));
    addSolution();
    addSolution();
    addStudy();
    window_->close();
    QCOMPARE(lost().count(QStringLiteral("• ")), 4);
    for (const char* part : {"the case “fig10a”", "6 runs", "and 2 more", "2 static solutions", "1 study report"})
        QVERIFY2(lost().contains(QString::fromUtf8(part)), part);
    answer(*window_, "closing", leave);
    QVERIFY(!window_->isVisible());
}

void TestClosingQuestion::goesOnWorking()
{
    startSlowRun();
    window_->close();
    answer(*window_, "closing", goOn);
    QVERIFY(window_->isVisible());
    QCOMPARE(window_->controller().state(), RunController::State::Running);
    window_->close(); // asks again
    QVERIFY(question(*window_, "closing"));
}

void TestClosingQuestion::savesAllIntoAFolder()
{
    const QTemporaryDir folder;
    addRuns(2);
    edit("springs.flying_height", QStringLiteral("4"));
    addSolution();
    addStudy();
    const QString first = suggestedName(window_->runs().record(0));
    QFile taken(folder.filePath(first + QStringLiteral(".h5"))); // is not replaced
    QVERIFY(taken.open(QIODevice::WriteOnly) && taken.write("mine") == 4);
    taken.close();
    window_->close();
    answer(*window_, "closing", saveAll);
    QVERIFY(window_->isVisible());
    chooseFolder(folder.path());
    QVERIFY(!window_->isVisible());
    QCOMPARE(QFileInfo(taken).size(), 4);
    QCOMPARE(openCase(folder.filePath(QStringLiteral("fig10a.toml")).toStdString()).value.springs.flyingHeight, 4e-9);
    QCOMPARE(readResults((folder.filePath(first) + "-2.h5").toStdString()).status, std::string("completed"));
    const QString second = suggestedName(window_->runs().record(1));
    QCOMPARE(readResults((folder.filePath(second) + ".h5").toStdString()).samples.size(), std::size_t(101));
    QCOMPARE(readSteady(folder.filePath(QStringLiteral("solution1.h5")).toStdString()).states.size(), std::size_t(1));
    const StoredStudy study = readStudy(folder.filePath(QStringLiteral("work-precision.h5")).toStdString());
    QVERIFY2(study.problem.empty(), study.problem.c_str());
    QCOMPARE(study.report.findings, sampleReport().findings);
}

void TestClosingQuestion::savesACaseToItsFile()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mine.toml"));
    QCOMPARE(writeCaseFile(file.toStdString(), "[springs]\nflying_height = \"7 nm\" # as designed\n"), std::string());
    window_->files().openNow(file);
    edit("springs.flying_height", QStringLiteral("4"));
    window_->close();
    answer(*window_, "closing", saveAll);
    QVERIFY(!window_->isVisible()); // without a second question
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QVERIFY(written.readAll().contains("flying_height = \"4 nm\" # as designed"));
}

void TestClosingQuestion::asksForACaseThatAnotherProgramChanged_data()
{
    QTest::addColumn<bool>("withResults");
    QTest::newRow("the case alone") << false;
    QTest::newRow("with results") << true;
}

void TestClosingQuestion::asksForACaseThatAnotherProgramChanged()
{
    QFETCH(const bool, withResults);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mine.toml"));
    QCOMPARE(writeCaseFile(file.toStdString(), "[springs]\nflying_height = \"7 nm\"\n"), std::string());
    window_->files().openNow(file);
    edit("springs.flying_height", QStringLiteral("4"));
    if (withResults) addSolution();
    QCOMPARE(writeCaseFile(file.toStdString(), "[springs]\nflying_height = \"5 nm\"\n"), std::string());
    const auto text = [&file] {
        QFile written(file);
        return written.open(QIODevice::ReadOnly) ? written.readAll() : QByteArray();
    };
    window_->close();
    answer(*window_, "closing", saveAll);
    answer(*window_, "changedFile", QStringLiteral("Cancel"));
    QVERIFY(window_->isVisible());
    QVERIFY(text().contains("5 nm"));
    window_->close();
    answer(*window_, "closing", saveAll);
    answer(*window_, "changedFile", QStringLiteral("Write over it"));
    QVERIFY(text().contains("4 nm"));
    if (withResults) chooseFolder(folder.path());
    QVERIFY(!window_->isVisible());
}

void TestClosingQuestion::asksForTheNameOfACaseAlone()
{
    const QTemporaryDir folder;
    edit("springs.flying_height", QStringLiteral("4"));
    window_->close();
    answer(*window_, "closing", saveAll);
    auto* dialog = window_->findChild<QFileDialog*>();
    QVERIFY(dialog);
    dialog->setDirectory(folder.path());
    QMetaObject::invokeMethod(dialog, "accept");
    QVERIFY(!window_->isVisible());
    QCOMPARE(openCase(folder.filePath(QStringLiteral("fig10a.toml")).toStdString()).value.springs.flyingHeight, 4e-9);
}

void TestClosingQuestion::staysOpenWhenSomethingIsNotSaved()
{
    const QTemporaryDir folder;
    addRuns(1);
    edit("springs.flying_height", QStringLiteral("7 mN")); // no length
    window_->close();
    answer(*window_, "closing", saveAll);
    chooseFolder(folder.path());
    QVERIFY(window_->isVisible());
    QMessageBox* told = question(*window_, "notSaved");
    QVERIFY(told);
    QVERIFY2(told->informativeText().startsWith(QStringLiteral("The case: Static flying height")),
             qPrintable(told->informativeText()));
    QVERIFY(!window_->runs().record(0).file.isEmpty()); // the run is saved
}

void TestClosingQuestion::keepsARunThatIsStopped()
{
    const QTemporaryDir folder;
    startSlowRun();
    window_->close();
    answer(*window_, "closing", saveAll);
    QCOMPARE(window_->controller().state(), RunController::State::Idle);
    chooseFolder(folder.path());
    QVERIFY(!window_->isVisible());
    const StoredRun run = readResults(window_->runs().record(0).file.toStdString());
    QCOMPARE(run.status, std::string("cancelled"));
    QCOMPARE(run.samples.size(), window_->runs().record(0).sampleCount());
}

void TestClosingQuestion::asksForARunWhoseFileAnotherTook()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("run.h5"));
    edit("run.duration", QStringLiteral("10 µs"));
    window_->files().write(folder.filePath(QStringLiteral("mine.toml")));
    for (int i = 0; i < 2; ++i) {
        window_->runWindow().start({window_->edits().value(), window_->files().text(), file.toStdString()});
        QTRY_VERIFY(!window_->controller().active());
    }
    QVERIFY(window_->runs().record(0).file.isEmpty());
    QCOMPARE(window_->runs().record(1).file, file);
    window_->close();
    QVERIFY2(lost().contains(QStringLiteral("1 run that is not saved: 1 ")), qPrintable(lost()));
}

void TestClosingQuestion::asksForAResultWhoseFileIsAnotherByNow_data()
{
    QTest::addColumn<bool>("removed");
    QTest::newRow("written over") << false;
    QTest::newRow("removed") << true;
}

void TestClosingQuestion::asksForAResultWhoseFileIsAnotherByNow()
{
    QFETCH(const bool, removed);
    const QTemporaryDir folder;
    const QString run = folder.filePath(QStringLiteral("run.h5")), solution = folder.filePath(QStringLiteral("st.h5"));
    addRuns(1);
    addSolution();
    QCOMPARE(saveHdf5(window_->runs().record(0), run), QString());
    window_->runs().setFile(1, run);
    SolutionsModel& solutions = window_->film().solutions();
    QCOMPARE(saveSolution(solutions.record(0), solution), QString());
    solutions.setFile(1, solution);
    for (const QString& file : {run, solution})
        if (removed)
            QVERIFY(QFile::remove(file));
        else
            QCOMPARE(writeCaseFile(file.toStdString(), "of another program"), std::string());
    window_->close();
    QVERIFY2(lost().contains(QStringLiteral("1 run that is not saved: 1 ")), qPrintable(lost()));
    QVERIFY2(lost().contains(QStringLiteral("1 static solution that is not saved: 1 ")), qPrintable(lost()));
    answer(*window_, "closing", saveAll);
    chooseFolder(folder.path());
    QVERIFY(!window_->isVisible());
    QCOMPARE(QDir(folder.path()).entryList({QStringLiteral("*.h5")}, QDir::Files).size(), removed ? 2 : 4);
}

void TestClosingQuestion::savesTheTextsOfStudies()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mine.toml"));
    QCOMPARE(writeCaseFile(file.toStdString(), "kind = \"hysteresis\"\nsteps = 400\n"), std::string());
    StudyEditor& editor = *window_->studies().editor();
    window_->files().open(file);
    window_->close();
    QVERIFY(!window_->isVisible()); // it was only opened
    window_->show();
    editor.setText(QStringLiteral("kind = \"hysteresis\"\nsteps = 123\n"));
    editor.setKind(QStringLiteral("cycles"));
    editor.setText(QStringLiteral("kind = \"cycles\"\n"));
    window_->close();
    QVERIFY(window_->isVisible());
    QVERIFY2(lost().contains(QStringLiteral("the changes of 2 studies")), qPrintable(lost()));
    answer(*window_, "closing", saveAll);
    chooseFolder(folder.path());
    QVERIFY(!window_->isVisible());
    QFile mine(file), other(folder.filePath(QStringLiteral("cycles.toml")));
    QVERIFY(mine.open(QIODevice::ReadOnly) && other.open(QIODevice::ReadOnly));
    QCOMPARE(mine.readAll(), QByteArray("kind = \"hysteresis\"\nsteps = 123\n"));
    QCOMPARE(other.readAll(), QByteArray("kind = \"cycles\"\n"));
}

void TestClosingQuestion::savesTheSeriesAndTheModes()
{
    const QTemporaryDir folder;
    const FilmView* view = window_->film().view();
    Case listed = test::sampleFilmCase();
    listed.steady.radii = {20e-3, 25e-3};
    view->series()->restore({listed, {test::sampleSteady(), test::sampleSteady()}, {}});
    FoundModes modes{test::sampleFilmCase(), {}};
    modes.result.modes.resize(1);
    modes.result.modes.front().frequency = 91.5e3;
    view->modes()->restore(modes);
    window_->close();
    QVERIFY2(lost().contains(QStringLiteral("a series of 2 static states")), qPrintable(lost()));
    QVERIFY2(lost().contains(QStringLiteral("modes that are not saved")), qPrintable(lost()));
    answer(*window_, "closing", saveAll);
    chooseFolder(folder.path());
    QVERIFY(!window_->isVisible());
    for (const auto& [name, bytes] :
         {std::pair("series.csv", view->series()->csv()), std::pair("modes.csv", csvOf(modes.result))}) {
        QFile file(folder.filePath(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), bytes);
    }
    window_->show();
    window_->close(); // without a question
    QVERIFY(!window_->isVisible());
}

TOUCHDOWN_TEST(TestClosingQuestion)

} // namespace test_closing_question

#include "test_closing_question.moc"
