// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/case/case_key.h"
#include "core/physics/slider/rail_outline.h"
#include "core/physics/slider/surface_check.h"
#include "core/simulation/static_state/contact_rest.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady_near.h"
#include "core/work/team.h"

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

void addContactParameters(const Case& c, std::vector<Varied>& list)
{
    const std::pair<const char*, double> steps[]{{"ono_yamane.meniscus_force", 1e-7},
                                                 {"ono_yamane.initial_contact_force", 1e-7},
                                                 {"ono_yamane.contact_stiffness", 10.0},
                                                 {"ono_yamane.touch_down", 1e-13},
                                                 {"ono_yamane.friction", 1e-5},
                                                 {"asperity.plane_height", 1e-13},
                                                 {"asperity.height_deviation", 1e-14},
                                                 {"asperity.density", 1e7},
                                                 {"asperity.radius", 1e-11},
                                                 {"asperity.friction", 1e-5},
                                                 {"meniscus.surface_tension", 1e-7},
                                                 {"elastic.modulus", 1e6},
                                                 {"elastic.friction", 1e-5},
                                                 {"adhesion.surface_energy", 1e-6}};
    for (const auto& [key, step] : steps) {
        auto found = numberKey(c, key);
        auto* parameter = std::get_if<Parameter>(&found);
        if (parameter && parameter->used(c)) list.push_back({std::move(*parameter), step});
    }
}

} // namespace

AttitudeSensitivity::AttitudeSensitivity(const Case& c, FilmBalance& balance, const ContactAtRest& contact)
    : case_(c),
      balance_(balance),
      contact_(contact),
      adjoint_(balance.adjoint(contact.region)),
      nearest_(balance.nearest(balance.place()).at)
{}

/// R and G of a changed case at the state: at the same attitude and pressure.
Vector3 AttitudeSensitivity::misses(const Case& moved, MinimumSpacing spacing, std::shared_ptr<const FilmGaps> gaps,
                                    std::vector<double>& residual) const
{
    FilmBalance there(moved, std::move(spacing), std::move(gaps), balance_.body().attitude(balance_.body().rest()), {},
                      contact_.acts() ? FilmBalance::Contact::Acts : FilmBalance::Contact::Out);
    there.place(balance_.place(), contact_.branch, contact_.region);
    const std::vector<double> plain = balance_.level().gaps.pad.unpad<double>(balance_.level().pressure);
    std::vector<double>& pressure = there.level().pressure; // the outline's may have changed
    there.level().gaps.pad.pad<double>(plain, pressure);
    there.level().film.residual(pressure, residual);
    return there.force(contact_.region);
}

Sensitivity AttitudeSensitivity::to(const std::function<void(Case&, double)>& change, double step, bool ofSurface) const
{
    const FilmGaps& gaps = balance_.level().gaps;
    const Attitude attitude = balance_.level().film.attitude();
    std::vector<double> residual(gaps.pad.size());
    Vector3 attitudeChange = Vector3::Zero();
    double direct = 0.0;
    for (const double sign : {1.0, -1.0}) {
        Case moved = case_;
        change(moved, sign * step);
        const double weight = sign / (2.0 * step);
        const Recess recess(moved.surface, case_.slider.length, case_.slider.width);
        MinimumSpacing spacing = ofSurface ? MinimumSpacing(moved.surface, recess) : balance_.spacings();
        if (ofSurface) direct += weight * spacing.at(attitude).spacing;
        // Lines of the grid move with the edges that lie on them: off its line an edge has another error.
        const Vector3 balance =
            misses(moved, std::move(spacing),
                   ofSurface ? std::make_shared<const FilmGaps>(
                                   recess, movedGrid(gaps.grid, case_.surface, moved.surface).value_or(gaps.grid))
                             : balance_.level().film.sharedGaps(),
                   residual);
        for (std::size_t k = 0; k < 3; ++k) {
            double sum = 0.0;
            for (std::size_t at = 0; at < residual.size(); ++at) sum += adjoint_.film[k][at] * residual[at];
            for (std::size_t m = 0; m < 3; ++m) sum += adjoint_.balance(k, m) * balance[m];
            attitudeChange[k] -= weight * sum;
        }
    }
    const double atNearest = attitudeChange[0] + attitudeChange[1] * (case_.slider.length - nearest_.x) -
                             attitudeChange[2] * (nearest_.y - 0.5 * case_.slider.width);
    return {"", "m", attitudeChange[0], attitudeChange[1], attitudeChange[2], atNearest + direct};
}

std::vector<Sensitivity> sensitivities(const Case& c, FilmBalance& balance, const ContactAtRest& contact)
{
    std::vector<Varied> list = variedParameters(c);
    if (contact.acts()) addContactParameters(c, list);
    const AttitudeSensitivity attitude(c, balance, contact);
    std::vector<Sensitivity> result;
    for (const Varied& varied : list) {
        const Parameter& parameter = varied.parameter;
        // Not by setFromNumber: a value at the end of its range is moved, too.
        const auto change = [&](Case& moved, double by) { parameter.set(moved, numberOf(parameter, moved) + by); };
        Sensitivity found = attitude.to(change, varied.step, varied.ofSurface());
        found.parameter = parameter.key;
        found.unit = parameter.unit;
        result.push_back(std::move(found));
    }
    return result;
}

