// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/engine/engine.h"

#include <algorithm>

#include <QtTest>

#include "core/studies/engine/shell.h"
#include "core/studies/study_plan.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_engine {

namespace fs = std::filesystem;

const std::string sweep =
    "study = \"sweep\"\ncase = \"fig10a\"\nset = { \"run.duration\" = \"20 us\" }\n[[axis]]\nkey = "
    "\"initial.flying_height\"\nfrom = \"5 nm\"\nto = \"30 nm\"\ncount = 12\n[[reading]]\nquantity = "
    "\"flying_height\"\n";

class TestEngine : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void wordsOfAShell()
    {
        for (const char* text : {"plain", "two words", "it's", "$HOME `x` \"y\" \\ ;"}) {
            const ShellAnswer answer = askShell("printf %s " + shellWord(text));
            QCOMPARE(answer.code, 0);
            QCOMPARE(answer.output, std::string(text));
        }
        QCOMPARE(askShell("exit 3").code, 3);
        QCOMPARE(askShell("echo no >&2").output, std::string("no\n"));
    }

    void endsWithWhatItStarted()
    {
        const std::string mark = file("mark");
        {
            ShellProcess process("sleep 60; touch " + shellWord(mark));
            QVERIFY(!process.ended().has_value());
        }
        QVERIFY(!fs::exists(mark));
        ShellProcess quick("exit 4");
        QTRY_VERIFY(quick.ended().has_value());
        QCOMPARE(*quick.ended(), 4);
    }

    /// Parts on this computer, and by a launcher: the table of one process.
    void partsJoin()
    {
        const StudyPlan plan = study();
        const StudyReport whole = plan.perform(2, {});
        for (const std::string submit : {"", "sh -c 'for k in {parts}; do {script} $k; done'"}) {
            EngineTask task = taskOf(submit.empty() ? EngineKind::Local : EngineKind::Command);
            task.submit = submit;
            const StudyReport report = performByEngine(plan, task, {}, [](const std::string&) {});
            QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
            QVERIFY(report.tables[0].rows == whole.tables[0].rows);
            QCOMPARE(report.findings, whole.findings);
            // All is there: nothing is solved again.
            fs::remove(task.folder / "part.sh");
            QVERIFY(performByEngine(plan, task, {}, [](const std::string&) {}).tables[0].rows == whole.tables[0].rows);
            fs::remove_all(task.folder);
        }
    }

    /// What ends before it is done is submitted again; what never makes progress is given up with its last words.
    void submitsAgain()
    {
        const StudyPlan plan = study();
        EngineTask task = taskOf(EngineKind::Command);
        const std::string once = file("once");
        task.submit = "sh -c 'for k in {parts}; do test $k = 2 && test ! -e " + once + " && touch " + once +
                      " && continue; {script} $k; done'";
        std::vector<std::string> told;
        const StudyReport report =
            performByEngine(plan, task, {}, [&](const std::string& text) { told.push_back(text); });
        QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
        QCOMPARE(told, std::vector<std::string>{"part 2 ended with 0 of 4 items; submitted again"});

        task = taskOf(EngineKind::Command);
        fs::remove_all(task.folder);
        task.submit = "sh -c 'echo the node is on fire' {script} {parts}";
        task.tries = 2;
        const StudyReport none = performByEngine(plan, task, {}, [](const std::string&) {});
        QCOMPARE(none.status, StudyStatus::Failed);
        QVERIFY2(none.message.find("ended 2 times without solving an item: the node is on fire") != std::string::npos,
                 none.message.c_str());
    }

    /// A Slurm of two scripts: it loses every second task once, and forgets its jobs.
    void slurm()
    {
        const StudyPlan plan = study();
        const StudyReport whole = plan.perform(2, {});
        put("sbatch",
            "#!/bin/bash\necho \"$@\" >> " + file("asked") + "\nn=$(cat " + file("count") +
                " 2>/dev/null || echo 0); n=$((n + 1)); echo $n > " + file("count") +
                "\nfor a in \"$@\"; do case $a in --array=*) list=${a#--array=};; esac; done\nfor k in $(for r in "
                "${list//,/ }; do seq ${r%-*} ${r#*-}; done); do if ((n > 1 || k % 2)); then bash \"${@: -1}\" $k; fi; "
                "done\necho $n\n");
        put("squeue", "#!/bin/bash\necho 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1\n");
        const QByteArray path = qgetenv("PATH");
        qputenv("PATH", QByteArray::fromStdString(folder_->path().toStdString()) + ":" + path);
        EngineTask task = taskOf(EngineKind::Slurm);
        task.options = "--time=1:00:00";
        std::vector<std::string> told;
        QCOMPARE(reasonAgainst(EngineKind::Slurm), std::string());
        const StudyReport report =
            performByEngine(plan, task, {}, [&](const std::string& text) { told.push_back(text); });
        qputenv("PATH", path);
        QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
        QVERIFY(report.tables[0].rows == whole.tables[0].rows);
        QCOMPARE(told, std::vector<std::string>{"part 2 ended with 0 of 4 items; submitted again"});
        QVERIFY2(read("asked").contains("--array=1-3 --time=1:00:00"), read("asked"));
        QVERIFY2(read("asked").contains("--array=2 --time=1:00:00"), read("asked"));
    }

    /// A part whose file has other rows is told, and not solved in secret by this process.
    void aFileOfAnotherPart()
    {
        const EngineTask task = taskOf(EngineKind::Local);
        const auto perform = [&] { return performByEngine(study(), task, {}, [](const std::string&) {}); };
        QCOMPARE(perform().status, StudyStatus::Completed);
        fs::copy_file(task.folder / "part_1.h5", task.folder / "part_2.h5", fs::copy_options::overwrite_existing);
        const StudyReport report = perform();
        QCOMPARE(report.status, StudyStatus::Failed);
        QVERIFY2(report.message.starts_with("4 items of 12 have no row in these files: 2, 5, 8, 11; a file of a part"),
                 report.message.c_str());
        fs::remove(task.folder / "part_2.h5");
        QCOMPARE(perform().status, StudyStatus::Completed);
    }

    void anotherStudyStays()
    {
        const EngineTask task = taskOf(EngineKind::Local);
        QCOMPARE(performByEngine(study(), task, {}, [](const std::string&) {}).status, StudyStatus::Completed);
        const StudyPlan other = parseStudy("sweep", sweep, "a.toml", {}, nullptr, {"run.tolerance=1e-6"});
        const StudyReport refused = performByEngine(other, task, {}, [](const std::string&) {});
        QVERIFY2(refused.message.find("holds another study") != std::string::npos, refused.message.c_str());
        EngineTask more = task;
        more.parts = 4;
        const StudyReport parts = performByEngine(study(), more, {}, [](const std::string&) {});
        QVERIFY2(parts.message.find("another number of parts") != std::string::npos, parts.message.c_str());
    }

private:
    static StudyPlan study() { return parseStudy("sweep", sweep, "a.toml", {}); }
    EngineTask taskOf(EngineKind kind) const
    {
        EngineTask task;
        task.kind = kind;
        task.folder = file("parts {parts} of it's");
        task.program = TOUCHDOWN_COMMAND;
        task.parts = 3;
        return task;
    }
    std::string file(const std::string& name) const
    {
        return folder_->filePath(QString::fromStdString(name)).toStdString();
    }
    void put(const std::string& name, const std::string& text) const
    {
        QFile out(QString::fromStdString(file(name)));
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(QByteArray::fromStdString(text));
        out.setPermissions(out.permissions() | QFileDevice::ExeOwner);
    }
    QByteArray read(const std::string& name) const
    {
        QFile in(QString::fromStdString(file(name)));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    std::unique_ptr<QTemporaryDir> folder_;
};

TOUCHDOWN_TEST(TestEngine)

} // namespace test_engine

#include "test_engine.moc"
