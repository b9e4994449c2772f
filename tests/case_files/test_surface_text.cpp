// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/surface_text.h"

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_settings.h"
#include "core/case_files/case_text.h"
#include "core/case_files/cml/cml_rail_file.h"
#include "core/case_files/surface_format.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>
#include <memory>
#include <random>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_text {

const std::string written = "# a slider of mine\n"
                            "model = \"film\"\n"
                            "\n"
                            "[abs] # the surface\n"
                            "base_recess = \"2.5 um\"\n"
                            "points_of_interest = [[\"1.24 mm\", \"0.5 mm\"], [1e-3, 0]]\n"
                            "\n"
                            "# the pad\n"
                            "[[abs.rail]]\n"
                            "recess = \"0 um\" # the zero plane\n"
                            "points = [[\"1.0 mm\", \"0.4 mm\"], [\"1.2 mm\", \"0.4 mm\"],\n"
                            "    [\"1.2 mm\", \"0.6 mm\"], [\"1.0 mm\", \"0.6 mm\"]] # square\n"
                            "walls = [1, 0, 2, 0]\n"
                            "\n"
                            "# the ramp\n"
                            "[[abs.rail]]\n"
                            "recess = [\"0 um\", 1e-6, \"200 nm\"]\n"
                            "points = [[0, 0], [\"0.2 mm\", 0], [0, \"1 mm\"]]\n"
                            "\n"
                            "[[abs.wall]] # steep\n"
                            "distance = [\"-1 um\", \"0 um\", \"3 um\"]\n"
                            "recess = [0, \"1 um\", \"2.5 um\"]\n"
                            "\n"
                            "[[abs.wall]] # flat\n"
                            "distance = [0, \"30 um\"]\n"
                            "recess = [0, \"2.5 um\"]\n"
                            "\n"
                            "[slider]\n"
                            "mass = \"1.6 mg\" # light\n";

QStringList problemsOf(const CaseDocument& document)
{
    QStringList texts;
    for (const InputProblem& problem : document.problems) texts << QString::fromStdString(problem.text());
    return texts;
}

/// Steps, ramps and profiles of any number, of which none need make sense.
AirBearingSurface anySurface(std::mt19937& generator)
{
    const auto length = [&] { return std::uniform_real_distribution<double>(-1.0, 1.0)(generator) * 1e-3; };
    const auto whole = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator); };
    AirBearingSurface surface;
    surface.walls.resize(static_cast<std::size_t>(whole(0, 3)));
    for (WallProfile& wall : surface.walls)
        for (int i = whole(1, 30); i > 0; --i) {
            wall.distance.push_back(length());
            wall.recess.push_back(length());
        }
    surface.rails.resize(static_cast<std::size_t>(whole(0, 4)));
    for (Rail& rail : surface.rails) {
        rail.kind = whole(0, 1) == 0 ? RailKind::Step : RailKind::Ramp;
        rail.recess[0] = length();
        if (rail.kind == RailKind::Ramp) rail.recess = {length(), length(), 1.0 / 3.0 * length()};
        const int wall = whole(0, static_cast<int>(surface.walls.size()));
        for (int i = whole(3, 12); i > 0; --i) rail.points.push_back({length(), length(), whole(0, 1) == 0 ? wall : 0});
    }
    for (int i = whole(0, 3); i > 0; --i) surface.pointsOfInterest.push_back({length(), length()});
    return surface;
}

std::string replaced(std::string text, const std::string& part, const std::string& with)
{
    const auto at = text.find(part);
    Q_ASSERT(at != std::string::npos);
    return text.replace(at, part.size(), with);
}

