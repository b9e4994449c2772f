// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "core/case/parameters.h"
#include "tests/support/command_process.h"
#include "tests/support/study_kinds.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_command_line {

class TestCommandLine : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }
    void helpAndVersion_data();
    void helpAndVersion();
    void wrongArguments_data();
    void wrongArguments();
    void settingsInAnyPlace_data();
    void settingsInAnyPlace();
    void validate();
    void validateStudies();
    void list();
    void listLesson();
    void listDemonstrations();
    void describeAll();
    void describeOne();
    void describeTheSurface();
    void describeUnknown();
    void describeStudies();

private:
    std::unique_ptr<CommandFolder> folder_;
};

void TestCommandLine::helpAndVersion_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("help") << QStringList{"--help"} << QByteArray("Exit codes:");
    QTest::newRow("version") << QStringList{"--version"} << QByteArray("touchdown " TOUCHDOWN_VERSION "\n");
    QTest::newRow("help of run") << QStringList{"run", "--help"} << QByteArray("--set KEY=VALUE");
    QTest::newRow("help of validate") << QStringList{"validate", "--help"} << QByteArray("CASE");
    QTest::newRow("help of list") << QStringList{"list", "--help"} << QByteArray("--json");
    QTest::newRow("help of list, the lesson") << QStringList{"list", "--help"} << QByteArray("lesson");
    QTest::newRow("a command asked for help") << QStringList{"help", "run"} << QByteArray("--set KEY=VALUE");
    QTest::newRow("help as a command") << QStringList{"help"} << QByteArray("Exit codes:");
    QTest::newRow("help of describe") << QStringList{"describe", "--help"} << QByteArray("KEY");
}

void TestCommandLine::helpAndVersion()
{
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, says);
    const Outcome o = folder_->touchdown(arguments);
    QCOMPARE(o.code, 0);
    QVERIFY2(o.out.contains(says), o.out);
    QCOMPARE(o.err, QByteArray());
}

void TestCommandLine::wrongArguments_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("none") << QStringList{} << QByteArray("A command (run, steady, modes, ");
    QTest::newRow("unknown command") << QStringList{"fly"} << QByteArray("\"fly\" is no command\n");
    QTest::newRow("misspelt command") << QStringList{"runn", "fig10a"}
                                      << QByteArray("\"runn\" is no command; did you mean run?\n");
    QTest::newRow("the case first")
        << QStringList{"fig10a", "study", "hysteresis"}
        << QByteArray("\"fig10a\" is no command; did you mean `touchdown study hysteresis fig10a`?\n");
    QTest::newRow("a kind without study") << QStringList{"work-precison", "fig10a"}
                                          << QByteArray("did you mean `touchdown study work-precision fig10a`?\n");
    QTest::newRow("only a case") << QStringList{"fig10a"} << QByteArray("did you mean `touchdown run fig10a`?\n");
    QTest::newRow("a study as a case")
        << QStringList{"run", "hysteresis_take_off"}
        << QByteArray("is a study, not a case; did you mean `touchdown study hysteresis hysteresis_take_off`?\n");
    QTest::newRow("a study to convert") << QStringList{"convert", "hysteresis_take_off", "a.toml"}
                                        << QByteArray("is a study, not a case; ");
    QTest::newRow("misspelt option") << QStringList{"run", "fig10a", "--sett", "a=1"}
                                     << QByteArray("run: --sett is no option; did you mean --set?\n");
    QTest::newRow("only options") << QStringList{"--json"} << QByteArray("--json");
    QTest::newRow("unknown option") << QStringList{"run", "fig10a", "--fast"} << QByteArray("--fast");
    QTest::newRow("no case") << QStringList{"run"} << QByteArray("CASE");
    QTest::newRow("no case but settings") << QStringList{"run", "--set", "springs.cutoff=1e-9"} << QByteArray("CASE");
    QTest::newRow("two cases") << QStringList{"run", "fig10a", "fig10b"} << QByteArray("fig10b");
    QTest::newRow("no such list") << QStringList{"list", "lessons"}
                                  << QByteArray("\"lessons\" is no list; `touchdown list lesson` prints");
    QTest::newRow("option with an empty file")
        << QStringList{"run", "fig10a", "--out", ""} << QByteArray("--out: the name of a file is empty");
    QTest::newRow("empty file of a time series")
        << QStringList{"run", "fig10a", "--csv", "", "--json"} << QByteArray("--csv: the name of a file is empty");
    QTest::newRow("empty file after =") << QStringList{"run", "fig10a", "--out="} << QByteArray("--out");
    QTest::newRow("empty file of a static state")
        << QStringList{"steady", "film_plane", "--out", ""} << QByteArray("--out: the name of a file is empty");
    QTest::newRow("empty file of a study") << QStringList{"study", "hysteresis", "fig10a", "--csv", ""}
                                           << QByteArray("--csv: the name of a file is empty");
    QTest::newRow("empty file of a found case")
        << QStringList{"advise", "film_pico", "--apply", ""} << QByteArray("--apply: the name of a file is empty");
    QTest::newRow("empty case") << QStringList{"run", ""} << QByteArray("CASE");
    QTest::newRow("conversion to nothing") << QStringList{"convert", "film_pico", ""} << QByteArray("TO");
    QTest::newRow("option without its file") << QStringList{"run", "fig10a", "--out"} << QByteArray("--out");
    QTest::newRow("validate without a case") << QStringList{"validate", "--json"} << QByteArray("CASE");
}

