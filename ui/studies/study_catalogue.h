// SPDX-License-Identifier: GPL-3.0-or-later
//
// The studies that the window offers: those of the core, or others in a test.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/studies/study/sample_study.h"
#include "core/studies/study_plan.h"

namespace touchdown {

struct StudyCatalogue {
    std::vector<StudyKind> kinds;
    std::vector<SampleStudy> samples;
    std::function<std::string(const std::string& kind, const Case& c)> textOf; // with which a study of this case begins
    std::function<StudyPlan(const std::string& kind, const std::string& text, const std::string& name,
                            const std::filesystem::path& folder, const Case& c)>
        plan;
};

StudyCatalogue coreStudies();

} // namespace touchdown
