// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/contact_doubts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include "core/case/case.h"
#include "core/formats/units.h"
#include "core/physics/contact/adhesion.h"
#include "core/physics/contact/contact_bodies.h"
#include "core/simulation/contact/contact_run.h"
#include "core/simulation/contact/pad_way.h"

namespace touchdown {
namespace {

constexpr double largeError = 0.02;     // of a force, for a warning [-]
constexpr double largeDifference = 0.2; // of a force from that with cells twice as large, which is much more wrong [-]
constexpr double mostCoarseSteps = 200.0; // of the run with cells twice as large
constexpr double notKnown = std::numeric_limits<double>::quiet_NaN();
constexpr double cellsOfZone = 2.0; // with fewer cells, edges hang on them
constexpr double ofCut = 2.5;       // sides of a patch that holds a contact, against sqrt(R d) [-]
constexpr std::array<std::string_view, 7> ofGrid = {
    "largest_contact_force", "pull_off_force", "pull_off_separation", "snap_in_separation",
    "release_separation",    "loop_work",      "closest_contact_area"};

auto figureOf(std::vector<RunFigure>& figures, std::string_view name)
{
    return std::ranges::find(figures, name, [](const RunFigure& figure) { return figure.quantity.name; });
}

/// The difference of a figure from another run of the case. The first jump here may not be the first jump there: for a
/// jump it is the distance to the nearest jump there, on the way out also the distance between the last jumps of both.
std::optional<double> difference(const Case& c, const Summary& own, const Summary& other, const RunFigure& figure)
{
    const std::string& name = figure.quantity.name;
    if (name != "release_separation" && name != "snap_in_separation") {
        const auto found = std::ranges::find(other.figures, name, [](const RunFigure& f) { return f.quantity.name; });
        if (found == other.figures.end()) return std::nullopt;
        return std::abs(found->value - figure.value);
    }
    const auto jumps = [&](const Summary& summary) {
        std::vector<double> list; // separations [m]
        for (const RunEvent& event : summary.events)
            if ((event.time > 0.5 * c.run.duration) == (name == "release_separation"))
                list.push_back(padSeparation(c, event.time));
        return list;
    };
    const std::vector<double> here = jumps(own), there = jumps(other);
    if (here.empty() || there.empty()) return std::nullopt;
    double nearest = std::numeric_limits<double>::infinity();
    for (const double d : there) nearest = std::min(nearest, std::abs(d - figure.value));
    return name == "release_separation" ? std::max(nearest, std::abs(here.back() - there.back())) : nearest;
}

std::string millinewtons(double force) { return fewDigits(force, "mN", 3); }
std::string micrometres(double length) { return fewDigits(length, "um", 4); }

/// An area counts whole cells: half a cell along the border of a disk of that area [m^2].
double rimError(double area, double cell) { return 0.5 * cell * 2.0 * std::sqrt(std::numbers::pi * area); }

void addError(std::vector<RunFigure>& figures, std::string_view name, double error)
{
    const auto figure = figureOf(figures, name);
    if (figure == figures.end()) return;
    RunFigure added = *figure;
    added.quantity.name += "_error";
    added.quantity.longName = "Error of its grid: " + figure->quantity.longName;
    added.value = error;
    figures.insert(figure + 1, std::move(added));
}

bool leavesOutAttraction(double beyond, double adhesion) { return beyond > 0.0 && beyond > -largeError * adhesion; }

std::string wantedPatch(const Case& c)
{
    if (c.model != ModelKind::Contact) return "elastic.patch_reach and elastic.patch_pitch set the size of the patches";
    if (c.pad.shape != PadShape::Sphere) return "increase approach.closest, or take a larger pad";
    const double depth = std::max(-c.approach.closest, 0.0);
    const double side = ofCut * std::sqrt(c.pad.radius * depth);
    const std::string wish = "pad.length and pad.width must be larger";
    return side > std::min(c.pad.length, c.pad.width) ? wish + ", about " + micrometres(roundedTo(side, 2)) : wish;
}

} // namespace

Case withFewerSamples(const Case& c)
{
    Case fewer = c;
    fewer.run.fieldSnapshots = 0;
    const bool moves = c.diskSurface.kind != DiskSurfaceKind::Flat && c.diskSurface.motion == SurfaceMotion::Moving;
    if (!moves) fewer.run.sampleInterval = std::max(c.run.sampleInterval, c.run.duration / mostCoarseSteps);
    return fewer;
}

double adhesionZone(const Case& c)
{
    if (!c.adhesion.acts()) return std::numeric_limits<double>::infinity();
    // E* dgamma/p_max^2, dgamma the depth of the energy.
    const AdhesionLaw law(c.adhesion);
    return contactModulus(c.elastic.pair) * -law.leastEnergy() / (law.peakAttraction() * law.peakAttraction());
}

bool edgesHangOnCells(const Case& c) { return adhesionZone(c) < cellsOfZone * c.elastic.cell; }

bool coversError(const Case& c, const ContactDoubts& doubts)
{
    return !doubts.cutOff && !doubts.belowCell && !edgesHangOnCells(c);
}

void ContactDoubts::add(const ContactGridError& patch)
{
    if (!grid) grid = ContactGridError{.known = true};
    grid->known = grid->known && patch.known;
    grid->force += patch.force;
    grid->area += patch.area;
    grid->other += patch.other;
    grid->cell = std::max(grid->cell, patch.cell);
    grid->cells += patch.cells;
}

std::vector<std::string> warningsOf(const Case& c, const ContactDoubts& doubts, double force, double adhesion)
{
    std::vector<std::string> list;
    if (doubts.cutOff)
        list.push_back("the contact reaches the border of its patch and is cut off there: force and area are too "
                       "small; " +
                       wantedPatch(c));
    if (leavesOutAttraction(doubts.adhesionBeyond, adhesion))
        list.push_back("the attraction beyond the border of the patch, up to " + millinewtons(doubts.adhesionBeyond) +
                       " where that on the patch is " + millinewtons(-adhesion) +
                       ", is left out: pad.length and pad.width must be larger");
    if (!doubts.grid) return list;
    const ContactGridError& grid = *doubts.grid;
    const double large = grid.cell > c.elastic.cell ? largeDifference : largeError;
    if (!grid.known)
        list.emplace_back("the error of the contact's grid is not known: the solution on other cells did not converge");
    else if (coversError(c, doubts) && grid.force > large * force && grid.force > 0.0)
        list.push_back("the cells are large for this contact: " + std::to_string(grid.cells) +
                       (grid.cells == 1 ? " cell touches" : " cells touch") + ", and the contact force of " +
                       millinewtons(force) + " has an error of up to " + millinewtons(grid.force) + " (" +
                       millinewtons(grid.other) + " with cells of " + micrometres(grid.cell) + " instead of " +
                       micrometres(c.elastic.cell) + "); take a smaller elastic.cell");
    return list;
}

void addErrors(const Case& c, const ContactDoubts& doubts, Summary& summary, const ContactComparison& comparison)
{
    const auto isKnown = [&](std::string_view name) {
        if (!comparison.parts && (name.starts_with("pull_off") || name == "loop_work")) return false;
        return name == "pull_off_force" || !leavesOutAttraction(doubts.adhesionBeyond, comparison.adhesion);
    };
    std::string large, missing;
    for (const std::string_view name : ofGrid) {
        const auto own = figureOf(summary.figures, name);
        if (own == summary.figures.end()) continue;
        std::string text(name);
        for (const auto& [written, read] : {std::pair("pull_off", "pull-off"), std::pair("snap_in", "snap-in")})
            if (text.starts_with(written)) text.replace(0, std::string_view(written).size(), read);
        std::ranges::replace(text, '_', ' ');
        const std::optional<double> distance = difference(c, summary, comparison.other, *own);
        if (!distance) missing += (missing.empty() ? "" : ", ") + text;
        if (!distance || !isKnown(name)) {
            addError(summary.figures, name, notKnown);
            continue;
        }
        const Quantity quantity = own->quantity;
        const double value = own->value;
        const double error = moreThanCoarse * *distance + (quantity.unit == "m" ? comparison.resolution : 0.0) +
                             (name == "pull_off_force" ? doubts.adhesionBeyond : 0.0) +
                             (name == "closest_contact_area" ? rimError(value, c.elastic.cell) : 0.0);
        if (name.ends_with("_force") && moreThanCoarse * *distance > largeDifference * std::abs(value))
            large += (large.empty() ? "" : ", ") + text + ": " + fewDigits(value, quantity.displayUnit, 3) +
                     " with an error of up to " + fewDigits(error, quantity.displayUnit, 2);
        addError(summary.figures, name, error);
    }
    const std::string cells = micrometres(2.0 * c.elastic.cell);
    if (!large.empty())
        summary.warnings.push_back("the cells are large for this contact: compared with cells of " + cells + ": " +
                                   large + "; take a smaller elastic.cell");
    if (!missing.empty())
        summary.warnings.push_back("the error of the contact's grid is not known for the " + missing +
                                   ": a run with cells of " + cells + " has none; take a smaller elastic.cell");
}

void addUnknownErrors(Summary& summary)
{
    for (const std::string_view name : ofGrid) addError(summary.figures, name, notKnown);
}

void addErrors(const Case& c, const ContactDoubts& doubts, Summary& summary, bool sameState)
{
    const bool known = doubts.grid && doubts.grid->known && coversError(c, doubts);
    addError(summary.figures, "largest_contact_force", known ? doubts.grid->force : notKnown);
    addError(summary.figures, "closest_contact_area", known && sameState ? doubts.grid->area : notKnown);
}

} // namespace touchdown
