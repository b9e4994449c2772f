// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/heading_cells.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_heading_cells {

/// "x=um|h=nm"; a unit that is no length has a question mark, no heading is "none".
QByteArray cells(const QByteArray& line, char separator, std::size_t columns)
{
    const auto found = headingCells(line.toStdString(), separator, columns);
    if (!found) return "none";
    QByteArrayList all;
    for (const HeadingCell& each : *found)
        all << QByteArray::fromStdString(each.name + (each.unit.empty() ? "" : "=" + each.unit)) +
                   (each.unit.empty() || each.metres ? "" : "?");
    return all.join('|');
}

class TestHeadingCells : public QObject {
    Q_OBJECT

private slots:
    void twoColumns_data()
    {
        QTest::addColumn<char>("separator");
        QTest::addColumn<QByteArray>("expected");
        const auto row = [](const char* line, char separator, const char* expected) {
            QTest::newRow(line) << separator << QByteArray(expected);
        };
        row("x [um]  h (nm)", ' ', "x=um|h=nm");
        row("x in um, h (in nm)", ',', "x=um|h=nm");
        row("x in um height in nm", ' ', "x=um|height=nm");
        row("track position [um], surface height [nm]", ' ', "track position=um|surface height=nm");
        row("track position [um]   surface height [nm]", ' ', "track position=um|surface height=nm");
        row("x_um;h_nm", ';', "x=um|h=nm");
        row("height_in_um h..nm.", ' ', "height=um|h=nm");
        row("x \xC2\xB5m, mean height \xC3\x85", ',', "x=um|mean height=angstrom");
        row("x/um\th / nm", ' ', "x=um|h=nm");
        row("x: um, h: nm", ' ', "x=um|h=nm");
        row("x, um;h, nm", ';', "x=um|h=nm");
        row("x um h nm", ' ', "x=um|h=nm");
        row("um, nm", ' ', "=um|=nm");
        row("x, h [um, nm]", ',', "x=um|h=nm");
        row("# columns: x (um), height (nm)", ' ', "columns: x=um|height=nm");
        row("by a tool 2 (x in um, h in nm)", ' ', "x=um|h=nm");
        row("x (forward) [um], h [nm] (raw)", ',', "x forward=um|h raw=nm");
        row("x h", ' ', "x|h");
        row("x, A", ',', "x|A");
        row("position  height [nm]", ' ', "position|height=nm");
        row("um, V", ',', "=um|=V?");
        row("t [ms], h [nm] x10", ',', "t=ms?|h=nm x10?");
        row("x (um), h (10 nm)", ',', "x=um|h=10 nm?");
        row("x [um], h (counts) [nm]", ',', "x=um|h=counts?");
        row("x [um], h (x10) [nm]", ',', "x=um|h=x10?");
        row("x [um], h (AFM) [nm]", ',', "x=um|h AFM=nm");
        row("x [um], h [nm] for steps [um]", ',', "x=um|h for steps=um?");
        row("Lateral um, Total Profile nm", ',', "Lateral=um|Total Profile=nm");
        row("x micro m, h nm", ',', "none");
        row("x E-6 m, h nm", ',', "none");
        row("x u m, h nm", ',', "none");
        row("x 10 um, h nm", ',', "none");
        row("x [um] y [um] h [nm]", ' ', "none");
        row("Disk 3, x [um], h [nm]", ',', "none");
        row("Height data, in nanometers, versus distance in micrometers", ',', "none");
    }
    void twoColumns()
    {
        QFETCH(char, separator);
        QFETCH(QByteArray, expected);
        QCOMPARE(cells(QTest::currentDataTag(), separator, 2), expected);
    }
    void oneAndThreeColumns()
    {
        QCOMPARE(cells("surface height [nm]", ' ', 1), QByteArray("surface height=nm"));
        QCOMPARE(cells("nm", ' ', 1), QByteArray("=nm"));
        QCOMPARE(cells("x y z [um, um, nm]", ' ', 3), QByteArray("x=um|y=um|z=nm"));
        QCOMPARE(cells(",x [um],h [nm]", ',', 3), QByteArray("|x=um|h=nm"));
    }
    void marksOfComments()
    {
        QCOMPARE(QByteArray::fromStdString(std::string(withoutMark("// x"))), QByteArray("x"));
        QCOMPARE(QByteArray::fromStdString(std::string(withoutMark("#;x;h"))), QByteArray("#;x;h")); // of an index
    }
};

TOUCHDOWN_TEST(TestHeadingCells)

} // namespace test_heading_cells

#include "test_heading_cells.moc"
