// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the parameter tables. A row names, in this order: key, label, symbol, dimension, range, the member of
// Case that holds the value, the condition under which the value is used, help text, source. Only for the files that
// list parameters.
#pragma once

#include "core/case/contact_kind.h"
#include "core/case/contact_law.h"
#include "core/case/integrator_kind.h"
#include "core/case/parameters.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace touchdown {

/// The parts of parameters(), in the order of a case file.
std::vector<Parameter> descriptionParameters();
std::vector<Parameter> sliderParameters();
std::vector<Parameter> springParameters();
std::vector<Parameter> suspensionParameters();
std::vector<Parameter> padParameters();
std::vector<Parameter> contactParameters();
std::vector<Parameter> elasticParameters();
std::vector<Parameter> asperityParameters();
std::vector<Parameter> surfaceParameters();
std::vector<Parameter> airParameters();
std::vector<Parameter> diskParameters();
std::vector<Parameter> diskSurfaceParameters();
std::vector<Parameter> filmParameters();
std::vector<Parameter> steadyParameters();
std::vector<Parameter> runParameters();

namespace parameter_builders {

/// Where a default comes from.
inline constexpr const char* none = "ours: none";
inline constexpr const char* lostTable =
    "assumed: Table II of the paper is lost; this default meets the steady states that its text states";

inline bool always(const Case&) { return true; }
inline bool withContactModel(const Case& c) { return c.model == ModelKind::Contact; }
inline bool withOnoYamane(const Case& c) { return characteristic(c).has_value(); }
inline bool withSprings(const Case& c) { return c.model == ModelKind::Springs; }
inline bool withFilm(const Case& c) { return c.model == ModelKind::Film; }
/// Surfaces given point by point and the forces between them, for a pad or a flying slider.
inline bool withSurfaces(const Case& c) { return c.contact == ContactKind::Elastic && contactActs(c); }
inline bool withPadSurfaces(const Case& c) { return withContactModel(c) && withSurfaces(c); }
/// Springs and film take the disk's surface into account with every kind of contact.
inline bool withDiskSurface(const Case& c) { return withSprings(c) || withFilm(c) || withSurfaces(c); }
inline bool withUnevenDisk(const Case& c) { return withDiskSurface(c) && c.diskSurface.kind != DiskSurfaceKind::Flat; }
/// Summits, by the statistics of the surface.
inline bool withAsperities(const Case& c)
{
    return (c.contact == ContactKind::Asperity || c.contact == ContactKind::MultiAsperity) && contactActs(c);
}
/// They act on a pad of a given size. Under a film, those without menisci act over the whole surface of the slider.
inline bool withAsperityPad(const Case& c)
{
    return withAsperities(c) && !(withFilm(c) && c.contact == ContactKind::Asperity);
}
/// The pad is the whole air bearing surface.
inline bool withSliderPad(const Case& c) { return withPadSurfaces(c) && c.pad.shape == PadShape::Slider; }
/// The slider moves under forces; the motion of a pad is prescribed.
inline bool withBearing(const Case& c) { return withSprings(c) || withFilm(c); }
inline bool withRoll(const Case& c) { return withFilm(c) && c.degreesOfFreedom == 3; }
inline bool withSliderSurface(const Case& c) { return withFilm(c) || withSliderPad(c); }
/// Length and width also place the springs over the disk.
inline bool withSliderOutline(const Case& c) { return withSliderSurface(c) || (withSprings(c) && withUnevenDisk(c)); }
/// The springs have a choice of integrators, the film one of its own.
inline bool withFixedSpringStep(const Case& c) { return withSprings(c) && hasFixedStep(c.run.integrator); }
inline bool withAdaptiveSpringStep(const Case& c) { return withSprings(c) && !withFixedSpringStep(c); }
/// A run is repeated with smaller steps.
inline bool withStepCheck(const Case& c)
{
    return withFixedSpringStep(c) ||
           (withSprings(c) && withOnoYamane(c) && withUnevenDisk(c) && c.diskSurface.motion == SurfaceMotion::Moving);
}
inline bool withNewmark(const Case& c) { return withSprings(c) && c.run.integrator == IntegratorKind::Newmark; }
inline bool withFixedStep(const Case& c)
{
    return withFixedSpringStep(c) || (withFilm(c) && c.run.steps == StepControl::Fixed);
}

/// Access to `case.group.member`, `case.group.part.member` or `case.member`.
template <typename Group, typename Value>
auto at(Group Case::*group, Value Group::*member)
{
    return [ group, member ](auto& c) -> auto& { return c.*group.*member; };
}
template <typename Group, typename Part, typename Value>
auto at(Group Case::*group, Part Group::*part, Value Part::*member)
{
    return [ group, part, member ](auto& c) -> auto& { return c.*group.*part.*member; };
}
template <typename Value>
auto at(Value Case::*member)
{
    return [member](auto& c) -> auto& { return c.*member; };
}

struct Dimension {
    const char* unit = "";        // SI
    const char* displayUnit = ""; // the unit people use
};
inline constexpr Dimension noUnit, metres{"m", "m"}, millimetres{"m", "mm"}, micrometres{"m", "um"},
    nanometres{"m", "nm"}, milliseconds{"s", "ms"}, microseconds{"s", "us"}, nanoseconds{"s", "ns"},
    degrees{"rad", "deg"}, milliradians{"rad", "mrad"}, microradians{"rad", "urad"}, turnsPerMinute{"rad/s", "rpm"},
    millinewtons{"N", "mN"}, micronewtonMetres{"N m", "uN m"}, newtonsPerMetre{"N/m", "N/m"},
    millinewtonsPerMetre{"N/m", "mN/m"}, gigapascals{"Pa", "GPa"};

struct Range {
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
    bool minimumAllowed = true;
    int stride = 0; // 0: any number in the range
};
inline constexpr Range anyNumber;
constexpr Range between(double minimum, double maximum) { return {minimum, maximum}; }
/// -limit <= x <= limit
constexpr Range within(double limit) { return {-limit, limit}; }
/// 0 <= x <= maximum
constexpr Range notNegative(double maximum) { return {0.0, maximum}; }
/// 0 < x <= maximum
constexpr Range positive(double maximum) { return {0.0, maximum, false}; }

/// How many numbers a list holds.
struct Count {
    std::size_t minimum = 0;
    std::size_t maximum = 0;
};
constexpr Count atMost(std::size_t count) { return {0, count}; }

using Condition = bool (*)(const Case&);

template <typename Member>
using ValueAt = std::remove_reference_t<std::invoke_result_t<Member, Case&>>;

/// For all rows: the description without its value.
inline Parameter described(ParameterKind kind, const char* key, const char* label, Condition used, const char* help,
                           const char* source)
{
    return {.key = key, .label = label, .kind = kind, .help = help, .source = source, .used = used};
}
inline void limit(Parameter& parameter, Dimension dimension, Range range)
{
    parameter.unit = dimension.unit;
    parameter.displayUnit = dimension.displayUnit;
    parameter.minimum = range.minimum;
    parameter.maximum = range.maximum;
    parameter.minimumAllowed = range.minimumAllowed;
    parameter.stride = range.stride;
}
/// The member has the type of the value.
template <typename Member>
Parameter plain(Parameter parameter, Member member)
{
    parameter.get = [member](const Case& c) { return ParameterValue(member(c)); };
    parameter.set = [member](Case& c, const ParameterValue& value) { member(c) = std::get<ValueAt<Member>>(value); };
    return parameter;
}

template <typename Member>
Parameter number(const char* key, const char* label, const char* symbol, Dimension dimension, Range range,
                 Member member, Condition used, const char* help, const char* source)
{
    Parameter parameter = plain(described(ParameterKind::Number, key, label, used, help, source), member);
    parameter.symbol = symbol;
    limit(parameter, dimension, range);
    // Adding zero turns -0 into 0, which has one spelling.
    parameter.set = [member](Case& c, const ParameterValue& value) { member(c) = std::get<double>(value) + 0.0; };
    return parameter;
}

template <typename Member>
Parameter integer(const char* key, const char* label, Range range, Member member, Condition used, const char* help,
                  const char* source)
{
    Parameter parameter = plain(described(ParameterKind::Integer, key, label, used, help, source), member);
    limit(parameter, noUnit, range);
    return parameter;
}

template <typename Member>
Parameter boolean(const char* key, const char* label, Member member, Condition used, const char* help,
                  const char* source)
{
    return plain(described(ParameterKind::Boolean, key, label, used, help, source), member);
}

template <typename Member>
Parameter text(const char* key, const char* label, Member member, Condition used, const char* help,
               const char* source = "")
{
    return plain(described(ParameterKind::Text, key, label, used, help, source), member);
}

/// `choices` are the names of the enumerators, in their order.
template <typename Member>
Parameter choice(const char* key, const char* label, std::vector<std::string> choices, Member member, Condition used,
                 const char* help, const char* source)
{
    Parameter parameter = described(ParameterKind::Choice, key, label, used, help, source);
    parameter.choices = std::move(choices);
    parameter.get = [member, names = parameter.choices](const Case& c) {
        return ParameterValue(names.at(static_cast<std::size_t>(member(c))));
    };
    parameter.set = [member, names = parameter.choices](Case& c, const ParameterValue& value) {
        const auto found = std::ranges::find(names, std::get<std::string>(value));
        if (found != names.end()) member(c) = static_cast<ValueAt<Member>>(found - names.begin());
    };
    return parameter;
}

/// The member is a vector or an array of numbers.
template <typename Member>
Parameter list(const char* key, const char* label, Dimension dimension, Range range, Count count, Member member,
               Condition used, const char* help, const char* source)
{
    using Number = typename ValueAt<Member>::value_type;
    Parameter parameter = described(ParameterKind::List, key, label, used, help, source);
    limit(parameter, dimension, range);
    parameter.minimumCount = count.minimum;
    parameter.maximumCount = count.maximum;
    parameter.get = [member](const Case& c) {
        const auto& values = member(c);
        return ParameterValue(std::vector<double>(values.begin(), values.end()));
    };
    parameter.set = [member](Case& c, const ParameterValue& value) {
        const auto& values = std::get<std::vector<double>>(value);
        if constexpr (requires(ValueAt<Member> & v) { v.resize(1); }) member(c).resize(values.size());
        std::ranges::transform(values, member(c).begin(), [](double v) { return static_cast<Number>(v + 0.0); });
    };
    return parameter;
}

} // namespace parameter_builders

} // namespace touchdown
