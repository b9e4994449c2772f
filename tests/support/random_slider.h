// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sliders drawn at random: a leading shelf with two arms, a leading pad, side pads, and a trailing shelf with pad and
// pocket, all with slanted edges and walls of finite width. Each is loaded so that it flies near a minimum spacing of
// 14 nm and a pitch of 140 urad: its load, the load point and its attitude come from one film at that attitude.
//
// A seed gives the same slider on every platform: the standard defines std::mt19937_64 bit for bit, the distributions
// are made here, and drawn lengths are rounded to 10 nm or 0.1 nm. The load depends on the solver and is rounded to
// four digits.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/formats/units.h"
#include "core/physics/slider/recess.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown::test {

class RandomSlider {
public:
    static constexpr double spacing = 14e-9; // at which each flies about [m]
    static constexpr double pitch = 140e-6;  // [rad]

    explicit RandomSlider(std::uint64_t seed) : seed_(seed), generator_(seed) {}

    /// Draws until a slider flies as wanted; its initial attitude is the static one, about. Film cases with 193 x 193
    /// nodes, without a problem of checkCombinations().
    Case draw()
    {
        for (;;) {
            Case c = shape();
            if (balance(c) && flies(c)) return c;
        }
    }

    /// A slider without its load.
    Case shape()
    {
        Case c;
        c.title = "Random slider " + std::to_string(seed_);
        c.model = ModelKind::Film;
        c.contact = noContact;
        c.degreesOfFreedom = 3;
        drawBody(c);
        c.disk.radius = rounded(uniform(15e-3, 42e-3), 1e-5);
        c.disk.speed = rpm * pick({5400.0, 7200.0, 10000.0, 12000.0, 15000.0});
        c.disk.skew = std::round(uniform(-1400.0, 1400.0)) / 100.0 * std::numbers::pi / 180.0;
        surface_ = {};
        surface_.crown = height(5e-9, 25e-9);
        surface_.camber = height(-3e-9, 3e-9);
        surface_.twist = height(-2.5e-9, 2.5e-9);
        surface_.baseRecess = depth(0.8e-6, 2.8e-6);
        shelf_ = depth(0.1e-6, 0.3e-6);
        drawWalls();
        drawLeading();
        drawSides();
        drawTrailing();
        c.surface = surface_;
        return c;
    }

private:
    static constexpr double rpm = 2.0 * std::numbers::pi / 60.0; // [rad/s]
    enum Wall { None, OfPad, OfShelf, OfPocket };

    double uniform(double low, double high)
    {
        return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
    }
    bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
    double pick(std::initializer_list<double> values) { return values.begin()[generator_() % values.size()]; }
    static double rounded(double value, double unit) { return std::round(value / unit) / std::round(1.0 / unit); }
    double height(double low, double high) { return rounded(uniform(low, high), 1e-11); }
    double depth(double low, double high) { return rounded(uniform(low, high), 1e-10); }

    void drawBody(Case& c)
    {
        const bool femto = chance(0.6);
        c.slider = {.mass = femto ? 0.58e-6 : 1.6e-6,
                    .pitchInertia = femto ? 3.8e-14 : 2.2e-13,
                    .rollInertia = femto ? 2.6e-14 : 1.45e-13,
                    .length = femto ? 0.85e-3 : 1.25e-3,
                    .width = femto ? 0.7e-3 : 1.0e-3,
                    .thickness = femto ? 0.23e-3 : 0.3e-3};
        length_ = c.slider.length;
        width_ = c.slider.width;
    }

    /// From `top` at the inner end to `bottom` at the outer end, steeper in the middle; as wide as 1 to 8 um.
    WallProfile wall(double top, double bottom, double inside)
    {
        const double width = uniform(1e-6, 8e-6);
        const int points = 3 + static_cast<int>(generator_() % 3);
        WallProfile profile;
        for (int k = 0; k < points; ++k) {
            const double t = static_cast<double>(k) / (points - 1), jitter = k % (points - 1) == 0 ? 0.0 : 0.1;
            const double at = t + uniform(-jitter, jitter), s = std::clamp(t + uniform(-jitter, jitter), 0.0, 1.0);
            profile.distance.push_back(rounded((at - inside) * width, 1e-10));
            profile.recess.push_back(rounded(top + (bottom - top) * s * s * (3.0 - 2.0 * s), 1e-10));
        }
        return profile;
    }
    /// Half of the sliders have walls that all begin at the recess of the pads, as those of real ones often do: their
    /// shelves and pockets then have a narrow ridge along each edge.
    void drawWalls()
    {
        pocket_ = shelf_ + depth(0.2e-6, 0.5e-6);
        const bool ridges = chance(0.5);
        surface_.walls = {wall(0.0, surface_.baseRecess, uniform(0.0, 0.15)),
                          wall(ridges ? 0.0 : shelf_, surface_.baseRecess, uniform(0.0, 0.15)),
                          ridges ? wall(0.0, surface_.baseRecess, uniform(0.0, 0.15)) : wall(pocket_, shelf_, 1.0)};
    }

