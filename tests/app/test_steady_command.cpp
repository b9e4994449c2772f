// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown steady` as a person and as a script use it. What the film itself does: tests/physics and tests/simulation.

#include <QtTest>

#include <csignal>

#include "core/simulation/static_state/steady.h"
#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_steady_command {

class TestSteadyCommand : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }
    void json();
    void text();
    void fixedAttitude();
    void railsInsideTheDisk();
    void unknownGridError();
    void saysWhatIsLeftOut();
    void series();
    void writesAFile();
    void theFileStandsAlone();
    void wrongInput_data();
    void wrongInput();
    void notConverged();
    void signalStops();
    void progressIsSilentUnlessAskedFor();

private:
    // A small grid, on which the numbers need not be exact.
    static QStringList quick(const QStringList& settings = {})
    {
        return QStringList{"--set", "film.nodes=33,33", "film.grid=uniform"} + settings;
    }
    std::unique_ptr<CommandFolder> folder_;
};

// The keys that scripts rely on.
void TestSteadyCommand::json()
{
    const Outcome o = folder_->touchdown(QStringList{"steady", "film_pico", "--json"} + quick());
    QCOMPARE(o.code, 0);
    QCOMPARE(o.err, QByteArray());
    const QJsonObject json = o.json();
    QCOMPARE(json["status"].toString(), "converged");
    QCOMPARE(json["grid"].toArray(), (QJsonArray{33, 33}));
    for (const char* key :
         {"nominal_trailing_edge_height", "pitch", "roll", "minimum_spacing", "positive_force", "negative_force",
          "shear_force_x", "shear_force_y", "maximum_pressure", "minimum_pressure", "iterations", "wall_seconds"})
        QVERIFY2(json[key].isDouble(), key);
    // Nothing touches: there are no such forces, and the message says so.
    for (const char* key : {"contact_force", "intermolecular_force"}) {
        QVERIFY2(json[key].isNull(), key);
        QVERIFY(json["message"].toString().contains(key));
    }
    for (const char* key : {"minimum_spacing_at", "centre_of_positive_pressure", "centre_of_negative_pressure"})
        QCOMPARE(json[key].toArray().size(), 2);
    QCOMPARE(json["stiffness"].toArray().size(), 3);
    for (const auto& row : json["stiffness"].toArray()) QCOMPARE(row.toArray().size(), 3);
    for (const char* key : {"minimum_spacing", "load", "pitch", "roll"})
        QVERIFY2(json["discretisation_error"].toObject()[key].isDouble(), key);
    QCOMPARE(json["unresolved_ridges"], QJsonValue(0)); // its walls begin at the recess of their rails
    const QJsonArray points = json["points_of_interest"].toArray();
    QCOMPARE(points.size(), 2);
    QCOMPARE(points[0].toObject()["x"].toDouble(), 1.215e-3);
    QVERIFY(points[0].toObject()["spacing"].toDouble() >= json["minimum_spacing"].toDouble());

    // The film carries the preload, within load_tolerance, and its parts are the whole.
    const double preload = 1.5e-3 * 9.80665;
    QVERIFY(std::abs(json["net_force"].toDouble() - preload) < 1e-5 * preload);
    QVERIFY(std::abs(json["positive_force"].toDouble() + json["negative_force"].toDouble() -
                     json["net_force"].toDouble()) < 1e-9 * preload);
}

