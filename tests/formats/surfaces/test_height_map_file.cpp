// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/height_map_file.h"

#include <sys/resource.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#include "core/formats/text_file.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_height_map_file {

/// In metres where the text names no unit.
HeightMapDocument read(const std::string& text, const std::string& name = "map.txt")
{
    const bool plain = name == "map.txt" && text.find_first_of("[(:") == std::string::npos;
    return readHeightMapText(text, name, plain ? "m" : "");
}

std::string problemsOf(const HeightMapDocument& document)
{
    std::string all;
    for (const InputProblem& problem : document.problems) all += (all.empty() ? "" : " | ") + problem.text();
    return all;
}

bool near(const std::vector<double>& a, const std::vector<double>& b)
{
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (std::abs(a[i] - b[i]) > 1e-12 * std::max(std::abs(a[i]), std::abs(b[i]))) return false;
    return true;
}

const std::vector<double> fourHeights{1e-9, 2e-9, 0.5e-9, -1e-9};

class TestHeightMapFile : public QObject {
    Q_OBJECT

private slots:
    void aProfileInManySpellings_data()
    {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, const char* text) { QTest::newRow(name) << QByteArray(text); };
        row("metres", "0 1e-9\n1e-6 2e-9\n2e-6 0.5e-9\n3e-6 -1e-9\n");
        row("Windows, tabs, no last line end", "0\t1e-9\r\n1e-6\t2e-9\r\n2e-6\t0.5e-9\r\n3e-6\t-1e-9");
        row("commas", "0, 1e-9\n1e-6, 2e-9\n2e-6, 0.5e-9\n3e-6, -1e-9\n");
        row("semicolons and empty lines", "0;1e-9\n\n1e-6;2e-9\n2e-6;0.5e-9\n3e-6;-1e-9\n\n");
        row("Fortran", "  0.0D0 1.0D-9\n 1.0D-06 2.0D-09\n 2.0-006 5.0-010\n 3.0d-6 -1.0d-9\n");
        row("units in a heading", "x [um] h [nm]\n0 1\n1 2\n2 .5\n3 -1\n");
        row("units in a comment", "# from the profiler\n# x (mm)\th (nm)\n0 1\n.001 2\n.002 .5\n.003 -1\n");
        row("a micro sign of Latin-1", "x [\xB5m] h [nm]\n0 1\n1 2\n2 .5\n3 -1\n");
        row("a micro sign of UTF-8", "x [\xC2\xB5m] h [nm]\n0 1\n1 2\n2 .5\n3 -1\n");
        row("comments between", "0 1e-9\n# here\n1e-6 2e-9\n% and\n2e-6 0.5e-9\n! there\n3e-6 -1e-9\n// end\n");
        row("another origin", "-5e-6 1e-9\n-4e-6 2e-9\n-3e-6 0.5e-9\n-2e-6 -1e-9\n");
        row("places as printed", "0.00e0 1e-9\n1.01e-6 2e-9\n2.00e-6 0.5e-9\n3.00e-6 -1e-9\n");
    }
    void aProfileInManySpellings()
    {
        QFETCH(QByteArray, text);
        const HeightMapDocument document = read(text.toStdString());
        QCOMPARE(problemsOf(document), std::string());
        QCOMPARE(document.map.nx, 4);
        QCOMPARE(document.map.ny, 1);
        QVERIFY(std::abs(document.map.dx - 1e-6) < 1e-18);
        QVERIFY(near(document.map.heights, fourHeights));
        QVERIFY(!document.map.closedX);
    }

    void aMapOfPoints_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("lines along x") << QByteArray(
            "x[um] y[um] h[nm]\n0 0 1\n1 0 2\n2 0 3\n3 0 4\n0 2 5\n1 2 6\n2 2 7\n3 2 8\n");
        QTest::newRow("lines along y") << QByteArray(
            "x[um] y[um] h[nm]\n0 0 1\n0 2 5\n1 0 2\n1 2 6\n2 0 3\n2 2 7\n3 0 4\n3 2 8\n");
        QTest::newRow("a matrix") << QByteArray(
            "# Channel: Topography\n# Width: 4.0 um\n# Height: 4 \xC2\xB5m\n# Value units: nm\n"
            "1 2 3 4\n5 6 7 8\n");
    }
    void aMapOfPoints()
    {
        QFETCH(QByteArray, text);
        const HeightMapDocument document = read(text.toStdString());
        QCOMPARE(problemsOf(document), std::string());
        QCOMPARE(document.map.nx, 4);
        QCOMPARE(document.map.ny, 2);
        QVERIFY(std::abs(document.map.dx - 1e-6) < 1e-18);
        QVERIFY(std::abs(document.map.dy - 2e-6) < 1e-18);
        QVERIFY(near(document.map.heights, {1e-9, 2e-9, 3e-9, 4e-9, 5e-9, 6e-9, 7e-9, 8e-9}));
    }

    void theEstablishedProgramsFile()
    {
        // Lines x h1 h2, then the two y.
        const HeightMapDocument map = read("0 1 5\n1e-6 2 6\n2e-6 3 7\n3e-6 4 8\n0 2e-6\n", "wave.def");
        QCOMPARE(problemsOf(map), std::string());
        QCOMPARE(map.map.nx, 4);
        QCOMPARE(map.map.ny, 2);
        QVERIFY(std::abs(map.map.dy - 2e-6) < 1e-18);
        QVERIFY(near(map.map.heights, {1e-9, 2e-9, 3e-9, 4e-9, 5e-9, 6e-9, 7e-9, 8e-9}));

        const HeightMapDocument profile = read("0 1\n1e-6 2\n2e-6 .5\n3e-6 -1\n0\n", "WAVE.DEF");
        QCOMPARE(problemsOf(profile), std::string());
        QCOMPARE(profile.map.ny, 1);
        QVERIFY(near(profile.map.heights, fourHeights));
        // Its units are fixed.
        const std::string text = "0 1\n1e-6 2\n2e-6 .5\n3e-6 -1\n0\n";
        QVERIFY(near(readHeightMapText(text, "wave.def", "m, nm").map.heights, fourHeights));
        QVERIFY(!readHeightMapText(text, "wave.def", "um, nm").valid());
        QCOMPARE(read("0 1\n1e-6 2\n2e-6 -9999\n3e-6 -1\n0\n", "wave.def").problems.front().line, 3);
    }

    void aMapThatClosesLosesItsLastPoint()
    {
        const HeightMapDocument document = read("0 1\n1 2\n2 3\n3 2\n4 1\n");
        QVERIFY(document.map.closedX);
        QCOMPARE(document.map.nx, 4);
        QVERIFY(near(document.map.heights, {1, 2, 3, 2}));
    }

    void whatIsNoSurfaceIsRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("problem");
        const auto row = [](const char* title, const char* text, const char* problem, const char* name = "map.txt") {
            QTest::newRow(title) << QByteArray(text) << QByteArray(name) << QByteArray(problem);
        };
        const char* empty =
            "map.txt: holds no numbers; a profile has two columns, x and height, and a map three, x, y and height";
        row("nothing", "", empty);
        row("words alone", "this is\nno map\n", empty);
        row("a hole", "0 1\n1 NaN\n2 3\n3 4\n",
            "map.txt:2: a surface has no holes: every height must be a number, not \"NaN\"");
        row("a hole in the first line", "nan 1\n1 2\n",
            "map.txt:1: a surface has no holes: every height must be a number, not \"nan\"");
        row("a hole of a matrix", "# Width: 1 um\n# Height: 1 um\n1 2 3 4\n1 -- 3 4\n",
            "map.txt:4: a surface has no holes: every height must be a number, not \"--\"");
        row("a word among numbers", "0 1\n1 two\n", "map.txt:2: a line of numbers is needed, not \"two\"");
        row("a missing number", "0 1\n1\n2 3\n3 4\n",
            "map.txt:2: has 1 number, the lines before it 2; a surface has no holes: every line must be complete");
        row("a missing number at the end", "0 1\n1 2\n2 3\n3\n",
            "map.txt:4: has 1 number, the lines before it 2; a surface has no holes: every line must be complete");
        row("a missing point of a profile", "0 1\n1 2\n2 3\n3 4\n5 5\n6 6\n",
            "map.txt:5: x must ascend in equal steps, without gaps: 5 m stands where 4 m is needed");
        row("steps that grow", "0 1\n1 2\n2.1 3\n3.3 4\n4.6 5\n",
            "map.txt:2: x must ascend in equal steps, without gaps: 1 m stands where 1.15 m is needed");
        row("x that turns back", "0 1\n1 2\n0.5 3\n3 4\n", "map.txt:3: x must ascend: 0.5 m comes after 1 m");
        row("a point twice", "0 1\n1 2\n1 3\n2 4\n", "map.txt:3: x must ascend: 1 m comes after 1 m");
        row("a missing point of a map", "0 0 1\n1 0 2\n2 0 3\n3 0 4\n0 1 1\n2 1 3\n3 1 4\n0 2 1\n1 2 1\n2 2 1\n3 2 1\n",
            "map.txt:6: a map has no holes: the point x = 1 m, y = 1 m is missing before this one");
        row("a map that ends early", "0 0 1\n1 0 2\n2 0 3\n3 0 4\n0 1 1\n1 1 3\n",
            "map.txt:6: a map has no holes: its last line ends after 2 of 4 points");
        row("too short", "0 1\n1 2\n2 3\n", "map.txt: a surface needs at least 4 points along the track, not 3");
        row("one point", "0 1\n", "map.txt:1: there must be two or more different x");
        row("columns without sense", "1 2 3 4\n5 6 7 8\n",
            "map.txt:1: has 4 numbers; a profile has two columns, x and height, a map three, x, y and height, and a "
            "matrix of "
            "heights needs the comments \"# Width: 10 um\" and \"# Height: 5 um\" before it; heights alone "
            "need \"# Spacing: 0.5 um\"");
        row("a matrix of no size", "# Width: 0 um\n# Height: 1 um\n1 2 3 4\n",
            "map.txt:1: Width must be a length above 0 with its unit, as \"10 um\", not \"0 um\"");
        row("a matrix of seconds", "# Width: 3 um\n# Height: 1 um\n# Value units: s\n1 2 3 4\n",
            "map.txt:3: names the unit \"s\", which is not clearly one of length, as \"nm\"");
        row("no y in wave.def", "0 1 5\n1e-6 2 6\n2e-6 3 7\n",
            "wave.def:3: the last line must hold only the y [m] of each profile, 2 numbers", "wave.def");
        row("too few y in wave.def", "0 1 5 6\n1e-6 2 6 7\n2e-6 3 7 8\n0 1e-6\n",
            "wave.def:4: the last line must hold the y [m] of each profile, 3 numbers, not 2", "wave.def");
        row("y of wave.def that fall", "0 1 5\n1 2 6\n2 3 7\n3 3 7\n1 0\n",
            "wave.def:5: y must ascend: 0 m comes after 1 m", "wave.def");
        row("a binary file",
            "\x7f"
            "ELF\x01\x02",
            "map.txt:1: holds bytes that no text holds; it may be a binary file");
    }
    void whatIsNoSurfaceIsRefused()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, problem);
        QCOMPARE(problemsOf(read(text.toStdString(), name.toStdString())), problem.toStdString());
    }

    void filesAreReadByTheirEnding()
    {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString();
        QCOMPARE(problemsOf(readHeightMap(path / "none.txt", "none.txt")), std::string("none.txt: does not exist"));
        QCOMPARE(problemsOf(readHeightMap(path / "none.h5", "none.h5")), std::string("none.h5: does not exist"));
        QCOMPARE(problemsOf(readHeightMap(path, "folder")), std::string("folder: is a directory, not a file"));
        QCOMPARE(writeTextFile(path / "a.txt", "x [m] h [m]\n0 1\n1 2\n2 3\n3 4\n"), std::string());
        QCOMPARE(readHeightMap(path / "a.txt", "a.txt").map.nx, 4);
        QCOMPARE(writeTextFile(path / "wave.def", "0 1\n1 2\n2 3\n3 4\n0\n"), std::string());
        QVERIFY(near(readHeightMap(path / "wave.def", "wave.def").map.heights, {1e-9, 2e-9, 3e-9, 4e-9}));
        QCOMPARE(writeTextFile(path / "a.h5", "0 1\n1 2\n"), std::string());
        QVERIFY(problemsOf(readHeightMap(path / "a.h5", "a.h5")).starts_with("a.h5: cannot be read as HDF5: "));
    }

    // Whatever is cut off or mixed up in a file, it is read as a map of finite heights or refused with a sentence.
    void nothingBreaksIt()
    {
        const std::string whole = "x [um] y [um] h [nm]\n0 0 1\n1 0 2\n2 0 3\n3 0 4\n0 2 5\n1 2 6\n2 2 7\n3 2 8\n";
        for (std::size_t i = 0; i < whole.size(); ++i)
            for (const char c : {'\0', '-', '9', ' ', '\n', 'x', '[', '.', '\xB5'})
                for (const char* name : {"map.txt", "wave.def"}) {
                    std::string text = whole;
                    if (c == '\0')
                        text.resize(i);
                    else
                        text[i] = c;
                    const HeightMapDocument document = read(text, name);
                    if (!document.valid()) continue;
                    const HeightMap& map = document.map;
                    QVERIFY(map.nx > 0 && map.ny > 0 && map.dx > 0.0 && std::isfinite(map.dx));
                    QCOMPARE(map.heights.size(), static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny));
                    for (const double h : map.heights) QVERIFY(std::isfinite(h));
                }
    }

    // Where a surface was turned or refused, no warning says that its name changed nothing.
    void oneWarningOfATurnedSurface()
    {
        const std::string rows = "0,1\n1,2\n2,.5\n3,-1\n";
        const std::string matrix = "# Width: 8 um\n# Height: 6 um\n# unit: nm\n1 2 5 3\n2 7 1 4\n4 1 2 3\n3 5 1 2\n";
        for (const std::string& text : {"x (um),pit depth (nm)\n" + rows, "x (um),height below the glass (nm)\n" + rows,
                                        "x (um),(-) z (nm)\n" + rows, "# Channel: Depth\n" + matrix,
                                        "# Channel: ZSensor (inverted)\n" + matrix}) {
            const HeightMapDocument document = read(text);
            QVERIFY2(document.valid(), text.c_str());
            QCOMPARE(document.warnings.size(), std::size_t{1});
            QVERIFY(document.warnings.front().text().find("turned") != std::string::npos);
        }
        for (const char* name :
             {"z\xC2\xB2", "Varianz", "Standardabweichung", "\xCE\x94z", "dz/dx", "lubricant thickness"}) {
            const HeightMapDocument document = read("x (um)," + std::string(name) + " (nm)\n" + rows);
            QVERIFY2(!document.valid() && document.warnings.empty(), name);
        }
    }
    void remarksThatWereNotUsedAreQuoted()
    {
        const HeightMapDocument document =
            read("# pits are positive\n# operator: Ann\nx (um),z (nm)\n0,1\n1,2\n2,.5\n3,-1\n# z in pm\n");
        QVERIFY(document.valid());
        QCOMPARE(document.warnings.size(), std::size_t{2});
        QVERIFY(document.warnings[0].text().find("\"pits are positive\"") != std::string::npos);
        QCOMPARE(document.warnings[1].line, 8);
    }

    // Places beside the heights of a matrix: a first row or column in equal steps.
    void placesInAMatrixAreRefused()
    {
        const std::string size = "# Width: 8 um\n# Height: 6 um\n# unit: nm\n";
        QVERIFY(read(size + "1 2 5 3\n2 7 1 4\n4 1 2 3\n3 5 1 2\n").valid());
        QVERIFY(!read(size + "0 2 5 3\n.5 7 1 4\n1 1 2 3\n1.5 5 1 2\n").valid());
        QVERIFY(!read(size + "0 2 4 6\n2 7 1 4\n4 1 2 3\n3 5 1 2\n").valid());
    }

    // A line of a million words or commas is looked at once.
    void longHeadings()
    {
        std::string words, commas;
        for (int i = 0; i < 1'000'000; ++i) {
            words += "x [um] ";
            commas += "a,b;";
        }
        const std::string text = words + "\n# " + words + "\n" + commas + "\nx [um] h [nm]\n0 1\n1 2\n2 .5\n3 -1\n";
        QVERIFY(near(read(text).map.heights, fourHeights));
    }

    // Of 1 GiB, the first 64 KiB tell that it is no text.
    void aGigabyteOfZerosIsNotRead()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("zeros.txt").toStdString();
        QCOMPARE(writeTextFile(file, "x"), std::string());
        std::filesystem::resize_file(file, std::uintmax_t(1) << 30);
        const auto memory = [] {
            rusage used{};
            getrusage(RUSAGE_SELF, &used);
            return used.ru_maxrss; // [KiB]
        };
        const long before = memory();
        QCOMPARE(problemsOf(readHeightMap(file, "zeros.txt")),
                 std::string("zeros.txt: holds bytes that no text holds; it may be a binary file"));
        QVERIFY2(memory() - before < 20'000, qPrintable(QString::number(memory() - before)));
    }

    // The distance of the points has its unit; no other unit along the track is needed.
    void heightsAloneNeedNoLateralUnit()
    {
        const HeightMapDocument document =
            readHeightMapText("# Spacing: 0.5 um\n# height_unit: nm\n1\n3\n2\n5\n4\n", "heights.txt");
        QVERIFY2(document.valid(), document.valid() ? "" : document.problems[0].text().c_str());
        QCOMPARE(document.map.nx, 5);
        QVERIFY(std::abs(document.map.dx - 0.5e-6) < 1e-18 && std::abs(document.map.heights[3] - 5e-9) < 1e-20);
    }
};

TOUCHDOWN_TEST(TestHeightMapFile)

} // namespace test_height_map_file

#include "test_height_map_file.moc"
