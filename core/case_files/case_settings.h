// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values changed on the command line or by a study.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace touchdown {

struct Case;
struct CaseDocument;

/// Who wrote a setting. A path that a person typed is asked for; one of a file stays in the folder of the case.
enum class SettingSource : std::uint8_t { Person, File };

/// Applies texts "key=value" in order. Their problems are added to the document; combinations, the file of a measured
/// disk surface and values without effect are checked again.
void applySettings(CaseDocument& document, const std::vector<std::string>& settings,
                   SettingSource source = SettingSource::Person);

/// A key of a case and its value, as a person writes it.
struct CaseSetting {
    std::string key;   // "run.step"
    std::string value; // "10 ns"
    bool operator==(const CaseSetting&) const = default;
};
/// Sets these values, which stand in a file or in the program, and checks their combination. Returns "", or a sentence
/// that names the key of the first problem, which may be a path out of the folder of the case; then the case is
/// unchanged.
std::string changeCase(Case& c, const std::vector<CaseSetting>& settings);

} // namespace touchdown
