// SPDX-License-Identifier: GPL-3.0-or-later
//
// A reference that two runs of different families prove.
//
// Of all runs, the two that end alike and lie closest are taken; their distance is the uncertainty of the reference.
// Where they part by more than the agreement, the horizon, the trajectory is no longer determined, and errors have no
// meaning from there on. The end may still be determined: if both end alike, and so do runs from starts that differ by
// less than anybody can set.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/studies/runs/measured_run.h"

namespace touchdown {

/// A run that may prove a reference. Those of a list are each of a family of its own: they share little of what they do
/// wrong.
struct ReferenceCase {
    std::string label; // "dopri5 (1e-14)"
    Case c;
};

/// Springs: dopri5 at 1e-14, rk4-events with steps of `step` [s], cvode at 1e-13.
std::vector<ReferenceCase> springReferences(const Case& c, double step);
/// Film, where grids are compared: adapted and graded ones of `nodes` lines each way; `stepError` [m] of runs in time.
std::vector<ReferenceCase> gridReferences(const Case& c, int nodes, std::optional<double> stepError);
/// Film on the case's own grid: film and slider at once with a hundredth of its step error, and staggered, where the
/// slider goes by a rule of lower order, with a thousandth.
std::vector<ReferenceCase> couplingReferences(const Case& c);
/// Of an ensemble, one run a start: springs dopri5 at 1e-12, film a tenth of the case's step error.
ReferenceCase ensembleReference(const Case& c);
/// The case from starts that differ by a ten-thousandth of a nanometre, and up to four times that.
std::vector<Case> nudgedStarts(const Case& c);

struct ProvenReference {
    std::string problem;           // why there is none, in a sentence; "" where there is one
    std::size_t which = 0;         // of the cases
    std::string label, other;      // the reference, and the run that lies closest to it
    MeasuredRun run, check;        // theirs
    double apart = 0.0;            // largest distance of the two over the whole run [unit of the first quantity]
    std::optional<double> horizon; // from which time on the trajectory is not determined [s]
    std::size_t samples = 0;       // before it
    bool endKnown = false;         // both end alike, and so do starts that hardly differ
};

/// `runs` of the cases, in their order; those that were stopped count for nothing. `sameDistance`: of spacings in one
/// end state [m].
ProvenReference proveReference(const std::vector<ReferenceCase>& cases, std::vector<MeasuredRun> runs, double agreement,
                               double sameDistance = sameSpacing);
/// The end is known only where it is that of these starts, too.
void proveEnd(ProvenReference& reference, const std::vector<MeasuredRun>& nudged, double sameDistance = sameSpacing);
/// "determined: two methods differ by 3e-9 nm at most; it flies at 7 nm", of a reference whose first quantity is a
/// length.
std::string knowledgeOf(const ProvenReference& reference);

} // namespace touchdown