void TestCommandLine::wrongArguments()
{
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, says);
    const Outcome o = folder_->touchdown(arguments);
    QCOMPARE(o.code, 2);
    QVERIFY2(o.err.contains(says), o.err);
    QVERIFY2(isRefusal(o, arguments), o.out);
}

void TestCommandLine::settingsInAnyPlace_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("after the case") << QStringList{"fig10a", "--set", "run.duration=1 us", "run.integrator=rk4-events"};
    QTest::newRow("before the case") << QStringList{"--set", "run.duration=1 us", "run.integrator=rk4-events",
                                                    "fig10a"};
    QTest::newRow("one each") << QStringList{"--set", "run.duration=1 us", "--set", "run.integrator=rk4-events",
                                             "fig10a"};
    QTest::newRow("the last one counts") << QStringList{
        "fig10a", "--set", "run.duration=2 ms", "run.integrator=rk4-events", "--set", "run.duration=1e-6"};
}

void TestCommandLine::settingsInAnyPlace()
{
    QFETCH(QStringList, arguments);
    const Outcome o = folder_->touchdown(QStringList{"run", "--json"} + arguments);
    QCOMPARE(o.code, 0);
    QCOMPARE(o.json()["end_time"].toDouble(), 1e-6);
    QCOMPARE(o.json()["integrator"].toString(), "rk4-events");
}

void TestCommandLine::validate()
{
    const Outcome good = folder_->touchdown({"validate", "fig10a"});
    QCOMPARE(good.code, 0);
    QCOMPARE(good.out, QByteArray("fig10a: valid\n"));
    QCOMPARE(good.err, QByteArray());

    int number = 0;
    folder_->put("bad.toml", changedCase("mass", "mass = \"-1 mg\"", number));
    const Outcome bad = folder_->touchdown({"validate", "bad.toml", "--json"});
    QCOMPARE(bad.code, 2);
    QCOMPARE(bad.json()["valid"].toBool(true), false);
    const QJsonObject problem = bad.json()["problems"].toArray()[0].toObject();
    QCOMPARE(problem["line"].toInt(), number);
    QCOMPARE(problem["key"].toString(), "slider.mass");
    QCOMPARE(bad.errorLines().size(), 1);
    QVERIFY(folder_->touchdown({"validate", "fig10a", "--json"}).json()["valid"].toBool());

    const Outcome idle = folder_->touchdown({"validate", "fig10a", "--json", "--set", "film.coupling=staggered"});
    QCOMPARE(idle.code, 0);
    QCOMPARE(idle.err, QByteArray("warning: --set: film.coupling: has no effect here, only with model = \"film\"\n"));
    QCOMPARE(idle.json()["unused"].toArray().size(), 1);

    // With its line where the file says it; a case that may bounce for ever is valid.
    folder_->put("gives.toml", changedCase("meniscus_force", "meniscus_force = \"1 mN\"", number));
    const Outcome gives = folder_->touchdown({"validate", "gives.toml"});
    QCOMPARE(gives.code, 0);
    QCOMPARE(gives.errorLines().size(), 1);
    QVERIFY2(gives.err.startsWith("warning: gives.toml:" + QByteArray::number(number) +
                                  ": ono_yamane.meniscus_force: W = -0.5 pJ is negative"),
             gives.err.constData());
    QVERIFY(folder_->touchdown({"validate", "gives.toml", "--set", "ono_yamane.take_off=6 nm"}).err.isEmpty());
}

