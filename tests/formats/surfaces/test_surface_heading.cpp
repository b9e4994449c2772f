// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_heading.h"

#include <QTest>

#include "core/formats/cml_text.h"
#include "tests/support/refused_line.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_heading {

using test::refusedLine;

ColumnUnits unitsOf(const std::string& text, const ColumnUnits& key = {})
{
    const MapTable table = readMapTable(text);
    return columnHeading(table, HeaderValues(table), key).units;
}

class TestSurfaceHeading : public QObject {
    Q_OBJECT

private slots:
    void columns()
    {
        const char* text = "# tip [V]\nname\nx [um] h [nm]\n0 1\n1 2\n";
        QCOMPARE(unitsOf(text), (ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(unitsOf(text, {1e-6, 1e-9}), (ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(refusedLine([&] { unitsOf(text, {1e-6, 1e-6}); }), 3);
        QCOMPARE(refusedLine([] { unitsOf("a\nx h [nm]\n0 1\n"); }), 2);
        QCOMPARE(refusedLine([] { unitsOf("0 1\n"); }), 1);
        QCOMPARE(unitsOf("# lateral_unit: um\n# height_unit: nm\nx,z\n0,1\n"), (ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(unitsOf("# x-unit: um\n# y-unit: mm\n# z-unit: nm\n0 0 1\n"), (ColumnUnits{1e-6, 1e-3, 1e-9}));
        QCOMPARE(unitsOf("# x: um, z: nm\n0 1\n"), (ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(unitsOf("height [nm]\n1\n2\n"), (ColumnUnits{1e-9}));
        QCOMPARE(unitsOf("Long Name\tPosition\tHeight\nUnits\tum\tnm\n0\t1\n"), (ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(unitsOf("x [um],z [nm]\nScan length,60um\n0,1\n"), (ColumnUnits{1e-6, 1e-9}));
    }
    // Only a heading with one cell for each column gives units; in a comment all of its words must be known. The line
    // of a unit in a sentence is named.
    void proseGivesNoUnits_data()
    {
        QTest::addColumn<int>("line");
        const auto row = [](const char* text, int line) { QTest::newRow(text) << line; };
        row("Height data, in nanometers, versus distance in micrometers\n0,1\n", 1);
        row("Roughness height (nm) as a function of track position (um)\nx,z\n0,1\n", 1);
        row("Roughness height (nm) as a function of track position (um)\n0 1\n", 1);
        row("# spot size (mm), wavelength (um)\nx,z\n0,1\n", 1);
        row("# tip height (um), tip radius (nm)\n0,1\n", 1);
        row("# left (nm), right (um)\nx,z\n0,1\n", 1);
        row("# heights in nm\nx z\n0 1\n", 1);
        row("# x in um and z in nm\n0 1\n", 1);
        row("x micro m, z nm\n0 1\n", 1);
        row("# unit: nm\n0 1\n", 1);
    }
    void proseGivesNoUnits()
    {
        QFETCH(int, line);
        const std::string text = QTest::currentDataTag();
        QCOMPARE(refusedLine([&] { unitsOf(text); }), line);
        // Beside a heading it does no harm.
        const std::size_t numbers = text.rfind('\n', text.size() - 2) + 1;
        QCOMPARE(unitsOf(text.substr(0, text.find('\n') + 1) + "x [um],z [nm]\n" + text.substr(numbers)),
                 (ColumnUnits{1e-6, 1e-9}));
    }
    void columnsInAnotherOrder()
    {
        QCOMPARE(refusedLine([] { unitsOf("h [nm] x [um]\n0 1\n"); }), 1);
        QCOMPARE(refusedLine([] { unitsOf("y [um] x [um] z [nm]\n0 1 2\n"); }), 1);
        QCOMPARE(refusedLine([] { unitsOf("z y x\n0 1 2\n", {1.0, 1.0, 1.0}); }), 1);
        QCOMPARE(unitsOf("x [um] y [nm]\n0 1\n"), (ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(unitsOf("Height profile\nx [um] h [nm]\n0 1\n"), (ColumnUnits{1e-6, 1e-9})); // a title
    }
    // A quantity that is no height is refused whatever the case gives; an unknown name is read with units of the case.
    void whatIsNoHeight()
    {
        for (const char* name : {"gap", "log10 z", "z^2", "std of z", "slope", "PSD", "counts", "z error"}) {
            const std::string heading = std::string("x (um),") + name + " (nm)\n0,1\n";
            QCOMPARE(refusedLine([&] { unitsOf(heading, {1e-6, 1e-9}); }), 1);
            QCOMPARE(refusedLine([&] { unitsOf("# " + heading); }), 1);
        }
        for (const char* heading : {"x,2*z\n0,1\n", "x\t10z\n0\t1\n", "time z\n0 1\n", "Weg;Abstand\n0;1\n"})
            QCOMPARE(refusedLine([&] { unitsOf(heading, {1e-6, 1e-9}); }), 1);
        QCOMPARE(refusedLine([&] { unitsOf("x [um],etch [nm]\n0,1\n"); }), 1);
        QCOMPARE(unitsOf("x,etch\n0,1\n", {1e-6, 1e-9}), (ColumnUnits{1e-6, 1e-9}));
    }
    void heightsThatCountDownwards()
    {
        const auto turnedBy = [](const char* heading) {
            const MapTable table = readMapTable(std::string(heading) + "\n0,1\n");
            const auto line = columnHeading(table, HeaderValues(table), {1e-6, 1e-9}).turned;
            return line ? line->line : 0;
        };
        QCOMPARE(turnedBy("x [um],depth [nm]"), 1);
        QCOMPARE(turnedBy("# x (um), -z (nm)\nDisk A"), 1);
        QCOMPARE(turnedBy("um,nm\nx,inverted z"), 2);
        QCOMPARE(turnedBy("x [um],z [nm]"), 0);
        QCOMPARE(turnedBy("x,recess"), 1);
        QCOMPARE(turnedBy("Posici\xC3\xB3n,Profundidad"), 1);
        QCOMPARE(turnedBy("x (um),(-) z (nm)"), 1);
        QCOMPARE(turnedBy("x (um),(-)height (nm)"), 1);
        QCOMPARE(turnedBy("x [um],-depth [nm]"), 0);
    }
    // Units of the case say nothing of what a column holds: a name that is not known is a doubt.
    void unknownNamesWithUnitsOfTheCase()
    {
        const auto doubts = [](const std::string& heading) {
            const MapTable table = readMapTable(heading + "\n0 1\n1 2\n");
            return columnHeading(table, HeaderValues(table), {1e-6, 1e-9}).doubts;
        };
        for (const char* heading :
             {"x etch", "x\tetch", "Posici\xC3\xB3n\tetch", "foo\tbar", "x [um] etched height [nm]"})
            QVERIFY2(!doubts(heading).empty(), heading);
        for (const char* heading : {"x z", "Weg\tH\xC3\xB6he", "Height profile", "Disk A", "um nm", "a b", "# Disk A",
                                    "x\tdepth of etch"}) // turned, which has a warning of its own
            QVERIFY2(doubts(heading).empty(), heading);
        const std::string sentence = doubts("x\tH\xC3\xB6he \xC3\xBC"
                                            "ber Glas")
                                         .front()
                                         .text;
        QVERIFY2(sentence.find("\"H\xC3\xB6he \xC3\xBC"
                               "ber Glas\"") != sentence.npos,
                 sentence.c_str());
    }
    // "x recess" right above the numbers is a heading, also where another line gives the units.
    void namesWithoutUnitsAreNoTitle()
    {
        QCOMPARE(refusedLine([] { unitsOf("x etch\num nm\n0 1\n"); }), 1);
        QCOMPARE(refusedLine([] { unitsOf("foo;bar\num;nm\n0;1\n"); }), 1);
        QCOMPARE(unitsOf("Etched glass\nx [um] z [nm]\n0 1\n"), (ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(unitsOf("x [um],z [nm]\nDisk A,etched glass\n0,1\n"), (ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(unitsOf("Tencor P-16+\nx [um] z [nm]\n0 1\n"), (ColumnUnits{1e-6, 1e-9}));
    }
    void unitsInASentenceAreNamed()
    {
        const auto message = [](const char* text) -> std::string {
            try {
                unitsOf(text);
            } catch (const CmlError& error) {
                return error.what();
            }
            return {};
        };
        QVERIFY(message("# The second column is the height in nanometres.\n0 1\n").find("nanometres") !=
                std::string::npos);
        QVERIFY(message("# Abstand 0,25 \xC2\xB5m\n0 1\n").find("\"\xC2\xB5m\"") != std::string::npos);
        QVERIFY(message("# measured in a hurry\n0 1\n").find("no unit is named") != std::string::npos);
    }
    void anIndexIsTakenOut()
    {
        for (const char* heading :
             {"index x h", "Line x h", "#;x;h", ";x;h", "\"\",x,h", "Unnamed: 0,x,h", "No.\tx\th", "# i x h"}) {
            MapTable table = readMapTable(std::string(heading) + "\n0 5 7\n1 6 8\n2 7 9\n");
            takeOutIndex(table);
            QCOMPARE(table.columns, std::size_t{2});
            QCOMPARE(table.numbers, (std::vector<double>{5, 7, 6, 8, 7, 9}));
        }
        MapTable table = readMapTable("x y h\n0 5 7\n1 6 8\n2 7 9\n");
        QCOMPARE(refusedLine([&] { takeOutIndex(table); }), 2);
        table = readMapTable("index x h\n0 5 7\n2 6 8\n3 7 9\n"); // no index
        takeOutIndex(table);
        QCOMPARE(table.columns, std::size_t{3});
    }
    void aSecondChannel()
    {
        const auto line = [](const char* text, bool matrix) {
            return refusedLine([&] { refuseSecondChannel(readMapTable(text), matrix); });
        };
        QCOMPARE(line("1 2\n# Channel: Phase\n3 4\n", false), 2);
        QCOMPARE(line("1 2\n# Width: 2 um\n", false), 2);
        QCOMPARE(line("1 2\n# x [um] h [nm]\n3 4\n", false), 2);
        QCOMPARE(line("1 2\n# a remark\n\n3 4\n", false), -1);
        QCOMPARE(line("1 2\n# a remark\n3 4\n", true), 2);
        QCOMPARE(line("1 2\n3 4\n\n3 4\n", true), 3);
        QCOMPARE(line("1 2\n\n3 4\n\n3 4\n\n", true), -1);
    }
};

TOUCHDOWN_TEST(TestSurfaceHeading)

} // namespace test_surface_heading

#include "test_surface_heading.moc"
