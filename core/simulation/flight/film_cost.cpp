// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_cost.h"

#include "core/simulation/flight/coupled_step.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

void addFigures(const CoupledCost& cost, Summary& summary)
{
    const auto add = [&](const char* name, const char* unit, const char* longName, double value) {
        summary.figures.push_back({{name, unit, unit, longName}, value});
    };
    add("film_time", "s", "Wall time of the film's steps", cost.filmSeconds);
    add("response_time", "s", "Wall time of the film's responses to the attitude", cost.responseSeconds);
    add("force_time", "s", "Wall time of the film's forces", cost.forceSeconds);
    add("contact_time", "s", "Wall time of the contact", cost.contactSeconds);
    add("disk_time", "s", "Wall time of the disk's surface under the film", cost.diskSeconds);
    add("film_solves", "1", "Attitudes at which the film was solved", static_cast<double>(cost.filmSolves));
    add("linearisations", "1", "Linearisations of the film", static_cast<double>(cost.linearisations));
    add("contact_solves", "1", "Attitudes at which the contact was asked", static_cast<double>(cost.contactSolves));
    add("contact_skipped", "1", "Attitudes at which no contact was in reach", static_cast<double>(cost.contactSkipped));
    const double perContact =
        cost.contactSolves > 0 ? cost.contactSolveSeconds / static_cast<double>(cost.contactSolves) : 0.0;
    add("contact_saved", "s", "Wall time that skipped contacts would have taken",
        perContact * static_cast<double>(cost.contactSkipped));
    add("jacobians_kept", "1", "Attitudes at which the film needed no linearisation",
        static_cast<double>(cost.jacobiansKept));
}

} // namespace touchdown
