// SPDX-License-Identifier: GPL-3.0-or-later
//
// What became of a run, against a reference that two independent methods prove.
//
// The reference of springs is dopri5 at a tolerance of 1e-12, checked by rk4-events in steps of 1 ns; that of the film takes a hundredth
// of the case's step error, film and slider at once, checked by film and slider in turns with a thousandth. Where the two
// part by more than the agreement, the trajectory is not determined, and the ends of starts that differ by less than anybody can set
// tell whether the end is; where they differ, nothing is.
//
//   failed            by its failure: chatter, lost spring, diverged, stopped; or just as the reference, whose failure is the truth
//   not determined    the end of the reference
//   wrong end state   it completed, and ends otherwise than the reference
//   drifting energy   |E(t) - E(0) - gained| exceeds `energyDrift` of the largest change of a part of the energy (spring_books.h,
//                     film_books.h), and what the reference misses, which is the grid's, by half
//   cut steps         steps of a fixed length had to be cut, as they found no solution
//   another way       the right end, by a trajectory further than the agreement from the reference's, where that is determined
//   agrees            none of these
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/studies/measured_run.h"

namespace touchdown {

enum class RunClass : std::uint8_t {
    Agrees,
    OtherWay,
    CutSteps,
    NotDetermined,
    AsReference,
    DriftingEnergy,
    WrongEnd,
    Chatter,
    LostSpring,
    Diverged,
    Stopped
};
inline constexpr int runClasses = 11;
std::string_view name(RunClass kind);
/// 0 good .. 3 failed.
int severity(RunClass kind);

struct ClassRule {
    double agreement = 0.1e-9; // of the spacing [m]
    double energyDrift = 0.01; // [-]
};

/// Both cases of a reference, the one that is taken first.
struct ReferenceCases {
    std::string label, checkLabel;
    Case reference, check;
    std::vector<Case> nudged; // the first, from starts that hardly differ
};
ReferenceCases referenceCases(const Case& c);

struct ReferenceRun {
    MeasuredRun run, check;
    std::vector<MeasuredRun> nudged; // where the two part; their samples are not needed
    double apart = 0.0;              // of the two, the largest distance of the spacing [m]
    std::optional<double> horizon;   // from which time on the trajectory is not determined [s]
    bool endKnown = true;
    std::string sentence;            // what is known, for a person
};
/// Sets all but the runs; again when runs from nudged starts are there.
void judgeReference(ReferenceRun& reference, const ClassRule& rule);

struct RunVerdict {
    RunClass kind = RunClass::Stopped;
    double apart = 0.0;     // largest distance of the spacing from the reference, where both last [m]
    double imbalance = 0.0; // of the energy [-]
    std::string sentence;
};
/// Runs as measureRun makes them, of the spacing alone, springs with their energy's books.
RunVerdict classify(const Case& c, const MeasuredRun& run, const ReferenceRun& reference, const ClassRule& rule);

/// Same way to end: the same end state, or the same failure.
bool sameOutcome(const MeasuredRun& a, const MeasuredRun& b);
/// "flies at 7 nm", "ends in contact at 1.59 nm", "fails: chattering at 12 us".
std::string outcomeText(const MeasuredRun& run);
/// Largest distance of the first columns where both last.
double largestDistance(const MeasuredRun& a, const MeasuredRun& b);

} // namespace touchdown
