// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study of accuracy against speed is to do, read and checked: see core/studies/precision/work_precision.h.
#pragma once

#include <vector>

#include "core/simulation/recording/quantity.h"
#include "core/studies/runs/ensemble.h"
#include "core/studies/runs/proven_reference.h"
#include "core/studies/runs/swept_method.h"
#include "core/studies/runs/trajectory_error.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

struct PrecisionTask {
    Case start;
    bool inTime = true;         // false: the static state
    Quantity quantity;          // of which the errors are
    std::vector<Quantity> also; // whose errors the table lists besides
    ErrorMeasure measure = ErrorMeasure::Worst;
    std::vector<SweptMethod> methods;
    std::vector<ReferenceCase> references; // two or more
    int repeats = 5;                       // of a timed run, after the one that warms up
    double timeLimit = 0.1;                // a run that takes longer is timed once [s]
    double budget = 15.0;                  // for references and timed runs, of wall time [s]
    double agreement = 0.1e-9;             // within which the references must stay together [unit of the quantity]
    EnsembleTask ensemble;
    bool ensembleWanted = false; // else only where the trajectory is not determined
    ReferenceCase ensembleReference;
};

/// The keys of the study with their defaults for a case.
StudyForm workPrecisionForm(const Case& c);
/// Adds what is wrong to the reader's problems; of use only where there is none.
PrecisionTask readPrecisionTask(StudyReader& reader);

} // namespace touchdown