class TestSurfaceText : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void reads()
    {
        const CaseDocument document = parseCase(written, "a.toml");
        QCOMPARE(problemsOf(document), QStringList());
        const AirBearingSurface& surface = document.value.surface;
        QCOMPARE(surface.baseRecess, 2.5e-6);
        QCOMPARE(surface.pointsOfInterest, (std::vector<SurfacePoint>{{1.24e-3, 0.5e-3}, {1e-3, 0.0}}));
        QCOMPARE(surface.rails.size(), std::size_t{2});
        const Rail step{RailKind::Step,
                        {{1.0e-3, 0.4e-3, 1}, {1.2e-3, 0.4e-3, 0}, {1.2e-3, 0.6e-3, 2}, {1.0e-3, 0.6e-3, 0}},
                        {0.0, 0.0, 0.0}};
        QVERIFY(surface.rails[0] == step);
        const Rail ramp{RailKind::Ramp, {{0.0, 0.0, 0}, {0.2e-3, 0.0, 0}, {0.0, 1e-3, 0}}, {0.0, 1e-6, 200e-9}};
        QVERIFY(surface.rails[1] == ramp);
        QVERIFY((surface.walls ==
                 std::vector<WallProfile>{{{-1e-6, 0.0, 3e-6}, {0.0, 1e-6, 2.5e-6}}, {{0.0, 30e-6}, {0.0, 2.5e-6}}}));
    }
    void readsTablesInALine()
    {
        const CaseDocument document =
            parseCase("model = 'film'\nabs.rail = [{ points = [[0, 0], [1e-3, 0], [0, 1e-3]], walls = 1 }]\n"
                      "abs.wall = [{ distance = [0, 1e-6], recess = [0, 2e-6] }]\n",
                      "a.toml");
        QCOMPARE(problemsOf(document), QStringList());
        QCOMPARE(document.value.surface.rails.at(0).points.at(2).wall, 1);
        QCOMPARE(document.value.surface.rails.at(0).recess[0], 0.0);
    }

    void namesTheProblem_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const QByteArray& text, const char* says) {
            QTest::newRow(name) << "model = 'film'\n" + text << "a.toml:" + QString(says);
        };
        const QByteArray rail = "[[abs.rail]]\npoints = [[0,0],[1e-3,0],[0,1e-3]]\n";
        const QByteArray wall = "[[abs.wall]]\ndistance = [0,1e-6]\nrecess = [0,1e-6]\n";
        row("a table instead of tables", "[abs.rail]\nrecess = 0",
            "2: abs.rail: is one table; write [[abs.rail]] for each rail");
        row("a value instead of tables", "[abs]\nwall = 3",
            "3: abs.wall: is not a table; write [[abs.wall]] for each wall");
        row("a list instead of tables", "[abs]\nrail = [1, 2]",
            "3: abs.rail: is not a table; write [[abs.rail]] for each rail");
        row("an unknown key", rail + "reces = 0", "4: abs.rail[1].reces: unknown key; did you mean recess?");
        row("an unknown key of a wall", wall + "depth = 0", "5: abs.wall[1].depth: unknown key");
        row("a table in a rail", rail + "[abs.rail.form]\nx = 1", "4: abs.rail[1].form: unknown table");
        row("a wrong unit", rail + "recess = '2 mg'",
            "4: abs.rail[1].recess: \"2 mg\" has the wrong unit; a length such as nm, um or mm is needed");
        row("no unit", rail + "recess = '2'",
            "4: abs.rail[1].recess: \"2\" has no unit; a length such as nm, um or mm is needed");
        row("not a number", rail + "recess = nan", "4: abs.rail[1].recess: is not a finite number");
        row("an infinite recess", rail + "recess = '-inf um'",
            "4: abs.rail[1].recess: \"-inf um\" is not a finite number");
        row("a recess of kilometres", rail + "recess = 2000",
            "4: abs.rail[1].recess: 2000 m is out of range: allowed is at most 1 m");
        row("a boolean recess", rail + "recess = true",
            "4: abs.rail[1].recess: has the wrong type; a number or \"1 um\" is needed");
        row("two recesses", rail + "recess = [0, 1e-6]",
            "4: abs.rail[1].recess: has 2 numbers; a step has one recess, a ramp a list of three, at its first three "
            "points");
        row("a wrong recess of a ramp", rail + "recess = [0,\n '1 mg', 0]",
            "5: abs.rail[1].recess: \"1 mg\" has the wrong unit; a length such as nm, um or mm is needed");
        row("no points", "[[abs.rail]]\nrecess = 0", "2: abs.rail[1]: needs points");
        row("two points", "[[abs.rail]]\npoints = [[0,0],[1e-3,0]]",
            "3: abs.rail[1].points: has 2 points; a rail has three or more");
        row("a point of three", "[[abs.rail]]\npoints = [[0,0],\n[1e-3,0,0],[0,1e-3]]",
            "4: abs.rail[1].points: a point is a list of two, such as [\"0.1 mm\", \"0.5 mm\"]");
        row("points in one list", "[[abs.rail]]\npoints = [0,0,1e-3,0,0,1e-3]",
            "3: abs.rail[1].points: a point is a list of two, such as [\"0.1 mm\", \"0.5 mm\"]");
        row("a point that is not a number", "[[abs.rail]]\npoints = [[0,0],[1e-3,0],[0,inf]]",
            "3: abs.rail[1].points: is not a finite number");
        row("a wrong unit of a point", "[[abs.rail]]\npoints = [[0,0],[1e-3,0],\n[0,'1 deg']]",
            "4: abs.rail[1].points: \"1 deg\" has the wrong unit; a length such as nm, um or mm is needed");
        row("a text of points", "[[abs.rail]]\npoints = '0 0 1 0'",
            "3: abs.rail[1].points: has the wrong type; a list such as [[\"0.1 mm\", \"0.5 mm\"]] is needed");
        row("walls for two edges", rail + "walls = [1, 1]\n" + wall, "4: abs.rail[1].walls: has 2 numbers for 3 edges");
        row("a wall that does not exist", rail + "walls = [0, 2,\n 0]\n" + wall,
            "4: abs.rail[1].walls: wall 2 does not exist: there is 1 wall");
        row("a wall of none", rail + "walls = 1", "4: abs.rail[1].walls: wall 1 does not exist: there are 0 walls");
        row("a negative wall", rail + "walls = -1\n" + wall,
            "4: abs.rail[1].walls: wall -1 does not exist: there is 1 wall");
        row("half a wall", rail + "walls = 0.5\n" + wall,
            "4: abs.rail[1].walls: has the wrong type; the number of a wall is needed, 0 for none");
        row("a wall without a recess", "[[abs.wall]]\ndistance = [0, 1e-6]",
            "2: abs.wall[1]: needs a distance and a recess");
        row("fewer recesses than distances", "[[abs.wall]]\ndistance = [0, 1e-6]\nrecess = [0]",
            "4: abs.wall[1].recess: has 1 number for 2 distances");
        row("a word among distances", "[[abs.wall]]\ndistance = [0, 'far']\nrecess = [0, 1]",
            "3: abs.wall[1].distance: \"far\" is not a number");
        row("distances that go back", "[[abs.wall]]\ndistance = [1e-6, 0]\nrecess = [0, 1e-6]",
            "2: abs.wall[1]: Wall profile 1: the distances must ascend; point 2 lies before the point ahead of it");
        row("a rail that crosses itself", rail + "[[abs.rail]]\npoints = [[0,0],[1e-3,1e-3],[1e-3,0],[0,1e-3]]",
            "4: abs.rail[2]: Rail 2: the outline crosses itself");
        row("points of interest in one list", "[abs]\npoints_of_interest = [1e-3, 1e-3]",
            "3: abs.points_of_interest: a point is a list of two, such as [\"0.1 mm\", \"0.5 mm\"]");
        row("too many points of interest", "[abs]\npoints_of_interest = [" + QByteArray("[0,0],").repeated(101) + "]",
            "3: abs.points_of_interest: 101 points are too many; at most 100 are possible");
        row("rails from nowhere", "[abs]\nrails = 'rail.dat'",
            "3: abs.rails: names a file, but this text has no folder");
        row("a number of rails", "[abs]\nrails = 3",
            "3: abs.rails: has the wrong type; the name of a file in quotation marks is needed");
        row("rails from both", "[abs]\nrails = 'rail.dat'\n" + rail,
            "3: abs.rails: rails come from a file or from [[abs.rail]], not from both");
        row("a taper longer than the slider", "[abs]\ntaper_length = '2 mm'",
            "3: abs.taper_length: must be at most slider.length (1.25 mm)");
    }
    /// One sentence for each problem, with file, line and key.
    void namesTheProblem()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, says);
        QCOMPARE(problemsOf(parseCase(text.toStdString(), "a.toml")), QStringList(says));
    }
    void reportsEverythingAtOnce()
    {
        const CaseDocument document = parseCase("model = 'film'\n[[abs.rail]]\nrecess = nan\n[[abs.rail]]\nwalls = 7\n"
                                                "points = [[0,0],[1e-3,0],[0,1e-3]]\n[[abs.wall]]\ndistance = 1\n"
                                                "[disk]\nradius = '-1 mm'\n",
                                                "");
        QStringList places;
        for (const InputProblem& problem : document.problems)
            places << QString("%1 %2").arg(problem.line).arg(problem.key.c_str());
        QCOMPARE(places, (QStringList{"2 abs.rail[1]", "3 abs.rail[1].recess", "5 abs.rail[2].walls", "7 abs.wall[1]",
                                      "8 abs.wall[1].distance", "10 disk.radius"}));
    }
    void thereAreBounds_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("says");
        QTest::newRow("rails") << QByteArray("[[abs.rail]]\npoints=[[0,0],[1,0],[0,1]]\n").repeated(1001)
                               << "a.toml: abs.rail: 1001 rails are too many; at most 1000 are possible";
        QTest::newRow("walls") << QByteArray("[[abs.wall]]\ndistance=[0,1]\nrecess=[0,1]\n").repeated(1001)
                               << "a.toml: abs.wall: 1001 walls are too many; at most 1000 are possible";
        const QByteArray points = "[[abs.rail]]\npoints=[\n" + QByteArray("[0,0],\n").repeated(5001) + "]\n";
        QTest::newRow("points of all rails")
            << points + points << "a.toml:5006: abs.rail[2].points: makes more than 10000 points of all rails";
        QTest::newRow("points of a rail")
            << points + "[[abs.rail]]\npoints=[\n" + QByteArray("[0,0],\n").repeated(10001) + "]\n"
            << "a.toml:5006: abs.rail[2].points: 10001 points are too many; at most 10000 are possible";
        QTest::newRow("points of a wall")
            << "[[abs.wall]]\nrecess=[0,0]\ndistance=[\n" + QByteArray("0,\n").repeated(1001) + "]\n"
            << "a.toml:3: abs.wall[1].distance: 1001 numbers are too many; at most 1000 are possible";
    }
    void thereAreBounds()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, says);
        QCOMPARE(problemsOf(parseCase(text.toStdString(), "a.toml")), QStringList(says));
    }
    /// A good case with a few bytes changed is read or refused, and never ends the program.
    void survivesChangedBytes()
    {
        std::mt19937 generator(6);
        for (int round = 0; round < 3000; ++round) {
            std::string text = written;
            for (int i = 0; i < 3; ++i) text[generator() % text.size()] = static_cast<char>(generator() % 128);
            const CaseDocument document = parseCase(text, "x");
            for (const InputProblem& problem : document.problems) QVERIFY(!problem.message.empty());
        }
    }
    void warnsOfWhatMayNotBeMeant()
    {
        const CaseDocument document =
            parseCase("model = 'film'\n[[abs.rail]]\npoints = [[0,0],['1 mm',0],['1 mm','1.1 mm']]\n", "a.toml");
        QCOMPARE(problemsOf(document), QStringList());
        QCOMPARE(document.warnings.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(document.warnings.front().text()),
                 QString("a.toml:2: abs.rail[1]: Rail 1: corner 3 lies outside the slider."));
    }

    void formattingReadsBack()
    {
        std::mt19937 generator(17);
        for (int round = 0; round < 100; ++round) {
            Case c = defaultsOf(round % 3 == 0 ? ModelKind::Springs : ModelKind::Film);
            c.surface = anySurface(generator);
            QVERIFY(parseCase(formatCase(c), "").value.surface == c.surface);
        }
    }
    void formattedTextIsReadable()
    {
        const std::string text = formatSurface(parseCase(written, "").value.surface);
        QCOMPARE(
            QString::fromStdString(text),
            QString("points_of_interest = [[\"1.24 mm\", \"0.5 mm\"], [\"1 mm\", \"0 mm\"]]\n"
                    "\n[[abs.rail]]\nrecess = \"0 um\"\n"
                    "points = [[\"1 mm\", \"0.4 mm\"], [\"1.2 mm\", \"0.4 mm\"], [\"1.2 mm\", \"0.6 mm\"], "
                    "[\"1 mm\", \"0.6 mm\"]]\n"
                    "walls = [1, 0, 2, 0]\n"
                    "\n[[abs.rail]]\nrecess = [\"0 um\", \"1 um\", \"0.2 um\"]\n"
                    "points = [[\"0 mm\", \"0 mm\"], [\"0.2 mm\", \"0 mm\"], [\"0 mm\", \"1 mm\"]]\nwalls = 0\n"
                    "\n# wall 1\n[[abs.wall]]\ndistance = [\"-1 um\", \"0 um\", \"3 um\"]\n"
                    "recess = [\"0 um\", \"1 um\", \"2.5 um\"]\n"
                    "\n# wall 2\n[[abs.wall]]\ndistance = [\"0 um\", \"30 um\"]\nrecess = [\"0 um\", \"2.5 um\"]\n"));
    }
    void linesStayShort()
    {
        Case c = defaultsOf(ModelKind::Film);
        Rail rail;
        for (int i = 0; i < 300; ++i) rail.points.push_back({i / 3e6, std::sqrt(2.0) * i, 0});
        c.surface.rails.push_back(rail);
        for (const QByteArray& line : QByteArray::fromStdString(formatCase(c)).split('\n')) QVERIFY(line.size() < 160);
    }

    void anUnchangedSurfaceChangesNothing()
    {
        QCOMPARE(updateCaseText(written, parseCase(written, "").value), written);
    }
    void aChangeStaysInItsPlace_data()
    {
        QTest::addColumn<QByteArray>("expected");
        QTest::addColumn<int>("change");
        const auto row = [](const char* name, int change, const std::string& part, const std::string& with) {
            QTest::newRow(name) << QByteArray::fromStdString(replaced(written, part, with)) << change;
        };
        row("a recess", 0, "recess = \"0 um\" # the zero plane", "recess = \"0.1 um\" # the zero plane");
        row("a step becomes a ramp", 1, "recess = \"0 um\" # the zero plane",
            "recess = [\"0 um\", \"0.1 um\", \"0.2 um\"] # the zero plane");
        row("walls", 2, "walls = [1, 0, 2, 0]", "walls = 2");
        row("walls of the ramp, which had none", 3, "points = [[0, 0], [\"0.2 mm\", 0], [0, \"1 mm\"]]\n",
            "points = [[0, 0], [\"0.2 mm\", 0], [0, \"1 mm\"]]\nwalls = 1\n");
        row("a wall", 4, "recess = [0, \"1 um\", \"2.5 um\"]", "recess = [\"0 um\", \"1.5 um\", \"2.5 um\"]");
        row("points of interest", 5, "[[\"1.24 mm\", \"0.5 mm\"], [1e-3, 0]]", "[[\"1 mm\", \"0 mm\"]]");
        row("the last wall goes", 6, "[[abs.wall]] # flat\ndistance = [0, \"30 um\"]\nrecess = [0, \"2.5 um\"]\n", "");
        row("a wall comes", 7, "recess = [0, \"2.5 um\"]\n",
            "recess = [0, \"2.5 um\"]\n\n[[abs.wall]]\ndistance = [\"0 um\", \"1 um\"]\nrecess = [\"0 um\", \"2.5 "
            "um\"]\n");
        row("the first rail goes", 8,
            "[[abs.rail]]\nrecess = \"0 um\" # the zero plane\npoints = [[\"1.0 mm\", \"0.4 mm\"], [\"1.2 mm\", \"0.4 "
            "mm\"],\n    [\"1.2 mm\", \"0.6 mm\"], [\"1.0 mm\", \"0.6 mm\"]] # square\nwalls = [1, 0, 2, 0]\n",
            "");
        row("a rail comes first", 9, "[[abs.rail]]\nrecess = \"0 um\" # the",
            "[[abs.rail]]\nrecess = \"0 um\"\npoints = [[\"0 mm\", \"0 mm\"], [\"1 mm\", \"0 mm\"], [\"0 mm\", \"1 "
            "mm\"]]\n"
            "walls = 0\n\n[[abs.rail]]\nrecess = \"0 um\" # the");
        row("a rail comes between", 10, "walls = [1, 0, 2, 0]\n",
            "walls = [1, 0, 2, 0]\n\n[[abs.rail]]\nrecess = \"0 um\"\npoints = [[\"0 mm\", \"0 mm\"], [\"1 mm\", \"0 "
            "mm\"], "
            "[\"0 mm\", \"1 mm\"]]\nwalls = 0\n");
        row("the crown, which is new to [abs]", 11, "points_of_interest = [[\"1.24 mm\", \"0.5 mm\"], [1e-3, 0]]\n",
            "points_of_interest = [[\"1.24 mm\", \"0.5 mm\"], [1e-3, 0]]\ncrown = \"20 nm\"\n");
    }
    void aChangeStaysInItsPlace()
    {
        QFETCH(QByteArray, expected);
        QFETCH(int, change);
        const Rail fresh{RailKind::Step, {{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}}, {}};
        Case c = parseCase(written, "").value;
        AirBearingSurface& surface = c.surface;
        switch (change) {
        case 0: surface.rails[0].recess[0] = 100e-9; break;
        case 1: surface.rails[0].kind = RailKind::Ramp, surface.rails[0].recess = {0.0, 100e-9, 200e-9}; break;
        case 2:
            for (RailPoint& point : surface.rails[0].points) point.wall = 2;
            break;
        case 3:
            for (RailPoint& point : surface.rails[1].points) point.wall = 1;
            break;
        case 4: surface.walls[0].recess[1] = 1.5e-6; break;
        case 5: surface.pointsOfInterest = {{1e-3, 0.0}}; break;
        case 6:
            surface.walls.pop_back();
            surface.rails[0].points[2].wall = 0;
            break;
        case 7: surface.walls.push_back({{0.0, 1e-6}, {0.0, 2.5e-6}}); break;
        case 8: surface.rails.erase(surface.rails.begin()); break;
        case 9: surface.rails.insert(surface.rails.begin(), fresh); break;
        case 10: surface.rails.insert(surface.rails.begin() + 1, fresh); break;
        case 11: surface.crown = 20e-9; break;
        default: QFAIL("no such change");
        }
        std::string text = updateCaseText(written, c);
        if (change == 6) text = replaced(text, "walls = [1, 0, 0, 0]", "walls = [1, 0, 2, 0]");
        QCOMPARE(QString::fromStdString(text), QString::fromUtf8(expected));
    }
    void aSurfaceComesIntoATextWithout()
    {
        Case c = defaultsOf(ModelKind::Film);
        c.surface.crown = 20e-9;
        c.surface.rails.push_back({RailKind::Step, {{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}}, {}});
        QCOMPARE(
            QString::fromStdString(updateCaseText("# notes\r\nmodel = 'film'\r\n", c)),
            QString("# notes\r\nmodel = 'film'\r\n\r\n[abs]\r\ncrown = \"20 nm\"\r\n\r\n[[abs.rail]]\r\nrecess = \"0 "
                    "um\"\r\n"
                    "points = [[\"0 mm\", \"0 mm\"], [\"1 mm\", \"0 mm\"], [\"0 mm\", \"1 mm\"]]\r\nwalls = 0\r\n"));
    }
    /// [abs] may follow its rails, which imply it.
    void aCrownComesToRailsWithoutATable()
    {
        const std::string text = "model = 'film'\n[[abs.rail]] # mine\npoints = [[0,0],[1e-3,0],[0,1e-3]]\n";
        Case c = parseCase(text, "").value;
        c.surface.crown = 20e-9;
        QCOMPARE(updateCaseText(text, c), text + "\n[abs]\ncrown = \"20 nm\"\n");
    }
    void anythingReadsBack_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("tables") << QByteArray::fromStdString(written);
        QTest::newRow("tables with Windows lines") << QByteArray::fromStdString(written).replace("\n", "\r\n");
        QTest::newRow("tables in lines") << QByteArray(
            "# a slider of mine\nmodel = 'film'\nabs.rail = [{ points = [[0, 0], [1e-3, 0], [0, 1e-3]] }]\n");
        QTest::newRow("no surface") << QByteArray("# a slider of mine\n");
        QTest::newRow("an empty list") << QByteArray("# a slider of mine\nabs.rail = []\n");
    }
    /// From any surface to any other the text says the new one, and keeps its first comment where it was tables.
    void anythingReadsBack()
    {
        QFETCH(QByteArray, text);
        std::mt19937 generator(23);
        std::string now = text.toStdString();
        for (int round = 0; round < 60; ++round) {
            Case c = parseCase(now, "").value;
            AirBearingSurface other = anySurface(generator);
            if (round % 3 != 0) { // a part of the surface stays
                if (!c.surface.rails.empty()) other.rails.insert(other.rails.begin(), c.surface.rails.front());
                other.walls.insert(other.walls.begin(), c.surface.walls.begin(), c.surface.walls.end());
                if (other.walls.size() > 6) other.walls.resize(6);
                for (Rail& rail : other.rails)
                    for (RailPoint& point : rail.points)
                        point.wall = std::min(point.wall, static_cast<int>(other.walls.size()));
            }
            c.surface = other;
            now = updateCaseText(now, c);
            QVERIFY(parseCase(now, "").value.surface == c.surface);
            QCOMPARE(updateCaseText(now, c), now);
            if (text.contains("[[") || round == 0)
                QVERIFY2(now.find("# a slider of mine") != std::string::npos || !text.contains("[[abs"), now.c_str());
        }
    }

    void readsAFileOfRails()
    {
        AirBearingSurface surface = parseCase(written, "").value.surface;
        surface.crown = 25e-9;
        putRails(surface);
        const auto file = path("case.toml");
        const std::string text =
            "# notes\nmodel = \"film\"\n[abs]\nrails = \"rail.dat\" # measured\ncamber = \"3 nm\"\n";
        QCOMPARE(writeCaseFile(file, text), std::string());
        const CaseDocument document = readCaseFile(file);
        QCOMPARE(problemsOf(document), QStringList());
        const Case& c = document.value;
        QVERIFY(c.surface.rails == surface.rails);
        QVERIFY(c.surface.walls == surface.walls);
        QVERIFY(c.surface.pointsOfInterest == surface.pointsOfInterest);
        QCOMPARE(c.surface.crown, 25e-9);
        QCOMPARE(c.surface.camber, 3e-9); // the case wins
        QCOMPARE(c.slider.length, 0.85e-3);
        QCOMPARE(c.slider.width, 0.70e-3);
        QCOMPARE(c.slider.thickness, 0.23e-3);

        // In its folder the text may go on naming the file.
        QCOMPARE(updateCaseText(text, c, document.folder), text);
        Case heavier = c;
        heavier.slider.mass = 1e-6;
        heavier.surface.crown = 30e-9;
        QCOMPARE(updateCaseText(text, heavier, document.folder),
                 text + "crown = \"30 nm\"\n\n[slider]\nmass = \"1 mg\"\n");
        // Elsewhere, and with other rails, the rails must stand in the text.
        QVERIFY(sameInText(updateCaseText(text, c), c));
        Case changed = c;
        changed.surface.rails.pop_back();
        const std::string own = updateCaseText(text, changed, document.folder);
        QVERIFY(sameInText(own, changed));
        QVERIFY(own.find("rail.dat") == std::string::npos && own.find("# notes") != std::string::npos);
    }
    void settingsLeaveAFileOfRailsNamed()
    {
        putRails(parseCase(written, "").value.surface);
        const auto file = path("case.toml");
        QCOMPARE(writeCaseFile(file, "model = \"film\"\n[abs]\nrails = \"rail.dat\"\n"), std::string());
        CaseDocument document = readCaseFile(file);
        applySettings(document, {"abs.crown=10 nm"});
        QCOMPARE(problemsOf(document), QStringList());
        QCOMPARE(document.text, std::string("model = \"film\"\n[abs]\nrails = \"rail.dat\"\ncrown = \"10 nm\"\n"));
    }
    void namesTheProblemOfAFileOfRails()
    {
        const auto file = path("case.toml");
        QCOMPARE(writeCaseFile(file, "model = \"film\"\n[abs]\nrails = \"rail.dat\"\n"), std::string());
        QCOMPARE(problemsOf(readCaseFile(file)),
                 QStringList(QString::fromStdString(file.string()) + ":3: abs.rails: \"rail.dat\" does not exist"));
        std::ofstream(path("rail.dat")) << "CML\n\n0.85e-3 x\n";
        const QStringList problems = problemsOf(readCaseFile(file));
        QCOMPARE(problems.size(), 1);
        QVERIFY2(problems.front().startsWith(QString::fromStdString(path("rail.dat").string()) + ":3: "),
                 qPrintable(problems.front()));
    }

private:
    static bool sameInText(const std::string& text, const Case& c)
    {
        const CaseDocument document = parseCase(text, "");
        return document.valid() && document.value.surface == c.surface &&
               document.value.slider.length == c.slider.length && document.value.slider.thickness == c.slider.thickness;
    }
    void putRails(const AirBearingSurface& surface) const
    {
        std::ofstream(path("rail.dat")) << formatCmlRails(0.85e-3, 0.70e-3, 0.23e-3, surface);
    }
    std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path(folder_->path().toStdString()) / name;
    }
    std::unique_ptr<QTemporaryDir> folder_;
};

TOUCHDOWN_TEST(TestSurfaceText)

} // namespace test_surface_text

#include "test_surface_text.moc"
