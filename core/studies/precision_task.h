// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study of accuracy against speed is to do, read and checked: see core/studies/work_precision.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/simulation/case.h"
#include "core/simulation/quantity.h"
#include "core/studies/ensemble.h"
#include "core/studies/trajectory_error.h"

namespace touchdown {

/// One way to run the case.
struct PrecisionSetting {
    std::string label; // "10 ns"; empty: the method has one setting
    Case c;
    bool chosen = false;     // what the case itself asks for
    bool inEnsemble = false; // an ensemble is made with it, where there is one
};

struct PrecisionMethod {
    std::string name; // "rk4"
    std::string key{}; // that is swept, "run.step"; empty: none
    bool ordered = false;                     // the values are numbers, from coarse to fine
    std::vector<PrecisionSetting> settings{};
};

/// A run that may prove the reference. Those of one family share what they do wrong.
struct PrecisionReference {
    std::string label; // "dopri5, 1e-14"
    Case c;
};

struct PrecisionTask {
    Case start;
    bool inTime = true;                // false: the static state
    Quantity quantity;                 // of which the errors are
    std::vector<Quantity> also;        // whose errors the table lists besides
    ErrorMeasure measure = ErrorMeasure::Worst;
    std::vector<PrecisionMethod> methods;
    std::vector<PrecisionReference> references; // two or more, each of a family of its own
    int repeats = 5;                   // of a timed run, after the one that warms up
    double timeLimit = 0.1;            // a run that takes longer is timed once [s]
    double budget = 15.0;              // for references and timed runs [s]
    double agreement = 0.1e-9;         // within which the references must stay together [unit of the quantity]
    EnsembleTask ensemble;
    bool ensembleWanted = false;       // else only where the trajectory is not determined
    PrecisionReference ensembleReference;
};

} // namespace touchdown
