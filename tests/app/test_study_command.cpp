// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>

#include "core/studies/study/study_file_reader.h"
#include "core/studies/study_plan.h"
#include "tests/support/command_process.h"
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

    void refuses_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const QStringList& arguments, const char* says) {
            QTest::newRow(name) << arguments << says;
        };
        row("no study", {"study"},
            "study: a kind (work-precision, stability, hysteresis, cycles, response, advise, design, convergence");
        row("a study that is not there", {"study", "sweep", "contact_hertz"}, "sweep");
        row("no file", {"study", "hysteresis"}, "hysteresis: FILE");
        row("a file that is not there", {"study", "hysteresis", "b.toml"}, "b.toml: is neither a file, ");
        row("another kind", {"study", "stability", "a.toml"}, "a.toml:1: kind: is \"hysteresis\", not \"stability\"");
        row("a design by name", {"study", "hysteresis", "film_fig1_micro_pa"}, "film_fig1_micro_pa: ");
        row("a directory", {"study", "hysteresis", "."}, ".: ");
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
        row("a study without its kind", {"study", "a.toml", "--json"},
            "did you mean `touchdown study hysteresis a.toml --json`?");
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
    const QStringList quick_{"--option", "steps=2", "hold=20 us", "equilibria=false"};
    std::unique_ptr<CommandFolder> folder_;
};

TOUCHDOWN_TEST(TestStudyCommand)

} // namespace test_study_command

#include "test_study_command.moc"
