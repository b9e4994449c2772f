// SPDX-License-Identifier: GPL-3.0-or-later
//
// A method as studies compare it: a name, changes of the case, and one key with the values that it sweeps.
//
//   [[method]]
//   name = "rk4"
//   set = { "run.integrator" = "rk4" }
//   key = "run.step"
//   values = ["100 ns", "10 ns", "1 ns"]
//   ensemble = ["10 ns"]        # with which of them ensembles are made, where the study makes any; default: all
//
// Where the key says how fine a solution is, a step, a tolerance, the nodes of a grid, its values are taken from coarse
// to fine, in whatever order they are written.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/case_files/case_settings.h"
#include "core/case_files/outside_path.h"
#include "core/formats/input_problem.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;
struct Parameter;

/// As a study's file writes it.
struct MethodSpec {
    std::string name;
    std::vector<CaseSetting> set; // on the case
    std::string key{};            // that is swept; empty: none
    std::vector<std::string> values{};
    std::vector<std::string> ensemble{};
    OutsidePaths outside = OutsidePaths::Refused; // may its values name files outside the folder of the study?
};
/// The methods of a study's file; what is wrong with them as far as no case is needed to see it.
std::vector<MethodSpec> readMethods(StudyReader& reader, bool ensembles);
/// The keys of each [[method]].
std::vector<StudyKey> methodKeys(bool ensembles);
/// As readMethods reads it.
std::string methodText(const MethodSpec& spec);

/// One way to run the case.
struct MethodSetting {
    std::string label; // "10 ns"; empty: the method has one setting
    Case c;
    double value = std::numeric_limits<double>::quiet_NaN(); // of the key, where it is a number or a list of them
    bool chosen = false;                                     // what the case itself asks for
    bool inEnsemble = false;                                 // an ensemble is made with it, where there is one
};
struct SweptMethod {
    std::string name;     // "rk4"
    std::string key{};    // that is swept, "run.step"; empty: none
    bool ordered = false; // its settings go from coarse to fine
    std::vector<MethodSetting> settings{};
};

/// "rk4 (10 ns)".
std::string nameOf(const std::string& method, const std::string& setting);

/// A method with a case for each of its values; `addOwn`: and for the value of the case itself where the method is its
/// own. Of a list that has a fixed length, one number stands for all. Returns the first problem.
std::optional<InputProblem> makeMethod(const Case& start, const MethodSpec& spec, SweptMethod& method,
                                       bool addOwn = true);

} // namespace touchdown
