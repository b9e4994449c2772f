// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the files of all studies share: title, kind, case and the changes of the case; and the options that replace keys
// of a file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/studies/study/study_reader.h"

namespace touchdown {

struct CaseDocument;

/// Largest file of a study that is read [byte].
inline constexpr std::uintmax_t maximumStudyFileSize = 1 << 20;

/// The text of a study's file. Its kind may stand in the key `study`, too; it is the key `kind` of what is returned.
TomlDocument readStudyText(const std::string& text);

std::vector<StudyKey> headKeys();

/// Whether the file is of this kind, or names none; else the kind is a problem of the reader.
bool isOfKind(StudyReader& reader, const std::string& kind);

/// Whether the file names a case.
bool namesCase(StudyReader& reader);

/// The case that the study names: a file in the study's folder or a sample case, changed by the study's `set`, then by
/// the settings of --set. Problems of the case are in the document, each with its place: the study, the case or --set.
/// Without a name there is no case, and the reader has the problem.
std::optional<CaseDocument> openStudyCase(StudyReader& reader);
/// Another case, found by the same rules and with the same changes.
CaseDocument openFurtherCase(StudyReader& reader, const std::string& name);
/// The same without the changes.
CaseDocument openCaseBeside(StudyReader& reader, const std::string& name);

/// The same changes of a case that is there already.
CaseDocument changedStudyCase(StudyReader& reader, CaseDocument start);

/// Puts each "key=value" of --option over what the file says; the last one of a key counts. A key of a table has its
/// name before it: ensemble.starts. A value is TOML or bare text: 3, [1, 2], "10 ns", 10 ns. Returns the problems of
/// texts that are no option; the reader reports keys that the study does not know.
std::vector<InputProblem> applyOptions(TomlDocument& toml, const std::vector<std::string>& options);

} // namespace touchdown
