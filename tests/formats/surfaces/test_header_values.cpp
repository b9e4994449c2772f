// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/header_values.h"

#include <QTest>

#include <cmath>

#include "tests/support/refused_line.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_header_values {

const std::string rows = "1 2 3 4\n5 6 7 8\n";

using test::refusedLine;

bool near(double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); }

class TestHeaderValues : public QObject {
    Q_OBJECT

private slots:
    // Each header gives a matrix of 4 x 2 points, 2 um and 3 um apart, with heights in nm.
    void sizesOfAMatrix_data()
    {
        QTest::addColumn<double>("heights"); // their unit [m]
        const auto row = [](const char* header, double unit = 1e-9) { QTest::newRow(header) << unit; };
        row("# Width: 8 um\n# Height: 6 um\n# Value units: nm\n");
        row("# Height = 6 um\n# Width [mm]: 0,008\n# z-unit: nm\n");
        row("# x-pixels = 4\n# y-pixels = 2\n# x-length = 8000\n# y-length = 6000\n# Bit2nm = 0.01\n", 1e-11);
        row("WSxM ASCII Matrix file\nX Amplitude: 8 \xC2\xB5m\nY Amplitude: 6000 nm\nZ Amplitude: 7 \xC3\x85\n", 1e-10);
        row("\"x pixel size (nm/pixel)\",\"2000\"\n\"y pixel size (um/px)\",\"3\"\n\"Horizontal\",\"4\"\n"
            "\"Unit\",\"um\"\n",
            1e-6);
        row("NX = 4\nNY = 2\nScale X = 2\nScale Y = 3\nUnit X = um\nUnit Data = nm\n");
        row("xres = 4\nxreal = 8e-6\nyreal = 6e-6\nxyunits = m\nzunits = m\n", 1.0);
    }
    void sizesOfAMatrix()
    {
        QFETCH(double, heights);
        const MapTable table = readMapTable(QTest::currentDataTag() + rows);
        const HeaderValues values(table);
        QVERIFY(values.sizesMatrix());
        const PointSteps steps = pointSteps(table, values, {});
        QVERIFY(near(steps.x, 2e-6) && near(steps.y, 3e-6));
        QVERIFY(near(*heightUnit(values), heights));
    }
    void stepsByTheCase()
    {
        const MapTable table = readMapTable("ncols 4\nnrows 2\ncellsize 0.5\nNODATA_value -9999\n" + rows);
        const HeaderValues values(table);
        QVERIFY(near(pointSteps(table, values, {1e-6, 1e-6, 1e-9}).y, 0.5e-6));
        QVERIFY(!heightUnit(values));
        QCOMPARE(refusedLine([&] { pointSteps(table, values, {}); }), 3);
    }
    void heightsAlone()
    {
        const MapTable table = readMapTable("# Spacing: 0.5 um\n# Points: 3\n# Unit: nm\n1\n2\n3\n");
        const HeaderValues values(table);
        QVERIFY(near(pointSteps(table, values, {}).x, 0.5e-6));
        QVERIFY(near(*heightUnit(values), 1e-9));
    }
    void whatContradictsIsRefused_data()
    {
        QTest::addColumn<int>("line");
        QTest::newRow("# Width: 1 um\n# Width: 2 um\n# Height: 1 um\n# unit: nm\n") << 2;
        QTest::newRow("# x-pixels: 5\n# Width: 1 um\n# Height: 1 um\n# unit: nm\n") << 1;
        QTest::newRow("# Width: 1 um\n# Height: 1 um\n# unit: V\n") << 3;
        QTest::newRow("# Width: 1 um\n# Height: 0 um\n# unit: nm\n") << 2;
        QTest::newRow("# Width: 4 um\n# Height: 2 um\n# pixel size: 2 um\n# unit: nm\n") << 3;
        QTest::newRow("# pixel size: 1 um/s\n# unit: nm\n") << 1;
        QTest::newRow("# pixel size: 1 um\n# unit: nm\n# z scale: 0.1\n") << 3;
        QTest::newRow("# pixel size: 1 um\n# unit: nm\n# Channel: Phase\n") << 3;
        QTest::newRow("# pixel size: 1 um\n# unit: nm\n# NODATA = 7\n") << 5;
    }
    void whatContradictsIsRefused()
    {
        QFETCH(int, line);
        const MapTable table = readMapTable(QTest::currentDataTag() + rows);
        QCOMPARE(refusedLine([&] {
                     const HeaderValues values(table);
                     pointSteps(table, values, {});
                     heightUnit(values);
                     channelIsTurned(table, values, 0);
                 }),
                 line);
    }
    void channels()
    {
        const auto turned = [](const char* channel) {
            const MapTable table = readMapTable("# Channel: " + std::string(channel) + "\n" + rows);
            return channelIsTurned(table, HeaderValues(table), 0);
        };
        QVERIFY(turned("Depth"));
        QVERIFY(!turned("Z (forward)") && !turned("Topography 1/2"));
        QVERIFY(beginsChannel("# Channel: Phase") && beginsChannel("# Width: 2 um") && !beginsChannel("# rate: 2 Hz"));
        QVERIFY(isValue("rate = 1 Hz") && isValue("x unit: um") && !isValue("x [um], h [nm]"));
    }
};

TOUCHDOWN_TEST(TestHeaderValues)

} // namespace test_header_values

#include "test_header_values.moc"
