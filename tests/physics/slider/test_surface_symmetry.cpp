// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/surface_symmetry.h"

#include <cmath>

#include <QTest>

#include "core/physics/slider/rail_outline.h"
#include "core/physics/slider/surface_check.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_symmetry {

constexpr double width = 0.8e-3; // [m]; the centre line is at 400 um
constexpr double reach = 1e-7;   // [m]

Rail railOf(const std::vector<RailPoint>& corners)
{
    Rail rail;
    for (const RailPoint& p : corners) rail.points.push_back({p.x * 1e-6, p.y * 1e-6, p.wall});
    return rail;
}

AirBearingSurface symmetric(const std::vector<Rail>& rails, const PartSelection& parts)
{
    AirBearingSurface surface;
    surface.rails = rails;
    surface.walls.assign(4, {{0.0, 4e-6}, {0.0, 2e-6}});
    return madeSymmetric(surface, parts, width, reach);
}

bool isItsOwnImage(const AirBearingSurface& surface)
{
    const auto images = mirrorImages(surface, width, 1e-12);
    return images[0] && images[0]->rail == 0 && surfaceProblems(surface).empty() &&
           surfaceWarnings(surface, 1e-3, width).empty();
}

const Rail side = railOf({{100, 50, 1}, {300, 60, 2}, {200, 150, 3}});
const Rail other = railOf({{500, 50, 0}, {600, 50, 0}, {600, 90, 0}, {500, 90, 0}});

class TestSurfaceSymmetry : public QObject {
    Q_OBJECT

private slots:
    /// The image lies next to its rail, its walls on the images of the edges; a second time nothing changes.
    void aSideRailGetsAnImage()
    {
        const AirBearingSurface after = symmetric({side, other}, {{PartKind::Rail, 0}});
        QCOMPARE(after.rails.size(), std::size_t(3));
        QVERIFY(after.rails[0] == side && after.rails[2] == other);
        QVERIFY(std::abs(after.rails[1].points[2].y - 650e-6) < 1e-15);
        QCOMPARE(after.rails[1].points[1].wall, 2);
        QVERIFY(madeSymmetric(after, {{PartKind::Rail, 0}, {PartKind::Rail, 1}}, width, reach) == after);
    }
    void severalRails()
    {
        const AirBearingSurface after = symmetric({side, other}, {{PartKind::Rail, 0}, {PartKind::Rail, 1}});
        QCOMPARE(after.rails.size(), std::size_t(4));
        QVERIFY(after.rails[0] == side && after.rails[2] == other);
        for (const auto& image : mirrorImages(after, width, reach)) QVERIFY(image.has_value());
    }
    /// From 300 to 480 um: the half below the centre line, 100 um high, is the larger one. Its vertical edges run
    /// straight on over the line, so that four corners remain.
    void aRectangleAcrossTheCentreLine()
    {
        const Rail rail = railOf({{100, 300, 1}, {200, 300, 2}, {200, 480, 3}, {100, 480, 4}});
        const AirBearingSurface after = symmetric({rail}, {{PartKind::Rail, 0}});
        QVERIFY(isItsOwnImage(after));
        QCOMPARE(after.rails[0].points.size(), std::size_t(4));
        QVERIFY(std::abs(std::abs(signedArea(after.rails[0].points)) - 100e-6 * 200e-6) < 1e-18);
        for (const RailPoint& p : after.rails[0].points) {
            const bool lower = std::abs(p.y - 300e-6) < 1e-15;
            QVERIFY(lower || std::abs(p.y - 500e-6) < 1e-15);
        }
    }
    /// The edge 1 below, its image above; edge 2 at the right has one wall on both halves.
    void wallsAreMirrored()
    {
        const Rail rail = railOf({{100, 300, 1}, {200, 300, 2}, {230, 480, 3}, {90, 480, 4}});
        const AirBearingSurface after = symmetric({rail}, {{PartKind::Rail, 0}});
        QVERIFY(isItsOwnImage(after));
        const std::vector<RailPoint>& points = after.rails[0].points;
        QCOMPARE(points.size(), std::size_t(6)); // the slanted sides bend at the centre line
        for (std::size_t k = 0; k < 6; ++k) {
            const RailPoint &a = points[k], &b = points[(k + 1) % 6];
            const double middle = 0.5 * (a.x + b.x);
            const int expected = std::abs(a.y - b.y) < 1e-9 ? 1 : middle > 150e-6 ? 2 : 4;
            QCOMPARE(a.wall, expected);
        }
    }
    void aCornerOnTheLine()
    {
        const Rail rail = railOf({{100, 400, 1}, {200, 300, 2}, {300, 400, 3}, {200, 450, 4}});
        const AirBearingSurface after = symmetric({rail}, {{PartKind::Rail, 0}});
        QVERIFY(isItsOwnImage(after));
        QCOMPARE(after.rails[0].points.size(), std::size_t(4));
    }
    void whatStays()
    {
        const Rail own = railOf({{100, 300, 1}, {200, 300, 2}, {200, 500, 1}, {100, 500, 4}});
        QVERIFY(symmetric({own}, {{PartKind::Rail, 0}}).rails[0] == own);
        Rail ramp = railOf({{100, 300, 0}, {200, 300, 0}, {200, 480, 0}});
        ramp.kind = RailKind::Ramp;
        ramp.recess = {0.0, 1e-7, 1e-7};
        QVERIFY(symmetric({ramp}, {{PartKind::Rail, 0}}).rails[0] == ramp);
        // A U whose legs both cross the line has four crossings.
        const Rail legs = railOf({{100, 300, 0},
                                  {300, 300, 0},
                                  {300, 480, 0},
                                  {250, 480, 0},
                                  {250, 350, 0},
                                  {150, 350, 0},
                                  {150, 480, 0},
                                  {100, 480, 0}});
        QVERIFY(symmetric({legs}, {{PartKind::Rail, 0}}).rails[0] == legs);
        QVERIFY(symmetric({side}, {{PartKind::Corner, 0, 1}, {PartKind::Rail, 7}}).rails.size() == 1);
    }
};

TOUCHDOWN_TEST(TestSurfaceSymmetry)

} // namespace test_surface_symmetry

#include "test_surface_symmetry.moc"
