// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/contact_patch.h"

#include <algorithm>
#include <cmath>

#include "core/physics/contact/contact_grid_error.h"
#include "core/physics/slider/minimum_spacing.h"
#include "core/physics/slider/recess.h"

namespace touchdown {

namespace {

constexpr int scanLines = 512;     // over the width
constexpr int scanPoints = 512;    // over the length at least
constexpr double mostNumber = 1e9; // of cells along a side, that they can be counted
constexpr double aside = 1e-12;    // from a break, relative to the length: on which side of it a value is taken

UniformGrid gridOf(double x0, double y0, double length, double width, double cell)
{
    const auto count = [&](double side) { return std::max(1, static_cast<int>(std::llround(side / cell))); };
    return {count(length), count(width), cell, cell, x0, y0};
}

/// Whole numbers of scan steps, or of cells, [x0, x1) x [y0, y1).
struct Box {
    int x0, y0, x1, y1;
    void include(const Box& other)
    {
        x0 = std::min(x0, other.x0);
        y0 = std::min(y0, other.y0);
        x1 = std::max(x1, other.x1);
        y1 = std::max(y1, other.y1);
    }
};

int gap(const Box& a, const Box& b)
{
    const int x = std::max(std::max(a.x0, b.x0) - std::min(a.x1, b.x1), 0);
    const int y = std::max(std::max(a.y0, b.y0) - std::min(a.y1, b.y1), 0);
    return std::max(x, y);
}

bool areNear(const Box& a, const Box& b)
{
    const auto size = [](const Box& box) { return std::max(box.x1 - box.x0, box.y1 - box.y0); };
    return gap(a, b) <= std::min(size(a), size(b));
}

void mergeNear(std::vector<Box>& boxes)
{
    for (bool merged = true; merged;) {
        merged = false;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            for (std::size_t k = i + 1; k < boxes.size();) {
                if (!areNear(boxes[i], boxes[k])) {
                    ++k;
                    continue;
                }
                boxes[i].include(boxes[k]);
                boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(k));
                merged = true;
            }
    }
}

/// Heights over a slider at its attitude, and where they are below the reach.
class SliderScan {
public:
    SliderScan(const AirBearingSurface& surface, double length, double width, double pitch, double roll, double reach)
        : recess_(surface, length, width), length_(length), width_(width), pitch_(pitch), roll_(roll), reach_(reach)
    {
        const MinimumSpacing::Place place = MinimumSpacing(surface, recess_).at({0.0, pitch, roll});
        lowest_ = place.at;
        base_ = place.spacing;
    }

    SurfacePoint lowest() const { return lowest_; }
    double recess(double x, double y) const { return recess_.at(x, y); }
    bool holds(double x, double y) const { return x >= 0.0 && x <= length_ && y >= 0.0 && y <= width_; }
    /// Above the lowest point; nothing comes lower than it, but for the rounding of where that is.
    double height(double x, double y) const
    {
        return std::max(pitch_ * (length_ - x) - roll_ * (y - 0.5 * width_) + recess_.at(x, y) - base_, 0.0);
    }

    /// The pieces of a line below the reach, as ranges of x.
    std::vector<std::pair<double, double>> below(double y) const
    {
        std::vector<double> breaks{0.0};
        recess_.breaksAlongX(y, 0.0, length_, breaks);
        breaks.push_back(length_);
        const double step = length_ / scanPoints;
        std::vector<std::pair<double, double>> pieces;
        const auto add = [&](double from, double to) {
            if (!pieces.empty() && from <= pieces.back().second + step)
                pieces.back().second = std::max(pieces.back().second, to);
            else
                pieces.emplace_back(from, to);
        };
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
            const double a = breaks[i], b = breaks[i + 1];
            if (b <= a) continue;
            const double slack = std::min(aside * length_, 0.25 * (b - a));
            const int parts = std::max(2, static_cast<int>(std::ceil((b - a) / step)));
            for (int k = 0; k <= parts; ++k) {
                const double x = std::clamp(a + (b - a) * k / parts, a + slack, b - slack);
                // What is between two points counts with the lower one.
                if (height(x, y) <= reach_) add(std::max(x - (b - a) / parts, a), std::min(x + (b - a) / parts, b));
            }
        }
        return pieces;
    }

private:
    Recess recess_;
    double length_, width_, pitch_, roll_, reach_;
    SurfacePoint lowest_;
    double base_ = 0.0; // of the lowest point [m]
};

std::vector<Box> regions(const SliderScan& scan, double length, double width, int lines, double lowestY,
                         const std::function<bool()>& goOn)
{
    std::vector<Box> done, open;
    for (int row = 0; row < lines; ++row) {
        if (goOn && !goOn()) return {};
        const double y = (row + 0.5) * width / lines;
        auto pieces = scan.below(y);
        const bool holdsLowest = row == std::min(static_cast<int>(lowestY / width * lines), lines - 1);
        // A ridge may end between two lines.
        if (holdsLowest) pieces.emplace_back(scan.lowest().x, scan.lowest().x);
        std::vector<Box> next;
        for (const auto& [from, to] : pieces) {
            Box box{static_cast<int>(std::floor(from / length * scanPoints)), row,
                    static_cast<int>(std::floor(to / length * scanPoints)) + 1, row + 1};
            for (Box& above : open)
                if (above.x0 < box.x1 && box.x0 < above.x1) {
                    box.include(above);
                    above.x1 = above.x0; // taken
                }
            next.push_back(box);
        }
        for (const Box& box : open)
            if (box.x1 > box.x0) done.push_back(box);
        open = std::move(next);
    }
    done.insert(done.end(), open.begin(), open.end());
    return done;
}

