// SPDX-License-Identifier: GPL-3.0-or-later
//
// One profile and one map as instruments and people write them: read right within 0.5 %, or refused with the line.
#include "core/formats/surfaces/height_map_file.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_spellings {

constexpr int nx = 40, mapX = 12, mapY = 6;
constexpr double um = 1e-6, nm = 1e-9;

/// x = 0, 0.25 um, ...; h = 2.5 nm + 1.5 nm sin(2 pi x/4 um).
double profileHeight(int i) { return 2.5 * nm + 1.5 * nm * std::sin(2.0 * std::numbers::pi * 0.25 * i / 4.0); }
/// Points 1 um apart; rows that all differ.
double mapHeight(int i, int j) { return 2.5 * nm + 1.5 * nm * std::sin(0.5 * i) + 0.2 * nm * j; }

/// How numbers are written.
struct Style {
    double x = um, h = nm; // units [m]
    QByteArray separator = "\t";
    bool comma = false, quotes = false;
    QByteArray end = "\n";

    QByteArray cell(double v) const
    {
        QByteArray text = QByteArray::number(v, 'f', 4);
        if (std::abs(v) < 1e-2 && v != 0.0) text = QByteArray::number(v, 'e', 6);
        if (comma) text.replace('.', ',');
        return quotes ? '"' + text + '"' : text;
    }
    QByteArray row(const std::vector<double>& values) const
    {
        QByteArray line;
        for (const double v : values) line += (line.isEmpty() ? QByteArray() : separator) + cell(v);
        return line + end;
    }
};

QByteArray profile(const QByteArray& heading, const Style& style = {})
{
    QByteArray text = heading;
    for (int i = 0; i < nx; ++i) text += style.row({0.25 * um * i / style.x, profileHeight(i) / style.h});
    return text;
}
Style in(double x, double h, const char* separator = "\t") { return {x, h, separator, false, false, "\n"}; }
Style decimalCommas(const char* separator = "\t", bool quotes = false)
{
    return {um, nm, separator, true, quotes, "\n"};
}

/// `place` gives the points in the order of the file.
QByteArray points(const QByteArray& heading, const std::function<std::pair<int, int>(int)>& place)
{
    QByteArray text = heading;
    for (int k = 0; k < mapX * mapY; ++k) {
        const auto [i, j] = place(k);
        text += Style{}.row({1.0 * i, 1.0 * j, mapHeight(i, j) / nm});
    }
    return text;
}
QByteArray matrix(const QByteArray& heading, const Style& style = {}, const QByteArray& between = {})
{
    QByteArray text = heading;
    for (int j = 0; j < mapY; ++j) {
        std::vector<double> row;
        for (int i = 0; i < mapX; ++i) row.push_back(mapHeight(i, j) / style.h);
        text += (j > 0 ? between : QByteArray()) + style.row(row);
    }
    return text;
}
QByteArray indexed(const QByteArray& heading, const char* separator, int first)
{
    QByteArray text = heading;
    for (int i = 0; i < nx; ++i)
        text +=
            QByteArray::number(first + i) + separator + in(um, nm, separator).row({0.25 * i, profileHeight(i) / nm});
    return text;
}
QByteArray utf16(const QByteArray& text, bool bigEndian)
{
    QByteArray bytes = bigEndian ? "\xFE\xFF" : "\xFF\xFE";
    for (const QChar c : QString::fromUtf8(text)) {
        const char low = static_cast<char>(c.unicode() & 0xFF), high = static_cast<char>(c.unicode() >> 8);
        bytes += bigEndian ? high : low;
        bytes += bigEndian ? low : high;
    }
    return bytes;
}
QByteArray lines(int count, const QByteArray& text) { return text.split('\n').mid(0, count).join('\n') + '\n'; }

const QByteArray gwyddion = "# Channel: Z\n# Width: 12 \xC2\xB5m\n# Height: 6 \xC2\xB5m\n# Value units: nm\n";
const QByteArray heading = "x [um]\th [nm]\n";

