// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/joint_key.h"

#include <algorithm>

#include "core/formats/quotation.h"
#include "core/formats/words.h"

namespace touchdown {

std::variant<JointKey, std::string> jointKey(const std::vector<std::string>& keys, const FindKey& find)
{
    std::vector<Parameter> all;
    JointKey joint;
    for (const std::string& key : keys) {
        auto found = find(key);
        if (const auto* problem = std::get_if<std::string>(&found)) return inQuotes(key) + " " + *problem;
        Parameter& parameter = std::get<Parameter>(found);
        if (!all.empty() && (all.front().unit != parameter.unit || all.front().kind != parameter.kind))
            return inQuotes(key) + " has another unit than " + inQuotes(all.front().key) +
                   " and cannot take the same value";
        const ParameterText one = parameterText(parameter);
        if (all.empty())
            joint.text = one;
        else
            joint.text.label += " and " + uncapitalized(one.label);
        all.push_back(std::move(parameter));
    }
    joint.key = all.front();
    joint.key.key = joined(keys);
    for (const Parameter& each : all) {
        Parameter& whole = joint.key;
        whole.minimumAllowed = each.minimum > whole.minimum    ? each.minimumAllowed
                               : each.minimum == whole.minimum ? whole.minimumAllowed && each.minimumAllowed
                                                               : whole.minimumAllowed;
        whole.minimum = std::max(whole.minimum, each.minimum);
        whole.maximum = std::min(whole.maximum, each.maximum);
    }
    joint.key.set = [all](Case& changed, const ParameterValue& value) {
        for (const Parameter& each : all) each.set(changed, value);
    };
    return joint;
}

} // namespace touchdown
