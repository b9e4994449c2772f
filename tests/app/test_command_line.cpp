// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "core/simulation/fields.h"
#include "tests/support/command_process.h"

using namespace touchdown;

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
    void list();
    void describeAll();
    void describeOne();
    void describeTheSurface();
    void describeUnknown();

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
    QTest::newRow("misspelt command") << QStringList{"runn", "fig10a"} << QByteArray("\"runn\" is no command; did you mean run?\n");
    QTest::newRow("only options") << QStringList{"--json"} << QByteArray("--json");
    QTest::newRow("unknown option") << QStringList{"run", "fig10a", "--fast"} << QByteArray("--fast");
    QTest::newRow("no case") << QStringList{"run"} << QByteArray("CASE");
    QTest::newRow("no case but settings") << QStringList{"run", "--set", "springs.cutoff=1e-9"} << QByteArray("CASE");
    QTest::newRow("two cases") << QStringList{"run", "fig10a", "fig10b"} << QByteArray("fig10b");
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
    QCOMPARE(o.out, QByteArray());
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

void TestCommandLine::describeAll()
{
    const Outcome text = folder_->touchdown({"describe"});
    const Outcome json = folder_->touchdown({"describe", "--json"});
    QCOMPARE(text.code, 0);
    const QJsonArray all = json.json()["fields"].toArray();
    QCOMPARE(static_cast<std::size_t>(all.size()), fields().size());
    for (const Field& field : fields()) {
        QVERIFY2(text.out.contains("\n" + QByteArray::fromStdString(field.key) + " "), field.key.c_str());
        QVERIFY2(text.out.contains(QByteArray::fromStdString(allowedRange(field)) + "\n"), field.key.c_str());
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

QTEST_GUILESS_MAIN(TestCommandLine)
#include "test_command_line.moc"
