// SPDX-License-Identifier: GPL-3.0-or-later
//
// Air bearing surfaces drawn at random: rectangles, stars and ramps that overlap and reach over the slider's outline,
// with walls inside and outside their edges. Jumps are large and slopes small, so that a test can tell one from the
// other.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown::test {

class RandomSurface {
public:
    static constexpr double length = 0.85e-3; // [m]
    static constexpr double width = 0.70e-3;  // [m]
    /// No slope of recess against distance along an axis is greater, jumps apart [-].
    static constexpr double steepest = 0.06;

    explicit RandomSurface(unsigned seed) : generator_(seed) {}

    AirBearingSurface draw()
    {
        AirBearingSurface surface;
        surface.baseRecess = 3e-6;
        for (int i = 0; i < walls; ++i) surface.walls.push_back(wall());
        const int rails = whole(2, 10);
        for (int i = 0; i < rails; ++i) surface.rails.push_back(rail());
        return surface;
    }
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator_); }

private:
    static constexpr int walls = 4;
    // Tops and walls are on different levels: [0, 1.5], whole 0.5 um, and their wall 0.25 um aside.
    static constexpr double level = 0.5e-6;

    /// Two to five points, from inside the edge or from the edge on; some vertical at a point.
    WallProfile wall()
    {
        WallProfile profile;
        double distance = whole(0, 1) ? 0.0 : -uniform(2e-6, 12e-6);
        double recess = level * whole(0, 2) + 0.5 * level;
        const int points = whole(2, 5);
        for (int i = 0; i < points; ++i) {
            profile.distance.push_back(distance);
            profile.recess.push_back(recess);
            const double step = whole(0, 4) ? uniform(2e-6, 15e-6) : 0.0;
            recess += step > 0.0 ? uniform(-0.5, 1.0) * 0.5 * steepest * step : level;
            distance += step;
        }
        return profile;
    }

    Rail rail()
    {
        Rail rail;
        const double x = uniform(-0.05, 1.05) * length;
        const double y = uniform(-0.05, 1.05) * width;
        if (whole(0, 2) == 0) {
            const double dx = uniform(5e-6, 300e-6);
            const double dy = uniform(5e-6, 300e-6);
            rail.points = {{x, y, 0}, {x + dx, y, 0}, {x + dx, y + dy, 0}, {x, y + dy, 0}};
        } else {
            const int count = whole(3, 24);
            const double size = uniform(20e-6, 200e-6);
            for (int i = 0; i < count; ++i) {
                const double angle = 2.0 * 3.14159265358979 * (i + uniform(0.0, 0.7)) / count;
                const double radius = size * uniform(0.35, 1.0);
                rail.points.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle), 0});
            }
        }
        for (RailPoint& p : rail.points) p.wall = whole(0, 3) ? whole(1, walls) : 0;
        if (whole(0, 1)) std::reverse(rail.points.begin(), rail.points.end());
        rail.recess[0] = level * whole(-1, 3);
        if (whole(0, 4) == 0) makeRamp(rail);
        return rail;
    }
    void makeRamp(Rail& rail)
    {
        rail.kind = RailKind::Ramp;
        const double cx = uniform(-0.4, 0.4) * steepest * 0.1;
        const double cy = uniform(-0.4, 0.4) * steepest * 0.1;
        const double c = rail.recess[0] - cx * rail.points[0].x - cy * rail.points[0].y;
        for (std::size_t i = 0; i < 3; ++i) rail.recess[i] = c + cx * rail.points[i].x + cy * rail.points[i].y;
    }

    std::mt19937 generator_;
};

} // namespace touchdown::test
