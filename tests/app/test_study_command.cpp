// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <random>

#include "core/results/results_reader.h"
#include "core/simulation/recording/quantity.h"
#include "core/studies/study/study_file_reader.h"
#include "core/studies/study_plan.h"
#include "tests/support/command_process.h"
#include "tests/support/study_cells.h"
#include "tests/support/study_kinds.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_command {

class TestStudyCommand : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }

    void json()
    {
        const Outcome o = folder_->touchdown(
            QStringList{"study", "hysteresis", "fig10a", "--json", "--out", "a.h5", "--csv", "a.csv"} + quick_);
        QCOMPARE(o.code, 0);
        QCOMPARE(o.err, QByteArray());
        const QJsonObject study = o.json();
        QCOMPARE(study["status"].toString(), QString("completed"));
        QCOMPARE(study["kind"].toString(), QString("hysteresis"));
        QVERIFY(!study["findings"].toArray().isEmpty());
        QVERIFY(!study["charts"].toArray().isEmpty());
        const QJsonObject table = study["tables"].toArray().first().toObject();
        const QJsonArray columns = table["columns"].toArray();
        QCOMPARE(table["rows"].toArray().first().toObject().size(), columns.size());
        QVERIFY(study["found"].isNull());
        QCOMPARE(folder_->files(), (QStringList{"a.csv", "a.h5"}));
    }
    /// Findings come first, then tables with their units.
    void text()
    {
        const Outcome o = folder_->touchdown(QStringList{"study", "hysteresis", "fig10a", "--progress"} + quick_);
        QCOMPARE(o.code, 0);
        QVERIFY2(o.out.contains("status                completed"), o.out);
        QVERIFY2(o.out.contains(" [nm]"), o.out);
        QVERIFY2(o.err.contains(" %"), o.err);
    }
    void aFile()
    {
        folder_->put("a.toml", "kind = \"hysteresis\"\ntitle = \"Mine\"\ncase = \"fig10a\"\nsteps = 1\nhold = \"20 "
                               "us\"\nequilibria = false\n");
        const Outcome o = folder_->touchdown({"study", "hysteresis", "a.toml", "--json", "--jobs", "2"});
        QCOMPARE(o.code, 0);
        QVERIFY(!o.json()["title"].toString().isEmpty());
    }
    /// What --template prints is a study of that case.
    void asTemplate()
    {
        const Outcome o =
            folder_->touchdown({"study", "hysteresis", "--template", "fig10a", "--set", "run.duration=1 ms"});
        QCOMPARE(o.code, 0);
        QCOMPARE(o.err, QByteArray());
        const StudyPlan plan = parseStudy("hysteresis", o.out.toStdString(), "a.toml", {});
        QVERIFY2(plan.valid(), o.out);
        QCOMPARE(plan.start.name, std::string("fig10a"));
        QCOMPARE(plan.start.value.run.duration, 1e-3);
    }
    /// Of a study it prints the study.
    void asTemplateOfAStudy()
    {
        const Outcome sample = folder_->touchdown({"study", "hysteresis", "hysteresis_take_off", "--template"});
        QCOMPARE(sample.code, 0);
        QVERIFY2(sample.out.contains("case = \"fig13a\"\n"), sample.out);
        folder_->put("a.toml", "case = \"fig10a\" # mine\nsteps = 3\n");
        const Outcome file = folder_->touchdown({"study", "hysteresis", "a.toml", "--template"});
        QCOMPARE(file.out, QByteArray("case = \"fig10a\" # mine\nsteps = 3\n"));
        const Outcome design = folder_->touchdown({"study", "design", "film_fig4_pico", "--template"});
        QCOMPARE(design.code, 0);
        QVERIFY2(design.out.contains("kind = \"design\"\n"), design.out);
    }
    void optionsOfTables()
    {
        const Outcome o = folder_->touchdown({"study", "work-precision", "fig10a", "--option", "ensemble.starts=1"});
        QCOMPARE(o.code, 2);
        QCOMPARE(o.err, QByteArray("--option: ensemble.starts: must be a whole number from 2 to 100000\n"));
    }
    /// No line is wider than what shows it; rows beyond 40, and columns for which there is no room, are named. 44 runs:
    /// there and back over 22 values.
    void tablesFit()
    {
        const QStringList arguments{"study",    "hysteresis", "fig10a",          "--option",
                                    "steps=21", "hold=2 us",  "equilibria=false"};
        for (const int width : {40, 72, 200}) {
            const Outcome o = folder_->touchdown(arguments, {QString("COLUMNS=%1").arg(width)});
            QCOMPARE(o.code, 0);
            const QByteArray table = o.out.mid(o.out.indexOf("\nsteps:\n"));
            QVERIFY2(table.contains("… 44 rows; all with --csv\n"), table);
            QCOMPARE(table.contains("left out: "), width == 40);
            for (const QString& line : QString::fromUtf8(table).split('\n'))
                QVERIFY2(line.size() <= width, qPrintable(line));
            QCOMPARE(table.contains("spacing_min [nm]"), width != 72); // there its heading takes two lines
        }
    }
    /// Ctrl + C: what was found until then is printed and written.
    void stopped()
    {
        folder_->put("a.toml", "case = \"fig10a\"\nsteps = 400\nhold = \"100 ms\"\n");
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.start(TOUCHDOWN_COMMAND, {"study", "hysteresis", "a.toml", "--json", "--out", "a.h5", "--progress"});
        process.setReadChannel(QProcess::StandardError);
        QVERIFY(process.waitForReadyRead(20000)); // it is under way
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(20000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 1);
        const QJsonObject study = QJsonDocument::fromJson(process.readAllStandardOutput()).object();
        QCOMPARE(study["status"].toString(), QString("cancelled"));
        QVERIFY(folder_->files().contains("a.h5"));
    }

    /// kill -9: what was found until then is in the file, and nothing is beside it.
    void killed()
    {
        folder_->put("a.toml", "case = \"fig10a\"\nsteps = 400\nhold = \"20 ms\"\nequilibria = false\n");
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.start(TOUCHDOWN_COMMAND, {"study", "hysteresis", "a.toml", "--out", "a.h5", "--csv", "a.csv"});
        const std::string file = folder_->path("a.h5").toStdString();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder_->path("a.h5")), 20000);
        QCOMPARE(readStudy(file).report.status, StudyStatus::Interrupted);
        QTRY_VERIFY_WITH_TIMEOUT(!readStudy(file).report.tables.empty(), 60000);
        process.kill();
        QVERIFY(process.waitForFinished(20000));
        const StoredStudy stored = readStudy(file);
        QCOMPARE(stored.problem, std::string());
        QCOMPARE(stored.report.status, StudyStatus::Interrupted);
        QVERIFY(!stored.report.tables.front().rows.empty());
        QVERIFY(stored.studyText.find("steps = 400") != std::string::npos);
        const QStringList next{"study", "hysteresis", "fig10a", "--out", "b.h5"};
        QCOMPARE(folder_->touchdown(next + quick_).code, 0);
        QCOMPARE(folder_->files(), (QStringList{"a.h5", "a.toml", "b.h5"}));
    }

    /// A file that names its kind needs no word, and one that a study wrote goes on as it is.
    void aFileThatNamesItsKind()
    {
        folder_->put("a.toml", sweep_);
        const Outcome o = folder_->touchdown({"study", "a.toml", "--out", "a.h5", "--csv", "a.csv"});
        QCOMPARE(o.code, 0);
        const Outcome again = folder_->touchdown({"study", "a.h5", "--out", "a.h5", "--csv", "b.csv", "--resume"});
        QVERIFY2(again.err.contains("30 of 30 items were there already"), again.err);
        QCOMPARE(read("b.csv"), read("a.csv"));
    }
    /// Parts on several computers give what one run gives.
    void partsAndJoin()
    {
        folder_->put("a.toml", sweep_);
        QCOMPARE(folder_->touchdown({"study", "a.toml", "--out", "a.h5", "--csv", "a.csv"}).code, 0);
        QStringList parts;
        for (const char* part : {"1", "2", "3"}) {
            parts << QString("p%1.h5").arg(part);
            const Outcome o = folder_->touchdown(
                {"study", "a.toml", "--part", QString("%1/3").arg(part), "--out", parts.last(), "--jobs", part});
            QCOMPARE(o.code, 0);
        }
        const Outcome joined =
            folder_->touchdown(QStringList{"study", "--join"} + parts + QStringList{"--out", "b.h5", "--csv", "b.csv"});
        QVERIFY2(joined.code == 0, joined.err);
        QCOMPARE(read("b.csv"), read("a.csv"));
        const StudyReport whole = readStudy(folder_->path("a.h5").toStdString()).report,
                          all = readStudy(folder_->path("b.h5").toStdString()).report;
        QCOMPARE(all.findings, whole.findings);
        QVERIFY(all.tables[0].rows == whole.tables[0].rows);
        const Outcome missing = folder_->touchdown({"study", "--join", "p1.h5", "p3.h5", "--out", "c.h5"});
        QCOMPARE(missing.code, 1);
        QVERIFY2(missing.err.contains("10 items of 30 have no row in these files"), missing.err);
    }
    /// With keep = "all" each row names a results file that the command `run` would write, in parts, too.
    void keepsWholeRuns()
    {
        const QByteArray few = QByteArray(sweep_).replace("count = 6", "count = 2").replace("count = 5", "count = 2");
        folder_->put("rows.toml", few);
        folder_->put("a.toml",
                     QByteArray(few).replace("[[axis]]\nkey = \"initial", "keep = \"all\"\n[[axis]]\nkey = \"initial"));
        QCOMPARE(folder_->touchdown({"study", "rows.toml", "--csv", "rows.csv"}).code, 0);
        QVERIFY(!QFile::exists(folder_->path("runs")));
        const Outcome without = folder_->touchdown({"study", "a.toml", "--csv", "a.csv"});
        QCOMPARE(without.code, 2);
        QVERIFY2(without.err.contains("--out: is needed"), without.err);
        for (const char* part : {"1", "2"})
            QCOMPARE(folder_
                         ->touchdown({"study", "a.toml", "--part", QString("%1/2").arg(part), "--out",
                                      QString("p%1.h5").arg(part)})
                         .code,
                     0);
        QCOMPARE(folder_->touchdown({"study", "--join", "p1.h5", "p2.h5", "--out", "a.h5"}).code, 0);
        const StudyReport report = readStudy(folder_->path("a.h5").toStdString()).report;
        const StudyTable& table = report.tables.front();
        const StudyReport bare = openStudy("sweep", folder_->path("rows.toml").toStdString()).perform(1, {});
        QCOMPARE(table.rows.size(), std::size_t(4));
        for (std::size_t i = 0; i < 4; ++i) {
            const std::string name = test::word(table, i, "file");
            const QString file = folder_->path("runs/" + QString::fromStdString(name));
            QVERIFY2(QFile::exists(file), qPrintable(file));
            const StoredRun run = readResults(file.toStdString());
            QVERIFY2(run.problem.empty(), run.problem.c_str());
            QCOMPARE(run.status, std::string("completed"));
            const auto column = std::size_t(findQuantity(run.quantities, "flying_height"));
            QCOMPARE(run.samples.columns[column].back(), test::number(table, i, "flying_height_end"));
            QCOMPARE(test::number(bare.tables.front(), i, "flying_height_end"),
                     test::number(table, i, "flying_height_end"));
        }
    }
    /// A run whose file is gone is made again, the others are not.
    void aKeptRunThatIsGone()
    {
        folder_->put("a.toml", QByteArray(sweep_)
                                   .replace("count = 6", "count = 2")
                                   .replace("count = 5", "count = 1")
                                   .replace("[[axis]]\nkey = \"initial", "keep = \"all\"\n[[axis]]\nkey = \"initial"));
        const QStringList command{"study", "a.toml", "--out", "a.h5", "--resume"};
        QCOMPARE(folder_->touchdown(command).code, 0);
        QVERIFY(folder_->touchdown(command).err.contains("2 of 2 items were there already"));
        const StudyTable table = readStudy(folder_->path("a.h5").toStdString()).report.tables.front();
        const QString file = folder_->path("runs/" + QString::fromStdString(test::word(table, 0, "file")));
        QVERIFY(QFile::remove(file));
        const Outcome o = folder_->touchdown(command);
        QVERIFY2(o.err.contains("1 of 2 items were there already"), o.err);
        QVERIFY(QFile::exists(file));
    }
    /// Killed at any moment and continued: the same table, and nothing is solved twice.
    void killedAndContinued()
    {
        folder_->put("a.toml", sweep_);
        QCOMPARE(folder_->touchdown({"study", "a.toml", "--csv", "a.csv"}).code, 0);
        std::mt19937 random(1);
        int kills = 0;
        for (int trial = 0; trial < 4; ++trial) {
            const QString out = QString("k%1.h5").arg(trial);
            const QStringList arguments{"study", "a.toml", "--out", out, "--csv", "k.csv", "--resume", "--jobs", "2"};
            for (int rows = 0; rows < 20;) {
                QProcess process;
                process.setWorkingDirectory(folder_->path());
                process.start(TOUCHDOWN_COMMAND, arguments);
                const int wanted = rows + 1 + int(random() % 8);
                QTRY_VERIFY_WITH_TIMEOUT(
                    (rows = linesOf(out + ".items")) > wanted || process.state() == QProcess::NotRunning, 60000);
                process.kill();
                QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished(20000));
                ++kills;
                if (!QFile::exists(folder_->path(out + ".items"))) break;
            }
            const int before = linesOf(out + ".items") - 1;
            const Outcome o = folder_->touchdown(arguments);
            QCOMPARE(o.code, 0);
            if (before >= 0)
                QVERIFY2(o.err.contains(QByteArray::number(before) + " of 30 items were there already"), o.err);
            QCOMPARE(read("k.csv"), read("a.csv"));
            QVERIFY(!QFile::exists(folder_->path(out + ".items")));
        }
        QVERIFY(kills >= 4);
    }
    /// Rows of an interrupted study are not thrown away by a command that does not ask for them.
    void nobodysWorkIsLost()
    {
        folder_->put("a.toml", sweep_);
        folder_->put("a.h5.items", "touchdown-items 1\nkey\t1\t" + checkOf("key\t1") + "\n");
        const Outcome o = folder_->touchdown({"study", "a.toml", "--out", "a.h5"});
        QCOMPARE(o.code, 2);
        QVERIFY2(o.err.contains("holds 1 row of a study that was interrupted; go on with --resume"), o.err);
        QCOMPARE(folder_->touchdown({"study", "a.toml", "--out", "a.h5", "--resume"}).code, 0);
    }
    /// Rows that are in the study's file when it is continued stay when that is killed, and rows that this part or this
    /// axis does not use stay, too.
    void rowsOfTheFileStay()
    {
        folder_->put("a.toml", sweep_);
        const QStringList first{"study", "a.toml", "--out", "a.h5", "--part", "1/2"};
        QCOMPARE(folder_->touchdown(first).code, 0);
        const Outcome second = folder_->touchdown({"study", "a.toml", "--out", "a.h5", "--part", "2/2", "--resume"});
        QVERIFY2(second.err.contains("0 of 15 items were there already"), second.err);
        const Outcome all = folder_->touchdown({"study", "a.toml", "--out", "a.h5", "--resume"});
        QVERIFY2(all.err.contains("30 of 30 items were there already"), all.err);

        folder_->put("b.toml", QByteArray(sweep_).replace("count = 6", "count = 5000"));
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.start(TOUCHDOWN_COMMAND, {"study", "b.toml", "--out", "a.h5", "--resume"});
        QTRY_VERIFY_WITH_TIMEOUT(linesOf("a.h5.items") > 40, 60000);
        process.kill();
        QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished(20000));
        const Outcome last = folder_->touchdown({"study", "a.toml", "--out", "a.h5", "--resume"});
        QVERIFY2(last.err.contains("30 of 30 items were there already"), last.err);
    }
    /// A study that was stopped is not replaced by a command that does not go on with it.
    void aStoppedStudyStays()
    {
        folder_->put("a.toml", QByteArray(sweep_).replace("count = 6", "count = 5000"));
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.start(TOUCHDOWN_COMMAND, {"study", "a.toml", "--out", "a.h5"});
        QTRY_VERIFY_WITH_TIMEOUT(linesOf("a.h5.items") > 10, 60000);
        process.terminate();
        QVERIFY(process.waitForFinished(20000));
        const Outcome o = folder_->touchdown({"study", "a.toml", "--out", "a.h5"});
        QCOMPARE(o.code, 2);
        QVERIFY2(o.err.contains("of a study that ended early; go on with --resume"), o.err);
    }
    /// An axis with one more value solves what is new alone.
    void aChangedAxis()
    {
        folder_->put("a.toml", sweep_);
        QCOMPARE(folder_->touchdown({"study", "a.toml", "--out", "a.h5"}).code, 0);
        folder_->put("a.toml", QByteArray(sweep_).replace("count = 6", "count = 11"));
        const Outcome o = folder_->touchdown({"study", "a.toml", "--out", "a.h5", "--resume"});
        QCOMPARE(o.code, 0);
        QVERIFY2(o.err.contains("30 of 55 items were there already"), o.err);
    }

    void refuses_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const QStringList& arguments, const QString& says) {
            QTest::newRow(name) << arguments << says;
        };
        row("no study", {"study"}, "study: a kind (" + test::studyKindNames());
        row("a study that is not there", {"study", "swep", "contact_hertz"}, "did you mean sweep?");
        row("no file", {"study", "hysteresis"}, "hysteresis: FILE");
        row("a file that is not there", {"study", "hysteresis", "b.toml"}, "b.toml: is neither a file, ");
        row("another kind", {"study", "stability", "a.toml"}, "a.toml:1: kind: is \"hysteresis\", not \"stability\"");
        row("a design by name", {"study", "hysteresis", "film_fig1_micro_pa"}, "film_fig1_micro_pa: ");
        row("a directory", {"study", "hysteresis", "."}, ".: ");
        row("a part of no list", {"study", "hysteresis", "fig10a", "--part", "1/2", "--out", "b.h5"},
            "--part: is for a study that is a list of items");
        row("a part beyond", {"study", "sweep", "fig10a", "--part", "3/2", "--out", "b.h5"}, "--part: must be K/N");
        row("no part", {"study", "sweep", "fig10a", "--part", "1", "--out", "b.h5"}, "--part: must be K/N");
        row("a part without a file", {"study", "sweep", "fig10a", "--part", "1/2"}, "--part: needs --out FILE.h5");
        row("resumed without a file", {"study", "sweep", "fig10a", "--resume"}, "--resume: needs --out FILE.h5");
        row("joined from nothing", {"study", "sweep", "fig10a", "--join", "no.h5", "--out", "b.h5"}, "--join: no.h5");
        row("joined from a part of a part",
            {"study", "sweep", "fig10a", "--join", "no.h5", "--out", "b.h5", "--part", "1/2"}, "--join: stands alone");
        row("a bad setting", {"study", "hysteresis", "fig10a", "--set", "run.duratio=1"},
            "--set: run.duratio: unknown key; did you mean run.duration?");
        row("a bad option", {"study", "hysteresis", "fig10a", "--option", "step=1"},
            "--option: step: unknown key; did you mean steps?");
        row("only an option", {"study", "hysteresis", "--option", "steps=1"}, "hysteresis: FILE");
        row("a bad target", {"study", "hysteresis", "fig10a", "--out", "no/such.h5"}, "no/such.h5");
        row("a directory as target", {"study", "hysteresis", "fig10a", "--csv", "."}, "--csv: ");
        row("the study itself", {"study", "hysteresis", "a.toml", "--csv", "a.toml"},
            "--csv: a.toml is read by this command");
        row("one file for two", {"study", "hysteresis", "fig10a", "--out", "a", "--csv", "a"},
            "--out and --csv: both name a");
        row("no jobs", {"study", "hysteresis", "fig10a", "--jobs", "0"}, "--jobs");
        row("an option without a value", {"study", "hysteresis", "fig10a", "--option"}, "--option");
        row("a template of nothing", {"study", "hysteresis", "--template", "fig10q"}, "did you mean");
        row("a template of springs to advise on", {"advise", "fig10a", "--template"},
            "fig10a: case: must be of model \"film\"");
        row("a template with an option", {"study", "hysteresis", "fig10a", "--template", "--option", "steps=3"},
            "--option: has no effect");
        row("a template of a study with a setting",
            {"study", "hysteresis", "a.toml", "--template", "--set", "run.duration=1 ms"}, "--set: has no effect");
        row("two tolerances", {"advise", "film_pico", "--tolerance", "1%", "--option", "tolerance=2%"},
            "advise: --tolerance 1% and --option tolerance=2% are one value; give it once");
        row("the case before the kind", {"study", "fig10a", "hysteresis"},
            "\"fig10a\" is no kind of study; did you mean `touchdown study hysteresis fig10a`?");
        row("a misspelt kind", {"study", "hysteresys", "fig10a"},
            "\"hysteresys\" is no kind of study; did you mean hysteresis?");
        row("no kind at all", {"study", "bogus", "fig10a"}, "\"bogus\" is no kind of study: allowed is one of ");
        row("a misspelt option", {"study", "hysteresis", "fig10a", "--option", "steps=3", "--jsom"},
            "hysteresis: --jsom is no option; did you mean --json?");
        row("two studies", {"study", "hysteresis", "fig10a", "--json", "fig10b"},
            "hysteresis: \"fig10b\" was not expected");
        row("a pad", {"study", "stability", "contact_hertz"}, "contact_hertz: case: ");
        row("a case to design", {"study", "design", "fig10a"},
            "fig10a: case: a design study takes a case of model \"film\"");
        row("a list of tables as option", {"study", "hysteresis", "fig10a", "--option", "method.name=a"},
            "--option: method");
        row("advice on a slider that is held", {"advise", "film_plane"},
            "film_plane: case: holds the slider at one attitude (steady.fixed_attitude = true)");
        row("advice on springs", {"advise", "fig10a"}, "fig10a: case: must be of model \"film\"");
        row("advice without a case", {"advise", "--tolerance", "1%"}, "advise: FILE");
        row("a bad tolerance", {"advise", "film_pico", "--tolerance", "few"}, "--option: tolerance: ");
    }
    void refuses()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, says);
        folder_->put("a.toml", "kind = \"hysteresis\"\ncase = \"fig10a\"\n");
        const Outcome o = folder_->touchdown(arguments);
        QCOMPARE(o.code, 2);
        QVERIFY2(isRefusal(o, arguments), o.out);
        QVERIFY2(o.err.contains(says.toUtf8()), o.err);
        QCOMPARE(folder_->files(), QStringList{"a.toml"});
        QVERIFY2(o.errorLines().size() == 1 || o.err.endsWith("Run with --help for more information.\n"), o.err);
    }
    void allProblemsAtOnce()
    {
        const Outcome o =
            folder_->touchdown({"study", "hysteresis", "fig10a", "--option", "step=1", "hold=x", "--csv", "."});
        QCOMPARE(o.code, 2);
        QCOMPARE(o.errorLines().size(), 3);
    }
    /// A study that checks something says by a key whether it holds.
    void verdict_data()
    {
        QTest::addColumn<QByteArrayList>("ends");
        QTest::addColumn<QString>("verdict");
        QTest::newRow("holds") << QByteArrayList{"flying"} << "holds";
        QTest::newRow("partly") << QByteArrayList{"flying", "contact"} << "holds partly";
        QTest::newRow("not") << QByteArrayList{"contact"} << "does not hold";
    }
    void verdict()
    {
        QFETCH(QByteArrayList, ends);
        QFETCH(QString, verdict);
        QByteArray study("kind = \"statements\"\ncase = \"fig10a\"\n");
        for (const QByteArray& end : ends)
            study += "[[statement]]\nfigure = \"1\"\nquote = \"q\"\nend = [\"" + end + "\"]\n";
        folder_->put("a.toml", study);
        const Outcome o = folder_->touchdown({"study", "statements", "a.toml", "--json"});
        QCOMPARE(o.code, 0);
        QCOMPARE(o.json()["verdict"].toString(), verdict);
        const Outcome plain = folder_->touchdown({"study", "statements", "a.toml"});
        QVERIFY2(plain.out.contains("verdict               " + verdict.toUtf8() + "\n"), plain.out);
    }
    void othersHaveNoVerdict()
    {
        const Outcome o = folder_->touchdown(QStringList{"study", "hysteresis", "fig10a", "--json"} + quick_);
        QVERIFY(o.json().contains("verdict") && o.json()["verdict"].isNull());
    }

private:
    QByteArray read(const QString& name) const
    {
        QFile file(folder_->path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    int linesOf(const QString& name) const { return int(read(name).count('\n')); }
    static QByteArray checkOf(const QByteArray& text)
    {
        std::uint64_t hash = 0xcbf29ce484222325ULL;
        for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
        return QByteArray::number(qulonglong(hash), 16).rightJustified(16, '0');
    }
    const QByteArray sweep_ =
        "study = \"sweep\"\ncase = \"fig10a\"\nset = { \"run.duration\" = \"100 us\" }\n[[axis]]\nkey = "
        "\"initial.flying_height\"\nfrom = \"5 nm\"\nto = \"30 nm\"\ncount = 6\n[[axis]]\nkey = "
        "\"ono_yamane.meniscus_force\"\nfrom = \"1 mN\"\nto = \"9 mN\"\ncount = 5\n[[reading]]\nquantity = "
        "\"flying_height\"\n[[reading]]\nquantity = \"motion\"\n";
    const QStringList quick_{"--option", "steps=2", "hold=20 us", "equilibria=false"};
    std::unique_ptr<CommandFolder> folder_;
};

TOUCHDOWN_TEST(TestStudyCommand)

} // namespace test_study_command

#include "test_study_command.moc"
