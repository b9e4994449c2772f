// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>

#include "core/studies/study_plan.h"
#include "tests/support/command_process.h"

using namespace touchdown;

class TestStudyCommand : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }

    void json()
    {
        const Outcome o = folder_->touchdown(QStringList{"study", "hysteresis", "fig10a", "--json", "--out", "a.h5", "--csv", "a.csv"} + quick_);
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
        folder_->put("a.toml", "kind = \"hysteresis\"\ntitle = \"Mine\"\ncase = \"fig10a\"\nsteps = 1\nhold = \"20 us\"\nequilibria = false\n");
        const Outcome o = folder_->touchdown({"study", "hysteresis", "a.toml", "--json", "--jobs", "2"});
        QCOMPARE(o.code, 0);
        QVERIFY(!o.json()["title"].toString().isEmpty());
    }
    /// What --template prints is a study of that case.
    void asTemplate()
    {
        const Outcome o = folder_->touchdown({"study", "hysteresis", "--template", "fig10a", "--set", "run.duration=1 ms"});
        QCOMPARE(o.code, 0);
        QCOMPARE(o.err, QByteArray());
        const StudyPlan plan = parseStudy("hysteresis", o.out.toStdString(), "a.toml", {});
        QVERIFY2(plan.valid(), o.out);
        QCOMPARE(plan.start.name, std::string("fig10a"));
        QCOMPARE(plan.start.value.run.duration, 1e-3);
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

    void refuses_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const QStringList& arguments, const char* says) { QTest::newRow(name) << arguments << says; };
        row("no study", {"study"}, "study: convergence, design, work-precision");
        row("a study that is not there", {"study", "sweep", "contact_hertz"}, "sweep");
        row("no file", {"study", "hysteresis"}, "hysteresis: FILE");
        row("a file that is not there", {"study", "hysteresis", "b.toml"}, "b.toml: is neither a file, ");
        row("another kind", {"study", "stability", "a.toml"}, "a.toml:1: kind: is \"hysteresis\", not \"stability\"");
        row("a design by name", {"study", "hysteresis", "film_fig1_micro_pa"}, "film_fig1_micro_pa: ");
        row("a directory", {"study", "hysteresis", "."}, ".: ");
        row("a bad setting", {"study", "hysteresis", "fig10a", "--set", "run.duratio=1"}, "--set: run.duratio: unknown key; did you mean run.duration?");
        row("a bad option", {"study", "hysteresis", "fig10a", "--option", "step=1"}, "--option: step: unknown key; did you mean steps?");
        row("only an option", {"study", "hysteresis", "--option", "steps=1"}, "hysteresis: FILE");
        row("a bad target", {"study", "hysteresis", "fig10a", "--out", "no/such.h5"}, "no/such.h5");
        row("a directory as target", {"study", "hysteresis", "fig10a", "--csv", "."}, "--csv: ");
        row("the study itself", {"study", "hysteresis", "a.toml", "--csv", "a.toml"}, "--csv: a.toml is the case file itself");
        row("one file for two", {"study", "hysteresis", "fig10a", "--out", "a", "--csv", "a"}, "--out and --csv: both name a");
        row("no jobs", {"study", "hysteresis", "fig10a", "--jobs", "0"}, "--jobs");
        row("an option without a value", {"study", "hysteresis", "fig10a", "--option"}, "--option");
        row("a template of nothing", {"study", "hysteresis", "--template", "fig10q"}, "did you mean");
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
        QCOMPARE(o.out, QByteArray());
        QVERIFY2(o.err.contains(says.toUtf8()), o.err);
        QCOMPARE(folder_->files(), QStringList{"a.toml"});
    }
    void allProblemsAtOnce()
    {
        const Outcome o = folder_->touchdown({"study", "hysteresis", "fig10a", "--option", "step=1", "hold=x", "--csv", "."});
        QCOMPARE(o.code, 2);
        QCOMPARE(o.errorLines().size(), 3);
    }

private:
    const QStringList quick_{"--option", "steps=2", "hold=20 us", "equilibria=false"};
    std::unique_ptr<CommandFolder> folder_;
};

QTEST_GUILESS_MAIN(TestStudyCommand)
#include "test_study_command.moc"
