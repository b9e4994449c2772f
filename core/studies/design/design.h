// SPDX-License-Identifier: GPL-3.0-or-later
//
// A search for the values of a film case with which its static state is as wanted. Parameters x lie between bounds and
// are counted as u = (x - minimum)/(maximum - minimum); each quantity q_i has a target t_i with a tolerance e_i:
//
//   r_i(u) = (q_i - t_i)/e_i,   |r|^2 least,   found where every |r_i| <= 1
//
// Damped Gauss-Newton (Levenberg 1944, Marquardt 1963), core/numerics/bounded_step.h, with J by differences of one
// parameter at a time. The static state is that of `touchdown steady` from the initial attitude of the case; a state in
// which the film alone leaves rails below the mean plane of the disk counts too, since contact may carry the rest
// there. In the end the values get as few digits of their display units as reach the targets, 4, 6 or 8.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/case/case_key.h"
#include "core/simulation/recording/quantity.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/study/study.h"

namespace touchdown {

struct DesignParameter {
    std::vector<Parameter> keys; // the first is meant by the numbers below; the others change by as much
    double start = 0.0, minimum = 0.0, maximum = 0.0; // [unit of the first key]
};

struct DesignTarget {
    Quantity quantity;      // of core/simulation/static_state/steady_quantities.h
    double value = 0.0;     // [unit of the quantity]
    double tolerance = 0.0; // > 0
};

struct DesignTask {
    std::vector<DesignParameter> parameters;
    std::vector<DesignTarget> targets;
    int maximumIterations = 30;
    double difference = 0.01; // for the slopes, of a range [-]; above the scatter of grids that follow the rails
};

/// A set of values that was tried.
struct DesignPoint {
    int iteration = 0;
    std::vector<double> parameters; // [unit]
    std::vector<double> quantities; // of the targets; empty where there was no static state
    double misfit = 0.0;            // the largest |r_i| [-]
    std::string problem;            // why there is no static state, in a sentence; "" where there is one
};

struct DesignStudy {
    StudyStatus status = StudyStatus::Failed; // completed: all targets are reached
    std::string message;
    std::vector<DesignPoint> steps; // the start and every better set that was found; the last one is the best
    Case found;                     // the case with the values of the best
    SteadyResult state;             // of the best, without pressure, gap and recess
    int solves = 0;                 // static states
};

/// Called while a static state is solved; return false to stop.
struct DesignProgress {
    int iteration = 0, solves = 0;
    double misfit = 0.0;                 // of the best so far [-]
    const DesignStudy* better = nullptr; // with a better set, once after it was found
};
using DesignCallback = std::function<bool(const DesignProgress&)>;

/// Why a valid case cannot be studied so, in a sentence; "" when it can.
std::string reasonNotToDesign(const Case& c);

/// The case with one value for each parameter; what is wrong with it, in a sentence, or "".
std::string applyParameters(Case& c, const std::vector<DesignParameter>& parameters, const std::vector<double>& values);

/// `c` has no reason not to; the task has parameters and targets, and its bounds were accepted by the keys.
/// Deterministic.
DesignStudy studyDesign(const Case& c, const DesignTask& task, const DesignCallback& callback = {});

} // namespace touchdown
