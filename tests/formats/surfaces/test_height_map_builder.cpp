// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/height_map_builder.h"

#include <QTest>

#include <cmath>
#include <functional>

#include "core/formats/cml_text.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_height_map_builder {

std::string refusal(const std::function<void()>& action)
{
    try {
        action();
    } catch (const CmlError& error) {
        return std::to_string(error.line()) + ": " + error.what();
    }
    return {};
}

class TestHeightMapBuilder : public QObject {
    Q_OBJECT

private slots:
    void equalStepsMakeAnAxis()
    {
        const MapAxis axis = equalSteps(std::vector<double>{-1.0, 1.0, 3.0, 5.0}, {}, "x");
        QCOMPARE(axis.points, std::size_t(4));
        QCOMPARE(axis.first, -1.0);
        QCOMPARE(axis.step, 2.0);
        QCOMPARE(axis.at(3), 5.0);
        // A fiftieth of a step is what printed digits may take.
        QVERIFY(axis.holds(1, 1.03));
        QVERIFY(!axis.holds(1, 1.05));
    }

    // The gap is at the third line; by the mean step, 1.25, the second would be blamed.
    void aGapIsFoundWhereItIs()
    {
        const std::vector<double> places{0.0, 1.0, 3.0, 4.0, 5.0};
        const std::vector<int> lines{10, 11, 12, 13, 14};
        QCOMPARE(refusal([&] { equalSteps(places, lines, "y"); }),
                 std::string("12: y must ascend in equal steps, without gaps: 3 m stands where 2 m is needed"));
        QCOMPARE(refusal([&] { equalSteps(places, {}, "y"); }).substr(0, 2), std::string("0:"));
        // In the unit of the file.
        std::vector<double> inMicrometres(places);
        for (double& place : inMicrometres) place *= 1e-6;
        QCOMPARE(refusal([&] { equalSteps(inMicrometres, lines, "y", 1e-6); }),
                 std::string("12: y must ascend in equal steps, without gaps: 3 um stands where 2 um is needed"));
    }

    void mapsThatCloseLoseTheirLastPoints()
    {
        // 4 points along and 5 across, the fifth row the first one again, and so the last column.
        const MapAxis along{5, 0.0, 1.0}, across{6, 0.0, 1.0};
        std::vector<double> heights;
        for (int j = 0; j < 6; ++j)
            for (int i = 0; i < 5; ++i) heights.push_back(10.0 * (j % 5) + i % 4);
        const HeightMap map = builtMap(along, across, heights);
        QVERIFY(map.closedX && map.closedY);
        QCOMPARE(map.nx, 4);
        QCOMPARE(map.ny, 5);
        for (int j = 0; j < 5; ++j)
            for (int i = 0; i < 4; ++i) QCOMPARE(map.heights[static_cast<std::size_t>(4 * j + i)], 10.0 * j + i);

        heights[9] += 0.1; // one point that differs
        const HeightMap open = builtMap(along, across, heights);
        QVERIFY(!open.closedX && open.closedY);
        QCOMPARE(open.nx, 5);
        QCOMPARE(open.heights.size(), std::size_t(25));
    }

    void aProfileIsOneRow()
    {
        const HeightMap map = builtMap({4, 0.0, 1e-6}, {1, 0.0, 1e-6}, {1.0, 2.0, 3.0, 4.0});
        QCOMPARE(map.ny, 1);
        QVERIFY(!map.closedX && !map.closedY);
        QCOMPARE(map.dx, 1e-6);
    }
};

TOUCHDOWN_TEST(TestHeightMapBuilder)

} // namespace test_height_map_builder

#include "test_height_map_builder.moc"