void TestSteadyCommand::text()
{
    const Outcome o = folder_->touchdown(QStringList{"steady", "film_pico"} + quick());
    QCOMPARE(o.code, 0);
    QVERIFY2(o.out.startsWith("Film: a pico slider"), o.out);
    for (const char* part : {"converged", "33 x 33 nodes", "minimum spacing", " nm", "net force", "1.5000 gf",
                             "stiffness", "spacing of point 2", "pitch torque"})
        QVERIFY2(o.out.contains(part), part);

    // Pressures above ambient, as the window shows them, with five digits; the numbers for scripts are absolute.
    const QJsonObject json = folder_->touchdown(QStringList{"steady", "film_pico", "--json"} + quick()).json();
    const auto above = [&o](const char* row) {
        const QByteArray line = o.out.mid(o.out.indexOf(row)).split('\n').front();
        const double size = line.mid(qstrlen(row)).trimmed().split(' ').front().toDouble();
        return line.contains(" kPa above ambient at ") ? size : line.contains(" kPa below ambient at ") ? -size : 0.0;
    };
    QVERIFY(std::abs(above("highest pressure") - (json["maximum_pressure"].toDouble() - 101325.0) / 1e3) < 0.051);
    QVERIFY(std::abs(above("lowest pressure") - (json["minimum_pressure"].toDouble() - 101325.0) / 1e3) < 0.00051);
}

void TestSteadyCommand::fixedAttitude()
{
    const QStringList settings = quick({"initial.nominal_trailing_edge_height=50 nm", "initial.pitch=150 urad"});
    const Outcome o = folder_->touchdown(QStringList{"steady", "film_pico", "--fixed-attitude", "--json"} + settings);
    QCOMPARE(o.code, 0);
    QCOMPARE(o.json()["nominal_trailing_edge_height"].toDouble(), 50e-9);
    QCOMPARE(o.json()["pitch"].toDouble(), 150e-6);
    QCOMPARE(o.json()["roll"].toDouble(), 0.0);
    const Outcome same = folder_->touchdown(QStringList{"steady", "film_pico", "--json"} + settings +
                                            QStringList{"steady.fixed_attitude=true"});
    QCOMPARE(same.json()["net_force"].toDouble(), o.json()["net_force"].toDouble());
}

// Refused before anything is computed, in one line; numbers that nobody knows are null. The trailing pad is lowest
// where its walls begin, at (1.2245, 0.5) mm: -20 nm + 150 urad 25.5 um - 1.20 nm of crown - 3 nm of camber = -20.37
// nm.
void TestSteadyCommand::railsInsideTheDisk()
{
    const QStringList settings = quick({"initial.nominal_trailing_edge_height=-20 nm"});
    const Outcome o = folder_->touchdown(QStringList{"steady", "film_pico", "--fixed-attitude", "--json"} + settings);
    QCOMPARE(o.code, 1);
    QCOMPARE(o.json()["status"].toString(), QString("failed"));
    QVERIFY(o.json()["message"].toString().startsWith("the rails are inside the disk, 20.4 nm below"));
    for (const char* key : {"net_force", "residual", "load_error", "grid", "maximum_pressure", "minimum_spacing"})
        QVERIFY2(o.json().contains(key) && o.json()[key].isNull(), key);
    QCOMPARE(o.errorLines().size(), 1);
    const Outcome text = folder_->touchdown(QStringList{"steady", "film_pico", "--fixed-attitude"} + settings);
    QVERIFY(!text.out.contains("gf,") && !text.out.contains("net force"));
}

void TestSteadyCommand::unknownGridError()
{
    const QStringList single = quick({"suspension.preload=1000 gf"}); // ends on the coarsest grid
    const Outcome o = folder_->touchdown(QStringList{"steady", "film_pico", "--json"} + single);
    QCOMPARE(o.code, 1);
    QVERIFY(o.json()["message"].toString().contains(
        "the last attitude with rails above the disk was: trailing edge height"));
    const QJsonObject error = o.json()["discretisation_error"].toObject();
    QCOMPARE(error.size(), 4);
    for (const QJsonValue& each : error) QVERIFY(each.isNull());
    QVERIFY(o.json()["message"].toString().contains("discretisation_error"));
    const QByteArray text = folder_->touchdown(QStringList{"steady", "film_pico"} + single).out;
    QCOMPARE(text.count("(grid error not known)"), 4);
    QVERIFY(!folder_->touchdown(QStringList{"steady", "film_pico"} + quick()).out.contains("not known"));
}

