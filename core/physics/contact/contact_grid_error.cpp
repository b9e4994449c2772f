// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/contact_grid_error.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/physics/contact/elastic_contact.h"

namespace touchdown {
namespace {

constexpr double errorPerCell = 0.4;          // of an island's force, times its number of cells [-]
constexpr double cellsWanted = 64.0;          // in contact on the finer grid
constexpr int mostRefined = 64;               // r
constexpr double mostFineCells = 262144.0;    // of the finer grid: a second or two
constexpr double mostSearchCells = 4194304.0; // at which the undeformed surfaces are compared
constexpr int searchTimes = 8, searches = 3;  // for an overlap between these points
constexpr double refinedTolerance = 1e-6;
constexpr int mostIterations = 2000;

/// Cells [x0, x1) x [y0, y1) of a grid.
struct Window {
    int x0, y0, x1, y1;
    bool empty() const { return x1 <= x0; }
    void include(int i, int j)
    {
        x0 = std::min(x0, i);
        y0 = std::min(y0, j);
        x1 = std::max(x1, i + 1);
        y1 = std::max(y1, j + 1);
    }
};

struct IslandSums {
    double force = 0.0, area = 0.0; // [N], [m^2]
    double forceDoubt = 0.0;        // bounds of their errors
    double areaDoubt = 0.0;
};

/// IslandSums over the islands of touching cells, neighbours across sides.
IslandSums sumsOf(const UniformGrid& grid, std::span<const double> pressure)
{
    IslandSums sums;
    std::vector<char> seen(grid.cells(), 0);
    std::vector<std::size_t> open;
    const auto touches = [&](int i, int j) {
        return i >= 0 && j >= 0 && i < grid.nx && j < grid.ny && pressure[grid.at(i, j)] > 0.0;
    };
    for (std::size_t first = 0; first < pressure.size(); ++first) {
        if (!(pressure[first] > 0.0) || seen[first]) continue;
        double load = 0.0, cells = 0.0, rim = 0.0;
        open.assign(1, first);
        seen[first] = 1;
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            load += pressure[at] * grid.cellArea();
            cells += 1.0;
            const int i = static_cast<int>(at % static_cast<std::size_t>(grid.nx));
            const int j = static_cast<int>(at / static_cast<std::size_t>(grid.nx));
            bool atRim = false;
            for (const auto& [x, y] : {std::pair{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}}) {
                if (!touches(x, y)) {
                    atRim = true;
                } else if (!seen[grid.at(x, y)]) {
                    seen[grid.at(x, y)] = 1;
                    open.push_back(grid.at(x, y));
                }
            }
            rim += atRim ? 1.0 : 0.0;
        }
        sums.force += load;
        sums.area += cells * grid.cellArea();
        sums.forceDoubt += errorPerCell * load / cells;
        sums.areaDoubt += 0.5 * rim * grid.cellArea();
    }
    return sums;
}

UniformGrid refined(const UniformGrid& grid, const Window& window, int times)
{
    return {(window.x1 - window.x0) * times, (window.y1 - window.y0) * times, grid.dx / times, grid.dy / times,
            grid.x0 + window.x0 * grid.dx,   grid.y0 + window.y0 * grid.dy};
}

/// Where pressure may act, and about how many cells it may cover.
struct Overlap {
    Window window;
    double cells;
};

/// The cell of `grid` around whose lowest point at `around`, between the samples, surfaces overlap; none if they do
/// not.
void includeHidden(const UniformGrid& grid, UniformGrid around, const SeparationOn& separation, Overlap& reach)
{
    std::vector<double> s;
    for (int search = 0; search < searches; ++search) {
        s.resize(around.cells());
        separation(around, s);
        const auto lowest = std::ranges::min_element(s);
        const int at = static_cast<int>(lowest - s.begin());
        const double x = around.x(at % around.nx), y = around.y(at / around.nx);
        if (*lowest < 0.0) {
            const auto cell = [](double length, double side, int count) {
                return std::clamp(static_cast<int>(length / side), 0, count - 1);
            };
            reach.window.include(cell(x - grid.x0, grid.dx, grid.nx), cell(y - grid.y0, grid.dy, grid.ny));
            reach.cells = around.cellArea() / grid.cellArea();
            return;
        }
        around = {2 * searchTimes,         2 * searchTimes, around.dx / searchTimes,
                  around.dy / searchTimes, x - around.dx,   y - around.dy};
    }
}

Overlap overlapOf(const ContactState& state, const SeparationOn& separation)
{
    const UniformGrid& grid = state.grid;
    Overlap reach{{grid.nx, grid.ny, 0, 0}, 0.0};
    const int times = 16.0 * static_cast<double>(grid.cells()) <= mostSearchCells ? 4 : 1;
    const UniformGrid fine = refined(grid, {0, 0, grid.nx, grid.ny}, times);
    std::vector<double> s(fine.cells());
    separation(fine, s);
    double overlap = 0.0, touching = 0.0;
    for (int j = 0; j < fine.ny; ++j)
        for (int i = 0; i < fine.nx; ++i)
            if (s[fine.at(i, j)] < 0.0) {
                overlap += 1.0 / (times * times);
                reach.window.include(i / times, j / times);
            }
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
            if (state.pressure[grid.at(i, j)] > 0.0) {
                touching += 1.0;
                reach.window.include(i, j);
            }
    // A sphere touches on half of the area of its overlap; what touches on the grid may be too large.
    reach.cells = std::min(touching > 0.0 ? touching : overlap, std::max(0.5 * overlap, 1.0 / (times * times)));
    if (reach.window.empty()) includeHidden(grid, fine, separation, reach);
    Window& w = reach.window;
    if (state.edges == HalfSpaceEdges::Periodic && !w.empty()) w = {0, 0, grid.nx, grid.ny};
    if (!w.empty())
        w = {std::max(w.x0 - 1, 0), std::max(w.y0 - 1, 0), std::min(w.x1 + 1, grid.nx), std::min(w.y1 + 1, grid.ny)};
    return reach;
}

} // namespace

