// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures and warnings of a film's run beside its samples: what its steps cost, how well they were solved, and what
// they ran into.
#pragma once

#include <string>

#include "core/case/case.h"
#include "core/physics/contact/contact_grid_error.h"
#include "core/simulation/flight/coupled_step.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

class LinearFilm;

/// The largest of the accepted steps.
struct StepErrors {
    double balance = 0.0, left = 0.0, film = 0.0; // as in CoupledStepResult [-], [m], [-]

    void add(const CoupledStepResult& accepted);
};

/// What steps ran into.
struct StepTroubles {
    long long cuts = 0; // of fixed steps
    std::string firstCut;
    long long jumps = 0;    // of the air's force
    long long closings = 0; // of cells of the film
    void pass(auto& stream) { stream(cuts, firstCut, jumps, closings); }
};

/// Why a step was not accepted, in a part of a sentence; `ofContact`: what the contact says.
std::string reasonOf(const CoupledStepResult& result, const std::string& ofContact);
/// Why a run ends that finds no step; `disk`: what no law of contact keeps away; may be empty. `spacing`: the last good
/// one [m].
std::string noStepIsShortEnough(const std::string& time, const std::string& reason, const std::string& disk,
                                double spacing);
void addStepWarnings(Summary& summary, const StepTroubles& troubles, FilmCoupling coupling);
/// Of a linear film: of its fit, and of a motion that is not small.
void addLinearErrors(Summary& summary, const LinearFilm& film);
/// Why a run ends whose motion is too large for it, without the time.
std::string tooFarFromRest(const LinearFilm& film, double limit);
void addCost(Summary& summary, const CoupledCost& cost);
/// `energyImbalance`: see FilmRecorder.
void addStepErrors(Summary& summary, const StepErrors& worst, double energyImbalance);
/// Of the contact's grid at the largest contact force. `covers`: it holds all errors, else it is not known.
void addGridError(Summary& summary, const ContactGridError& error, bool covers);

} // namespace touchdown
