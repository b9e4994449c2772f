// SPDX-License-Identifier: GPL-3.0-or-later
//
// The class of a run, judged against a reference that two independent methods prove (proven_reference.h).
//
//   failed            by the kind of failure: chatter, lost spring, diverged, stopped; or it fails as the reference
//                     does, whose failure is the true result
//   not determined    the end of the reference is not determined
//   wrong end state   the run completed, and its end differs from the reference's
//   drifting energy   the energy imbalance |E(t) - E(0) - gained| exceeds `energyDrift` of the largest change of an
//                     energy term (spring_energy_balance.h, film_energy_balance.h), and is more than 1.5 times that
//                     of the reference, which is due to the grid
//   cut steps         steps of a fixed length had to be cut, as they found no solution
//   another way       to the right end, but the trajectory differs from the reference's by more than the agreement,
//                     where the reference's trajectory is determined
//   agrees            none of these
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace touchdown {

struct Case;
struct MeasuredRun;
struct ProvenReference;

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
/// Runs as measureRun makes them, of the spacing alone, springs with their energy balance.
RunVerdict classify(const Case& c, const MeasuredRun& run, const ProvenReference& reference, const ClassRule& rule);

} // namespace touchdown