// A study is checked with its case; what it says in vain is told.
void TestCommandLine::validateStudies()
{
    QCOMPARE(folder_->touchdown({"validate", "hysteresis_take_off"}).out,
             QByteArray("hysteresis_take_off: valid, a study of kind hysteresis\n"));
    const QString design = TOUCHDOWN_SOURCE_DIR "/sample_cases/studies/film_fig4_pico.toml";
    QCOMPARE(folder_->touchdown({"validate", design}).code, 0);
    QCOMPARE(folder_->touchdown({"validate", design, "--json"}).json()["kind"].toString(), "design");
    const auto said = [this](const QByteArray& text) {
        folder_->put("a.toml", text);
        const Outcome o = folder_->touchdown({"validate", "a.toml"});
        return o.code == 2 && o.out.isEmpty() ? o.err : "code " + QByteArray::number(o.code);
    };
    QCOMPARE(said("kind = \"hysteresis\"\ncase = \"fig10a\"\nsteps = 0\n"),
             QByteArray("a.toml:3: steps: must be a whole number from 1 to 999\n"));
    QCOMPARE(said("case = \"fig10a\"\n"), "a.toml: kind: is missing: it is one of " + test::studyKindNames() + "\n");
    QCOMPARE(said("case = \"fig10a\"\nkind = \"hysterese\"\n"),
             "a.toml:2: kind: \"hysterese\" is no kind of study: allowed is one of " + test::studyKindNames() +
                 "; did you mean hysteresis?\n");
    QCOMPARE(said("case = \"fig10a\"\nkind = \"hysteresis\"\n[set]\nrun.step = \"1 nm\"\n").left(24),
             QByteArray("a.toml:4: set.run.step: "));
}

void TestCommandLine::list()
{
    const Outcome text = folder_->touchdown({"list"});
    const Outcome json = folder_->touchdown({"list", "--json"});
    QCOMPARE(text.code, 0);
    QCOMPARE(json.code, 0);
    const QJsonArray cases = json.json()["cases"].toArray();
    QCOMPARE(static_cast<std::size_t>(cases.size()), sampleCases().size());
    for (const auto& each : cases) {
        QVERIFY(text.out.contains(each.toObject()["name"].toString().toUtf8() + " "));
        QVERIFY(text.out.contains(each.toObject()["title"].toString().toUtf8() + "\n"));
    }
    QVERIFY(text.out.contains("\nStudies: touchdown study KIND NAME\n"));
    const QJsonArray studies = json.json()["studies"].toArray();
    QVERIFY(studies.size() >= 2);
    for (const auto& each : studies) {
        QVERIFY(!each.toObject()["kind"].toString().isEmpty());
        QVERIFY(text.out.contains(each.toObject()["title"].toString().toUtf8() + "\n"));
    }
}

void TestCommandLine::listDemonstrations()
{
    const Outcome text = folder_->touchdown({"list", "demonstrations"});
    QCOMPARE(text.code, 0);
    QCOMPARE(text.err, QByteArray());
    const QJsonArray steps = folder_->touchdown({"list", "demonstrations", "--json"}).json()["steps"].toArray();
    QCOMPARE(steps.size(), 13);
    for (const auto& step : steps) {
        QVERIFY(text.out.contains("\n" + step.toObject()["title"].toString().toUtf8() + "\n"));
        for (const auto& run : step.toObject()["runs"].toArray())
            QVERIFY(text.out.contains("\n      " + run.toObject()["command"].toString().toUtf8() + "\n"));
    }
}

void TestCommandLine::listLesson()
{
    const Outcome text = folder_->touchdown({"list", "lesson"});
    QCOMPARE(text.code, 0);
    QCOMPARE(text.err, QByteArray());
    const QJsonArray steps = folder_->touchdown({"list", "lesson", "--json"}).json()["steps"].toArray();
    QCOMPARE(steps.size(), 6);
    const qsizetype answers = text.out.indexOf("\nAnswers\n");
    for (const auto& each : steps) {
        const QJsonObject step = each.toObject();
        // The title stands above the question, and again above the answer.
        const QByteArray title = ". " + step["title"].toString().toUtf8() + "\n";
        QVERIFY(text.out.indexOf(title) < answers && text.out.lastIndexOf(title) > answers);
        for (const auto& run : step["runs"].toArray()) {
            const QByteArray command = run.toObject()["command"].toString().toUtf8();
            QVERIFY2(text.out.contains("\n      " + command + "\n"), command);
        }
    }
    QVERIFY(text.out.contains("\n      touchdown run fig13a --set 'initial.flying_height=9 nm' --set "
                              "'initial.pitch=90.6 urad'\n"));
    QVERIFY(text.out.contains("\n      touchdown study cycles cycles_meniscus_force\n"));
}

void TestCommandLine::describeAll()
{
    const Outcome text = folder_->touchdown({"describe"});
    const Outcome json = folder_->touchdown({"describe", "--json"});
    QCOMPARE(text.code, 0);
    const QJsonArray all = json.json()["fields"].toArray();
    QCOMPARE(static_cast<std::size_t>(all.size()), parameters().size());
    for (const Parameter& parameter : parameters()) {
        QVERIFY2(text.out.contains("\n" + QByteArray::fromStdString(parameter.key) + " "), parameter.key.c_str());
        QVERIFY2(text.out.contains(QByteArray::fromStdString(allowedRange(parameter)) + "\n"), parameter.key.c_str());
    }
    QCOMPARE(folder_->touchdown({"describe", "springs", "--json"}).json()["fields"].toArray().size(), 10);
}

