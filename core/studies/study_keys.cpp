// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study_keys.h"

#include <algorithm>

#include "core/case/fields.h"
#include "core/studies/study_plan.h"

namespace touchdown {

std::vector<DescribedKey> studyKeys(const std::string& kind)
{
    std::vector<DescribedKey> keys;
    for (const ModelKind model : {ModelKind::Springs, ModelKind::Film, ModelKind::Contact}) {
        const Case c = defaultsOf(model);
        const StudyPlan plan = parseStudy(kind, "", kind, {}, &c);
        const bool refused = std::ranges::find(plan.problems, "case", &InputProblem::key) != plan.problems.end();
        // A study that refuses all default cases, as it needs more than a model, is described with the last one.
        if (refused && (model != ModelKind::Contact || !keys.empty())) continue;
        for (const StudyKey& row : studyForm(kind, c).keys) {
            if (row.kind == StudyKeyKind::Table) continue;
            auto described =
                std::ranges::find_if(keys, [&](const DescribedKey& each) { return each.key.key == row.key; });
            if (described == keys.end()) described = keys.insert(described, {row, allowedText(row), {}});
            described->varies = described->varies || described->allowed != allowedText(row);
            if (const std::string standard = defaultText(row); !standard.empty())
                described->standards.emplace_back(toText(c, *findField("model")), standard);
        }
    }
    return keys;
}

} // namespace touchdown
