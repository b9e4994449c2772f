// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/sensitivity.h"

#include <string>
#include <utility>
#include <variant>

#include "core/case/case_key.h"
#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

namespace {

/// A parameter, and a change that is small against everything.
struct Varied {
    Parameter parameter;
    double step; // [unit]
    bool ofSurface() const { return parameter.key.starts_with("abs."); }
};

std::vector<Varied> variedParameters(const Case& c)
{
    std::vector<Varied> list;
    const auto add = [&](const std::string& key, double step) {
        auto found = numberKey(c, key);
        if (auto* parameter = std::get_if<Parameter>(&found)) list.push_back({std::move(*parameter), step});
    };
    constexpr double recess = 1e-12, place = 1e-11; // [m]
    for (const char* key : {"abs.crown", "abs.camber", "abs.twist", "abs.base_recess"}) add(key, recess);
    if (c.surface.taperLength > 0.0) {
        add("abs.taper_length", place);
        add("abs.taper_angle", 1e-8);
    }
    for (std::size_t k = 1; k <= c.surface.rails.size(); ++k) add("abs.rail[" + std::to_string(k) + "].recess", recess);
    for (std::size_t k = 1; k <= c.surface.walls.size(); ++k) add("abs.wall[" + std::to_string(k) + "].shift", place);
    add("suspension.preload", 1e-7);
    add("suspension.offset_x", 1e-9);
    add("suspension.offset_y", 1e-9);
    add("suspension.pitch_torque", 1e-12);
    add("suspension.roll_torque", 1e-12);
    add("air.pressure", 1.0);
    add("air.viscosity", 1e-10);
    add("air.mean_free_path", 1e-13);
    add("air.altitude", 0.1);
    add("air.temperature", 1e-3);
    add("disk.speed", 1e-3);
    add("disk.radius", 1e-8);
    add("disk.skew", 1e-6);
    return list;
}

} // namespace

std::vector<Sensitivity> sensitivities(const Case& c, FilmLevel& level, const MinimumSpacing& spacing)
{
    const Attitude attitude = level.film.attitude();
    const FlyingAttitude::Adjoint adjoint = level.flying.adjoint(level.pressure);
    const SurfacePoint nearest = spacing.at(attitude).at;
    const PaddedGrid& pad = level.gaps.pad;
    std::vector<double> residual(pad.size());
    std::vector<Sensitivity> result;
    for (const Varied& varied : variedParameters(c)) {
        const Parameter& parameter = varied.parameter;
        Vector3 attitudeChange = Vector3::Zero();
        double direct = 0.0;
        for (const double sign : {1.0, -1.0}) {
            Case moved = c;
            // Not by setFromNumber: a value at the end of its range is moved, too.
            parameter.set(moved, numberOf(parameter, c) + sign * varied.step);
            const double weight = sign / (2.0 * varied.step);
            const Recess recess(moved.surface, c.slider.length, c.slider.width);
            const FilmGaps gaps = varied.ofSurface() ? FilmGaps(recess, level.gaps.grid) : level.gaps;
            GasFilm film(gaps, filmSetting(moved));
            film.setAttitude(attitude);
            std::vector<double> pressure(pad.size(), film.ambient()); // the outline's may have changed
            pad.pad<double>(pad.unpad<double>(level.pressure), pressure);
            film.residual(pressure, residual);
            FilmLoads loads(film);
            FlyingAttitude flying(film, loads, sliderLoad(moved), spacing);
            const Vector3 balance = flying.imbalance(pressure);
            for (std::size_t k = 0; k < 3; ++k) {
                double sum = 0.0;
                for (std::size_t at = 0; at < residual.size(); ++at) sum += adjoint.film[k][at] * residual[at];
                for (std::size_t m = 0; m < 3; ++m) sum += adjoint.balance(k, m) * balance[m];
                attitudeChange[k] -= weight * sum;
            }
            if (varied.ofSurface()) direct += weight * MinimumSpacing(moved.surface, recess).at(attitude).spacing;
        }
        const double atNearest = attitudeChange[0] + attitudeChange[1] * (c.slider.length - nearest.x) -
                                 attitudeChange[2] * (nearest.y - 0.5 * c.slider.width);
        result.push_back({parameter.key, parameter.unit, attitudeChange[0], attitudeChange[1], attitudeChange[2],
                          atNearest + direct});
    }
    return result;
}

} // namespace touchdown
