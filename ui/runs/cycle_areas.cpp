// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/cycle_areas.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/formats/units.h"
#include "core/numerics/interval.h"
#include "ui/style/quantity_format.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

using Outline = std::vector<std::pair<double, double>>;

/// The net force on the pad on the way up from d_s to d_e; on the way down there is none.
Outline forceOnTheWayUp(const OnoYamane& parameters)
{
    const OnoYamaneLaw law(parameters);
    Outline way;
    for (const ContactRegion region : {ContactRegion::Lifting, ContactRegion::Bridged}) {
        const Interval holds = law.interval(region);
        for (const double d : {holds.lower, holds.upper})
            if (holds.lower < holds.upper)
                way.emplace_back(d, law.contactForce(region, d) + law.adhesionForce(region, d));
    }
    return way;
}

/// The part of the area that encloses W in which the force pushes (sign 1: it creates energy) or pulls (-1: it takes
/// energy), and that energy [J].
std::pair<ShadedArea, double> cyclePart(const Outline& way, double sign)
{
    ShadedArea area;
    area.style.colour = sign > 0.0 ? 1 : 6; // ink
    Outline& part = area.outline;
    for (std::size_t i = 0; i < way.size(); ++i) {
        const auto [d, force] = way[i];
        if (i > 0 && way[i - 1].second * force < 0.0) { // it changes its sign
            const auto [before, forceBefore] = way[i - 1];
            part.emplace_back(before + forceBefore / (forceBefore - force) * (d - before), 0.0);
        }
        part.emplace_back(d, sign * std::max(0.0, sign * force));
    }
    double energy = 0.0;
    for (std::size_t i = 1; i < part.size(); ++i)
        energy += 0.5 * sign * (part[i].second + part[i - 1].second) * (part[i].first - part[i - 1].first);
    if (!part.empty()) {
        part.insert(part.begin(), {part.front().first, 0.0});
        part.emplace_back(part.back().first, 0.0);
    }
    return {std::move(area), energy};
}

/// "W = 7.5 pJ" in the one that takes, or both parts by name.
void nameAreas(ShadedArea& takes, double taken, ShadedArea& creates, double created, double work)
{
    const auto energy = [](double value) { return QString::fromStdString(fewDigits(value, "pJ", 3)); };
    takes.label = QStringLiteral("W = %1").arg(trueMinus(energy(work)));
    if (created <= 0.0) return;
    creates.label = tr("creates %1").arg(energy(created));
    takes.label = tr("takes %1, %2").arg(energy(taken), takes.label);
}

/// The force on one way at separations that rise; `way` in the order of the separation. At a jump, where one separation
/// has two forces, the one beyond it.
std::vector<double> forcesAt(const Outline& way, const std::vector<double>& separations)
{
    std::vector<double> forces;
    std::size_t next = 1;
    for (const double d : separations) {
        while (next + 1 < way.size() && way[next].first < d) ++next;
        const auto [before, low] = way[next - 1];
        const auto [after, high] = way[next];
        const double part = after > before ? std::clamp((d - before) / (after - before), 0.0, 1.0) : 1.0;
        forces.push_back(std::lerp(low, high, part));
    }
    return forces;
}

} // namespace

std::vector<ShadedArea> cycleAreas(const OnoYamane& parameters)
{
    const Outline way = forceOnTheWayUp(parameters);
    auto [takes, taken] = cyclePart(way, -1.0);
    auto [creates, created] = cyclePart(way, 1.0);
    nameAreas(takes, taken, creates, created, OnoYamaneLaw(parameters).cycleWork());
    if (created <= 0.0) return {takes};
    return {takes, creates};
}

std::vector<ShadedArea> cycleAreas(const MinMaxPyramid& separation, const MinMaxPyramid& netForce)
{
    constexpr int places = 2000;     // at which the two ways are compared
    constexpr double noForce = 1e-4; // a smaller difference of the ways is none, of the largest force

    Outline all;
    for (std::size_t i = 0; i < netForce.size(); ++i)
        if (const auto d = separation.valueAt(netForce.time(i))) all.emplace_back(*d, netForce.value(i));
    const auto deepest = std::ranges::min_element(all, {}, &Outline::value_type::first);
    if (all.end() - deepest < 2 || deepest - all.begin() < 1) return {};
    Outline in(all.begin(), deepest + 1), out(deepest, all.end());
    std::ranges::reverse(in);

    const double low = deepest->first, high = std::min(in.back().first, out.back().first);
    if (!(high > low)) return {};
    std::vector<double> d;
    for (int i = 0; i <= places; ++i) d.push_back(low + (high - low) * i / places);
    const std::vector<double> forceIn = forcesAt(in, d), forceOut = forcesAt(out, d);
    double largest = 0.0;
    for (const auto& [at, force] : all) largest = std::max(largest, std::abs(force));

    // Along the way out, and back along the way in, where the force on the way out is lower (takes) or higher.
    const auto part = [&](double sign) {
        std::pair<ShadedArea, double> made;
        Outline back;
        for (std::size_t i = 0; i < d.size(); ++i) {
            const double above = sign * (forceOut[i] - forceIn[i]);
            const double seen = above > noForce * largest ? forceOut[i] : forceIn[i];
            made.first.outline.emplace_back(d[i], seen);
            back.emplace_back(d[i], forceIn[i]);
            if (i > 0) {
                const auto& path = made.first.outline;
                made.second += 0.5 * sign *
                               (path[i].second - back[i].second + path[i - 1].second - back[i - 1].second) *
                               (d[i] - d[i - 1]);
            }
        }
        made.first.outline.insert(made.first.outline.end(), back.rbegin(), back.rend());
        made.first.style.colour = sign > 0.0 ? 1 : 6;
        return made;
    };
    auto [takes, taken] = part(-1.0);
    auto [creates, created] = part(1.0);
    if (taken == 0.0 && created == 0.0) return {};
    nameAreas(takes, taken, creates, created, taken - created);
    if (created <= 0.0) return {takes};
    return {takes, creates};
}

} // namespace touchdown
