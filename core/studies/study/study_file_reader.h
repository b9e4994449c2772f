// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the report of a study from a file (study_file.h says what it holds), in a process of its own
// (core/formats/reader_process.h). The columns of its tables that are left out where there is little room are not
// marked in the file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/studies/study/study.h"

namespace touchdown {

struct StoredStudy {
    StudyReport report;
    std::string caseText;               // of the case that was studied
    std::string studyText;              // empty where the study took its defaults
    std::string problem;                // "" when it was read; else one sentence, and nothing else is set
    std::vector<std::string> options{}; // "key=value", over those of the text
};
StoredStudy readStudy(const std::filesystem::path& file);
/// The same in this process: for that process, and for files that this program wrote.
StoredStudy readStudyDirectly(const std::filesystem::path& file);

} // namespace touchdown