    /// A polygon in shares of length and width, each corner moved by up to `jitter`.
    void rail(std::initializer_list<std::pair<double, double>> corners, double recess, Wall walls, double jitter = 0.02)
    {
        Rail rail;
        for (const auto& [x, y] : corners)
            rail.points.push_back({place(x, jitter, length_), place(y, jitter, width_), walls});
        rail.recess[0] = recess;
        surface_.rails.push_back(std::move(rail));
    }
    double place(double share, double jitter, double size)
    {
        const double moved = std::clamp(share + uniform(-jitter, jitter), 0.025, 0.975);
        return rounded(moved * size, 1e-8);
    }
    void step(std::initializer_list<std::pair<double, double>> corners) { rail(corners, shelf_, OfShelf); }
    void pad(std::initializer_list<std::pair<double, double>> corners) { rail(corners, 0.0, OfPad, 0.012); }

    /// A shelf across the width with an arm along each side, and a pad on it, which may be parted.
    void drawLeading()
    {
        const double bar = uniform(0.22, 0.3), inner = uniform(0.36, 0.55), outer = uniform(0.36, 0.55);
        const double arm = uniform(0.12, 0.18);
        step({{0.04, 0.05},
              {inner, 0.05},
              {inner - 0.04, 0.05 + arm},
              {bar, 0.12 + arm},
              {bar + 0.03, 0.5},
              {bar, 0.88 - arm},
              {outer - 0.04, 0.95 - arm},
              {outer, 0.95},
              {0.04, 0.95}});
        const double front = uniform(0.08, 0.11), back = bar - uniform(0.02, 0.04);
        if (chance(0.5)) {
            pad({{front, 0.15}, {back, 0.12}, {back + 0.01, 0.5}, {back, 0.88}, {front, 0.85}});
        } else {
            const double gap = uniform(0.08, 0.16);
            pad({{front, 0.12}, {back, 0.14}, {back - 0.02, 0.5 - gap}, {front + 0.01, 0.48 - gap}});
            pad({{front + 0.01, 0.52 + gap}, {back - 0.02, 0.5 + gap}, {back, 0.86}, {front, 0.88}});
        }
    }

    /// Islands behind the arms: pads, each perhaps on a shelf of its own.
    void drawSides()
    {
        for (const bool outer : {false, true}) {
            const double x = uniform(0.58, 0.62), end = uniform(0.74, 0.8), deep = uniform(0.13, 0.18);
            const auto y = [outer](double share) { return outer ? 1.0 - share : share; };
            if (chance(0.5))
                step({{x - 0.03, y(0.06)}, {end + 0.02, y(0.06)}, {end, y(0.1 + deep)}, {x, y(0.08 + deep)}});
            pad({{x + 0.03, y(0.08)}, {end - 0.02, y(0.09)}, {end - 0.04, y(0.05 + deep)}, {x + 0.04, y(0.06 + deep)}});
        }
    }

    /// A shelf in the middle of the trailing edge, a pad on it, and before the pad perhaps a pocket.
    void drawTrailing()
    {
        const double half = uniform(0.14, 0.2), front = uniform(0.64, 0.7);
        step({{front, 0.5 - 0.8 * half},
              {0.965, 0.5 - half - 0.03},
              {0.97, 0.5 + half + 0.03},
              {front, 0.5 + 0.8 * half}});
        const double pads = uniform(0.83, 0.87);
        pad({{pads - 0.04, 0.5 - half},
             {pads + 0.02, 0.5 - half - 0.01},
             {0.955, 0.5 - 0.5 * half},
             {0.955, 0.5 + 0.5 * half},
             {pads + 0.02, 0.5 + half + 0.01},
             {pads - 0.04, 0.5 + half},
             {pads, 0.5}});
        if (chance(0.5))
            rail({{front + 0.04, 0.46}, {pads - 0.05, 0.45}, {pads - 0.05, 0.55}, {front + 0.04, 0.54}}, pocket_,
                 OfPocket, 0.008);
    }

