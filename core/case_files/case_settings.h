// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values changed on the command line or by a study.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/case_files/outside_path.h"
#include "core/formats/input_problem.h"

namespace touchdown {

struct Case;
struct CaseDocument;

/// Applies texts "key=value" in order. Their problems are added to the document; combinations, the file of a measured
/// disk surface and values without effect are checked again. A path that a person typed is asked for, so allowed; one
/// that stands in a file stays in the folder of the case.
void applySettings(CaseDocument& document, const std::vector<std::string>& settings,
                   OutsidePaths outside = OutsidePaths::Allowed);

/// A key of a case and its value, as a person writes it.
struct CaseSetting {
    std::string key;   // "run.step"
    std::string value; // "10 ns"
    bool operator==(const CaseSetting&) const = default;
};
/// Sets these values, which stand in a file or in the program, and checks their combination. Returns the first problem
/// with its key, which may be a path out of the folder of the case; then the case is unchanged.
std::optional<InputProblem> changeCase(Case& c, const std::vector<CaseSetting>& settings,
                                       OutsidePaths outside = OutsidePaths::Refused);

} // namespace touchdown