// A static state is over a disk that stands still, at a fixed attitude without contact, and says so.
void TestSteadyCommand::saysWhatIsLeftOut()
{
    const Outcome alone = folder_->touchdown(QStringList{"steady", "film_pico", "--json"} + quick());
    QVERIFY2(!alone.json()["message"].toString().contains("has no part"), alone.out);
    const QStringList settings = quick({"contact=ono-yamane", "disk.surface.kind=rough"});
    const Outcome more = folder_->touchdown(QStringList{"steady", "film_pico", "--json"} + settings);
    QCOMPARE(more.code, 0);
    QVERIFY2(more.json()["message"].toString().contains("over a flat disk: disk.surface has no part in it"), more.out);
    QCOMPARE(more.json()["minimum_spacing"].toDouble(), alone.json()["minimum_spacing"].toDouble());
    const Outcome text = folder_->touchdown(QStringList{"steady", "film_pico"} + quick({"contact=ono-yamane"}));
    QVERIFY2(!text.out.contains("left out") && text.out.contains("flying"), text.out);
    const Outcome held = folder_->touchdown(QStringList{"steady", "film_pico"} +
                                            quick({"contact=ono-yamane", "steady.fixed_attitude=true"}));
    QVERIFY2(held.out.contains("left out") && held.out.contains("contact has no part in it"), held.out);
}

// A list for scripts, a table for people; each state is that of a case of its own.
void TestSteadyCommand::series()
{
    const QStringList settings = quick({"steady.speeds=5400 rpm,7200 rpm", "steady.altitudes=[0, 3000]"});
    const Outcome o = folder_->touchdown(QStringList{"steady", "film_pico", "--json"} + settings);
    QCOMPARE(o.code, 0);
    QCOMPARE(o.json()["status"].toString(), "converged");
    const QJsonArray series = o.json()["series"].toArray();
    QCOMPARE(series.size(), 4);
    const auto number = [&](int i, const char* key) { return series[i].toObject()[key].toDouble(); };
    QCOMPARE(number(0, "radius"), 23e-3);
    QCOMPARE(number(2, "altitude"), 3000.0);
    QVERIFY(number(1, "speed") > number(0, "speed"));
    QVERIFY(number(2, "minimum_spacing") < number(0, "minimum_spacing")); // thinner air carries less
    const Outcome alone =
        folder_->touchdown(QStringList{"steady", "film_pico", "--json"} +
                           quick({"disk.speed=7200 rpm", "air.source=atmosphere", "air.altitude=3000"}));
    QCOMPARE(number(3, "minimum_spacing"), alone.json()["minimum_spacing"].toDouble());

    const Outcome text = folder_->touchdown(QStringList{"steady", "film_pico"} + settings);
    const QList<QByteArray> lines = text.out.trimmed().split('\n');
    QCOMPARE(lines.size(), 6); // title, head, states
    QVERIFY(lines[1].contains("speed [rpm]") && lines[1].contains("altitude [m]") &&
            lines[1].contains("minimum_spacing [nm]"));
    QVERIFY(lines[3].contains("7200") && lines[3].endsWith("converged"));
}

