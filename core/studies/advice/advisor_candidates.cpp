// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/advisor_candidates.h"

#include <algorithm>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/physics/contact/adhesion_kind.h"
#include "core/studies/advice/spring_fit.h"

namespace touchdown {

namespace {

constexpr int fewestLines = 33; // of a grid that still sees the rails

std::string listed(const std::vector<ModelPart>& parts, std::string ModelPart::*text)
{
    std::string list;
    for (const ModelPart& part : parts) list += (list.empty() ? "" : ", ") + part.*text;
    return list;
}

/// So many times fewer cells along each side, to the next number of lines that a grid may have.
int fewer(int nodes, int divisor)
{
    return std::max(fewestLines, 16 * ((nodes - 1 + 8 * divisor) / (16 * divisor)) + 1);
}

void addGrids(const Case& c, std::vector<ModelPart>& parts)
{
    std::array<int, 2> last = c.film.nodes;
    for (const int divisor : {2, 4, 8}) {
        const std::array<int, 2> nodes{std::min(last[0], fewer(c.film.nodes[0], divisor)),
                                       std::min(last[1], fewer(c.film.nodes[1], divisor))};
        if (nodes == last) break;
        const std::string text = std::to_string(nodes[0]) + ", " + std::to_string(nodes[1]);
        parts.push_back({std::to_string(nodes[0]) + " x " + std::to_string(nodes[1]) + " grid lines",
                         "grid lines beyond " + std::to_string(nodes[0]) + " x " + std::to_string(nodes[1]),
                         {{"film.nodes", text}, {"film.accuracy", "0"}},
                         "grid"});
        last = nodes;
    }
}

/// In the order in which they are tried: those that leave out most of the work first, so that what takes longer is soon
/// given up.
std::vector<ModelPart> partsOf(const Case& c, double roll)
{
    std::vector<ModelPart> parts;
    addGrids(c, parts);
    std::ranges::reverse(parts);
    if (c.film.motion == FilmMotion::Full)
        parts.insert(parts.begin(), {"linear", "the film's own law", {{"film.motion", "linear"}}, "film"});
    if (c.run.steps == StepControl::Adaptive)
        for (const double factor : {100.0, 10.0}) {
            const std::string error = fewDigits(factor * c.run.stepError, "nm", 6);
            parts.push_back(
                {"step error " + error, "step errors below " + error, {{"run.step_error", error}}, "steps"});
        }
    else
        for (const double factor : {4.0, 2.0}) {
            const std::string step = fewDigits(factor * c.run.step, "ns", 6);
            parts.push_back({"steps of " + step, "shorter steps than " + step, {{"run.step", step}}, "steps"});
        }
    if (c.diskSurface.kind != DiskSurfaceKind::Flat)
        parts.push_back({"flat disk", "the disk's surface", {{"disk.surface.kind", "flat"}}, "surface"});
    if (c.contact != noContact)
        parts.push_back({"no contact", "contact and what adheres in it", {{"contact", "none"}}, "contact"});
    const auto uses = [&](const char* key) { return findParameter(key)->used(c); };
    if (c.adhesion.kind != AdhesionKind::None && uses("adhesion.kind"))
        parts.push_back({"no adhesion", "adhesion", {{"adhesion.kind", "none"}}, "adhesion"});
    const auto law = characteristic(c);
    if (law && law->meniscusForce > 0.0)
        parts.push_back({"no menisci", "the force of the menisci", {{"ono_yamane.meniscus_force", "0 N"}}, "adhesion"});
    if (uses("meniscus.surface_tension") && c.meniscus.surfaceTension > 0.0)
        parts.push_back(
            {"no menisci", "the force of the menisci", {{"meniscus.surface_tension", "0 N/m"}}, "adhesion"});
    if (uses("elastic.cell")) {
        const std::string cell = fewDigits(2.0 * c.elastic.cell, "um", 6);
        parts.push_back(
            {"contact cells of " + cell, "contact cells finer than " + cell, {{"elastic.cell", cell}}, "cells"});
    }
    if (c.degreesOfFreedom == 3)
        parts.push_back({"roll held",
                         "motion in roll",
                         {{"degrees_of_freedom", "2"}, {"initial.roll", formatQuantity(roll, "urad")}},
                         "roll"});
    return parts;
}

bool wanted(const AdvisorTask& task, CandidateKind kind)
{
    return task.models.empty() || std::ranges::find(task.models, name(kind)) != task.models.end();
}

} // namespace

std::vector<Candidate> candidatesOf(const AdvisorTask& task, double roll)
{
    const Case& c = task.start;
    const bool waves = c.diskSurface.kind == DiskSurfaceKind::Waves && c.diskSurface.motion == SurfaceMotion::Moving;
    const std::string touches = c.contact != noContact ? ", contact" : "";
    const std::string surface = c.diskSurface.kind != DiskSurfaceKind::Flat ? ", the disk's surface" : "";
    std::vector<Candidate> candidates, reduced;
    reduced.push_back({CandidateKind::Static, "static state", "all motion" + surface + touches, {}, c});
    if (characteristic(c))
        reduced.push_back({CandidateKind::ContactRest, "rest in contact", "all motion" + surface, {}, c});
    if (waves)
        reduced.push_back(
            {CandidateKind::WaveAnswer, "answer to the waves", "the start, all that is not linear" + touches, {}, c});
    reduced.push_back({CandidateKind::SmallMotion,
                       "small motions",
                       "all that is not linear" + (waves ? "" : surface) + touches,
                       {},
                       c});
    if (c.contact == noContact || characteristic(c))
        reduced.push_back({CandidateKind::Springs,
                           "springs",
                           "the film's own law" + (springsKnowDisk(c) ? "" : surface) +
                               (c.degreesOfFreedom == 3 ? ", motion in roll" : ""),
                           {},
                           c});
    std::vector<ModelPart> grids{{}};
    addGrids(c, grids);
    for (const Candidate& candidate : reduced)
        for (const ModelPart& grid : grids) {
            Candidate on = candidate;
            if (!grid.name.empty()) {
                on.name += " on " + grid.name;
                on.leavesOut += ", " + grid.leavesOut;
            }
            // Springs hold the roll at that of their static state.
            if (candidate.kind == CandidateKind::Springs && c.degreesOfFreedom == 3) on.c.initial.roll = roll;
            if (wanted(task, candidate.kind) && !changeCase(on.c, grid.settings)) candidates.push_back(std::move(on));
        }
    if (!wanted(task, CandidateKind::Part) && !wanted(task, CandidateKind::Sum)) return candidates;
    for (const ModelPart& part : partsOf(c, roll)) {
        Candidate candidate{CandidateKind::Part, "film, " + part.name, part.leavesOut, {part}, c};
        if (!changeCase(candidate.c, part.settings)) candidates.push_back(std::move(candidate));
    }
    return candidates;
}

std::optional<Candidate> sumOf(const AdvisorTask& task, const std::vector<ModelPart>& parts)
{
    const bool withoutContact = std::ranges::find(parts, "contact", &ModelPart::family) != parts.end();
    std::vector<ModelPart> kept;
    for (const ModelPart& part : parts) // without contact nothing adheres, and there are no cells
        if (!withoutContact || (part.family != "adhesion" && part.family != "cells")) kept.push_back(part);
    if (!wanted(task, CandidateKind::Sum) || kept.size() < 2) return {};
    std::ranges::sort(kept, {}, &ModelPart::family);
    Candidate candidate{CandidateKind::Sum, "film, " + listed(kept, &ModelPart::name),
                        listed(kept, &ModelPart::leavesOut), kept, task.start};
    for (const ModelPart& part : kept)
        if (changeCase(candidate.c, part.settings)) return {};
    return candidate;
}

} // namespace touchdown
