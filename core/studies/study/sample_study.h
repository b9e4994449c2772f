// SPDX-License-Identifier: GPL-3.0-or-later
//
// The studies that are built into the program: sample_cases/studies/*.toml. Their cases are sample cases, by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

struct SampleStudy {
    std::string name;
    std::string kind; // "work-precision", "design"
    std::string title;
    std::string text;
};
/// In the order of their kinds, then of their names.
const std::vector<SampleStudy>& sampleStudies();
/// The one of this kind and name; nullptr if there is none.
const SampleStudy* findSampleStudy(std::string_view kind, std::string_view name);
std::vector<std::string> sampleStudyNames(std::string_view kind);

/// Names and texts, as the build put them in.
struct SampleStudyText {
    std::string name;
    std::string text;
};
const std::vector<SampleStudyText>& sampleStudyTexts();

} // namespace touchdown
