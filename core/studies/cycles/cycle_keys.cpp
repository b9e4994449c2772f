// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/cycle_keys.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "core/case/case_key.h"
#include "core/formats/quotation.h"
#include "core/formats/words.h"
#include "core/studies/hysteresis/held_steps.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

std::optional<Parameter> readKeys(StudyReader& reader, const std::string& name, const std::string& text,
                                  ParameterText& label)
{
    const Case& c = reader.start();
    std::vector<Parameter> keys;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string key(trimmed(std::string_view(text).substr(begin, end - begin)));
        begin = end + 1;
        const auto found = sceneKey(c, key);
        std::string problem;
        if (const auto* wrong = std::get_if<std::string>(&found))
            problem = *wrong;
        else if (belongsToStart(key))
            problem = "belongs to the start, which the study chooses itself";
        else if (!keys.empty() && keys.front().unit != std::get<Parameter>(found).unit)
            problem = "has another unit than " + inQuotes(keys.front().key) + " and cannot take the same value";
        if (!problem.empty()) {
            reader.add(name, inQuotes(key) + " " + problem);
            return {};
        }
        keys.push_back(std::get<Parameter>(found));
        const ParameterText one = parameterText(keys.back());
        if (keys.size() == 1)
            label = one;
        else
            label.label += " and " + uncapitalized(one.label);
    }
    Parameter all = keys.front();
    all.key = text;
    for (const Parameter& key : keys) {
        all.minimumAllowed = key.minimum > all.minimum    ? key.minimumAllowed
                             : key.minimum == all.minimum ? all.minimumAllowed && key.minimumAllowed
                                                          : all.minimumAllowed;
        all.minimum = std::max(all.minimum, key.minimum);
        all.maximum = std::min(all.maximum, key.maximum);
    }
    all.set = [keys](Case& changed, const ParameterValue& value) {
        for (const Parameter& key : keys) key.set(changed, value);
    };
    return all;
}

std::optional<double> readValue(StudyReader& reader, const std::string& name, const Parameter& keys)
{
    return reader.number(name, keys.unit, keys.displayUnit, keys.minimum, keys.maximum);
}

} // namespace touchdown