class TestSurfaceSpellings : public QObject {
    Q_OBJECT

private slots:
    void profilesAreReadRight_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("unit");
        const auto row = [](const char* name, const QByteArray& text, const char* unit = "") {
            QTest::newRow(name) << text << QByteArray(unit);
        };
        const auto headings = [&](double x, double h, std::initializer_list<const char*> all) {
            for (const char* each : all) row(each, profile(each + QByteArray("\n"), in(x, h)));
        };
        headings(um, nm,
                 {"x [um]  h [nm]",
                  "x (um)\th (nm)",
                  "x{um} h{nm}",
                  "x in um,height in nm",
                  "x in um height in nm",
                  "Distance (in um);Height (in nm)",
                  "x_um, h_nm",
                  "x_um h_nm",
                  "pos.um height.nm",
                  "x..um.,h..nm.",
                  "x-um h-nm",
                  "x/um\th/nm",
                  "x / um   h / nm",
                  "x/\xC2\xB5m,h/nm",
                  "X (\xCE\xBCm), Z (nm)",
                  "X [\xE3\x8E\x9B], Z [\xE3\x8E\x9A]",
                  "x [\xB5m]\th [nm]",
                  "\xC2\xB5m,nm",
                  "\"\xC2\xB5m\",\"nm\"",
                  "um nm",
                  "[um] [nm]",
                  "x um, h nm",
                  "Distance [microns], Height [nanometers]",
                  "Lateral (micrometer)\tHeight (Nanometre)",
                  "POSITION [MICRONS]\tHEIGHT [NANOMETERS]",
                  "X [UM]  H [NM]",
                  "Weg [Mikrometer]; H\xC3\xB6he [Nanometer]",
                  "# x [um]  h [nm]",
                  "% columns: x (um), height (nm)",
                  "// units: um; nm",
                  "# exported by Tool 2.1 (x in um, h in nm)",
                  "x, h [um, nm]",
                  "x [\\mum] h [nm]",
                  "x [$\\mu$m], h [nm]",
                  "x (forward) [um], h (raw) [nm]",
                  "Profile 1\n   x             y\n   um            nm",
                  "Distance,Height\n\xC2\xB5m,nm",
                  "Position;Height\n[um];[nm]",
                  "Scan rate [Hz]: 1.0\nTip radius: 8 nm\nx [um]\th [nm]",
                  "# bias [V]\n# x [um]  h [nm]",
                  "# scan size: 10 um x 10 um, speed 5 um/s\nx [um], h [nm]",
                  "Information: none\nx [um], h [nm]",
                  "Disk A\nx [um], h [nm]",
                  "2024-01-05\nx [um], h [nm]",
                  "Height profile: x [um], z [nm]",
                  "x;s\n\xC2\xB5m;nm",
                  "X Axis [\xC2\xB5m]\tZ Axis [nm]",
                  "\"x [um]\"\t\"h [nm]\""});
        headings(nm, 1e-10,
                 {"x [nm]  h [A]", "x (nm), h (\xC3\x85)", "x [nm], h [\xE2\x84\xAB]", "x [nm], h [A\xCC\x8A]",
                  "x [nm]\th [\xC5]", "x in nm, h in angstrom", "x [nm], h [Angstroem]", "nm,\xC3\x85ngstr\xC3\xB6m",
                  "x_nm,h_angstroms", "nm A"});
        headings(1e-3, um, {"x [mm]  h [um]", "x (millimetres), h (microns)", "x/mm h/\xC2\xB5m"});
        headings(1.0, 1.0, {"x [m]  h [m]", "   x     y\n   m     m", "x (metres), h (meters)", "x_m;h_m"});
        row("inches and microinches", profile("x [in], h [uin]\n", in(0.0254, 25.4e-9)));
        row("one unit of the case", profile("", in(um, um)), "um");
        row("a unit of the case for each column", profile("distance height\n"), "um, nm");
        row("units of the case and the same in the file", profile(heading), "micrometres; nm");
        row("units of the case and one of the file", profile("position  height [nm]\n"), "um, nm");

