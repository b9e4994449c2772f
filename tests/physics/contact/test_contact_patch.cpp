// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/contact_patch.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_patch {

constexpr double length = 1.25e-3, width = 1e-3, cell = 0.5e-6;
constexpr int mostCells = 2048;

Rail rail(double x0, double x1, double y0, double y1, double recess = 0.0)
{
    return {RailKind::Step, {{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}, {recess}};
}

/// Two trailing pads, 0.45 mm apart.
AirBearingSurface twoPads()
{
    AirBearingSurface surface;
    surface.rails = {rail(1.1e-3, 1.2e-3, 0.2e-3, 0.25e-3), rail(1.1e-3, 1.2e-3, 0.7e-3, 0.75e-3)};
    return surface;
}

double end(double x0, int n, double d) { return x0 + n * d; }

class TestContactPatch : public QObject {
    Q_OBJECT

private slots:
    void flat()
    {
        const ContactPatch patch = flatPatch(20e-6, 10e-6, 0.25e-6);
        QCOMPARE(patch.grid.nx, 80);
        QCOMPARE(patch.grid.ny, 40);
        QVERIFY(std::ranges::all_of(patch.height, [](double h) { return h == 0.0; }));
    }
    /// r^2/(2 R) about the middle, which lies between four cells: their centres are half a diagonal off, r^2 = 2
    /// (cell/2)^2.
    void sphere()
    {
        const ContactPatch patch = spherePatch(8e-6, 4e-6, 1e-6, 1e-3);
        QCOMPARE(patch.grid.nx, 8);
        QCOMPARE(patch.grid.ny, 4);
        const auto at = [&](int i, int j) { return patch.height[static_cast<std::size_t>(j * 8 + i)]; };
        for (const auto& [i, j] : {std::pair{3, 1}, {4, 1}, {3, 2}, {4, 2}})
            QVERIFY(std::abs(at(i, j) - 0.5e-12 / 2e-3) < 1e-24);
        QVERIFY(std::abs(at(0, 0) - (3.5e-6 * 3.5e-6 + 1.5e-6 * 1.5e-6) / 2e-3) < 1e-22);
        QVERIFY(std::abs(at(0, 0) - at(7, 3)) < 1e-22);
    }

    /// With a pitch of 100 urad the pads rise by 0.1 nm a micrometre: those of a reach of 3 nm end 30 um ahead of their
    /// trailing edge.
    void padsOfASlider()
    {
        const SliderPatches found = sliderPatches(twoPads(), length, width, 100e-6, 0.0, cell, 3e-9, mostCells);
        QCOMPARE(found.problem, std::string());
        QCOMPARE(found.patches.size(), std::size_t{2});
        QVERIFY(std::abs(found.lowest.x - 1.2e-3) < 1e-9);
        // A scan step of 1.25 mm/512 to the next point, one more to the next whole number of them, and two cells.
        const double slack = 2.0 * length / 512.0 + 2.0 * cell;
        for (const ContactPatch& patch : found.patches) {
            const UniformGrid& grid = patch.grid;
            QVERIFY(grid.x0 <= 1.17e-3 && grid.x0 >= 1.17e-3 - slack);
            QVERIFY(end(grid.x0, grid.nx, cell) >= 1.2e-3 && end(grid.x0, grid.nx, cell) <= 1.2e-3 + slack);
            QVERIFY(std::abs(grid.ny * cell - 50e-6) <= 2.0 * slack);
            for (int j = 0; j < grid.ny; ++j)
                for (int i = 0; i < grid.nx; ++i) {
                    const double y = grid.y(j), x = grid.x(i);
                    const bool onPad =
                        x > 1.1e-3 && x < 1.2e-3 && ((y > 0.2e-3 && y < 0.25e-3) || (y > 0.7e-3 && y < 0.75e-3));
                    if (!onPad) continue;
                    const double height = patch.height[static_cast<std::size_t>(j * grid.nx + i)];
                    // The lowest point is sought 0.1 nm beside the edge.
                    QVERIFY(std::abs(height - 100e-6 * (1.2e-3 - x)) < 1.1e-14);
                }
        }
    }
    /// Beside the pad stands the base recess, far away.
    void besideAPad()
    {
        const SliderPatches found = sliderPatches(twoPads(), length, width, 100e-6, 0.0, cell, 3e-9, mostCells);
        const ContactPatch& patch = found.patches.front();
        QVERIFY(*std::ranges::max_element(patch.height) > 1.9e-6);
        QVERIFY(*std::ranges::min_element(patch.height) < 100e-6 * cell);
    }
    /// Without it the patch ends at the pad's sides, 100 cells of 0.5 um apart, and at its trailing edge.
    void margins()
    {
        const SliderPatches found = sliderPatches(twoPads(), length, width, 100e-6, 0.0, cell, 3e-9, mostCells);
        const ContactPatch &whole = found.patches.front(), inner = withoutMargin(whole, 1e-7);
        QVERIFY(inner.grid.nx < whole.grid.nx);
        QCOMPARE(inner.grid.ny, 100);
        QVERIFY(std::abs(end(inner.grid.x0, inner.grid.nx, cell) - 1.2e-3) < 1e-9);
        QVERIFY(*std::ranges::max_element(inner.height) < 10e-9);
        QCOMPARE(inner.height.size(), inner.grid.cells());
        QCOMPARE(inner.recess.size(), inner.grid.cells());
        const auto i = static_cast<int>(std::lround((inner.grid.x0 - whole.grid.x0) / cell));
        const auto j = static_cast<int>(std::lround((inner.grid.y0 - whole.grid.y0) / cell));
        QCOMPARE(inner.height[inner.grid.at(3, 7)], whole.height[whole.grid.at(i + 3, j + 7)]);
        QCOMPARE(withoutMargin(whole, -1.0).grid.nx, whole.grid.nx); // nothing is so low
    }
    /// Rolled by 20 urad the pads differ by 9 nm: one of them stays out of reach.
    void onePadOfARolledSlider()
    {
        const SliderPatches found = sliderPatches(twoPads(), length, width, 100e-6, 20e-6, cell, 3e-9, mostCells);
        QCOMPARE(found.patches.size(), std::size_t{1});
        QVERIFY(found.patches.front().grid.y0 > 0.6e-3); // the outer one: the inner edge is up
    }
    /// Two pads nearer to each other than they are long are solved together.
    void nearPadsAreOne()
    {
        AirBearingSurface surface;
        surface.rails = {rail(1.1e-3, 1.2e-3, 0.4e-3, 0.45e-3), rail(1.1e-3, 1.2e-3, 0.47e-3, 0.52e-3)};
        const SliderPatches found = sliderPatches(surface, length, width, 100e-6, 0.0, cell, 5e-9, mostCells);
        QCOMPARE(found.patches.size(), std::size_t{1});
        QVERIFY(found.patches.front().grid.ny * cell >= 0.12e-3);
    }
    /// Posts of 6 um, 20 um apart, are not near each other, but cells of 40 um with one more all round are.
    void noCellIsInTwoPatches()
    {
        AirBearingSurface surface;
        surface.rails = {rail(1.1e-3, 1.106e-3, 0.4e-3, 0.406e-3), rail(1.126e-3, 1.132e-3, 0.4e-3, 0.406e-3)};
        QCOMPARE(sliderPatches(surface, length, width, 0.0, 0.0, cell, 1e-9, mostCells).patches.size(), std::size_t{2});
        QCOMPARE(sliderPatches(surface, length, width, 0.0, 0.0, 40e-6, 1e-9, mostCells).patches.size(),
                 std::size_t{1});
    }
    void firstHoldsTheLowestPoint()
    {
        AirBearingSurface surface = twoPads();
        surface.rails[0].recess[0] = 1e-9;
        const SliderPatches found = sliderPatches(surface, length, width, 100e-6, 0.0, cell, 3e-9, mostCells);
        QCOMPARE(found.patches.size(), std::size_t{2});
        QVERIFY(found.patches.front().grid.y0 > 0.6e-3);
        QVERIFY(found.lowest.y > 0.6e-3);
    }
    /// Without pitch a pad of 1 mm lies flat: 2000 cells of 0.5 um along it.
    void tooManyCells()
    {
        AirBearingSurface surface;
        surface.rails = {rail(0.2e-3, 1.2e-3, 0.4e-3, 0.5e-3)};
        const SliderPatches found = sliderPatches(surface, length, width, 0.0, 0.0, cell, 1e-9, 1000);
        QVERIFY(found.patches.empty());
        QVERIFY2(found.problem.find("more than 1000 cells") != std::string::npos, found.problem.c_str());
        QVERIFY(sliderPatches(surface, length, width, 0.0, 0.0, cell, 1e-9, mostCells).problem.empty());
    }
    /// No reach: the patch is around the lowest point alone.
    void nothingInReach()
    {
        const SliderPatches found = sliderPatches(twoPads(), length, width, 100e-6, 20e-6, cell, 0.0, mostCells);
        QCOMPARE(found.patches.size(), std::size_t{1});
        QVERIFY(found.patches.front().grid.nx < 20);
    }

    void distances()
    {
        const UniformGrid a{10, 10, 1e-6, 1e-6, 0.0, 0.0};
        QCOMPARE(patchDistance(a, {10, 10, 1e-6, 1e-6, 5e-6, 5e-6}), 0.0);
        QVERIFY(std::abs(patchDistance(a, {10, 10, 1e-6, 1e-6, 13e-6, 14e-6}) - 5e-6) < 1e-18);
        QVERIFY(std::abs(patchDistance({10, 10, 1e-6, 1e-6, 13e-6, 0.0}, a) - 3e-6) < 1e-18);
    }
};

TOUCHDOWN_TEST(TestContactPatch)

} // namespace test_contact_patch

#include "test_contact_patch.moc"
