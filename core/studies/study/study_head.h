// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys that all studies have: title, kind, case and the changes of the case.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/case_files/case_file.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

/// Largest file of a study that is read [byte].
inline constexpr std::uintmax_t maximumStudyFileSize = 1 << 20;

std::vector<StudyKey> headKeys();

/// Whether the file is of this kind, or does not say of which; else the reader has the problem.
bool isOfKind(StudyReader& reader, const std::string& kind);

/// Whether the file names a case.
bool namesCase(StudyReader& reader);

/// The case that the study names, beside it in `folder` or a sample case, with the changes of its `set` and then those
/// of --set. What is wrong with the case is in the document's problems, each where it was said: in the study, in the
/// case or by --set. Without a name the reader has the problem, and there is none.
std::optional<CaseDocument> openStudyCase(StudyReader& reader, const std::filesystem::path& folder,
                                          const std::vector<std::string>& settings);

/// The same changes of a case that is there already.
CaseDocument changedStudyCase(StudyReader& reader, CaseDocument start, const std::vector<std::string>& settings);

} // namespace touchdown
