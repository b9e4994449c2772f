// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a script gets that reads --json, when its input or its arguments are wrong.
#include <QtTest>
#include <memory>

#include <sys/resource.h>

#include "core/results/results_reader.h"
#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_refusal {

class TestRefusal : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }

    void isOneObject_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("key"); // of the first problem
        const auto row = [](const char* name, const QStringList& arguments, const char* key) {
            QTest::newRow(name) << arguments << QString::fromLatin1(key);
        };
        row("run, no such case", {"run", "none.toml"}, "");
        row("run, a bad value", {"run", "bad.toml"}, "slider.mass");
        row("run, a bad setting", {"run", "fig10a", "--set", "run.steep=1"}, "run.steep");
        row("run, a bad target", {"run", "fig10a", "--out", "none/a.h5"}, "--out");
        row("steady, springs", {"steady", "fig10a"}, "model");
        row("steady, a bad target", {"steady", "film_pico", "--out", "none/a.h5"}, "--out");
        row("modes, springs", {"modes", "fig10a"}, "model");
        row("study, a bad key", {"study", "hysteresis", "study.toml"}, "steps");
        row("study, a bad target", {"study", "hysteresis", "fig10a", "--csv", "none/a.csv"}, "--csv");
        row("study, a template in vain", {"study", "hysteresis", "fig10a", "--template", "--option", "steps=3"},
            "--option");
        row("advise, springs", {"advise", "fig10a"}, "case");
        row("describe, no such key", {"describe", "springs.cutof"}, "springs.cutof");
        row("describe, no such kind", {"describe", "study.hystersis"}, "study.hystersis");
        row("an unknown option", {"run", "fig10a", "--fast"}, "");
        row("an unknown command", {"rum", "fig10a"}, "");
        row("a command without --json", {"convert", "fig10a"}, "");
        row("no case", {"run"}, "");
        row("two values of one key", {"advise", "film_pico", "--tolerance", "1%", "--option", "tolerance=2%"}, "");
    }
    void isOneObject()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, key);
        int number = 0;
        folder_->put("bad.toml", changedCase("mass", "mass = \"-1 mg\"", number));
        folder_->put("study.toml", "kind = \"hysteresis\"\ncase = \"fig10a\"\nsteps = 0\n");
        const Outcome plain = folder_->touchdown(arguments);
        QCOMPARE(plain.code, 2);
        QCOMPARE(plain.out, QByteArray());
        QVERIFY(!plain.err.isEmpty());

        const Outcome o = folder_->touchdown(arguments + QStringList{"--json"});
        QCOMPARE(o.code, 2);
        QVERIFY(!o.err.isEmpty());
        const QJsonObject json = o.json();
        QCOMPARE(json["status"].toString(), "wrong input");
        QVERIFY(!json["message"].toString().isEmpty());
        const QJsonObject problem = json["problems"].toArray().first().toObject();
        QVERIFY(!problem["message"].toString().isEmpty());
        QCOMPARE(problem["key"].toString(), key);
    }

    void placesEachProblem()
    {
        int number = 0;
        folder_->put("bad.toml", changedCase("mass", "mass = \"-1 mg\"\nwings = 2", number));
        const Outcome o = folder_->touchdown({"run", "bad.toml", "--csv", "none/a.csv", "--json"});
        const QJsonArray problems = o.json()["problems"].toArray();
        QCOMPARE(problems.size(), 3);
        QCOMPARE(problems[0].toObject()["file"].toString(), "bad.toml");
        QCOMPARE(problems[0].toObject()["line"].toInt(), number);
        QCOMPARE(problems[1].toObject()["key"].toString(), "slider.wings");
        QVERIFY(problems[2].toObject()["line"].isNull());
        QCOMPARE(o.errorLines().size(), 3);
    }

    /// A person gets the first ones, a script all.
    void aFloodIsCounted()
    {
        QByteArray file;
        for (int i = 0; i < 500; ++i) file += "[table" + QByteArray::number(i) + "]\n";
        folder_->put("flood.toml", file);
        for (const char* command : {"run", "validate"}) {
            const Outcome o = folder_->touchdown({command, "flood.toml", "--json"});
            QCOMPARE(o.code, 2);
            QCOMPARE(o.errorLines().size(), 21);
            QVERIFY2(o.errorLines()[19].contains("table19"), o.err);
            QCOMPARE(o.errorLines()[20], QByteArray("and 480 further problems"));
            QCOMPARE(o.json()["problems"].toArray().size(), 500);
        }
    }

    void outOfMemory_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const QStringList large{"film_pico", "--set", "film.nodes=1025,1025"};
        QTest::newRow("run") << QStringList{"run"} + large + QStringList{"--out", "a.h5"};
        QTest::newRow("steady") << QStringList{"steady"} + large;
        QTest::newRow("modes") << QStringList{"modes"} + large;
        QTest::newRow("advise") << QStringList{"advise"} + large;
        QTest::newRow("several at a time") << QStringList{"study",     "convergence",    "film_pico", "--option",
                                                          "grids=513", "reference=1025", "--jobs",    "2"};
    }
    void outOfMemory()
    {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("the operator new of a sanitizer ends the program instead of throwing");
#endif
        QFETCH(const QStringList, arguments);
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.setChildProcessModifier([] {
            const rlimit limit{250'000'000, 250'000'000}; // the film needs more, the program itself less
            ::setrlimit(RLIMIT_AS, &limit);
        });
        process.start(TOUCHDOWN_COMMAND, arguments + QStringList{"--json"});
        const Outcome o = outcome(process);
        QCOMPARE(o.code, 1);
        QCOMPARE(o.json()["status"].toString(), QStringLiteral("failed"));
        const QString message = o.json()["message"].toString();
        QVERIFY2(message.contains("memory") && message.contains("film_pico") && message.contains("film.nodes"), o.out);
        QCOMPARE(o.errorLines().size(), 1);
        if (!arguments.contains("a.h5")) return;
        const StoredRun run = readResults(folder_->path("a.h5").toStdString());
        QCOMPARE(run.problem, std::string());
        QCOMPARE(run.status, std::string("failed"));
        QVERIFY(message.startsWith(QString::fromStdString(run.message)));
    }

    /// Not the name alone, which may be long and whose place is not known.
    void theCaseOfAStudyHasItsPlace()
    {
        folder_->put("study.toml", "kind = \"hysteresis\"\ncase = \"" + QByteArray(5000, 'x') + "\"\n");
        const Outcome o = folder_->touchdown({"study", "hysteresis", "study.toml"});
        QCOMPARE(o.code, 2);
        QVERIFY2(o.err.startsWith("study.toml:2: case: \"xxx"), o.err);
        QVERIFY2(o.err.size() < 200, o.err);
    }

    void helpIsNoRefusal()
    {
        const Outcome o = folder_->touchdown({"run", "--json", "--help"});
        QCOMPARE(o.code, 0);
        QVERIFY(!o.out.startsWith('{'));
    }

private:
    std::unique_ptr<CommandFolder> folder_;
};

TOUCHDOWN_TEST(TestRefusal)

} // namespace test_refusal

#include "test_refusal.moc"
