// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shorthand for the tables of fields: a description and the member of Case that it describes. Only for the files that
// list fields.
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

inline bool always(const Case&) { return true; }
inline bool withContactModel(const Case& c) { return c.model == ModelKind::Contact; }
inline bool withOnoYamane(const Case& c) { return c.contact == ContactKind::OnoYamane; }
inline bool withSprings(const Case& c) { return c.model == ModelKind::Springs; }
inline bool withFilm(const Case& c) { return c.model == ModelKind::Film; }
/// Surfaces that are given point by point, and what acts between them: of a pad, or of a slider that flies.
inline bool withSurfaces(const Case& c) { return !withSprings(c) && c.contact == ContactKind::Elastic; }
inline bool withPadSurfaces(const Case& c) { return withContactModel(c) && withSurfaces(c); }
/// A film flies over a surface that is not flat whatever touches it.
inline bool withDiskSurface(const Case& c) { return withFilm(c) || withSurfaces(c); }
inline bool withAsperities(const Case& c)
{
    return withContactModel(c) && (c.contact == ContactKind::Asperity || c.contact == ContactKind::MultiAsperity);
}
/// The whole air bearing surface stands against the disk.
inline bool withSliderPad(const Case& c) { return withPadSurfaces(c) && c.pad.shape == PadShape::Slider; }
/// The slider moves as forces tell it; a pad alone moves as it is told.
inline bool withBearing(const Case& c) { return withSprings(c) || withFilm(c); }
inline bool withRoll(const Case& c) { return withFilm(c) && c.degreesOfFreedom == 3; }
inline bool withSliderSurface(const Case& c) { return withFilm(c) || withSliderPad(c); }
/// The springs have a choice of integrators, the film one of its own.
inline bool withFixedSpringStep(const Case& c)
{
    using enum IntegratorKind;
    return withSprings(c) && (c.run.integrator == Rk4 || c.run.integrator == Rk4Events || c.run.integrator == Newmark);
}
inline bool withAdaptiveSpringStep(const Case& c) { return withSprings(c) && !withFixedSpringStep(c); }
inline bool withNewmark(const Case& c) { return withSprings(c) && c.run.integrator == IntegratorKind::Newmark; }
inline bool withFixedStep(const Case& c)
{
    return withFixedSpringStep(c) || (withFilm(c) && c.run.steps == StepControl::Fixed);
}

/// Access to `case.group.member`, or to `case.member`.
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

template <typename Member>
Field number(Field field, Member member, bool (*used)(const Case&) = always)
{
    field.kind = FieldKind::Number;
    field.get = [member](const Case& c) { return FieldValue(member(c)); };
    // Adding zero turns -0 into 0, which has one spelling.
    field.set = [member](Case& c, const FieldValue& value) { member(c) = std::get<double>(value) + 0.0; };
    field.used = used;
    return field;
}

/// Also for integers, booleans and texts, whose member has the type of the value.
template <typename Member>
Field plain(FieldKind kind, Field field, Member member, bool (*used)(const Case&) = always)
{
    using Value = std::remove_reference_t<decltype(member(std::declval<Case&>()))>;
    field.kind = kind;
    field.get = [member](const Case& c) { return FieldValue(member(c)); };
    field.set = [member](Case& c, const FieldValue& value) { member(c) = std::get<Value>(value); };
    field.used = used;
    return field;
}

/// `field.choices` are the names of the enumerators, in their order.
template <typename Member>
Field choice(Field field, Member member, bool (*used)(const Case&) = always)
{
    using Enum = std::remove_reference_t<decltype(member(std::declval<Case&>()))>;
    field.kind = FieldKind::Choice;
    field.get = [member, names = field.choices](const Case& c) {
        return FieldValue(names.at(static_cast<std::size_t>(member(c))));
    };
    field.set = [member, names = field.choices](Case& c, const FieldValue& value) {
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == std::get<std::string>(value)) member(c) = static_cast<Enum>(i);
    };
    field.used = used;
    return field;
}

/// The member is a vector or an array of numbers.
template <typename Member>
Field list(Field field, Member member, bool (*used)(const Case&) = always)
{
    using Values = std::remove_reference_t<decltype(member(std::declval<Case&>()))>;
    using Value = typename Values::value_type;
    field.kind = FieldKind::List;
    field.get = [member](const Case& c) {
        const auto& values = member(c);
        return FieldValue(std::vector<double>(values.begin(), values.end()));
    };
    field.set = [member](Case& c, const FieldValue& value) {
        const auto& values = std::get<std::vector<double>>(value);
        if constexpr (requires(Values & v) { v.resize(1); }) member(c).resize(values.size());
        std::ranges::transform(values, member(c).begin(), [](double v) { return static_cast<Value>(v + 0.0); });
    };
    field.used = used;
    return field;
}

} // namespace field_builders

} // namespace touchdown