    static Case onCoarseGrid(const Case& c, bool fixedAttitude)
    {
        Case coarse = c;
        coarse.film.nodes = {65, 65};
        coarse.steady.fixedAttitude = fixedAttitude;
        coarse.steady.stiffness = false;
        return coarse;
    }

    /// The lowest point of a lattice and beside the edges: above the minimum spacing where walls begin inside. The
    /// errors that are stated were chosen on sliders drawn with this height.
    static double lowestOf(const AirBearingSurface& surface, const Recess& recess, const Attitude& attitude)
    {
        const double length = recess.length(), width = recess.width();
        double lowest = 1.0;
        const auto look = [&](double x, double y) {
            if (x < 0.0 || y < 0.0 || x > length || y > width) return;
            lowest = std::min(lowest, recess.at(x, y) + attitude.height + attitude.pitch * (length - x) -
                                          attitude.roll * (y - 0.5 * width));
        };
        for (int j = 0; j <= 128; ++j)
            for (int i = 0; i <= 128; ++i) look(length * i / 128, width * j / 128);
        for (const Rail& rail : surface.rails)
            for (std::size_t k = 0; k < rail.points.size(); ++k) {
                const RailPoint &a = rail.points[k], &b = rail.points[(k + 1) % rail.points.size()];
                const double dx = b.x - a.x, dy = b.y - a.y, edge = std::hypot(dx, dy), beside = 1e-10;
                const int parts = std::clamp(static_cast<int>(64 * edge / length), 1, 64);
                for (int m = 0; m <= parts; ++m)
                    for (const double side : {-beside, beside}) {
                        const double along = std::clamp(edge * m / parts, beside, edge - beside) / edge;
                        look(a.x + along * dx - side * dy / edge, a.y + along * dy + side * dx / edge);
                    }
            }
        return lowest;
    }

    /// Sets the attitude, and the load that balances its film. False where that is no load of a real suspension.
    bool balance(Case& c)
    {
        const Recess recess(c.surface, length_, width_);
        const double roll = rounded(uniform(-4e-6, 4e-6), 1e-8);
        const double above = lowestOf(c.surface, recess, {0.0, pitch, roll});
        c.initial.nominalTrailingEdgeHeight = rounded(spacing - above, 1e-12);
        c.initial.pitch = pitch;
        c.initial.roll = roll;
        const SteadyResult film = steady(onCoarseGrid(c, true));
        if (film.status != SteadyStatus::Converged) return false;
        constexpr double gramForce = 9.80665e-3; // [N]
        const double load = roundedTo(film.forces.net / gramForce, 4) * gramForce;
        if (load < 0.6 * gramForce || load > 5.0 * gramForce) return false;
        c.suspension.preload = load;
        c.suspension.offsetX = rounded(-(film.forces.pitchTorque + film.shearPitchTorque) / load, 1e-8);
        c.suspension.offsetY = rounded(-(film.forces.rollTorque + film.shearRollTorque) / load, 1e-8);
        return std::abs(c.suspension.offsetX) < 0.2 * length_ && std::abs(c.suspension.offsetY) < 0.1 * width_;
    }

    /// From a start that is a little off.
    static bool flies(const Case& c)
    {
        Case start = onCoarseGrid(c, false);
        start.initial.nominalTrailingEdgeHeight += 3e-9;
        const SteadyResult found = steady(start);
        const double lowest = lowestOf(c.surface, Recess(c.surface, c.slider.length, c.slider.width), found.attitude);
        return found.status == SteadyStatus::Converged && std::abs(lowest - spacing) < 2e-9 &&
               std::abs(found.attitude.pitch - pitch) < 20e-6;
    }

    std::uint64_t seed_;
    std::mt19937_64 generator_;
    double length_ = 0.0, width_ = 0.0, shelf_ = 0.0, pocket_ = 0.0; // [m]
    AirBearingSurface surface_;
};

} // namespace touchdown::test
