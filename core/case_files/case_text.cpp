// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/case_text.h"

#include "core/case/parameters.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/surface_format.h"
#include "core/case_files/surface_text.h"
#include "core/formats/toml_editor.h"
#include "core/formats/toml_quantity.h"

#include <algorithm>
#include <array>
#include <optional>

namespace touchdown {

namespace {

std::string_view groupComment(std::string_view group)
{
    static constexpr auto comments = std::to_array<std::pair<std::string_view, std::string_view>>({
        {"about", "What this case is about."},
        {"slider", "The slider as a rigid body."},
        {"springs", "The air bearing: two nonlinear springs with dashpots, given at the static state."},
        {"suspension", "The suspension, about the static state."},
        {"pad", "The pad that meets the disk."},
        {"approach", "How the pad moves."},
        {"ono_yamane", "Contact and adhesion: the simplified characteristic of Ono and Yamane, and the pad."},
        {"elastic", "The two bodies, and the elastic contact of their surfaces."},
        {"adhesion", "Intermolecular and electrostatic attraction of the surfaces."},
        {"asperity", "The summits of a statistical surface."},
        {"meniscus", "The lubricant's menisci on the summits."},
        {"abs", "The air bearing surface."},
        {"air", "The air and its slip at the walls."},
        {"disk", "The disk's motion under the slider."},
        {"disk.surface", "The surface of the disk."},
        {"film", "The discretisation of the film and its solution."},
        {"steady", "The static state."},
        {"initial", "The start."},
        {"run", "The integration."},
        {"spectrum", "The power spectra."},
    });
    for (const auto& [name, comment] : comments)
        if (name == group) return comment;
    return {};
}

std::string tomlList(const std::vector<double>& values, std::string_view displayUnit)
{
    std::string list;
    for (const double value : values) list += (list.empty() ? "" : ", ") + formatTomlQuantity(value, displayUnit);
    return '[' + list + ']';
}

/// The value with the quotation marks that TOML needs.
std::string tomlValue(const Case& c, const Parameter& parameter)
{
    const ParameterValue value = parameter.get(c);
    switch (parameter.kind) {
    case ParameterKind::Text:
    case ParameterKind::Choice: return tomlString(std::get<std::string>(value));
    case ParameterKind::Integer:
    case ParameterKind::Boolean: return toText(c, parameter);
    case ParameterKind::List: return tomlList(std::get<std::vector<double>>(value), parameter.displayUnit);
    case ParameterKind::Number: return formatTomlQuantity(std::get<double>(value), parameter.displayUnit);
    }
    return {};
}

/// The tables of one kind, as [[abs.rail]]: equal tables at the front and at the back are kept, the tables between them
/// are changed in place, and surplus tables are removed or missing ones inserted there.
template <typename Item>
void putTables(TomlEditor& editor, const std::string& name, const std::vector<Item>& old, const std::vector<Item>& now)
{
    const auto front = static_cast<std::size_t>(std::ranges::mismatch(old, now).in1 - old.begin());
    std::size_t back = 0;
    while (back < std::min(old.size(), now.size()) - front && old[old.size() - 1 - back] == now[now.size() - 1 - back])
        ++back;
    std::size_t i = front;
    for (; i < std::min(old.size(), now.size()) - back; ++i) {
        const auto before = surfaceRows(old[i]);
        const auto after = surfaceRows(now[i]);
        const std::string table = "abs." + name + '[' + std::to_string(i + 1) + "].";
        for (std::size_t row = 0; row < after.size(); ++row)
            if (before[row].value != after[row].value) editor.put(table + after[row].key, after[row].value);
    }
    for (std::size_t k = i; k < old.size() - back; ++k) editor.removeTable("abs." + name, k + 1);
    std::string added;
    for (std::size_t k = i; k < now.size() - back; ++k)
        added += (added.empty() ? "" : "\n") + surfaceTable(name, surfaceRows(now[k]));
    if (!added.empty()) editor.insertTable("abs." + name, i, added);
}

void putSurface(TomlEditor& editor, const AirBearingSurface& old, const AirBearingSurface& now)
{
    if (old.pointsOfInterest != now.pointsOfInterest)
        editor.put("abs.points_of_interest", interestText(now.pointsOfInterest));
    putTables(editor, "rail", old.rails, now.rails);
    putTables(editor, "wall", old.walls, now.walls);
}

void putRelations(TomlEditor& editor, const AirBearingSurface& old, const AirBearingSurface& now)
{
    putTables(editor, "distance", old.distances, now.distances);
    putTables(editor, "symmetric", old.symmetries, now.symmetries);
}

/// Rails, walls and points of interest, without the numbers of [abs].
AirBearingSurface outline(const AirBearingSurface& surface)
{
    AirBearingSurface result;
    result.rails = surface.rails;
    result.walls = surface.walls;
    result.pointsOfInterest = surface.pointsOfInterest;
    return result;
}

/// The text was accepted when it was opened, with all files that it names.
CaseDocument parsed(const std::string& text, const std::filesystem::path& folder)
{
    return parseCase(text, "", folder, OutsidePaths::Allowed, MeasuredSurface::Unread);
}

std::string changedText(const std::string& text, const TomlDocument& toml, const CaseDocument& old, const Case& c)
{
    const bool fromFile = std::ranges::find(toml.entries, railFileKey, &TomlEntry::key) != toml.entries.end();
    // Rails that are no longer those of the file are written here.
    const bool readFile =
        fromFile && std::ranges::find(old.problems, railFileKey, &InputProblem::key) == old.problems.end();
    const bool keepsFile = readFile && outline(old.value.surface) == outline(c.surface);
    const CaseDocument base = fromFile && !keepsFile ? parsed(text, {}) : old;
    Case defaults = defaultsOf(c.model);
    defaults.model = Case{}.model;
    TomlEditor editor(text, toml);
    if (fromFile && !keepsFile) editor.remove(railFileKey);
    for (const Parameter& parameter : parameters()) {
        // A value that could not be read is replaced even if the new value is the default.
        const bool bad =
            editor.has(parameter.key) && std::ranges::any_of(base.problems, [&](const InputProblem& problem) {
                return problem.key == parameter.key && problem.kind != ProblemKind::Combination;
            });
        const bool ofFile = keepsFile && (parameter.group() == "abs" || parameter.group() == "slider");
        const Case& before = editor.has(parameter.key) || ofFile ? base.value : defaults;
        if (bad || parameter.get(before) != parameter.get(c)) editor.put(parameter.key, tomlValue(c, parameter));
    }
    if (!keepsFile) putSurface(editor, base.value.surface, c.surface);
    putRelations(editor, old.value.surface, c.surface); // a file of rails has none
    return editor.result();
}

} // namespace

std::string formatCase(const Case& c)
{
    const Case defaults;
    std::string text;
    std::string group;
    const auto closeGroup = [&] {
        if (group == "abs") text += formatSurface(c.surface);
    };
    for (const Parameter& parameter : parameters()) {
        // A changed value is written even if the model does not use it.
        const bool set = parameter.get(c) != parameter.get(defaults);
        const bool wanted = parameter.group() == "abs" && c.surface != AirBearingSurface{};
        if (!set && !wanted && (!parameter.used(c) || parameter.group() == "about")) continue;
        if (parameter.group() != group) {
            closeGroup();
            group = parameter.group();
            text += "\n# " + std::string(groupComment(group)) + "\n[" + group + "]\n";
        }
        text += std::string(parameter.leaf()) + " = " + tomlValue(c, parameter);
        text += parameter.symbol.empty() ? "\n" : " # " + parameter.symbol + "\n";
    }
    closeGroup();
    return text;
}

std::string updateCaseText(const std::string& text, const Case& c, const std::filesystem::path& folder)
{
    const TomlDocument toml = readToml(text);
    if (!toml.problem.empty()) return formatCase(c);
    const std::string updated = changedText(text, toml, parsed(text, folder), c);
    // A new text is better than a wrong one, should the editor not handle some form of TOML.
    CaseDocument check = parsed(updated, folder);
    check.value.folder = c.folder; // a text does not say where it is
    const bool broken =
        std::ranges::any_of(check.problems, [](const InputProblem& problem) { return problem.key.empty(); });
    return !broken && check.value == c ? updated : formatCase(c);
}

} // namespace touchdown
