// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the field tables. A row names, in this order: key, label, symbol, dimension, range, the member of Case
// that holds the value, the condition under which the value is used, help text, source. Only for the files that list
// fields.
#pragma once

#include "core/case/fields.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace touchdown {

/// The parts of fields(), in the order of a case file.
std::vector<Field> descriptionFields();
std::vector<Field> sliderFields();
std::vector<Field> springFields();
std::vector<Field> suspensionFields();
std::vector<Field> padFields();
std::vector<Field> contactFields();
std::vector<Field> elasticFields();
std::vector<Field> asperityFields();
std::vector<Field> surfaceFields();
std::vector<Field> airFields();
std::vector<Field> diskFields();
std::vector<Field> diskSurfaceFields();
std::vector<Field> filmFields();
std::vector<Field> steadyFields();
std::vector<Field> runFields();

namespace field_builders {

/// Where a default comes from.
inline constexpr const char* none = "ours: none";
inline constexpr const char* lostTable =
    "assumed: Table II of the paper is lost; this default meets the steady states that its text states";

inline bool always(const Case&) { return true; }
inline bool withContactModel(const Case& c) { return c.model == ModelKind::Contact; }
inline bool withOnoYamane(const Case& c) { return c.contact == ContactKind::OnoYamane; }
inline bool withSprings(const Case& c) { return c.model == ModelKind::Springs; }
inline bool withFilm(const Case& c) { return c.model == ModelKind::Film; }
/// Surfaces given point by point and the forces between them, for a pad or a flying slider.
inline bool withSurfaces(const Case& c) { return !withSprings(c) && c.contact == ContactKind::Elastic; }
inline bool withPadSurfaces(const Case& c) { return withContactModel(c) && withSurfaces(c); }
/// A film takes the disk's surface into account with every kind of contact.
inline bool withDiskSurface(const Case& c) { return withFilm(c) || withSurfaces(c); }
inline bool withAsperities(const Case& c)
{
    return withContactModel(c) && (c.contact == ContactKind::Asperity || c.contact == ContactKind::MultiAsperity);
}
/// The pad is the whole air bearing surface.
inline bool withSliderPad(const Case& c) { return withPadSurfaces(c) && c.pad.shape == PadShape::Slider; }
/// The slider moves under forces; the motion of a pad is prescribed.
inline bool withBearing(const Case& c) { return withSprings(c) || withFilm(c); }
inline bool withRoll(const Case& c) { return withFilm(c) && c.degreesOfFreedom == 3; }
inline bool withSliderSurface(const Case& c) { return withFilm(c) || withSliderPad(c); }
/// The springs have a choice of integrators, the film one of its own.
inline bool withFixedSpringStep(const Case& c) { return withSprings(c) && hasFixedStep(c.run.integrator); }
inline bool withAdaptiveSpringStep(const Case& c) { return withSprings(c) && !withFixedSpringStep(c); }
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
inline Field described(FieldKind kind, const char* key, const char* label, Condition used, const char* help,
                       const char* source)
{
    return {.key = key, .label = label, .kind = kind, .help = help, .source = source, .used = used};
}
inline void limit(Field& field, Dimension dimension, Range range)
{
    field.unit = dimension.unit;
    field.displayUnit = dimension.displayUnit;
    field.minimum = range.minimum;
    field.maximum = range.maximum;
    field.minimumAllowed = range.minimumAllowed;
    field.stride = range.stride;
}
/// The member has the type of the value.
template <typename Member>
Field plain(Field field, Member member)
{
    field.get = [member](const Case& c) { return FieldValue(member(c)); };
    field.set = [member](Case& c, const FieldValue& value) { member(c) = std::get<ValueAt<Member>>(value); };
    return field;
}

template <typename Member>
Field number(const char* key, const char* label, const char* symbol, Dimension dimension, Range range, Member member,
             Condition used, const char* help, const char* source)
{
    Field field = plain(described(FieldKind::Number, key, label, used, help, source), member);
    field.symbol = symbol;
    limit(field, dimension, range);
    // Adding zero turns -0 into 0, which has one spelling.
    field.set = [member](Case& c, const FieldValue& value) { member(c) = std::get<double>(value) + 0.0; };
    return field;
}

template <typename Member>
Field integer(const char* key, const char* label, Range range, Member member, Condition used, const char* help,
              const char* source)
{
    Field field = plain(described(FieldKind::Integer, key, label, used, help, source), member);
    limit(field, noUnit, range);
    return field;
}

template <typename Member>
Field boolean(const char* key, const char* label, Member member, Condition used, const char* help, const char* source)
{
    return plain(described(FieldKind::Boolean, key, label, used, help, source), member);
}

template <typename Member>
Field text(const char* key, const char* label, Member member, Condition used, const char* help, const char* source = "")
{
    return plain(described(FieldKind::Text, key, label, used, help, source), member);
}

/// `choices` are the names of the enumerators, in their order.
template <typename Member>
Field choice(const char* key, const char* label, std::vector<std::string> choices, Member member, Condition used,
             const char* help, const char* source)
{
    Field field = described(FieldKind::Choice, key, label, used, help, source);
    field.choices = std::move(choices);
    field.get = [member, names = field.choices](const Case& c) {
        return FieldValue(names.at(static_cast<std::size_t>(member(c))));
    };
    field.set = [member, names = field.choices](Case& c, const FieldValue& value) {
        const auto found = std::ranges::find(names, std::get<std::string>(value));
        if (found != names.end()) member(c) = static_cast<ValueAt<Member>>(found - names.begin());
    };
    return field;
}

/// The member is a vector or an array of numbers.
template <typename Member>
Field list(const char* key, const char* label, Dimension dimension, Range range, Count count, Member member,
           Condition used, const char* help, const char* source)
{
    using Number = typename ValueAt<Member>::value_type;
    Field field = described(FieldKind::List, key, label, used, help, source);
    limit(field, dimension, range);
    field.minimumCount = count.minimum;
    field.maximumCount = count.maximum;
    field.get = [member](const Case& c) {
        const auto& values = member(c);
        return FieldValue(std::vector<double>(values.begin(), values.end()));
    };
    field.set = [member](Case& c, const FieldValue& value) {
        const auto& values = std::get<std::vector<double>>(value);
        if constexpr (requires(ValueAt<Member> & v) { v.resize(1); }) member(c).resize(values.size());
        std::ranges::transform(values, member(c).begin(), [](double v) { return static_cast<Number>(v + 0.0); });
    };
    return field;
}

} // namespace field_builders

} // namespace touchdown
