// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_heading.h"

#include <QTest>

#include <functional>

#include "core/formats/cml_text.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_heading {

int refusedLine(const std::function<void()>& action)
{
    try {
        action();
    } catch (const CmlError& error) {
        return error.line();
    }
    return -1;
}

class TestSurfaceHeading : public QObject {
    Q_OBJECT

private slots:
    void theKeyHoldsUnits()
    {
        QCOMPARE(unitsOfKey(""), std::optional(ColumnUnits{}));
        QCOMPARE(unitsOfKey("um, nm"), std::optional(ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(unitsOfKey("um;um;nm"), std::optional(ColumnUnits{1e-6, 1e-6, 1e-9}));
        QVERIFY(!unitsOfKey("um, V"));
        QVERIFY(!unitsOfKey("um,"));
        QCOMPARE(unitsOfKey(ColumnUnits{1e-6}, 3), (ColumnUnits{1e-6, 1e-6, 1e-6}));
        QCOMPARE(unitsOfKey(ColumnUnits{1e-6, 1e-9}, 3), (ColumnUnits{1e-6, 1e-6, 1e-9}));
        QCOMPARE(refusedLine([] { unitsOfKey(ColumnUnits{1, 1, 1}, 2); }), 0);
    }
    void columns()
    {
        const MapTable table = readMapTable("# tip [V]\nname\nx [um] h [nm]\n0 1\n1 2\n");
        QCOMPARE(columnUnits(table, {}), (ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(columnUnits(table, {1e-6, 1e-9}), (ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(refusedLine([&] { columnUnits(table, {1e-6}); }), 3);
        QCOMPARE(refusedLine([] { columnUnits(readMapTable("a\nx h [nm]\n0 1\n"), {}); }), 2);
        QCOMPARE(refusedLine([] { columnUnits(readMapTable("0 1\n"), {}); }), 1);
    }
    void columnsInAnotherOrder()
    {
        QCOMPARE(refusedLine([] { columnUnits(readMapTable("h [nm] x [um]\n0 1\n"), {}); }), 1);
        QCOMPARE(refusedLine([] { columnUnits(readMapTable("y [um] x [um] z [nm]\n0 1 2\n"), {}); }), 1);
        QCOMPARE(refusedLine([] { columnUnits(readMapTable("z y\n0 1 2\n"), {1.0}); }), 1);
        QCOMPARE(columnUnits(readMapTable("x [um] y [nm]\n0 1\n"), {}), (ColumnUnits{1e-6, 1e-9}));
    }
    void anIndexIsTakenOut()
    {
        for (const char* heading :
             {"index x h", "#;x;h", ";x;h", "\"\",x,h", "Unnamed: 0,x,h", "No.\tx\th", "# i x h"}) {
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
    void sizesOfAMatrix()
    {
        const MapTable table = readMapTable("# Height = 6 um\n# Width [mm]: 0,012\n# Value units: nm\n1 2 3 4\n");
        const MatrixSize size = matrixSize(table, matrixHeading(table), {});
        QVERIFY(qFuzzyCompare(size.width, 12e-6) && qFuzzyCompare(size.height, 6e-6));
        QCOMPARE(size.valueUnit, 1e-9);
        QCOMPARE(refusedLine([] { matrixHeading(readMapTable("# Width: 1 um\n# Width: 2 um\n1 2 3 4\n")); }), 2);
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
