// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of a kind of study over all models of a case, for `touchdown describe study.KIND`.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/studies/study/study_key.h"

namespace touchdown {

struct DescribedKey {
    StudyKey key;                                               // of the first model that the study takes
    std::string allowed;                                        // "a whole number from 1 to 1000"
    std::vector<std::pair<std::string, std::string>> standards; // the default of each model: {"springs", "5"}
    bool varies = false;                                        // `allowed` depends on the case
};

/// In the order of the study's file; none for an unknown kind.
std::vector<DescribedKey> studyKeys(const std::string& kind);

} // namespace touchdown
