// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/parameters.h"

#include "core/case/contact_kind.h"
#include "core/case/parameter_builders.h"
#include "core/formats/nearest_name.h"

#include <algorithm>

namespace touchdown {

namespace {

std::vector<Parameter> allParameters()
{
    std::vector<Parameter> all;
    for (auto part : {descriptionParameters, sliderParameters, springParameters, suspensionParameters, padParameters,
                      contactParameters, elasticParameters, asperityParameters, surfaceParameters, airParameters,
                      diskParameters, diskSurfaceParameters, filmParameters, steadyParameters, runParameters})
        for (Parameter& parameter : part()) all.push_back(std::move(parameter));
    return all;
}

std::string_view leaf(std::string_view key) { return key.substr(key.find_last_of('.') + 1); }

} // namespace

std::string Parameter::group() const
{
    const auto dot = key.find_last_of('.');
    return dot == std::string::npos ? std::string() : key.substr(0, dot);
}

bool CaseProblem::concerns(std::string_view anyKey) const
{
    const auto within = [](std::string_view inner, std::string_view outer) {
        return inner.starts_with(outer) && (inner.size() == outer.size() || inner[outer.size()] == '.');
    };
    const auto meets = [&](std::string_view own) { return within(own, anyKey) || within(anyKey, own); };
    return meets(key) || std::ranges::any_of(otherKeys, meets);
}

InputProblem CaseProblem::in(const std::string& file, int line) const
{
    return {file, line, key, message, ProblemKind::Combination};
}

std::string_view Parameter::leaf() const { return touchdown::leaf(key); }

Case defaultsOf(ModelKind model)
{
    Case c;
    c.model = model;
    if (model == ModelKind::Film) {
        c.contact = noContact;
        c.degreesOfFreedom = 3;
        c.run.duration = 0.5e-3;
    }
    if (model == ModelKind::Contact) {
        c.contact = ContactKind::Elastic;
        c.run.sampleInterval = c.run.duration / 400.0;
    }
    return c;
}

bool usesSliderSurface(const Case& c) { return parameter_builders::withSliderSurface(c); }

std::span<const Parameter> parameters()
{
    static const std::vector<Parameter> all = allParameters();
    return all;
}

const Parameter* findParameter(std::string_view key)
{
    const auto all = parameters();
    const auto found = std::ranges::find(all, key, &Parameter::key);
    return found == all.end() ? nullptr : &*found;
}

std::string nearestKey(std::string_view key)
{
    std::vector<std::string> keys, leaves;
    for (const Parameter& parameter : parameters()) {
        keys.push_back(parameter.key);
        leaves.emplace_back(leaf(parameter.key));
    }
    const auto withLeaf = [&](std::string_view name) {
        const auto found = std::ranges::find(leaves, name);
        return found == leaves.end() ? std::string() : keys[static_cast<std::size_t>(found - leaves.begin())];
    };
    // The right name without a table; a misspelt key; the right name in the wrong table.
    if (key.find('.') == std::string_view::npos)
        if (auto right = withLeaf(key); !right.empty()) return right;
    if (auto nearest = nearestName(key, keys); !nearest.empty()) return nearest;
    const std::string name = nearestName(leaf(key), leaves, leaf(key).size() / 5);
    return name.empty() ? std::string() : withLeaf(name);
}

} // namespace touchdown