        row("commas", profile("x [um],h [nm]\n", in(um, nm, ",")));
        row("commas and blanks", profile("x [um], h [nm]\n", in(um, nm, ", ")));
        row("semicolons at the end, too", profile(heading).replace("\t", ";").replace("\n", ";\n"));
        row("quotation marks", profile("\"x [um]\",\"h [nm]\"\n", {um, nm, ",", false, true, "\n"}));
        row("decimal commas and tabs", profile(heading, decimalCommas()));
        row("decimal commas and semicolons", profile(heading, decimalCommas(";")));
        row("decimal commas and blanks", profile(heading, decimalCommas("  ")));
        row("decimal commas, semicolons and blanks", profile(heading, decimalCommas(" ; ")));
        row("decimal commas in quotation marks", profile(heading, decimalCommas(",", true)));
        row("decimal commas in quotation marks and semicolons", profile(heading, decimalCommas(";", true)));
        row("decimal commas without a zero", profile(heading, decimalCommas()).replace("\n0,", "\n,"));
        row("decimal commas with units of the case", profile("", decimalCommas(";")), "um, nm");
        row("returns alone", profile(heading).replace('\n', '\r'));
        row("Windows", profile(heading).replace("\n", "\r\n"));
        row("lines that end twice", profile(heading).replace("\n", "\r\r\n"));
        row("a mark of UTF-8", "\xEF\xBB\xBF" + profile("x [\xC2\xB5m]\th [nm]\n"));
        row("UTF-16, low byte first", utf16(profile("x [\xC2\xB5m]\th [nm]\n"), false));
        row("UTF-16, high byte first", utf16(profile("x [\xC2\xB5m]\th [nm]\n").replace("\n", "\r\n"), true));
        row("an index without a name", indexed(",x [um],h [nm]\n", ",", 0));
        row("an index without a name, quoted", indexed("\"\",\"x [um]\",\"h [nm]\"\n", ",", 1));
        row("an index without a name, tabs", indexed("\tx [um]\th [nm]\n", "\t", 0));
        row("an index", indexed("index,x [um],h [nm]\n", ",", 0));
        row("a number sign", indexed("#;x [um];h [nm]\n", ";", 1));
        row("numbers of points", indexed("No.\tx [um]\th [nm]\n", "\t", 1));
        row("an index in a comment", indexed("# no x_um h_nm\n", " ", 1));
        row("an index with a unit", indexed("index [-], x [um], h [nm]\n", ",", 0));
        QByteArrayList reversed = profile("").split('\n');
        std::reverse(reversed.begin(), reversed.end());
        row("x from the end", heading + reversed.mid(1).join('\n') + '\n');
        row("a comment between", profile(heading).replace("\n1.0000", "\n# here\n1.0000"));
    }
    void profilesAreReadRight()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, unit);
        const HeightMapDocument document = readHeightMapText(text.toStdString(), "a.txt", unit.toStdString());
        QVERIFY2(document.valid(), document.valid() ? "" : document.problems.front().text().c_str());
        QCOMPARE(document.map.nx, nx);
        QCOMPARE(document.map.ny, 1);
        QVERIFY(std::abs(document.map.dx / (0.25 * um) - 1.0) < 1e-3);
        for (int i = 0; i < nx; ++i)
            QVERIFY(std::abs(document.map.heights[static_cast<std::size_t>(i)] - profileHeight(i)) < 0.005 * nm);
    }

    void mapsAreReadRight_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("unit");
        const auto row = [](const char* name, const QByteArray& text, const char* unit = "") {
            QTest::newRow(name) << text << QByteArray(unit);
        };
        const QByteArray three = "x [um] y [um] z [nm]\n";
        row("lines along x", points(three, [](int k) { return std::pair(k % mapX, k / mapX); }));
        row("from the top", points(three, [](int k) { return std::pair(k % mapX, mapY - 1 - k / mapX); }));
        row("from the right", points(three, [](int k) { return std::pair(mapX - 1 - k % mapX, k / mapX); }));
        row("from the last point",
            points(three, [](int k) { return std::pair(mapX - 1 - k % mapX, mapY - 1 - k / mapX); }));
        row("lines along y from the top",
            points(three, [](int k) { return std::pair(k / mapY, mapY - 1 - k % mapY); }));
        row("there and back", points(three, [](int k) {
                const int j = k / mapX;
                return std::pair(j % 2 == 0 ? k % mapX : mapX - 1 - k % mapX, j);
            }));
        row("units of the case", points("", [](int k) { return std::pair(k % mapX, k / mapX); }), "um, nm");
        row("three units of the case", points("", [](int k) { return std::pair(k % mapX, k / mapX); }), "um,um,nm");
        row("empty lines between the lines of a map",
            points(three, [](int k) { return std::pair(k % mapX, k / mapX); }).replace("\n0.0000\t", "\n\n0.0000\t"));
        row("a matrix", matrix(gwyddion));
        row("a matrix with decimal commas", matrix(gwyddion, decimalCommas()));
        row("a matrix with commas", matrix(gwyddion, in(um, nm, ",")));
        row("a matrix with equals signs", matrix("# Value units = nm\n# Height = 6 um\n# Width = 12 um\n"));
        row("a matrix with units beside the names", matrix("# Width [um]: 12\n# Height (um) = 6\n# Z units: nm\n"));
        row("a matrix in one line", matrix("# Width: 12 um, Height: 6 um, Value units: nm\n"));
        row("a matrix with a decimal comma in its size",
            matrix("# Width: 12,0 um\n# Height: 6,00 um\n# Value units: nm\n"));
        row("a matrix in words", matrix("% width: 12e-6 metres\n% height: 6 microns\n% value units: nanometers\n"));
        row("a matrix in angstrom", matrix("# Width: 12um\n# Height: 6um\n# Value units: \xC3\x85\n", in(um, 1e-10)));
        row("a matrix with units of the case", matrix("# Width: 12\n# Height: 6\n"), "um, nm");
        row("a matrix with heights by the case", matrix("# Width: 12 um\n# Height: 6 um\n"), "um, nm");
        row("a matrix whose lines end twice", matrix(gwyddion).replace("\n", "\r\r\n"));
    }
    void mapsAreReadRight()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, unit);
        const HeightMapDocument document = readHeightMapText(text.toStdString(), "a.txt", unit.toStdString());
        QVERIFY2(document.valid(), document.valid() ? "" : document.problems.front().text().c_str());
        QCOMPARE(document.map.nx, mapX);
        QCOMPARE(document.map.ny, mapY);
        QVERIFY(std::abs(document.map.dx / um - 1.0) < 1e-6 && std::abs(document.map.dy / um - 1.0) < 1e-6);
        for (int j = 0; j < mapY; ++j)
            for (int i = 0; i < mapX; ++i)
                QVERIFY(std::abs(document.map.heights[static_cast<std::size_t>(j * mapX + i)] - mapHeight(i, j)) <
                        0.005 * nm);
    }

    void whatIsNotClearIsRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("unit");
        QTest::addColumn<int>("line");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const QByteArray& text, int line, const char* says,
                            const char* unit = "") {
            QTest::newRow(name) << text << QByteArray(unit) << line << QByteArray(says);
        };
        const char* key = "disk.surface.unit";
        row("no units", profile(""), 1, key);
        row("no units in the heading", profile("x\th\n"), 1, key);
        for (const char* each : {"position  height [nm]",
                                 "x [um]  h",
                                 "t [ms]  h [nm]",
                                 "x [um]  h [V]",
                                 "x [px]  h [nm]",
                                 "x [um]  h [counts]",
                                 "x [um]  h [deg]",
                                 "x [um], I [mA]",
                                 "x [M], h [NM]",
                                 "x [MM], h [nm]",
                                 "x [um], h [Nm]",
                                 "x [mM] h [nM]",
                                 "x [Mm] h [nm]",
                                 "x_ms,h_nm",
                                 "t in ms, h in nm",
                                 "ms,nm",
                                 "x [um], h [10 nm]",
                                 "x [um], h [nm] x10",
                                 "x [um], h [nm] * 10",
                                 "x [um^2] h [nm]",
                                 "x [um] y [um] h [nm]",
                                 "# x [um] h [mV]",
                                 "x [um/s] h [nm]",
                                 "x [um] h [nm/px]",
                                 "x (um) h (s)",
                                 "x [a.u.] h [nm]",
                                 "x [um] h [%]",
                                 "V,nm",
                                 "x (\xC2\xB5 m) h (nm)",
                                 "x micro m, h nm",
                                 "x E-6 m, h nm",
                                 "x [micro m] h [nm]",
                                 "x [10^-6 m] h [nm]",
                                 "x (1e-6 m) h (nm)",
                                 "h [nm]\tx [um]",
                                 "height in nm, x in um",
                                 "# unit: nm"})
            row(each, profile(each + QByteArray("\n")), 1, QByteArray(each).startsWith('h') ? "another order" : key);
        row("a bad unit of the case", profile(""), 0, "must hold units of length", "um, V");
        row("too many units of the case", profile(""), 0, "3 units", "um, um, nm");
        row("another unit by the case", profile(heading), 1, "other units", "um, um");
        row("another unit of one column by the case", profile("x  h [nm]\n"), 1, "other units", "um, um");
        row("no length, whatever the case gives", profile("t [ms] h [nm]\n"), 1, "\"ms\"", "um, nm");
        row("headings that differ", profile("# x [mm]  h [nm]\nx [um]  h [nm]\n"), 2, "other units");
        row("another width by the case", matrix(gwyddion), 2, "other units", "mm, nm");
        row("a matrix without a unit of heights", matrix("# Width: 12 um\n# Height: 6 um\n"), 3, key);
        row("a matrix without a unit of its width", matrix("# Width: 12\n# Height: 6 um\n# Value units: nm\n"), 1, key);
        row("a matrix of volts", matrix("# Width: 12 um\n# Height: 6 um\n# Value units: V\n"), 3, "\"V\"");
        row("a width of a thousand or one", matrix("# Width: 1,200 um\n# Height: 6 um\n# Value units: nm\n"), 1,
            "Width");

        row("commas for both", lines(9, profile("", {um, nm, ",", true, false, "\n"})), 1, "decimals", "um, nm");
        row("a matrix with commas for both", matrix(gwyddion, {um, nm, ",", true, false, "\n"}), 5, "decimals");
        row("a matrix with commas for both and blanks", matrix(gwyddion, {um, nm, ", ", true, false, "\n"}), 5,
            "decimals");
        row("whole numbers in pairs", gwyddion + "1,5,2,5\n1,6,2,6\n", 5, "decimals");
        row("thousands and points", heading + "0.0;1,002.5\n0.5;1,003.5\n", 2, "decimals");
        row("thousands with commas in quotation marks", heading + "\"0.0\",\"1,002.5\"\n", 2, "decimals");
        row("three digits after each comma", heading + "0\t1,002\n1\t1,003\n2\t1,004\n3\t1,005\n", 2, "thousands");
        row("thousands with dots and commas", heading + "0,5;1.002,5\n1,0;1.003,5\n", 2, "decimals");
        row("thousands with two commas", heading + "0;1,234,567\n1;1,234,568\n2;1,3\n3;1,2\n", 2, "1,234,567");
        row("thousands with apostrophes", heading + "0;1'234.5\n1;1'235.5\n", 2, "1'234.5");
        row("thousands with blanks", heading + "0;1 234.5\n1;1 235.5\n", 2, "1 234.5");
        row("an empty cell", heading.trimmed() + "\tq [nm]\n0,,1\n1,,1\n2,,1\n", 2, "missing");

        row("an index that no heading names", indexed("x [um],h [nm]\n", ",", 0), 2, "counts the rows");
        row("an index without heading", indexed("", "\t", 1), 1, "counts the rows", "um, nm");
        row("an index as x", lines(9, "index, h [nm]\n0, 1\n1, 2\n2, 3\n3, 4\n"), 1, "index", "um, nm");

        const auto withMark = [](const char* mark) {
            return profile(heading).replace("\n1.2500\t3.8858", QByteArray("\n1.2500\t") + mark);
        };
        for (const char* mark : {"-9999", "-999.25", "-32768", "32767", "2147483647", "2147483640", "1e30", "3.4e38",
                                 "-3.40282347e+38", "-99999", "65535", "-1e10", "1e9"})
            row(mark, withMark(mark), 7, "missing point");
        row("a mark many times", withMark("-9999").replace("\n2.0000\t2.5000", "\n2.0000\t-9999"), 7, "-9999");
        row("a mark of a matrix", matrix(gwyddion).replace("3.4191", "-32768"), 6, "missing point");
        for (const char* mark : {"NaN", "-", "--", "n/a", "null", "1.#QNAN", "-inf"})
            row(mark, withMark(mark), 7, "no holes");
        row("a first row that begins with a word", matrix(gwyddion).replace("units: nm\n2.5000", "units: nm\nvoid"), 5,
            "void");

        row("a second matrix", matrix(gwyddion) + matrix("# Channel: Phase\n"), 11, "one channel");
        row("a second size", matrix(gwyddion) + matrix("# Width: 12 um\n"), 11, "one channel");
        row("a second matrix after a comment", matrix(gwyddion) + matrix("# phase\n"), 11, "one channel");
        row("a second matrix after an empty line", matrix(gwyddion) + matrix("\n"), 11, "one channel");
        row("a second size before the numbers", matrix(gwyddion + "# Width: 13 um\n"), 5, "one channel");
        row("a second heading", profile(heading) + profile("x [um]\tphase [deg]\n"), nx + 2, "one profile");
        row("a second heading in a comment", profile(heading) + profile("# x [um]\th [nm]\n"), nx + 2, "one profile");
        row("a second profile", profile(heading) + profile("\n"), nx + 3, "second profile");
        row("a second profile at once", profile(heading) + profile(""), nx + 2, "second profile");
        const auto along = [](int k) { return std::pair(k % mapX, k / mapX); };
        row("points twice", points("x [um] y [um] z [nm]\n", along) + points("\n", along), 75, "second time");
    }
    void whatIsNotClearIsRefused()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, unit);
        QFETCH(int, line);
        QFETCH(QByteArray, says);
        const HeightMapDocument document = readHeightMapText(text.toStdString(), "a.txt", unit.toStdString());
        QCOMPARE(document.problems.size(), std::size_t{1});
        const std::string problem = document.problems.front().text();
        QVERIFY2(QByteArray::fromStdString(problem).contains(says), problem.c_str());
        QCOMPARE(document.problems.front().line, line);
    }
};

TOUCHDOWN_TEST(TestSurfaceSpellings)

} // namespace test_surface_spellings

#include "test_surface_spellings.moc"
