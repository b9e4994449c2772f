// SPDX-License-Identifier: GPL-3.0-or-later
//
// A value of a case that is held for a while, then moved on: each run begins where the one before ended.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/case/case_key.h"
#include "core/studies/runs/measured_run.h"
#include "core/work/work_done.h"

namespace touchdown {

class StudyReader;

struct HeldSteps {
    Case start; // as it stands, with the first value's start
    Parameter parameter;
    std::vector<double> values; // in their order, there [unit of the parameter]
    double hold = 1e-3;         // [s]
    bool fresh = false;         // each value begins as the case says, and there is no way back
    std::size_t count() const { return values.size() * (fresh ? 1 : 2); }
};

/// What came of one value.
struct HeldStep {
    double value = 0.0; // [unit of the parameter]
    bool back = false;  // on the way back
    bool done = false;
    bool anew = false; // began as the case says, since the run before failed
    EndState end;
    Statistics spacing; // over the last tenth [m]
    double pitch = 0.0; // its mean there [rad]
    double drift = 0.0; // by which the mean spacing there differs from that of a tenth in the middle of the hold [m]
    /// Neither moves there by more than a tenth of a nanometre, nor has since the middle.
    bool atRest() const { return spacing.max - spacing.min <= 0.1e-9 && drift <= 0.1e-9; }
    std::string problem; // why there is no valid end, in a sentence; "" where there is one
};

/// Whether a value of this key belongs to the start, so that nothing can be carried over.
bool belongsToStart(const std::string& key);

/// The case at a value; what is wrong with it, in a sentence, or "".
std::string setParameter(Case& c, const Parameter& parameter, double value);
/// Nothing where it is not valid there.
std::optional<Case> caseWith(Case c, const Parameter& parameter, double value);
/// An end of the range of a parameter, with which the studied case is valid, by its key "from" or "to"; `standard`
/// where the file gives none. Nothing where there is a problem, which is added.
std::optional<double> readEnd(StudyReader& reader, const char* key, const Parameter& parameter,
                              std::optional<double> standard);

/// A run that has ended.
struct HeldEnd {
    Case run;
    Summary summary;
    double startSpacing = 0.0; // at its beginning [m]
    bool valid = false;
};
/// What follows from it for the start of the next one: position over the disk, velocities, branch.
void carryOver(Case& next, const HeldEnd& before);

/// One run, its state carried from `last` unless that is not valid; `last` becomes it.
HeldStep holdValue(const HeldSteps& steps, double value, HeldEnd& last, std::vector<std::string>& warnings,
                   const GoOn& goOn, const ShareTeller& tell = {});

/// All of them in turn, there and back; `done` receives each. `tellerOf` gives the teller of each. False when stopped.
bool holdAll(const HeldSteps& steps, const GoOn& goOn, const std::function<void(std::size_t, HeldStep&&)>& done,
             std::vector<std::string>& warnings, const std::function<ShareTeller(std::size_t)>& tellerOf = {});

} // namespace touchdown
