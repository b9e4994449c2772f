// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/meeting_walls.h"

#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_meeting_walls {

constexpr double um = 1e-6;

/// Corners from the lower left, anticlockwise: edge 1 below, 2 at the right, 3 above, 4 at the left.
Rail box(double x0, double x1, double y0, double y1, int wall, double recess = 0.0)
{
    return {RailKind::Step,
            {{x0 * um, y0 * um, wall}, {x1 * um, y0 * um, wall}, {x1 * um, y1 * um, wall}, {x0 * um, y1 * um, wall}},
            {recess, 0.0, 0.0}};
}

/// Wall 1 is 20 um wide outside, wall 2 reaches 10 um outside and 8 um inside.
AirBearingSurface surfaceOf(std::vector<Rail> rails)
{
    AirBearingSurface surface;
    surface.walls = {{{0.0, 20 * um}, {0.0, 2e-6}}, {{-8 * um, 10 * um}, {0.0, 2e-6}}};
    surface.rails = std::move(rails);
    return surface;
}

class TestMeetingWalls : public QObject {
    Q_OBJECT

private slots:
    void walls_data()
    {
        QTest::addColumn<AirBearingSurface>("surface");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* name, std::vector<Rail> rails, const char* sentence = "") {
            QTest::newRow(name) << surfaceOf(std::move(rails)) << QString(sentence);
        };
        row("one rail", {box(100, 200, 100, 200, 1)});
        row("a gap of 41 um", {box(100, 200, 100, 200, 1), box(241, 300, 100, 200, 1)});
        row("a gap of 39 um", {box(100, 200, 100, 200, 1), box(239, 300, 100, 200, 1)},
            "Rail 1: the walls of edge 2 and of edge 4 of rail 2 run into each other.");
        row("one of them vertical", {box(100, 200, 100, 200, 1), box(210, 300, 100, 200, 0)});
        row("beside each other", {box(100, 200, 100, 200, 1), box(210, 300, 400, 500, 1)});
        row("a pad on a shelf", {box(100, 300, 100, 200, 1, 1e-6), box(150, 250, 110, 190, 1)});
        row("a third rail over the gap",
            {box(100, 200, 100, 200, 1), box(210, 300, 100, 200, 1), box(190, 220, 50, 250, 0)});
        row("a deeper rail over the gap",
            {box(100, 200, 100, 200, 1), box(210, 300, 100, 200, 1), box(200, 210, 50, 250, 0, 1.9e-6)},
            "Rail 1: the walls of edge 2 and of edge 4 of rail 2 run into each other.");
        row("at the base recess", {box(100, 200, 100, 200, 1), box(210, 300, 100, 200, 1, 2e-6)});
        row("rails that touch", {box(100, 200, 100, 200, 1), box(200, 300, 100, 200, 1)});
        row("inner walls of 16 um in a rail of 15 um", {box(100, 200, 100, 115, 2)},
            "Rail 1: the walls of edge 1 and edge 3 run into each other.");
        row("inner walls of 16 um in a rail of 17 um", {box(100, 200, 100, 117, 2)});
        row("inner walls below another rail", {box(100, 200, 100, 115, 2), box(50, 250, 50, 250, 0)});
        // A notch of 30 um between edges 3 and 5 of a U.
        row("a notch",
            {{RailKind::Step,
              {{100 * um, 100 * um, 1},
               {230 * um, 100 * um, 1},
               {230 * um, 200 * um, 0},
               {180 * um, 200 * um, 1},
               {180 * um, 150 * um, 0},
               {150 * um, 150 * um, 1},
               {150 * um, 200 * um, 0},
               {100 * um, 200 * um, 1}},
              {}}},
            "Rail 1: the walls of edge 4 and edge 6 run into each other.");
        row("two gaps",
            {box(100, 200, 100, 200, 1),
             {RailKind::Step,
              {{210 * um, 90 * um, 1},
               {300 * um, 90 * um, 1},
               {300 * um, 300 * um, 1},
               {100 * um, 300 * um, 1},
               {100 * um, 210 * um, 1},
               {210 * um, 210 * um, 1}},
              {}}},
            "Rail 1: the walls of edge 2 and of edge 6 of rail 2, and 1 more pair, run into each other.");
    }
    void walls()
    {
        QFETCH(AirBearingSurface, surface);
        QFETCH(QString, sentence);
        const std::vector<SurfaceProblem> warnings = meetingWalls(surface);
        QCOMPARE(warnings.size(), std::size_t(sentence.isEmpty() ? 0 : 1));
        if (warnings.empty()) return;
        QCOMPARE(QString::fromStdString(warnings[0].sentence), sentence);
        QCOMPARE(warnings[0].key, std::string("abs.rail[1]"));
    }
    /// In the middle of the gap; the two walls together reach from x = 195 to 220 um.
    void places()
    {
        const auto warnings = meetingWalls(surfaceOf({box(100, 200, 100, 200, 1), box(215, 300, 100, 200, 1)}));
        QCOMPARE(warnings.size(), std::size_t(1));
        QCOMPARE(warnings[0].places.size(), std::size_t(1));
        QVERIFY(std::abs(warnings[0].places[0].x - 207.5 * um) < 1e-3 * um);
        QVERIFY(std::abs(warnings[0].places[0].y - 150 * um) < 1e-3 * um);
    }
};

TOUCHDOWN_TEST(TestMeetingWalls)

} // namespace test_meeting_walls

#include "test_meeting_walls.moc"
