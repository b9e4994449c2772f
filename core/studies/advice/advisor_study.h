// SPDX-License-Identifier: GPL-3.0-or-later
//
// Error and cost of each candidate against the full model, in this order:
//
//   1. Models without a film in time. They take milliseconds, and their end is known.
//   2. The full model, until its mean over the last tenth is predicted to a quarter of the allowed error, and the error
//      of the cheapest model of step 1 within the tolerance is known to a factor of two. It runs to its end where a
//      first part predicts nothing: an unstable mode, unknown modes, a moving rough disk.
//   3. Models in time without a part, to their ends; each is stopped as soon as it has taken too long to be advised.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/studies/advice/advisor_candidates.h"
#include "core/studies/advice/advisor_judgement.h"
#include "core/studies/study/study.h"

namespace touchdown {

constexpr double worthwhile = 1.2; // a model must be so many times faster to be advised

struct CandidateOutcome {
    Candidate model;
    std::string problem; // why it has no answer, in a sentence
    std::string remark;  // a sentence for the report
    TailEstimate tail;
    double seconds = 0.0; // of one processor, over the whole run
    bool givenUp = false; // stopped, as it takes too long to be advised
    CandidateErrors errors;
    Verdict verdict = Verdict::NotKnown;
    std::optional<Case> found; // the model as a case of the program
    std::string command;       // that solves that case: "run", "steady"
    bool answers() const { return problem.empty() && !givenUp; }
    bool within() const { return answers() && verdict == Verdict::Within; }
};

struct AdvisorResult {
    StudyStatus status = StudyStatus::Completed;
    std::string message;
    CandidateOutcome full;     // with the tail that the pilot predicts
    double pilotTime = 0.0;    // how far it was run; zero: not at all [s]
    bool pilotWhole = false;   // to its end
    double studySeconds = 0.0; // of all threads
    bool contactActed = false;
    double gridError = 0.0;    // of the full model's static spacing [m]; zero: not known
    double growth = 0.0;       // e-folds of a mode that grows, over the run; zero: none does, or it is not known
    std::string growthProblem; // why it is not known, in a sentence
    bool roughPasses = false;  // a rough disk moves under the slider
    Allowance allowed;
    std::vector<CandidateOutcome> candidates;
    std::vector<std::string> missing; // models that were not tried, as the study was stopped or its budget was spent
    bool late = false;                // the budget was spent
    std::optional<std::size_t>
        advice; // among candidates; none: the full model, where any were tried and none is missing
    bool advisesFull() const { return !advice && missing.empty() && !candidates.empty(); }
    // Where it was confirmed:
    std::optional<TailEstimate> fullEnd;
    std::optional<CandidateErrors> found; // of the advice, from both at their ends
    double fullSeconds = 0.0, adviceSeconds = 0.0;
};

/// Called on the thread of the study; `sofar` where there is more than before; false stops.
using AdvisorTell = std::function<bool(double share, const std::string& doing, const AdvisorResult* sofar)>;

AdvisorResult advise(const AdvisorTask& task, int jobs, const AdvisorTell& tell);

} // namespace touchdown
