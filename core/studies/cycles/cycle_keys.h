// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of the case that a study of cycles changes, as its file names them: one, or several with commas between
// them that all take the same value.
#pragma once

#include <optional>
#include <string>

#include "core/case/parameters.h"
#include "core/studies/runs/value_ranges.h"

namespace touchdown {

class StudyReader;

inline constexpr const char* neededKeys = "a key of the case, or several with commas between them, in quotation marks";

/// The keys of the text as one. Nothing where there is a problem, which is added to the study's key `name`.
std::optional<Parameter> readKeys(StudyReader& reader, const std::string& name, const std::string& text,
                                  ParameterText& label);
/// A value of the keys that the study's key `name` gives, within the range of each.
std::optional<double> readValue(StudyReader& reader, const std::string& name, const Parameter& keys);

/// Reports at the study's key `name` where a value of the keys changes the film of the start, which is linear about one
/// static state. False: it does.
bool keepsFilm(StudyReader& reader, const std::string& name, const Parameter& keys, double value);

} // namespace touchdown
