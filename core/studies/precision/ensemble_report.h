// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shares of ensembles as sentences, a chart and tables.
#pragma once

#include <string>
#include <vector>

#include "core/studies/precision/ensemble.h"
#include "core/studies/study/study.h"

namespace touchdown {

/// What ensembles are told about.
struct EnsembleAccount {
    std::string what;                 // "300 starts with FH(0) within 0.5 nm of 250 nm"
    std::string workTitle;            // "Right-hand sides"
    const std::vector<Ensemble>& all; // the first one is the reference
};

/// How the starts lie.
std::string describeStarts(const Case& c, const EnsembleTask& task);

/// Adds findings, a chart, and the tables "shares" (a row for each end of each ensemble) and "ensembles" (a row for
/// each).
void reportEnsembles(const EnsembleAccount& account, StudyReport& report);

} // namespace touchdown