UniformGrid coarsened(const UniformGrid& grid)
{
    const int nx = (grid.nx + 1) / 2, ny = (grid.ny + 1) / 2;
    return {nx, ny, grid.nx * grid.dx / nx, grid.ny * grid.dy / ny, grid.x0, grid.y0};
}

ContactGridError contactGridError(const ContactState& state, const SeparationOn& separation,
                                  const std::function<bool()>& goOn)
{
    const IslandSums own = sumsOf(state.grid, state.pressure);
    ContactGridError error;
    error.cells = std::ranges::count_if(state.pressure, [](double p) { return p > 0.0; });
    const auto [window, covered] = overlapOf(state, separation);
    if (window.empty()) {
        error.known = true; // nothing can touch
        return error;
    }
    const double cells = static_cast<double>(window.x1 - window.x0) * (window.y1 - window.y0);
    int times = 2;
    while (times < mostRefined && covered * times * times < cellsWanted && 4.0 * cells * times * times <= mostFineCells)
        times *= 2;
    const bool finer = cells * times * times <= mostFineCells;
    const UniformGrid grid = finer ? refined(state.grid, window, times) : coarsened(state.grid);
    std::vector<double> s(grid.cells());
    separation(grid, s);
    ElasticContact contact(
        HalfSpace(grid, state.modulus, state.edges, goOn),
        {.tolerance = refinedTolerance, .maximumIterations = mostIterations, .hardness = state.hardness, .goOn = goOn});
    if (!contact.solve(s).converged) return error;
    const IslandSums other = sumsOf(grid, contact.pressure());
    error.known = true;
    error.cell = grid.dx;
    error.other = other.force;
    error.force = std::abs(own.force - other.force);
    error.area = std::abs(own.area - other.area);
    if (finer) {
        error.force += std::max(error.force / (times - 1), other.forceDoubt);
        error.area += std::max(error.area / (times - 1), other.areaDoubt);
    }
    return error;
}

bool isCutOff(const ContactState& state, const SeparationOn& separation)
{
    if (state.edges == HalfSpaceEdges::Periodic) return false;
    const UniformGrid& grid = state.grid;
    const UniformGrid around{grid.nx + 2, grid.ny + 2, grid.dx, grid.dy, grid.x0 - grid.dx, grid.y0 - grid.dy};
    std::vector<double> s(around.cells());
    separation(around, s);
    const auto cut = [&](int i, int j, int outI, int outJ) {
        return state.pressure[grid.at(i, j)] > 0.0 && s[around.at(outI + 1, outJ + 1)] < 0.0;
    };
    for (int i = 0; i < grid.nx; ++i)
        if (cut(i, 0, i, -1) || cut(i, grid.ny - 1, i, grid.ny)) return true;
    for (int j = 0; j < grid.ny; ++j)
        if (cut(0, j, -1, j) || cut(grid.nx - 1, j, grid.nx, j)) return true;
    return false;
}

} // namespace touchdown
