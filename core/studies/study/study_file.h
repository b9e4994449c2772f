// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings, charts and tables of a study on disk. HDF5:
//
//   /                         attributes format ("touchdown-study"), format_version, software_version, date, title,
//                             kind, status (completed, cancelled, failed; interrupted: it was under way), message,
//                             wall_seconds
//   /case/text, parameters    the case that was studied, as in a results file of a run
//   /study/text               the study's file; empty where the study took its defaults
//   /findings, warnings       sentences
//   /tables/<name>/<column>   an element for each row, numbers in SI (attributes unit, display_unit, long_name) or
//                             texts. An unknown number is 0, and <column>_known is 0 there, else 1; without unknown
//                             numbers there is no <column>_known. An unknown text is empty.
//   /charts/<n>/              from 1: attributes title, caption
//     panels/<n>/             attributes x_label, x_unit, x_display_unit, x_logarithmic, the same of y, equal_scales
//       series/<n>/           attributes name, line, markers, quiet; for each point x, y, x_error, y_error, label,
//                             kind, chosen
//       bands/<n>/            attributes along ("x", "y"), label, lower, upper; a missing end reaches to the edge
//       map/                  x, y; cells row by row, x first, as indices into class_name and class_severity, -1:
//                             unknown; details
//   /found/text               the case that the study advises, if it does
//
// CSV as RFC 4180: the first table, units in the heading; an unknown value is an empty cell.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/output_file.h"
#include "core/studies/study/study.h"

namespace touchdown {

inline constexpr const char* studyFormat = "touchdown-study";
inline constexpr int studyFormatMajor = 1;
inline constexpr int studyFormatMinor = 2;

/// What the file of a study holds besides its report.
struct StudySubject {
    std::string kind;                   // "hysteresis"
    std::string title;                  // of its report
    Case value;                         // that is studied
    std::string caseText;               // with the contents of the files that it names
    std::string studyText;              // empty where the study took its defaults
    std::vector<std::string> options{}; // "key=value", over those of the text
};

/// What a study has found so far, as it stands on disk until the study ends: its findings could be wrong.
StudyReport interruptedReport(StudyReport soFar);

/// Keeps the file of a study that is under way: the tables and charts so far can be read, with the status
/// "interrupted", after the program was killed. Every call returns "" or the problem in one sentence; after a problem,
/// the file holds what it held before.
class StudyWriter {
public:
    /// `interval`: from one state of the file to the next.
    explicit StudyWriter(std::chrono::milliseconds interval = std::chrono::seconds(2)) : interval_(interval) {}

    /// Locks the file. What it holds stays until something is found.
    std::string open(const std::filesystem::path& file, StudySubject subject);
    /// To be called with each progress of the study (StudyCallback), on its thread; keeps a report until it is written.
    std::string update(const StudyReport* soFar);
    /// Writes the whole report; closes the file.
    std::string finish(const StudyReport& report);

private:
    using Clock = std::chrono::steady_clock;
    std::string write(const StudyReport& report);

    std::chrono::milliseconds interval_;
    StudySubject subject_;
    std::unique_ptr<OutputLock> lock_;   // of the open file
    std::optional<StudyReport> pending_; // not yet written
    Clock::time_point begin_, written_;
    Clock::duration tookToWrite_{};
};

/// Each writes a whole file or none, also for a study that ended early, and returns "" or the problem in one sentence.
std::string writeStudy(const std::filesystem::path& file, const StudyReport& report, const Case& c,
                       const std::string& caseText, const std::string& studyText,
                       const std::vector<std::string>& options = {});
std::string writeStudyCsv(const std::filesystem::path& file, const StudyReport& report);

} // namespace touchdown