void TestSteadyCommand::writesAFile()
{
    const Outcome o = folder_->touchdown(QStringList{"steady", "film_pico", "--out", "a.h5"} + quick());
    QCOMPARE(o.code, 0);
    QCOMPARE(folder_->files(), QStringList("a.h5"));
    QFile file(folder_->path("a.h5"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.read(8) == QByteArray("\x89HDF\r\n\x1a\n"));
}

// The case in the file holds the rails that the case had from another one.
void TestSteadyCommand::theFileStandsAlone()
{
    QCOMPARE(folder_->touchdown({"convert", "film_pico", "cml"}).code, 0);
    folder_->put("mine.toml", "model = \"film\"\n[abs]\nrails = \"cml/rail.dat\"\n");
    const Outcome o = folder_->touchdown(QStringList{"steady", "mine.toml", "--out", "a.h5", "--json"} + quick());
    QCOMPARE(o.code, 0);
    QFile file(folder_->path("a.h5"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QVERIFY(bytes.contains("[[abs.rail]]"));
    QVERIFY(!bytes.contains("rail.dat"));
}

void TestSteadyCommand::wrongInput_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("no case") << QStringList{} << QByteArray("CASE");
    QTest::newRow("springs") << QStringList{"fig10a"}
                             << QByteArray("fig10a: model: must be \"film\" for a static state on an air film");
    QTest::newRow("an unknown key") << QStringList{"film_pico", "--set", "film.node=33,33"}
                                    << QByteArray("--set: film.node: unknown key; did you mean film.nodes?");
    QTest::newRow("a bad value") << QStringList{"film_pico", "--set", "film.nodes=100,100"}
                                 << QByteArray("--set: film.nodes: 100 is not possible");
    QTest::newRow("no folder for the results")
        << QStringList{"film_pico", "--out", "none/a.h5"}
        << QByteArray("--out: cannot write to none/a.h5: there is no directory none");
    QTest::newRow("an unknown option") << QStringList{"film_pico", "--csv", "a.csv"} << QByteArray("--csv");
}

void TestSteadyCommand::wrongInput()
{
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, says);
    const Outcome o = folder_->touchdown(QStringList{"steady"} + arguments);
    QCOMPARE(o.code, 2);
    QVERIFY2(o.err.contains(says), o.err);
    QCOMPARE(o.out, QByteArray());
    QCOMPARE(folder_->files(), QStringList());
}

// Under a disk that stands still nothing carries the slider: exit code 1, the status and the reason.
void TestSteadyCommand::notConverged()
{
    const Outcome o = folder_->touchdown(QStringList{"steady", "film_pico", "--json"} + quick({"disk.speed=0 rpm"}));
    QCOMPARE(o.code, 1);
    const QString status = o.json()["status"].toString();
    QCOMPARE(status, QString("failed"));
    QVERIFY(o.json()["message"].toString().contains("disk at rest (disk.speed is 0 rpm)"));
    QVERIFY2(o.err.startsWith(status.toUtf8()), o.err);
    QCOMPARE(o.errorLines().size(), 1);
}

// The first state of a long series has begun when its progress shows.
void TestSteadyCommand::signalStops()
{
    QProcess process;
    process.setWorkingDirectory(folder_->path());
    QString radii = "steady.radii=";
    for (int i = 0; i < 100; ++i) radii += QString::number(0.015 + 1e-4 * i) + ",";
    process.start(TOUCHDOWN_COMMAND,
                  QStringList{"steady", "film_femto", "--json", "--progress", "--out", "a.h5", "--set", radii});
    QVERIFY(process.waitForStarted());
    QByteArray progress;
    QTRY_VERIFY_WITH_TIMEOUT((progress += process.readAllStandardError()).contains("state "), 30000);
    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
    const Outcome o = outcome(process);
    QCOMPARE(o.code, 1);
    QVERIFY2(o.err.contains("cancelled"), o.err);
    QCOMPARE(o.json()["status"].toString(), "cancelled");
    QVERIFY(o.json()["series"].toArray().size() < 100);
    QCOMPARE(folder_->files(), QStringList("a.h5"));
}

void TestSteadyCommand::progressIsSilentUnlessAskedFor()
{
    QCOMPARE(folder_->touchdown(QStringList{"steady", "film_pico"} + quick()).err, QByteArray());
    const Outcome o = folder_->touchdown(QStringList{"steady", "film_pico", "--progress"} + quick());
    QVERIFY2(o.err.contains("grid 33 x 33, iteration "), o.err);
}

TOUCHDOWN_TEST(TestSteadyCommand)

} // namespace test_steady_command

#include "test_steady_command.moc"
