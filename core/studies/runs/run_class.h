// SPDX-License-Identifier: GPL-3.0-or-later
//
// What became of a run, against a reference that two independent methods prove (proven_reference.h).
//
//   failed            by its failure: chatter, lost spring, diverged, stopped; or just as the reference, whose failure
//   is the truth not determined    the end of the reference wrong end state   it completed, and ends otherwise than the
//   reference drifting energy   |E(t) - E(0) - gained| exceeds `energyDrift` of the largest change of a part of the
//   energy (spring_energy_balance.h,
//                     film_energy_balance.h), and what the reference misses, which is the grid's, by half
//   cut steps         steps of a fixed length had to be cut, as they found no solution
//   another way       to the right end, by a trajectory further than the agreement from the reference's, where that is
//   determined agrees            none of these
#pragma once

#include <string>
#include <string_view>

#include "core/studies/runs/proven_reference.h"

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

struct RunVerdict {
    RunClass kind = RunClass::Stopped;
    double apart = 0.0;     // largest distance of the spacing from the reference, where both last [m]
    double imbalance = 0.0; // of the energy [-]
    std::string sentence;
};
/// Runs as measureRun makes them, of the spacing alone, springs with their energy's books.
RunVerdict classify(const Case& c, const MeasuredRun& run, const ProvenReference& reference, const ClassRule& rule);

} // namespace touchdown
