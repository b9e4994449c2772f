// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far each model of the ladder is from the full one, and what it takes. The full model is run until what the last tenth of its
// run will be is known to a quarter of what may be wrong with it, or to the end; the models in time without a part over as much of theirs,
// judged by the same estimate, so that what it has of its own drops out. The other models take milliseconds and are known to the end.
//
// Errors: of the mean spacing over the last tenth, of its standard deviation there, in metres. Allowed are tolerance times the mean or,
// where a bounce has more, the spread; and spread_tolerance times the spread or, where that is more, times tolerance times the mean; of both
// at least twice what one step of the full model may displace the slider by. Besides, a model must end in the same state (flying, in
// contact, in and out of it) and, where the spread is more than tolerance times the mean, have its largest peak at the same frequency.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/studies/advisor_ladder.h"
#include "core/studies/study.h"
#include "core/studies/tail_estimate.h"

namespace touchdown {

struct RungErrors {
    double mean = 0.0, spread = 0.0;                     // [m]
    double meanResolution = 0.0, spreadResolution = 0.0; // below which they are not known [m]
    bool sameEnd = true, samePeak = true;
    double claimedMean() const { return std::max(mean, meanResolution); }
    double claimedSpread() const { return std::max(spread, spreadResolution); }
};

struct RungOutcome {
    Rung rung;
    std::string problem;         // why it has no answer, in a sentence
    std::string remark;          // what is to be said of it, in a sentence
    TailEstimate tail;
    std::array<TailEstimate, 2> earlier; // of models in time: foretold by 0.9 and 0.8 of the pilot
    SpacingSamples samples;      // of models in time, as far as they were run
    double seconds = 0.0;        // of one processor, over the whole run
    RungErrors errors;
    bool within = false;         // the tolerance
    std::optional<Case> found;   // the model as a case of the program
    bool valid() const { return problem.empty(); }
};

struct AdvisorResult {
    StudyStatus status = StudyStatus::Completed;
    std::string message;
    RungOutcome full;                // its tail as the pilot tells it
    double pilotTime = 0.0;          // how far it was run [s]
    double pilotSeconds = 0.0;       // of one processor
    double studySeconds = 0.0;       // of all threads
    bool contactActed = false;
    double gridError = 0.0;          // of the full model's static spacing [m]; zero: not known
    double growth = 0.0;             // e-folds of a mode that grows, over the run; zero: none does, or it is not known
    std::string growthProblem;       // why it is not known, in a sentence; the full model is run to its end then
    std::vector<RungOutcome> rungs;
    std::optional<std::size_t> advice; // among rungs; none: the full model
    // Where it was confirmed:
    std::optional<TailEstimate> fullEnd;
    RungErrors found;                // of the advice, from both at their ends
    double fullSeconds = 0.0, adviceSeconds = 0.0;

    double allowedMean(const AdvisorTask& task) const;
    double allowedSpread(const AdvisorTask& task) const;
};

/// `tell`: share done, what is being done; false stops.
AdvisorResult advise(const AdvisorTask& task, int jobs, const std::function<bool(double, const std::string&)>& tell);

} // namespace touchdown
