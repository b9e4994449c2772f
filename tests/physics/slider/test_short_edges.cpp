// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/short_edges.h"

#include <cmath>

#include <QTest>

#include "core/numerics/cell_grid.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_short_edges {

/// Cells of 20 x 10 um up to x = 200 um, of 50 x 10 um beyond.
CellGrid grid()
{
    CellGrid grid;
    for (int i = 0; i <= 10; ++i) grid.x.push_back(i * 20e-6);
    for (int i = 1; i <= 4; ++i) grid.x.push_back(200e-6 + i * 50e-6);
    for (int j = 0; j <= 40; ++j) grid.y.push_back(j * 10e-6);
    return grid;
}

AirBearingSurface railOf(const std::vector<SurfacePoint>& corners)
{
    AirBearingSurface surface;
    surface.rails.resize(1);
    for (const SurfacePoint& corner : corners) surface.rails[0].points.push_back({corner.x * 1e-6, corner.y * 1e-6, 0});
    return surface;
}

class TestShortEdges : public QObject {
    Q_OBJECT

private slots:
    void lengths_data()
    {
        QTest::addColumn<AirBearingSurface>("surface");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* name, const AirBearingSurface& surface, const char* sentence) {
            QTest::newRow(name) << surface << QString(sentence);
        };
        row("long edges", railOf({{10, 10}, {110, 10}, {110, 110}, {10, 110}}), "");
        row("a chamfer in a cell of 20 x 10 um", railOf({{10, 10}, {100, 10}, {110, 19}, {110, 110}, {10, 110}}),
            "Rail 1: edge 2 is shorter than a cell of the grid.");
        row("a chamfer higher than a cell", railOf({{10, 10}, {100, 10}, {110, 21}, {110, 110}, {10, 110}}), "");
        row("25 um in a cell of 20 um", railOf({{10, 10}, {110, 10}, {110, 110}, {85, 115}}), "");
        row("25 um in a cell of 50 um", railOf({{210, 10}, {310, 10}, {310, 110}, {285, 115}}),
            "Rail 1: edge 3 is shorter than a cell of the grid.");
        row("the last edge", railOf({{12, 12}, {110, 10}, {110, 110}, {10, 20}}),
            "Rail 1: edge 4 is shorter than a cell of the grid.");
        row("a repeated corner", railOf({{10, 10}, {10, 10}, {110, 10}, {110, 110}}), "");
        row("two chamfers", railOf({{10, 10}, {100, 10}, {105, 15}, {110, 110}, {105, 115}, {10, 110}}),
            "Rail 1: edges 2 and 4 are shorter than a cell of the grid.");
        // Each of its three edges is short; 30 um in all are not.
        row("a rounded corner", railOf({{10, 10}, {90, 10}, {105, 14}, {115, 23}, {120, 32}, {120, 110}, {10, 110}}),
            "");
        row("a small rounded corner", railOf({{10, 10}, {90, 10}, {94, 11}, {97, 13}, {98, 17}, {98, 110}, {10, 110}}),
            "Rail 1: edges 2, 3 and 4 are shorter than a cell of the grid.");
        row("a rail within a cell", railOf({{1, 1}, {8, 1}, {8, 8}}),
            "Rail 1: edges 1, 2 and 3 are shorter than a cell of the grid.");
    }
    void lengths()
    {
        QFETCH(AirBearingSurface, surface);
        QFETCH(QString, sentence);
        const std::vector<SurfaceProblem> warnings = shortEdges(surface, grid());
        QCOMPARE(warnings.size(), std::size_t(sentence.isEmpty() ? 0 : 1));
        if (warnings.empty()) return;
        QCOMPARE(QString::fromStdString(warnings[0].sentence), sentence);
        QCOMPARE(warnings[0].key, std::string("abs.rail[1]"));
    }
    /// At the middle of the edge.
    void places()
    {
        const auto warnings = shortEdges(railOf({{10, 10}, {100, 10}, {110, 19}, {110, 110}, {10, 110}}), grid());
        QCOMPARE(warnings.size(), std::size_t(1));
        QCOMPARE(warnings[0].places.size(), std::size_t(1));
        QVERIFY(std::abs(warnings[0].places[0].x - 105e-6) < 1e-15);
        QVERIFY(std::abs(warnings[0].places[0].y - 14.5e-6) < 1e-15);
    }
};

TOUCHDOWN_TEST(TestShortEdges)

} // namespace test_short_edges

#include "test_short_edges.moc"