void TestCommandLine::describeOne()
{
    const Outcome o = folder_->touchdown({"describe", "springs.cutoff"});
    QCOMPARE(o.code, 0);
    for (const char* part : {"springs.cutoff", "d_1", "nm (m)", "0.3 nm", "greater than 0 nm", "paper"})
        QVERIFY2(o.out.contains(part), part);
    const QJsonObject json =
        folder_->touchdown({"describe", "springs.cutoff", "--json"}).json()["fields"].toArray()[0].toObject();
    QCOMPARE(json["default"].toDouble(), 0.3e-9);
    QCOMPARE(json["unit"].toString(), "m");
    QCOMPARE(json["minimum"].toDouble(-1.0), 0.0);
    QCOMPARE(json["minimum_allowed"].toBool(true), false);
}

// Rails are tables, which the list of the keys cannot show.
void TestCommandLine::describeTheSurface()
{
    for (const char* key : {"abs", "abs.rail", "abs.wall", "abs.points_of_interest", "abs.rails"}) {
        const Outcome o = folder_->touchdown({"describe", key});
        QCOMPARE(o.code, 0);
        for (const char* part : {"[[abs.rail]]", "[[abs.wall]]", "points_of_interest", "rail.dat"})
            QVERIFY2(o.out.contains(part), part);
        QVERIFY(folder_->touchdown({"describe", key, "--json"}).json()["surface"].toString().contains("[[abs.rail]]"));
    }
    QVERIFY(!folder_->touchdown({"describe", "abs.crown"}).out.contains("[[abs.rail]]"));
    QCOMPARE(folder_->touchdown({"describe", "abs", "--json"}).json()["fields"].toArray().size(), 6);

    const QJsonObject nodes =
        folder_->touchdown({"describe", "film.nodes", "--json"}).json()["fields"].toArray()[0].toObject();
    QCOMPARE(nodes["kind"].toString(), "list");
    QCOMPARE(nodes["default"].toArray(), (QJsonArray{193.0, 193.0}));
    QCOMPARE(nodes["minimum_count"].toInt(), 2);
    QVERIFY(folder_->touchdown({"describe", "degrees_of_freedom"}).out.contains("2; film: 3"));
}

void TestCommandLine::describeUnknown()
{
    const Outcome o = folder_->touchdown({"describe", "springs.cutof"});
    QCOMPARE(o.code, 2);
    QCOMPARE(o.err, QByteArray("springs.cutof: unknown key; did you mean springs.cutoff?\n"));
    QCOMPARE(o.out, QByteArray());
    QVERIFY(folder_->touchdown({"describe", "sprins"}).err.contains("did you mean springs?"));
}

// Ranges, defaults and help of the keys.
void TestCommandLine::describeStudies()
{
    const Outcome kinds = folder_->touchdown({"describe", "study"});
    QCOMPARE(kinds.code, 0);
    for (const char* part : {"work-precision  ", "stability  ", "hysteresis  ", "cycles  ", "response  ", "advise  ",
                             "design  ", "convergence  "})
        QVERIFY2(kinds.out.contains(part), kinds.out);
    const Outcome all = folder_->touchdown({"describe", "study.hysteresis"});
    QCOMPARE(all.code, 0);
    QVERIFY2(
        all.out.contains(
            "\nsteps       a whole number from 1 to 999\n      From one end to the other. Default: 40; film: 6.\n"),
        all.out);
    QCOMPARE(folder_->touchdown({"describe", "study", "hysteresis"}).out, all.out);
    QVERIFY(folder_->touchdown({"describe", "work-precision"})
                .out.contains("\n[ensemble]\nensemble.starts  a whole number from 2 to 100000\n"));
    const Outcome one = folder_->touchdown({"describe", "hysteresis.hold", "--json"});
    const QJsonObject key = one.json()["keys"].toArray()[0].toObject();
    QCOMPARE(key["unit"].toString(), "s");
    QCOMPARE(key["allowed"].toString(), "from 0.1 us to 1e6 us");
    QCOMPARE(key["default"].toObject()["springs"].toString(), "2000 us");
    QCOMPARE(folder_->touchdown({"describe", "hysteresis.step"}).err,
             QByteArray("step: unknown key of a study of kind hysteresis; did you mean steps?\n"));
    QVERIFY(folder_->touchdown({"describe", "hysteresys"}).err.contains("did you mean hysteresis?"));
    QVERIFY(folder_->touchdown({"describe", "study.hysteresys"})
                .err.contains("allowed is one of " + test::studyKindNames()));
}

TOUCHDOWN_TEST(TestCommandLine)

} // namespace test_command_line

#include "test_command_line.moc"
