// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/cycle_keys.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "core/formats/quotation.h"
#include "core/formats/words.h"
#include "core/simulation/static_state/static_solution.h"
#include "core/studies/hysteresis/held_steps.h"
#include "core/studies/runs/joint_key.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

std::optional<Parameter> readKeys(StudyReader& reader, const std::string& name, const std::string& text,
                                  ParameterText& label)
{
    std::vector<std::string> keys;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        keys.emplace_back(trimmed(std::string_view(text).substr(begin, end - begin)));
        begin = end + 1;
    }
    auto joint = jointKey(keys, [&](std::string_view key) -> std::variant<Parameter, std::string> {
        auto found = sceneKey(reader.start(), key);
        if (std::holds_alternative<Parameter>(found) && belongsToStart(std::string(key)))
            return "belongs to the start, which the study chooses itself";
        return found;
    });
    if (const auto* problem = std::get_if<std::string>(&joint)) {
        reader.add(name, *problem);
        return {};
    }
    label = std::get<JointKey>(joint).text;
    Parameter& all = std::get<JointKey>(joint).key;
    all.key = text;
    return std::move(all);
}

std::optional<double> readValue(StudyReader& reader, const std::string& name, const Parameter& keys)
{
    return reader.number(name, keys.unit, keys.displayUnit, keys.minimum, keys.maximum);
}

bool keepsFilm(StudyReader& reader, const std::string& name, const Parameter& keys, double value)
{
    const Case& start = reader.start();
    const std::optional<Case> changed = caseWith(start, keys, value);
    if (start.model != ModelKind::Film || !changed || sameFilmApart(start, *changed)) return true;
    reader.add(name, inQuotes(keys.key) + " changes the film, which is linear about the static state of the case "
                                          "(film.motion); contact, friction, suspension, load and mass leave it");
    return false;
}

} // namespace touchdown
