// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/formats/units.h"
#include "core/simulation/flight/linear_film.h"

namespace touchdown {

namespace {

constexpr double largeError = 0.05; // of a transient [-]
constexpr double heardPeak = 0.1;   // of the largest peak [-]

void addMeasured(Summary& summary, const char* name, const char* unit, const char* longName, double value)
{
    summary.figures.push_back({{name, unit, unit, longName}, value, false, true});
}

} // namespace

void StepErrors::add(const CoupledStepResult& accepted)
{
    balance = std::max(balance, accepted.forceBalance);
    left = std::max(left, accepted.positionLeft);
    film = std::max(film, accepted.filmError);
}

std::string reasonOf(const CoupledStepResult& result, const std::string& ofContact)
{
    switch (result.failure) {
    case CoupledFailure::None: return "its error stays above run.step_error";
    case CoupledFailure::Film: return "the film does not converge";
    case CoupledFailure::Contact: return ofContact;
    case CoupledFailure::Iteration: return "film and slider do not come to agree";
    case CoupledFailure::Stopped: break;
    case CoupledFailure::NotFinite: return "the forces are no numbers";
    }
    return {};
}

std::string noStepIsShortEnough(const std::string& time, const std::string& reason, const std::string& disk,
                                double spacing)
{
    return "no step is short enough at " + time + ": " + reason +
           (disk.empty() ? "" : "; " + disk + ", and no law of contact acts (contact = \"none\")") +
           "; the samples end with the last good state, minimum spacing " +
           formatQuantity(std::round(spacing * 1e13) / 1e13, "nm");
}

void addStepWarnings(Summary& summary, const StepTroubles& troubles, FilmCoupling coupling)
{
    if (troubles.cuts > 0)
        summary.warnings.push_back(
            "steps of run.step found no solution and were cut " + std::to_string(troubles.cuts) +
            (troubles.cuts == 1 ? " time: " : " times, first as ") + troubles.firstCut +
            (coupling == FilmCoupling::Staggered ? "; film.coupling = \"monolithic\" has no such limit" : ""));
    if (troubles.jumps > 0)
        summary.warnings.push_back("the forces jumped at " + std::to_string(troubles.jumps) +
                                   " times where no law switches, as the film's do where its slip changes at once");
    if (troubles.closings > 0)
        summary.warnings.push_back("cells of the film closed " + std::to_string(troubles.closings) +
                                   " times: the air that was left in them is lost from the energy balance");
}

void addCost(Summary& summary, const CoupledCost& cost)
{
    const auto add = [&](const char* name, const char* unit, const char* longName, double value) {
        addMeasured(summary, name, unit, longName, value);
    };
    const auto addCount = [&](const char* name, const char* longName, long long count) {
        summary.figures.push_back({{name, "1", "1", longName}, static_cast<double>(count), true, true});
    };
    add("film_time", "s", "Wall time of the film's steps", cost.filmSeconds);
    add("response_time", "s", "Wall time of the film's responses to the attitude", cost.responseSeconds);
    add("force_time", "s", "Wall time of the film's forces", cost.forceSeconds);
    add("contact_time", "s", "Wall time of the contact", cost.contactSeconds);
    add("disk_time", "s", "Wall time of the disk's surface under the film", cost.diskSeconds);
    addCount("film_solves", "Attitudes at which the film was solved", cost.filmSolves);
    addCount("linearisations", "Linearisations of the film", cost.linearisations);
    addCount("contact_solves", "Attitudes at which the contact was asked", cost.contactSolves);
    addCount("contact_skipped", "Attitudes at which no contact was in reach", cost.contactSkipped);
    const double perContact =
        cost.contactSolves > 0 ? cost.contactSolveSeconds / static_cast<double>(cost.contactSolves) : 0.0;
    add("contact_saved", "s", "Wall time that skipped contacts would have taken",
        perContact * static_cast<double>(cost.contactSkipped));
    addCount("jacobians_kept", "Attitudes at which the film needed no linearisation", cost.jacobiansKept);
}

void addLinearErrors(Summary& summary, const LinearFilm& film)
{
    addMeasured(summary, "film_fit_error", "1",
                "Largest error of the linear film's answer at frequencies not yet fitted, against its largest entry",
                film.fit().error);
    addMeasured(summary, "film_linearity_error", "1",
                "Error of the corners' displacement because the film is linear, as estimated, against the displacement",
                film.linearityError());
    addMeasured(summary, "film_motion_size", "1",
                "Largest displacement of the slider's corners from the static state, against its minimum spacing",
                film.largestSize());
    if (film.transientError() > largeError)
        summary.warnings.push_back("the answer of the linear film to waves that begin is known to " +
                                   percent(film.transientError()) + ": so is the motion that the start over them " +
                                   "excites; what lasts is not concerned");
    for (const Peak& peak : summary.peaks)
        if (peak.frequency > highestFitted && peak.amplitude > heardPeak * summary.peaks.front().amplitude)
            summary.warnings.push_back("the linear film is fitted up to " + fewDigits(highestFitted, "kHz") +
                                       ": its answer to the motion at " + fewDigits(peak.frequency, "kHz") +
                                       " is extrapolated");
}

std::string tooFarFromRest(const LinearFilm& film, double limit)
{
    return "the motion is too large for a linear film: its error is estimated as " + percent(film.linearityError()) +
           " of the motion, above film.linear_limit = " + percent(limit) +
           " (film.motion = \"full\" has no such limit)";
}

void addStepErrors(Summary& summary, const StepErrors& worst, double energyImbalance)
{
    addMeasured(summary, "force_balance", "1", "Largest imbalance of the forces in an accepted step, against the load",
                worst.balance);
    addMeasured(summary, "position_left", "m", "Largest distance from its solution at which a step was accepted",
                worst.left);
    addMeasured(summary, "film_left", "1",
                "Largest error of the film's pressure that a step was accepted with, against ambient", worst.film);
    addMeasured(summary, "energy_balance", "1", "Energy imbalance, against the largest change of a part",
                energyImbalance);
}

void addGridError(Summary& summary, const ContactGridError& error, bool covers)
{
    const bool known = error.known && covers;
    const auto add = [&](const Quantity& quantity, double value) {
        summary.figures.push_back({quantity, known ? value : std::numeric_limits<double>::quiet_NaN()});
    };
    add({"contact_force_error", "N", "mN", "Error of the contact's grid at the largest contact force"}, error.force);
    add({"contact_area_error", "m^2", "um^2", "Error of its grid in the area of contact"}, error.area);
}

} // namespace touchdown
