// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_rail_file.h"

#include <QTest>

#include <limits>
#include <random>

#include "core/formats/quotation.h"
#include "tests/support/cml_sample.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cml_rail_file {

CmlRails read(const std::string& text) { return readCmlRails(text, "rail.dat"); }

std::string firstProblem(const CmlRails& rails)
{
    return rails.valid() ? std::string() : rails.problems.front().text();
}

class TestCmlRailFile : public QObject {
    Q_OBJECT

private slots:
    void theSampleSaysItsSurface()
    {
        const CmlRails rails = read(cmlRailText());
        QCOMPARE(firstProblem(rails), std::string());
        QVERIFY(rails.warnings.empty());
        QCOMPARE(rails.length, 1.25e-3);
        QCOMPARE(rails.width, 1e-3);
        QCOMPARE(rails.thickness, 3e-4);
        QVERIFY(rails.surface == cmlSurface());
        QCOMPARE(rails.railLines, (std::vector<int>{5, 11, 17}));
        QCOMPARE(rails.wallLines, (std::vector<int>{25, 27}));
        QCOMPARE(rails.lines.at("abs.camber"), 30);
    }

    void otherSpellings_data()
    {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, const std::string& text) {
            QTest::newRow(name) << QByteArray::fromStdString(text);
        };
        const std::string text = cmlRailText();
        row("Windows line ends", withLineEnds(text, "\r\n"));
        row("old Macintosh line ends", withLineEnds(text, "\r"));
        row("no last line end", text.substr(0, text.size() - 1));
        row("blank lines at the end", text + " \n\n \n");
        row("blank lines between", withLineEnds(text.substr(text.find("1.25")), "\n\n").insert(0, "CML\n\n"));
        row("Latin-1 in the header", replaced(text, "a slider", "pad of 5 \xb5m, M\xfcller"));
        row("Fortran's double precision", replaced(text, "1.2500E-003", "1.25D-3"));
        row("numbers broken over lines", withLine(text, 3, "1.25E-3\n1E-3\n3E-4"));
        row("a point broken over lines", withLine(text, 6, "1.0E-4\n2.0E-4\n1"));
        row("two points on one line", replaced(text, "1             \n4.0000E-004      8", "1 4.0000E-004      8"));
        row("commas", replaced(text, "4.0000E-004      2.0000E-004      1", "4.0E-004,2.0E-004, 1"));
        row("remarks behind the numbers", withLine(text, 6, "1.0E-4 2.0E-4 1 ! first corner"));
        row("a profile broken over lines", withLine(text, 25, "-1.0E-6 \n 0.0\n 2.0E-6"));
        row("points of interest broken over lines", withLine(text, 32, "5.0E-4\n4.5E-4"));
    }
    void otherSpellings()
    {
        QFETCH(QByteArray, text);
        const CmlRails rails = read(text.toStdString());
        QCOMPARE(firstProblem(rails), std::string());
        QVERIFY(rails.surface == cmlSurface());
        QVERIFY(rails.warnings.empty());
    }

    void whatIsNotThere()
    {
        const CmlRails noPoints = read(firstLines(cmlRailText(), 30));
        QCOMPARE(firstProblem(noPoints), std::string());
        QVERIFY(noPoints.surface.pointsOfInterest.empty());

        const CmlRails plane = read("CML\n-\n1e-3 1e-3 3e-4\n0 0\n0 0 0\n0 0 0\n");
        QCOMPARE(firstProblem(plane), std::string());
        QVERIFY(plane.surface.rails.empty());
        QCOMPARE(plane.surface.baseRecess, 0.0);
    }

    void warnings_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("warning");
        const std::string text = cmlRailText();
        const auto row = [](const char* name, const std::string& changed, const char* warning) {
            QTest::newRow(name) << QByteArray::fromStdString(changed) << QByteArray(warning);
        };
        row("a number too many", withLine(text, 4, "3 2 5"),
            "rail.dat:4: more numbers than are needed; the last ones are not used");
        row("a wall that does not exist", withLine(text, 7, "4.0E-4 2.0E-4 3"),
            "rail.dat:7: wall profile 3 does not exist; the edge is taken as vertical");
        row("words at the end", text + "drawn by hand\n", "rail.dat:32: text after the last number is not used");
    }
    void warnings()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, warning);
        const CmlRails rails = read(text.toStdString());
        QCOMPARE(firstProblem(rails), std::string());
        QCOMPARE(rails.warnings.size(), std::size_t(1));
        QCOMPARE(QByteArray::fromStdString(rails.warnings.front().text()), warning);
    }

    void malformed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem");
        const std::string text = cmlRailText();
        const auto row = [](const char* name, const std::string& changed, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(changed) << QByteArray(problem);
        };
        row("empty", "", "rail.dat: is empty");
        row("blank", " \r\n\n", "rail.dat: is empty");
        row("no header", text.substr(text.find("1.25")),
            "rail.dat:1: two lines of text are needed before the first number");
        row("one header line", text.substr(text.find("a slider")),
            "rail.dat:2: two lines of text are needed before the first number");
        row("cut after the header", firstLines(text, 2),
            "rail.dat:2: the file ends where the slider's length is needed");
        row("cut after the size", firstLines(text, 3), "rail.dat:3: the file ends where the number of rails is needed");
        row("cut before a rail", firstLines(text, 4),
            "rail.dat:4: rail 1: the file ends where the number of points is needed");
        row("cut inside a rail", firstLines(text, 7), "rail.dat:7: rail 1: the file ends where x of a point is needed");
        row("cut before a recess", firstLines(text, 9), "rail.dat:9: rail 1: the file ends where the recess is needed");
        row("cut before the walls", firstLines(text, 23),
            "rail.dat:23: the file ends where the number of points of a wall profile is needed");
        row("cut inside the walls", firstLines(text, 25),
            "rail.dat:25: wall profile 1: the file ends where a recess is needed");
        row("cut before the taper", firstLines(text, 28),
            "rail.dat:28: the file ends where the taper length is needed");
        row("cut before the crown", firstLines(text, 29), "rail.dat:29: the file ends where the crown is needed");
        row("cut inside a number", text.substr(0, text.find("-003      1.0000")) + "-",
            "rail.dat:3: the slider's length must be "
            "a number, not \"1.2500E-\"");
        row("cut before the points' y", firstLines(text, 31) + "5.0E-4",
            "rail.dat:32: the points of interest need as many y as x");
        row("an odd number of points of interest", firstLines(text, 31) + "5.0E-4 4.5E-4 1e-4",
            "rail.dat:32: the points of interest need as many y as x");
        row("a word for a length", withLine(text, 3, "long wide thick"),
            "rail.dat:3: the slider's length must be a number, not \"long\"");
        row("a word for a coordinate", withLine(text, 7, "4.0E-4 two 1"),
            "rail.dat:7: rail 1: y of a point must be a number, not \"two\"");
        row("a word for a count", withLine(text, 5, "four 1"),
            "rail.dat:5: rail 1: the number of points must be a number, not \"four\"");
        row("not a number", withLine(text, 30, "NaN 0 0"), "rail.dat:30: the crown must be a number, not \"NaN\"");
        row("infinite", withLine(text, 29, "5e-5 1e-2 inf"),
            "rail.dat:29: the base recess must be a number, not \"inf\"");
        row("too large for a double", withLine(text, 10, "1e999"),
            "rail.dat:10: rail 1: the recess must be a number, not \"1e999\"");
        row("no length", withLine(text, 3, "0 1e-3 3e-4"),
            "rail.dat:3: the slider's length: 0 mm is out of range: allowed is greater than 0 mm, at most 0.1 m");
        row("negative width", withLine(text, 3, "1e-3 -1e-3 3e-4"),
            "rail.dat:3: the slider's width: -1 mm is out of range: allowed is greater than 0 mm, at most 0.1 m");
        row("a length in millimetres", withLine(text, 12, "0.5 300 0"),
            "rail.dat:12: rail 2: y of a point is 300, which is too large; a count above it may be wrong");
        row("a point too few", withLine(text, 5, "5 1"),
            "rail.dat:11: rail 1: y of a point is 4, which is too large; a count above it may be wrong");
        row("a point too many", withLine(text, 5, "3 1"),
            "rail.dat:10: rail 2: the number of points must be a whole number from 3 to 10000, not \"1.5000E-007\"");
        row("a rail too few", withLine(text, 4, "2 2"),
            "rail.dat:17: the number of points of a wall profile must be a whole number from 2 to 1000, not \"1\"");
        row("a rail too many", withLine(text, 4, "4 2"),
            "rail.dat:24: rail 4: the type (1 step, 0 ramp) must be a whole number from 0 to 1, not \"2\"");
        row("two billion rails", withLine(text, 4, "2000000000 2"),
            "rail.dat:4: the number of rails must be a whole number from 0 to 1000, not \"2000000000\"");
        row("two billion points", withLine(text, 5, "2000000000 1"),
            "rail.dat:5: rail 1: the number of points must be a whole number from 3 to 10000, not \"2000000000\"");
        row("two billion profiles", withLine(text, 4, "3 2000000000"),
            "rail.dat:4: the number of wall profiles must be a whole number from 0 to 1000, not \"2000000000\"");
        row("two billion points of a profile", withLine(text, 24, "2000000000 2"),
            "rail.dat:24: the number of points of a wall profile must be a whole number from 2 to 1000, not "
            "\"2000000000\"");
        row("ten thousand points that are not there", withLine(text, 5, "10000 1"),
            "rail.dat:11: rail 1: y of a point is 4, which is too large; a count above it may be wrong");
        row("a negative count", withLine(text, 4, "-3 2"),
            "rail.dat:4: the number of rails must be a whole number from 0 to 1000, not \"-3\"");
        row("half a rail", withLine(text, 4, "2.5 2"),
            "rail.dat:4: the number of rails must be a whole number from 0 to 1000, not \"2.5\"");
        row("a rail of two points", withLine(text, 5, "2 1"),
            "rail.dat:5: rail 1: the number of points must be a whole number from 3 to 10000, not \"2\"");
        row("an unknown type", withLine(text, 5, "4 2"),
            "rail.dat:5: rail 1: the type (1 step, 0 ramp) must be a whole number from 0 to 1, not \"2\"");
        row("a negative wall", withLine(text, 6, "1e-4 2e-4 -1"),
            "rail.dat:6: rail 1: the wall profile of a point must be a whole number from 0 to 1000, not \"-1\"");
        row("a ramp with one recess", withLine(text, 16, "4e-7"),
            "rail.dat:17: rail 2: the recess at the second point is 5, which is too large; a count above it may be "
            "wrong");
        row("zero bytes", replaced(text, "1.5000E-007", std::string_view("1.5\0 ", 5)),
            "rail.dat:10: holds bytes that no text holds; it may be a binary file");
        row(
            "UTF-16",
            "\xff\xfe" +
                [&] {
                    std::string wide;
                    for (const char c : text) wide += {c, '\0'};
                    return wide;
                }(),
            "rail.dat:1: holds bytes that no text holds; it may be a binary file");
    }
    void malformed()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        const CmlRails rails = read(text.toStdString());
        QCOMPARE(rails.problems.size(), std::size_t(1));
        QCOMPARE(QByteArray::fromStdString(rails.problems.front().text()), problem);
    }

    void cutAnywhereItIsReadOrRefusedWithALine()
    {
        const std::string text = cmlRailText();
        const std::size_t complete = text.find(" 1.2400E-003  1.2000E-003"); // all but the points of interest
        for (std::size_t size = 1; size < text.size(); ++size) {
            const CmlRails rails = read(text.substr(0, size));
            // Without its last digits a number is another number, or none.
            if (size < complete - 20) QVERIFY2(!rails.valid(), std::to_string(size).c_str());
            for (const InputProblem& problem : rails.problems) {
                QVERIFY2(problem.line > 0, std::to_string(size).c_str());
                QVERIFY(!problem.message.empty());
            }
        }
    }
    void tooManyPointsInAll()
    {
        std::string text = "CML\n-\n1e-3 1e-3 3e-4\n11 0\n";
        for (int rail = 0; rail < 11; ++rail) {
            text += "10000 1\n";
            for (int i = 0; i < 10000; ++i) text += "0 0 0\n";
            text += "0\n";
        }
        QCOMPARE(firstProblem(read(text)), std::string("rail.dat:100025: rail 11: more than 100000 points in all"));
    }
    void noiseIsRefused()
    {
        std::mt19937 generator(7);
        std::uniform_int_distribution<int> byte(0, 255);
        for (int round = 0; round < 200; ++round) {
            std::string noise(1 + 20 * static_cast<std::size_t>(round), '\0');
            for (char& c : noise) c = static_cast<char>(byte(generator));
            const CmlRails rails = read(noise);
            QVERIFY(!rails.valid());
            QVERIFY(findInvalidUtf8(rails.problems.front().message) == std::string::npos);
        }
    }
    /// Bytes of a good file that change: what is read must stay within the limits, what is not must be told.
    void damagedFilesDoNoHarm()
    {
        std::mt19937 generator(11);
        const std::string text = cmlRailText();
        std::uniform_int_distribution<std::size_t> place(0, text.size() - 1);
        static constexpr std::string_view bytes = "0123456789 \n.-+eED,*a\xb5\r\t";
        std::uniform_int_distribution<std::size_t> letter(0, bytes.size() - 1);
        int refused = 0;
        for (int round = 0; round < 3000; ++round) {
            std::string damaged = text;
            for (int i = 0; i < 3; ++i) damaged[place(generator)] = bytes[letter(generator)];
            const CmlRails rails = read(damaged);
            if (!rails.valid()) {
                ++refused;
                QVERIFY(rails.problems.front().line > 0);
                continue;
            }
            const std::string again = formatCmlRails(rails.length, rails.width, rails.thickness, rails.surface);
            QVERIFY2(read(again).surface == rails.surface, damaged.c_str());
        }
        QVERIFY(refused > 100);
        QVERIFY(refused < 2900);
    }

    void roundTripOfAnyNumbers()
    {
        std::mt19937 generator(3);
        const auto whole = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator); };
        const auto number = [&] {
            return std::uniform_real_distribution<double>(-1.0, 1.0)(generator) * std::pow(10.0, whole(-12, -3));
        };
        for (int round = 0; round < 300; ++round) {
            AirBearingSurface s;
            s.walls.resize(static_cast<std::size_t>(whole(0, 4)));
            for (WallProfile& wall : s.walls) {
                const auto count = static_cast<std::size_t>(whole(2, 9));
                for (std::size_t i = 0; i < count; ++i) {
                    wall.distance.push_back(number());
                    wall.recess.push_back(number());
                }
            }
            s.rails.resize(static_cast<std::size_t>(whole(0, 6)));
            for (Rail& rail : s.rails) {
                rail.kind = whole(0, 1) == 0 ? RailKind::Step : RailKind::Ramp;
                rail.points.resize(static_cast<std::size_t>(whole(3, 12)));
                for (RailPoint& p : rail.points) p = {number(), number(), whole(0, static_cast<int>(s.walls.size()))};
                rail.recess[0] = number();
                if (rail.kind == RailKind::Ramp) rail.recess = {number(), number(), number()};
            }
            s.baseRecess = number();
            s.crown = number();
            s.camber = number();
            s.twist = number();
            s.taperLength = std::abs(number());
            s.taperAngle = std::abs(number());
            s.pointsOfInterest.resize(static_cast<std::size_t>(whole(0, 100)));
            for (SurfacePoint& p : s.pointsOfInterest) p = {number(), number()};
            const double length = std::abs(number()), width = std::abs(number()), thickness = std::abs(number());

            const CmlRails rails = read(formatCmlRails(length, width, thickness, s));
            QCOMPARE(firstProblem(rails), std::string());
            QVERIFY(rails.warnings.empty());
            QVERIFY(rails.surface == s);
            QCOMPARE(rails.length, length);
            QCOMPARE(rails.width, width);
            QCOMPARE(rails.thickness, thickness);
        }
    }
    void theFormatIsThatOfTheEstablishedProgram()
    {
        const QByteArray text = QByteArray::fromStdString(formatCmlRails(1.25e-3, 1e-3, 3e-4, cmlSurface()));
        const QList<QByteArray> lines = text.split('\n');
        QVERIFY(lines[0].startsWith("CML Version 7.0"));
        QCOMPARE(lines[2].simplified(), QByteArray("0.00125 0.001 0.0003"));
        QCOMPARE(lines[3].simplified(), QByteArray("3 2"));
        QCOMPARE(lines[4].simplified(), QByteArray("4 1"));
        QCOMPARE(lines[5].simplified(), QByteArray("0.0001 0.0002 1"));
        QCOMPARE(lines[15].simplified(), QByteArray("4e-7 2e-7 2e-7"));
        QCOMPARE(lines[31].simplified(), QByteArray("0.0005 0.00045"));
        QCOMPARE(text.count("\r\n"), text.count('\n'));
    }
};

TOUCHDOWN_TEST(TestCmlRailFile)

} // namespace test_cml_rail_file

#include "test_cml_rail_file.moc"
