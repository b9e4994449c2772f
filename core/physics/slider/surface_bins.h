// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rails and walls sorted into equal bins over the slider, so that a point is compared only with those near it. The
// lists of a bin are complete for the bin with its borders, without walls that are hidden everywhere in it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/physics/slider/rail_outline.h"
#include "core/physics/slider/rail_wall.h"

namespace touchdown {

/// The height of a rail's top: c + cx x + cy y, level for a step [m].
struct RailTop {
    double c = 0.0;  // [m]
    double cx = 0.0; // [-]
    double cy = 0.0; // [-]
    double at(double x, double y) const { return c + cx * x + cy * y; }
};

/// The parts of a surface. The wall shapes must not move: the walls refer to them.
struct SurfaceParts {
    double length, width; // [m]
    double baseRecess;    // [m]
    std::vector<RailTop> tops;
    std::vector<RailOutline> outlines; // one for each top
    std::vector<WallShape> shapes;
    std::vector<RailWall> walls; // in the order of their rails
};

class SurfaceBins {
public:
    static constexpr int columns = 128; // along x
    static constexpr int rows = 128;    // along y; the outlines have as many strips

    struct WallPart {
        std::uint32_t wall;
        WallSide side;
        bool certain;  // all of the bin is outside (inside) the polygon of the wall
        double lowest; // lower bound of the wall's recess in the bin; only outside [m]
    };
    struct Bin {
        int cover = -1; // the last rail that covers all of the bin; -1: none
        std::uint32_t rails = 0, walls = 0;
    };

    explicit SurfaceBins(const SurfaceParts& parts);

    int column(double x) const; // the first and the last extend to infinity
    int row(double y) const;
    SurfaceBox box(int column, int row) const;
    static std::size_t index(int column, int row) { return static_cast<std::size_t>(row * columns + column); }

    int cover(std::size_t bin) const { return bins_[bin].cover; }
    /// The rails whose outlines meet the bin, the last first, without those of which nothing is visible.
    std::span<const int> rails(std::size_t bin) const;
    /// Parts inside their polygon come first, then those outside, the lowest first.
    std::span<const WallPart> walls(std::size_t bin) const;

private:
    struct RailEntry {
        std::uint32_t bin;
        int rail;
    };
    struct WallEntry {
        std::uint32_t bin;
        WallPart part;
    };
    enum class Place : std::uint8_t { Outside, Inside, Crossed };

    void placeRail(const SurfaceParts& parts, int rail, std::vector<Place>& places);
    void sortRail(const std::vector<Place>& places, int rail, std::vector<RailEntry>& entries);
    void sortWall(const SurfaceParts& parts, std::uint32_t wall, const std::vector<Place>& places,
                  std::vector<WallEntry>& entries) const;
    void dropHidden(const SurfaceParts& parts, const std::vector<RailEntry>& rails,
                    std::vector<WallEntry>& walls) const;
    void fill(const SurfaceParts& parts, const std::vector<RailEntry>& rails, const std::vector<WallEntry>& walls);

    double length_, width_; // [m]
    double perX_, perY_;    // bins per metre
    std::vector<Bin> bins_; // one more for the end of the lists
    std::vector<int> rails_;
    std::vector<WallPart> walls_;
};

} // namespace touchdown
