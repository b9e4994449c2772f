// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values changed on the command line or by a study.
#pragma once

#include <string>
#include <vector>

namespace touchdown {

struct Case;
struct CaseDocument;

/// Applies texts "key=value" in order. Their problems are added to the document; combinations, the file of a measured
/// disk surface and values without effect are checked again.
void applySettings(CaseDocument& document, const std::vector<std::string>& settings);

/// A key of a case and its value, as a person writes it.
struct CaseSetting {
    std::string key;   // "run.step"
    std::string value; // "10 ns"
    bool operator==(const CaseSetting&) const = default;
};
/// Sets these values and checks their combination. Returns "", or a sentence that names the key of the first problem;
/// then the case is unchanged.
std::string changeCase(Case& c, const std::vector<CaseSetting>& settings);

} // namespace touchdown
