// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far each model of the ladder is from the full one, and what it takes. First the models without a film in time,
// which take milliseconds and are known to the end. Then the full model, until what the last tenth of its run will be
// is known to a quarter of what may be wrong with it, and the cheapest of those models that may be within is, with an
// error that is known to a factor of two. Else it goes to its end; to the end, too, where no first part tells it: a
// mode that grows, modes that are not known, a rough disk that passes by. Last the models in time without a part, to
// their ends; they are given up as soon as they have taken too long to be the advice.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/studies/advice/advisor_judgement.h"
#include "core/studies/study/study.h"

namespace touchdown {

constexpr double worthwhile = 1.2; // a model must be so many times faster to be advised

struct RungOutcome {
    Rung rung;
    std::string problem; // why it has no answer, in a sentence
    std::string remark;  // what is to be said of it, in a sentence
    TailEstimate tail;
    double seconds = 0.0; // of one processor, over the whole run
    bool givenUp = false; // it takes too long to be the advice; of the rest nothing is known
    RungErrors errors;
    Verdict verdict = Verdict::NotKnown;
    std::optional<Case> found; // the model as a case of the program
    std::string command;       // that solves that case: "run", "steady"
    bool answers() const { return problem.empty() && !givenUp; }
    bool within() const { return answers() && verdict == Verdict::Within; }
};

struct AdvisorResult {
    StudyStatus status = StudyStatus::Completed;
    std::string message;
    RungOutcome full;          // its tail as the pilot tells it
    double pilotTime = 0.0;    // how far it was run; zero: not at all [s]
    bool pilotWhole = false;   // to its end
    double studySeconds = 0.0; // of all threads
    bool contactActed = false;
    double gridError = 0.0;    // of the full model's static spacing [m]; zero: not known
    double growth = 0.0;       // e-folds of a mode that grows, over the run; zero: none does, or it is not known
    std::string growthProblem; // why it is not known, in a sentence
    bool roughPasses = false;  // a surface without an order of its own moves by
    Allowance allowed;
    std::vector<RungOutcome> rungs;
    std::vector<std::string> missing;  // models that were not tried, as the study was stopped or its budget was spent
    bool late = false;                 // the budget was spent
    std::optional<std::size_t> advice; // among rungs; none: the full model, where any were tried and none is missing
    bool advisesFull() const { return !advice && missing.empty() && !rungs.empty(); }
    // Where it was confirmed:
    std::optional<TailEstimate> fullEnd;
    std::optional<RungErrors> found; // of the advice, from both at their ends
    double fullSeconds = 0.0, adviceSeconds = 0.0;
};

/// Called on the thread of the study; `sofar` where there is more than before; false stops.
using AdvisorTell = std::function<bool(double share, const std::string& doing, const AdvisorResult* sofar)>;

AdvisorResult advise(const AdvisorTask& task, int jobs, const AdvisorTell& tell);

} // namespace touchdown
