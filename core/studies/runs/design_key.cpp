// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/design_key.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/case/parameters.h"
#include "core/formats/nearest_name.h"
#include "core/formats/units.h"

namespace touchdown {

namespace {

using Answer = std::variant<DesignKey, std::string>;

struct Extent {
    double low = std::numeric_limits<double>::infinity(), high = -low; // [m]
    double middle() const { return 0.5 * (low + high); }
    double size() const { return high - low; }
};

Extent extentOf(const Rail& rail, double RailPoint::*axis)
{
    Extent extent;
    for (const RailPoint& point : rail.points) {
        extent.low = std::min(extent.low, point.*axis);
        extent.high = std::max(extent.high, point.*axis);
    }
    return extent;
}

DesignKey recessKey(std::string key, std::size_t rail)
{
    const auto set = [rail](Case& c, double value) -> std::optional<std::string> {
        Rail& changed = c.surface.rails[rail];
        const double change = value - changed.recess[0];
        for (double& recess : changed.recess) recess += change;
        if (changed.kind == RailKind::Step) changed.recess = {value, 0.0, 0.0};
        return {};
    };
    return {std::move(key), "m", "um", [rail](const Case& c) { return c.surface.rails[rail].recess[0]; }, set};
}

DesignKey placeKey(std::string key, std::size_t rail, double RailPoint::*axis)
{
    const auto get = [rail, axis](const Case& c) { return extentOf(c.surface.rails[rail], axis).middle(); };
    const auto set = [rail, axis, get](Case& c, double value) -> std::optional<std::string> {
        const double change = value - get(c);
        for (RailPoint& point : c.surface.rails[rail].points) point.*axis += change;
        return {};
    };
    return {std::move(key), "m", "mm", get, set};
}

DesignKey sizeKey(std::string key, std::size_t rail, double RailPoint::*axis)
{
    const auto get = [rail, axis](const Case& c) { return extentOf(c.surface.rails[rail], axis).size(); };
    const auto set = [rail, axis](Case& c, double value) -> std::optional<std::string> {
        if (!(value > 0.0)) return formatQuantity(value, "mm") + " is out of range: allowed is greater than 0 mm";
        const Extent extent = extentOf(c.surface.rails[rail], axis);
        if (!(extent.size() > 0.0)) return std::string("the rail has no extent to stretch");
        for (RailPoint& point : c.surface.rails[rail].points)
            point.*axis = extent.middle() + (point.*axis - extent.middle()) * (value / extent.size());
        return {};
    };
    return {std::move(key), "m", "mm", get, set};
}

Answer railKey(const Case& c, const std::string& key)
{
    const std::size_t begin = std::string_view("abs.rail[").size();
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(key.data() + begin, key.data() + key.size(), number);
    const std::string_view rest(end, static_cast<std::size_t>(key.data() + key.size() - end));
    if (error != std::errc() || !rest.starts_with("].")) return "is no key of a rail, such as abs.rail[1].width";
    if (number < 1 || number > c.surface.rails.size())
        return "there is no rail " + std::to_string(number) + "; the case has " +
               std::to_string(c.surface.rails.size());
    const std::string_view leaf = rest.substr(2);
    if (leaf == "recess") return recessKey(key, number - 1);
    if (leaf == "x") return placeKey(key, number - 1, &RailPoint::x);
    if (leaf == "y") return placeKey(key, number - 1, &RailPoint::y);
    if (leaf == "length") return sizeKey(key, number - 1, &RailPoint::x);
    if (leaf == "width") return sizeKey(key, number - 1, &RailPoint::y);
    return "a study changes recess, x, y, length or width of a rail";
}

} // namespace

std::variant<DesignKey, std::string> designKey(const Case& c, std::string_view name)
{
    const std::string key(name);
    if (name.starts_with("abs.rail[")) return railKey(c, key);
    const Parameter* parameter = findParameter(name);
    if (parameter == nullptr) return "is no key of a case" + didYouMean(nearestKey(name));
    if (parameter->kind != ParameterKind::Number) return std::string("is no number with a range to search");
    if (!parameter->used(c)) return std::string("has no part in this case");
    const auto get = [parameter](const Case& from) { return std::get<double>(parameter->get(from)); };
    const auto set = [parameter](Case& target, double value) { return setFromNumber(target, *parameter, value); };
    return DesignKey{key, parameter->unit, parameter->displayUnit, get, set};
}

std::variant<DesignKey, std::string> sceneKey(const Case& c, std::string_view key)
{
    auto found = designKey(c, key);
    if (std::holds_alternative<DesignKey>(found) && (key.starts_with("run.") || key.starts_with("spectrum.")))
        return std::string("belongs to the computation, not to the scene");
    return found;
}

Interval allowedValues(std::string_view key)
{
    const Parameter* parameter = findParameter(key);
    return parameter ? Interval{parameter->minimum, parameter->maximum} : Interval{};
}

} // namespace touchdown