std::vector<double> atCentres(const UniformGrid& grid, const LengthAt& length)
{
    std::vector<double> values(grid.cells());
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) values[grid.at(i, j)] = length(grid.x(i), grid.y(j));
    return values;
}

std::string wholeMicrometres(double length) { return std::to_string(std::llround(length * 1e6)) + " um"; }

} // namespace

ContactPatch flatPatch(double length, double width, double cell)
{
    const UniformGrid grid = gridOf(0.0, 0.0, length, width, cell);
    const double endX = grid.nx * grid.dx, endY = grid.ny * grid.dy;
    const auto heightAt = [endX, endY](double x, double y) {
        return x >= 0.0 && x <= endX && y >= 0.0 && y <= endY ? 0.0 : beyondPad;
    };
    return {grid, std::vector<double>(grid.cells(), 0.0), {}, heightAt, {}};
}

ContactPatch spherePatch(double length, double width, double cell, double radius)
{
    ContactPatch patch = flatPatch(length, width, cell);
    const UniformGrid& grid = patch.grid;
    const double middleX = 0.5 * grid.nx * grid.dx, middleY = 0.5 * grid.ny * grid.dy;
    patch.heightAt = [middleX, middleY, radius](double atX, double atY) {
        const double x = atX - middleX, y = atY - middleY;
        return (x * x + y * y) / (2.0 * radius);
    };
    patch.height = atCentres(grid, patch.heightAt);
    return patch;
}

SliderPatches sliderPatches(const AirBearingSurface& surface, double length, double width, double pitch, double roll,
                            double cell, double reach, int mostCells, const std::function<bool()>& goOn)
{
    const SliderScan scan(surface, length, width, pitch, roll, reach);
    SliderPatches result;
    result.lowest = scan.lowest();
    // On multiples of the cell, one more all round, within the slider; merged as such, lest two share a cell.
    std::vector<Box> boxes;
    for (const Box& box : regions(scan, length, width, scanLines, scan.lowest().y, goOn)) {
        const auto low = [&](int steps, double side, int of) {
            return static_cast<int>(std::clamp(std::floor(steps * side / of / cell) - 1.0, 0.0, mostNumber));
        };
        const auto high = [&](int steps, double side, int of) {
            return static_cast<int>(
                std::min({std::ceil(steps * side / of / cell) + 1.0, std::floor(side / cell + 1e-9), mostNumber}));
        };
        const int x0 = low(box.x0, length, scanPoints), y0 = low(box.y0, width, scanLines);
        boxes.push_back({x0, y0, std::max(high(box.x1, length, scanPoints), x0 + 1),
                         std::max(high(box.y1, width, scanLines), y0 + 1)});
    }
    mergeNear(boxes);

    for (const Box& box : boxes) {
        const int nx = box.x1 - box.x0, ny = box.y1 - box.y0;
        if (nx > mostCells || ny > mostCells) {
            result.patches.clear();
            result.problem = "a region of " + wholeMicrometres(nx * cell) + " by " + wholeMicrometres(ny * cell) +
                             " can touch, which is more than " + std::to_string(mostCells) + " cells along or across";
            return result;
        }
        ContactPatch patch;
        patch.grid = {nx, ny, cell, cell, box.x0 * cell, box.y0 * cell};
        patch.height.reserve(patch.grid.cells());
        for (int j = 0; j < patch.grid.ny; ++j) {
            if (goOn && !goOn()) return {};
            for (int i = 0; i < patch.grid.nx; ++i) {
                patch.height.push_back(scan.height(patch.grid.x(i), patch.grid.y(j)));
                patch.recess.push_back(scan.recess(patch.grid.x(i), patch.grid.y(j)));
            }
        }
        patch.heightAt = [scan](double x, double y) { return scan.holds(x, y) ? scan.height(x, y) : beyondPad; };
        patch.recessAt = [scan](double x, double y) { return scan.holds(x, y) ? scan.recess(x, y) : beyondPad; };
        result.patches.push_back(std::move(patch));
    }
    const auto lowestOf = [](const ContactPatch& patch) { return *std::ranges::min_element(patch.height); };
    std::ranges::stable_sort(result.patches, {}, lowestOf);
    return result;
}

ContactPatch coarsened(const ContactPatch& patch)
{
    const UniformGrid grid = coarsened(patch.grid);
    return {grid, atCentres(grid, patch.heightAt), {}, patch.heightAt, patch.recessAt};
}

ContactPatch withoutMargin(ContactPatch patch, double limit)
{
    const UniformGrid& grid = patch.grid;
    Box box{grid.nx, grid.ny, 0, 0};
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i)
            if (patch.height[grid.at(i, j)] <= limit) box.include({i, j, i + 1, j + 1});
    if (box.x1 <= box.x0) return patch;
    ContactPatch inner;
    inner.grid = {box.x1 - box.x0, box.y1 - box.y0, grid.dx, grid.dy};
    inner.heightAt = patch.heightAt;
    inner.recessAt = patch.recessAt;
    inner.grid.x0 = grid.x0 + box.x0 * grid.dx;
    inner.grid.y0 = grid.y0 + box.y0 * grid.dy;
    for (int j = box.y0; j < box.y1; ++j)
        for (int i = box.x0; i < box.x1; ++i) {
            inner.height.push_back(patch.height[grid.at(i, j)]);
            inner.recess.push_back(patch.recess[grid.at(i, j)]);
        }
    return inner;
}

double patchDistance(const UniformGrid& a, const UniformGrid& b)
{
    const double x = std::max({a.x0 - (b.x0 + b.nx * b.dx), b.x0 - (a.x0 + a.nx * a.dx), 0.0});
    const double y = std::max({a.y0 - (b.y0 + b.ny * b.dy), b.y0 - (a.y0 + a.ny * a.dy), 0.0});
    return std::hypot(x, y);
}

} // namespace touchdown