namespace {

/// The shift of an edge by a metre away from its rail.
SurfaceShift outwards(const AirBearingSurface& surface, const SurfacePart& edge)
{
    const SurfaceShift right = edgeNormal(surface, edge);
    const double side = signedArea(surface.rails[edge.item].points) < 0.0 ? -1.0 : 1.0;
    return {side * right.x, side * right.y};
}

/// The edge and its neighbours are parallel to x or y: lines of a grid can go with them.
bool squareAt(const Rail& rail, std::size_t edge)
{
    const std::size_t count = rail.points.size();
    for (const std::size_t k : {edge + count - 1, edge, edge + 1}) {
        const RailPoint &a = rail.points[k % count], &b = rail.points[(k + 1) % count];
        if (std::min(std::abs(a.x - b.x), std::abs(a.y - b.y)) > 1e-12) return false;
    }
    return true;
}

/// How far a slanted edge is moved to see what that does: far beside the steps in which cells on slanted edges change
/// sides, little beside the rail [m].
double edgeStep(const Rail& rail)
{
    double left = rail.points[0].x, right = left, low = rail.points[0].y, high = low;
    for (const RailPoint& point : rail.points) {
        left = std::min(left, point.x);
        right = std::max(right, point.x);
        low = std::min(low, point.y);
        high = std::max(high, point.y);
    }
    return std::min(4e-6, 0.1 * std::min(right - left, high - low));
}

/// From two states with the edge moved outwards and inwards; nothing where one of them is not found.
std::optional<Sensitivity> edgeInfluence(const Case& c, const SteadyResult& state, const SurfacePart& edge,
                                         const std::function<bool()>& goOn)
{
    const SurfaceShift out = outwards(c.surface, edge);
    const double step = edgeStep(c.surface.rails[edge.item]);
    std::array<SteadyResult, 2> states;
    for (const int side : {0, 1}) {
        const double by = side == 0 ? -step : step;
        Case with = c;
        with.surface = moved(c.surface, {edge}, {by * out.x, by * out.y});
        if (!surfaceProblems(with.surface).empty()) return std::nullopt;
        SteadyResult& found = states[static_cast<std::size_t>(side)];
        found = steadyNear(with, c, state, [&goOn](const SteadyProgress&) { return goOn(); });
        if (found.status != SteadyStatus::Converged) return std::nullopt;
    }
    const auto slope = [&](auto value) { return (value(states[1]) - value(states[0])) / (2.0 * step); };
    Sensitivity per;
    per.height = slope([](const SteadyResult& each) { return each.attitude.height; });
    per.pitch = slope([](const SteadyResult& each) { return each.attitude.pitch; });
    per.roll = slope([](const SteadyResult& each) { return each.attitude.roll; });
    per.minimumSpacing = slope([](const SteadyResult& each) { return each.minimumSpacing; });
    return per;
}

} // namespace

std::vector<PartInfluence> shapeInfluence(const Case& c, const SteadyResult& state, const PartSelection& parts,
                                          const InfluenceCallback& callback)
{
    const TeamScope team(filmThreads(c));
    constexpr double recessStep = 1e-12, smallShift = 0.5e-6; // [m]
    std::unique_ptr<FilmBalance> balance;
    std::optional<AttitudeSensitivity> attitude;
    std::vector<PartInfluence> result;
    const auto goOn = [&callback] { return !callback || callback(nullptr); };
    const auto add = [&](const SurfacePart& part, const Sensitivity& per) {
        result.push_back({part, per});
        return !callback || callback(&result.back());
    };
    for (const SurfacePart& part : parts) {
        if (!has(c.surface, part)) continue;
        if (!goOn()) break;
        const bool edge = part.kind == PartKind::Edge;
        if (edge && !squareAt(c.surface.rails[part.item], part.index)) {
            if (const auto per = edgeInfluence(c, state, part, goOn); per && !add(part, *per)) break;
            continue;
        }
        if (!edge && part.kind != PartKind::Rail) continue;
        if (!balance) {
            balance = FilmBalance::at(c, state, goOn);
            if (!balance) break;
            attitude.emplace(c, *balance, state.contact);
        }
        const auto deeper = [&](Case& moved, double by) {
            for (double& recess : moved.surface.rails[part.item].recess) recess += by;
        };
        const SurfaceShift out = edge ? outwards(c.surface, part) : SurfaceShift{};
        const auto outer = [&](Case& moved, double by) {
            moved.surface = touchdown::moved(std::move(moved.surface), {part}, {by * out.x, by * out.y});
        };
        if (!add(part, edge ? attitude->to(outer, smallShift, true) : attitude->to(deeper, recessStep, true))) break;
    }
    return result;
}

} // namespace touchdown
