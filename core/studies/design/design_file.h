// SPDX-License-Identifier: GPL-3.0-or-later
//
// A design study as TOML, and what it found as CSV (RFC 4180: a line for the start and for every better set).
//
//   kind = "design"                   # may be left out, as may a title
//   case = "../film_fig4_pico.toml"   # beside the study; or the name of a sample case
//
//   [[parameter]]
//   key = "abs.rail[3].width"         # see core/studies/runs/design_key.h; keys = [...] change all by as much as the
//   first start = "0.5 mm"                  # the value of the case where it is left out minimum = "0.2 mm" maximum =
//   "0.9 mm"
//
//   [[target]]
//   quantity = "minimum_spacing"      # of core/simulation/static_state/steady_quantities.h
//   value = "3.2 nm"
//   tolerance = "0.01 nm"
//
//   [search]                          # may be left out
//   iterations = 30
//   difference = 0.01
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/case_files/case_file.h"
#include "core/studies/design/design.h"

namespace touchdown {

inline constexpr std::size_t mostParameters = 20;
inline constexpr std::size_t mostTargets = 20;

struct DesignDocument {
    CaseDocument start; // the case as it is before any parameter is changed
    DesignTask task;
    std::string name, title, text;      // of the study's file
    std::vector<InputProblem> problems; // all of them, those of the case among them
    bool valid() const { return problems.empty(); }
};

/// A file, or the name of a sample study. The settings are those of --set, on the case.
DesignDocument readDesign(const std::filesystem::path& file, const std::vector<std::string>& settings = {});
/// The same of a text that stands in `folder`.
DesignDocument parseDesign(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                           const std::vector<std::string>& settings = {});

/// "" or the problem in one sentence.
std::string writeDesignCsv(const std::filesystem::path& file, const DesignTask& task, const DesignStudy& study);

} // namespace touchdown
