// SPDX-License-Identifier: GPL-3.0-or-later
//
// Findings, charts and tables of a study on disk. HDF5:
//
//   /                         attributes format ("touchdown-study"), format_version, software_version, date, title,
//                             kind, status, message, wall_seconds
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

#include <filesystem>
#include <string>

#include "core/studies/study/study.h"

namespace touchdown {

inline constexpr const char* studyFormat = "touchdown-study";
inline constexpr int studyFormatMajor = 1;
inline constexpr int studyFormatMinor = 0;

/// Each writes a whole file or none, also for a study that ended early, and returns "" or the problem in one sentence.
std::string writeStudy(const std::filesystem::path& file, const StudyReport& report, const Case& c,
                       const std::string& caseText, const std::string& studyText);
std::string writeStudyCsv(const std::filesystem::path& file, const StudyReport& report);

} // namespace touchdown
