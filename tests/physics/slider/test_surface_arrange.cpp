// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/surface_arrange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <ranges>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_arrange {

constexpr double width = 0.8e-3; // [m]
const PartSelection firstThree{{PartKind::Rail, 0}, {PartKind::Rail, 1}, {PartKind::Rail, 2}};

Rail box(double x0, double y0, double x1, double y1)
{
    return {RailKind::Step, {{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}, {}};
}
/// Places of boxes in µm.
AirBearingSurface surfaceOf(std::initializer_list<std::array<double, 4>> boxes)
{
    AirBearingSurface surface;
    for (const auto& [x0, y0, x1, y1] : boxes) surface.rails.push_back(box(x0 / 1e6, y0 / 1e6, x1 / 1e6, y1 / 1e6));
    return surface;
}
/// The least x and y of a rail in µm.
std::pair<double, double> cornerOf(const AirBearingSurface& surface, std::size_t rail)
{
    const std::vector<RailPoint>& points = surface.rails.at(rail).points;
    return {std::ranges::min(points, {}, &RailPoint::x).x * 1e6, std::ranges::min(points, {}, &RailPoint::y).y * 1e6};
}
bool at(const AirBearingSurface& surface, std::size_t rail, double x, double y)
{
    const auto [left, bottom] = cornerOf(surface, rail);
    return std::abs(left - x) < 1e-8 && std::abs(bottom - y) < 1e-8;
}

class TestSurfaceArrange : public QObject {
    Q_OBJECT

private slots:
    /// Boxes of 10, 20 and 40 um; together from 100 to 200 um along x and from 0 to 90 um along y.
    void alignsToTheEdgesOfAll()
    {
        const AirBearingSurface surface =
            surfaceOf({{100, 0, 110, 10}, {130, 30, 150, 50}, {160, 50, 200, 90}, {0, 0, 5, 5}});
        const auto places = [&](Alignment to, std::array<std::array<double, 2>, 3> expected) {
            const AirBearingSurface result = aligned(surface, firstThree, to);
            for (std::size_t i = 0; i < 3; ++i)
                if (!at(result, i, expected[i][0], expected[i][1])) return false;
            return result.rails[3] == surface.rails[3];
        };
        QVERIFY(places(Alignment::Left, {{{100, 0}, {100, 30}, {100, 50}}}));
        QVERIFY(places(Alignment::MiddleX, {{{145, 0}, {140, 30}, {130, 50}}}));
        QVERIFY(places(Alignment::Right, {{{190, 0}, {180, 30}, {160, 50}}}));
        QVERIFY(places(Alignment::Bottom, {{{100, 0}, {130, 0}, {160, 0}}}));
        QVERIFY(places(Alignment::MiddleY, {{{100, 40}, {130, 35}, {160, 25}}}));
        QVERIFY(places(Alignment::Top, {{{100, 80}, {130, 70}, {160, 50}}}));
        QCOMPARE(aligned(surface, {{PartKind::Rail, 0}, {PartKind::Edge, 1, 0}}, Alignment::Left), surface);
    }
    /// 10 + 20 + 40 um of 130 um leave two gaps of 30 um; the order along x is that of the middles.
    void distributesTheGaps()
    {
        const AirBearingSurface surface = surfaceOf({{100, 0, 110, 10}, {190, 20, 230, 60}, {111, 10, 131, 30}});
        const AirBearingSurface result = distributed(surface, firstThree, true);
        QVERIFY(at(result, 0, 100, 0));
        QVERIFY(at(result, 1, 190, 20));
        QVERIFY(at(result, 2, 140, 10));
        // Along y 70 um of 60 um overlap twice by 5 um.
        QVERIFY(at(distributed(surface, firstThree, false), 2, 111, 5));
        QCOMPARE(distributed(surface, {{PartKind::Rail, 0}, {PartKind::Rail, 1}}, true), surface);
    }
    void anArrayHasExactPlaces()
    {
        const AirBearingSurface surface = surfaceOf({{100, 0, 110, 10}, {190, 20, 230, 60}});
        const AirBearingSurface result =
            withArray(surface, {{PartKind::Rail, 0}, {PartKind::Rail, 1}}, 3, {50e-6, -2.5e-6});
        QCOMPARE(result.rails.size(), std::size_t(8));
        for (std::size_t k = 0; k <= 3; ++k) {
            QVERIFY(at(result, 2 * k, 100 + 50.0 * double(k), -2.5 * double(k)));
            QVERIFY(at(result, 2 * k + 1, 190 + 50.0 * double(k), 20 - 2.5 * double(k)));
        }
        QCOMPARE(withArray(surface, {{PartKind::Rail, 0}}, 0, {1e-6, 0.0}), surface);
    }
    void aMirroredCopyOfAMirroredCopyLiesOnTheFirst()
    {
        AirBearingSurface surface = surfaceOf({{100, 50, 110, 80}});
        surface.rails[0].points[1].wall = 2;
        surface = withMirroredCopies(std::move(surface), {{PartKind::Rail, 0}}, width);
        QVERIFY(at(surface, 1, 100, 720));
        surface = withMirroredCopies(std::move(surface), {{PartKind::Rail, 1}}, width);
        QCOMPARE(surface.rails.size(), std::size_t(3));
        QCOMPARE(surface.rails[2], surface.rails[0]);
    }
    /// Whatever was done before: alignment twice is alignment once, gaps are equal, and copies leave the originals.
    void randomSequences()
    {
        std::mt19937 draw(5);
        const auto below = [&draw](int count) { return static_cast<int>(draw() % static_cast<unsigned>(count)); };
        for (int sequence = 0; sequence < 40; ++sequence) {
            AirBearingSurface surface;
            for (int i = 0; i < 4; ++i) {
                const double x = below(1000000) * 1.23e-9, y = below(700000) * 1.07e-9;
                surface.rails.push_back(box(x, y, x + (1 + below(90000)) / 0.97e9, y + (1 + below(90000)) / 0.89e9));
            }
            for (int step = 0; step < 12; ++step) {
                PartSelection some;
                for (int i = 0; i < 4; ++i)
                    some.insert(
                        {PartKind::Rail, static_cast<std::size_t>(below(static_cast<int>(surface.rails.size())))});
                const AirBearingSurface before = surface;
                switch (below(4)) {
                case 0: {
                    const auto to = static_cast<Alignment>(below(6));
                    surface = aligned(before, some, to);
                    QCOMPARE(aligned(surface, some, to), surface);
                    break;
                }
                case 1: surface = distributed(before, some, below(2) == 0); break;
                case 2:
                    surface = withMirroredCopies(before, some, width);
                    QCOMPARE(surface.rails.size(), before.rails.size() + some.size());
                    break;
                default: surface = withArray(before, some, 1, {below(100) * 1e-7, 3e-6}); break;
                }
                if (surface.rails.size() > before.rails.size())
                    QVERIFY(std::ranges::equal(before.rails, surface.rails | std::views::take(before.rails.size())));
                while (surface.rails.size() > 9) surface.rails.pop_back();
            }
        }
    }
};

TOUCHDOWN_TEST(TestSurfaceArrange)

} // namespace test_surface_arrange

#include "test_surface_arrange.moc"
