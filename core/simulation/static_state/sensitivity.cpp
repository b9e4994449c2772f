// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/sensitivity.h"

#include <functional>
#include <string>

#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

namespace {

/// A parameter: its name, its unit, a change that is small against everything, and how a case takes a change.
struct VariedParameter {
    std::string key, unit;
    double step; // [unit]
    std::function<void(Case&, double)> add;
    bool surface = false; // it changes the recess
};

std::vector<VariedParameter> parametersOf(const Case& c)
{
    constexpr double length = 1e-12, place = 1e-11; // [m] of a recess, of a position
    std::vector<VariedParameter> list{
        {"abs.crown", "m", length, [](Case& v, double d) { v.surface.crown += d; }, true},
        {"abs.camber", "m", length, [](Case& v, double d) { v.surface.camber += d; }, true},
        {"abs.twist", "m", length, [](Case& v, double d) { v.surface.twist += d; }, true},
        {"abs.base_recess", "m", length, [](Case& v, double d) { v.surface.baseRecess += d; }, true},
    };
    if (c.surface.taperLength > 0.0) {
        list.push_back({"abs.taper_length", "m", place, [](Case& v, double d) { v.surface.taperLength += d; }, true});
        list.push_back({"abs.taper_angle", "rad", 1e-8, [](Case& v, double d) { v.surface.taperAngle += d; }, true});
    }
    for (std::size_t k = 0; k < c.surface.rails.size(); ++k)
        list.push_back({"abs.rail[" + std::to_string(k + 1) + "].recess", "m", length,
                        [k](Case& v, double d) {
                            for (double& recess : v.surface.rails[k].recess) recess += d;
                        },
                        true});
    for (std::size_t k = 0; k < c.surface.walls.size(); ++k)
        list.push_back({"abs.wall[" + std::to_string(k + 1) + "].shift", "m", place,
                        [k](Case& v, double d) {
                            for (double& distance : v.surface.walls[k].distance) distance += d;
                        },
                        true});
    const auto scalar = [&](const char* key, const char* unit, double step, auto member) {
        list.push_back({key, unit, step, [member](Case& v, double d) { member(v) += d; }});
    };
    scalar("suspension.preload", "N", 1e-7, [](Case& v) -> double& { return v.suspension.preload; });
    scalar("suspension.offset_x", "m", 1e-9, [](Case& v) -> double& { return v.suspension.offsetX; });
    scalar("suspension.offset_y", "m", 1e-9, [](Case& v) -> double& { return v.suspension.offsetY; });
    if (!c.suspension.holdsAttitude) {
        scalar("suspension.pitch_torque", "N m", 1e-12, [](Case& v) -> double& { return v.suspension.pitchTorque; });
        scalar("suspension.roll_torque", "N m", 1e-12, [](Case& v) -> double& { return v.suspension.rollTorque; });
    }
    if (c.air.source == AirSource::Given) {
        scalar("air.pressure", "Pa", 1.0, [](Case& v) -> double& { return v.air.given.pressure; });
        scalar("air.viscosity", "Pa s", 1e-10, [](Case& v) -> double& { return v.air.given.viscosity; });
        scalar("air.mean_free_path", "m", 1e-13, [](Case& v) -> double& { return v.air.given.meanFreePath; });
    }
    if (c.air.source == AirSource::Atmosphere) {
        scalar("air.altitude", "m", 0.1, [](Case& v) -> double& { return v.air.altitude; });
        scalar("air.temperature", "K", 1e-3, [](Case& v) -> double& { return v.air.temperature; });
    }
    scalar("disk.speed", "rad/s", 1e-3, [](Case& v) -> double& { return v.disk.speed; });
    scalar("disk.radius", "m", 1e-8, [](Case& v) -> double& { return v.disk.radius; });
    scalar("disk.skew", "rad", 1e-6, [](Case& v) -> double& { return v.disk.skew; });
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
    for (const VariedParameter& parameter : parametersOf(c)) {
        Vector3 attitudeChange = Vector3::Zero();
        double direct = 0.0;
        for (const double sign : {1.0, -1.0}) {
            Case moved = c;
            parameter.add(moved, sign * parameter.step);
            const double weight = sign / (2.0 * parameter.step);
            const Recess recess(moved.surface, c.slider.length, c.slider.width);
            const FilmGaps gaps = parameter.surface ? FilmGaps(recess, level.gaps.grid) : level.gaps;
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
            if (parameter.surface) direct += weight * MinimumSpacing(moved.surface, recess).at(attitude).spacing;
        }
        const double atNearest = attitudeChange[0] + attitudeChange[1] * (c.slider.length - nearest.x) -
                                 attitudeChange[2] * (nearest.y - 0.5 * c.slider.width);
        result.push_back({parameter.key, parameter.unit, attitudeChange[0], attitudeChange[1], attitudeChange[2],
                          atNearest + direct});
    }
    return result;
}

} // namespace touchdown
