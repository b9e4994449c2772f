// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/elastic_pad.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/case/contact_patches.h"
#include "core/case/disk_setup.h"
#include "core/formats/units.h"
#include "core/physics/contact/adhesion_kind.h"
#include "core/physics/disk/disk_surface_check.h"
#include "core/physics/disk/surface_sampling.h"
#include "core/simulation/contact/contact_doubts.h"
#include "core/simulation/contact/disk_under_film.h"

namespace touchdown {

namespace {

constexpr double unresolvedShare = 0.1; // of a measured surface's RMS, between cells: a wave of 7 cells [-]
constexpr double lostShare = 0.01;      // of the RMS, that counts [-]
constexpr double cellsOfBump = 4.0;
constexpr double leastRms = 1e-12; // [m]; below it is flat
constexpr double seamShare = 1e-6; // of the surface's whole height: rounding [-]

std::vector<double> lines(double first, double step, int count)
{
    std::vector<double> result;
    for (int i = 0; i <= count; ++i) result.push_back(first + i * step);
    return result;
}

bool hasFeaturesBelowCell(const Case& c, const SurfaceSampling& sampling)
{
    return hasFile(c.diskSurface) && sampling.rmsOfMap >= leastRms &&
           sampling.unresolved > unresolvedShare * sampling.rmsOfMap;
}

/// Warns of features of the disk's surface that the cells of a patch lose.
void addSampling(const Case& c, const UniformGrid& grid, const DiskTopography& surface, std::vector<std::string>& list)
{
    const auto micrometres = [](double length) { return fewDigits(length, "um", 4); };
    const auto nanometres = [](double length) { return fewDigits(length, "nm", 3); };
    const SurfaceSampling sampling = surfaceSampling(surface, grid);
    const DiskSurface& disk = c.diskSurface;
    const bool isFlat = sampling.rmsOfMap < leastRms;
    if (hasFeaturesBelowCell(c, sampling))
        list.push_back("the measured surface has features below a cell: elastic.cell is " + micrometres(grid.dx) +
                       ", the points of its map are " + micrometres(surface.period().dx) +
                       " apart, and in the middle of four cells it differs by " + nanometres(sampling.unresolved) +
                       " RMS from their mean, of " + nanometres(sampling.rmsOfMap) +
                       " RMS in all; the contact does not know of it: take a smaller elastic.cell");
    // Where the cells are much smaller, the sampled part holds too few points to compare both RMS heights.
    const bool comparable = grid.dx > 0.5 * surface.period().dx;
    if ((hasFile(disk) || hasRoughness(disk)) && !isFlat && comparable &&
        sampling.rms < (1.0 - lostShare) * sampling.rmsOfMap)
        list.push_back("the centres of the patch's cells lie between the points of the surface's map, where it is "
                       "smoother: their heights have an RMS of " +
                       nanometres(sampling.rms) + ", those of the points " + nanometres(sampling.rmsOfMap) + ", " +
                       percent(sampling.rmsOfMap / sampling.rms - 1.0) + " more; a map with closer points" +
                       (hasFile(disk) ? "" : " (disk.surface.cell)") + " loses less");
    if (hasBumps(disk)) {
        double narrowest = *std::ranges::min_element(disk.bumpLengths);
        if (!disk.bumpWidths.empty()) narrowest = std::min(narrowest, *std::ranges::min_element(disk.bumpWidths));
        if (narrowest < cellsOfBump * grid.dx)
            list.push_back("a bump of " + micrometres(narrowest) + " has only " +
                           fewDigits(narrowest / grid.dx, "", 2) + " cells of " + micrometres(grid.dx) +
                           " across: its contact is coarse, or missed; take a smaller elastic.cell");
    }
    if (!c.elastic.periodic || c.model != ModelKind::Contact) return;
    const double seam = largestSeam(surface, grid);
    if (seam > seamShare * (surface.highest() - surface.lowest()))
        list.push_back(
            "elastic.periodic repeats the patch of " + micrometres(grid.nx * grid.dx) + " by " +
            micrometres(grid.ny * grid.dy) + ", but the surface does not repeat with it: at the seam its " +
            "height jumps by up to " + nanometres(seam) + " (RMS height " + nanometres(sampling.rmsOfMap) + ")" +
            (surface.repeats() ? "; its period is " + micrometres(surface.period().nx * surface.period().dx) + " by " +
                                     micrometres(surface.period().ny * surface.period().dy)
                               : std::string()));
}

} // namespace

ElasticPad::ElasticPad(const Case& c, const std::function<bool()>& goOn, bool coarser)
    : case_(c),
      topography_(diskTopography(c, goOn)),
      velocity_(surfaceVelocity(c, topography_)),
      modulus_(contactModulus(c.elastic.pair))
{
    for (ContactPatch& patch : patchesOf(c, topography_).patches) {
        if (coarser) patch = coarsened(patch);
        HalfSpace space(patch.grid, modulus_, c.elastic.periodic ? HalfSpaceEdges::Periodic : HalfSpaceEdges::Free,
                        goOn);
        AdhesiveContact contact(std::move(space), c.adhesion,
                                {.tolerance = c.elastic.tolerance,
                                 .maximumIterations = c.elastic.maximumIterations,
                                 .hardness = c.elastic.hardness,
                                 .goOn = goOn});
        const std::size_t cells = patch.grid.cells();
        parts_.push_back({std::move(patch), std::move(contact), std::vector<double>(topography_.flat() ? 0 : cells),
                          std::vector<double>(cells)});
    }
}

std::size_t ElasticPad::cells() const
{
    std::size_t count = 0;
    for (const Part& part : parts_) count += part.patch.grid.cells();
    return count;
}

const ContactForces& ElasticPad::move(double separation, double time)
{
    forces_ = {};
    forces_.separation = separation;
    time_ = time;
    forces_.minimumGap = std::numeric_limits<double>::infinity();
    jumped_ = false;
    for (Part& part : parts_) solve(part, separation, time);
    return forces_;
}

void ElasticPad::solve(Part& part, double separation, double time)
{
    const bool moves = velocity_.x != 0.0 || velocity_.y != 0.0;
    if (!part.surface.empty() && (part.surfaceTime < 0.0 || (moves && part.surfaceTime != time))) {
        topography_.heights(part.patch.grid, velocity_.x * time, velocity_.y * time, part.surface);
        part.surfaceTime = time;
    }
    for (std::size_t i = 0; i < part.separation.size(); ++i)
        part.separation[i] = separation + part.patch.height[i] - (part.surface.empty() ? 0.0 : part.surface[i]);

    const double cell = part.patch.grid.cellArea();
    const AdhesiveContactSummary summary = part.contact.solve(part.separation);
    forces_.iterations += summary.iterations;
    if (!summary.converged && forces_.problem.empty()) forces_.problem = summary.message;
    for (const double p : part.contact.pressure()) {
        if (p <= 0.0) continue;
        forces_.contact += p * cell;
        forces_.area += cell;
        forces_.peakPressure = std::max(forces_.peakPressure, p);
    }
    const double least = *std::ranges::min_element(part.contact.gap());
    // Where nothing flows, a gap below zero is what the solver's tolerance left.
    forces_.minimumGap = std::min(forces_.minimumGap, case_.elastic.hardness > 0.0 ? least : std::max(least, 0.0));
    for (const double p : part.contact.adhesion()) forces_.adhesion += p * cell;
    if (part.contact.adheres()) forces_.energy += part.contact.energy();
    jumped_ = jumped_ || summary.jumped;
}

void ElasticPad::remember(std::size_t place)
{
    for (Part& part : parts_) part.contact.remember(place);
}

void ElasticPad::recall(std::size_t place)
{
    for (Part& part : parts_) part.contact.recall(place);
}

ContactDoubts ElasticPad::doubts(const std::function<bool()>& goOn) const
{
    ContactDoubts doubts;
    if (!parts_.empty()) doubts.belowCell = losesFeatures(case_, topography_, parts_.front().patch.grid);
    for (const Part& part : parts_) {
        const SeparationOn separation = [&](const UniformGrid& grid, std::span<double> s) {
            topography_.heights(grid, velocity_.x * time_, velocity_.y * time_, s);
            for (int j = 0; j < grid.ny; ++j)
                for (int i = 0; i < grid.nx; ++i) {
                    double& at = s[grid.at(i, j)];
                    at = forces_.separation + part.patch.heightAt(grid.x(i), grid.y(j)) - at;
                }
        };
        const ContactState state{.grid = part.patch.grid,
                                 .modulus = modulus_,
                                 .edges = case_.elastic.periodic ? HalfSpaceEdges::Periodic : HalfSpaceEdges::Free,
                                 .hardness = case_.elastic.hardness,
                                 .pressure = part.contact.pressure()};
        doubts.cutOff = doubts.cutOff || isCutOff(state, separation);
        if (part.contact.adheres())
            doubts.adhesionBeyond += adhesionBeyond(part);
        else
            doubts.add(contactGridError(state, separation, goOn));
    }
    return doubts;
}

/// Beyond a circle around a sphere: the integral of f(s) 2 pi r dr, with r dr = R ds.
double ElasticPad::adhesionBeyond(const Part& part) const
{
    if (case_.pad.shape != PadShape::Sphere || case_.elastic.periodic) return 0.0;
    const UniformGrid& grid = part.patch.grid;
    const std::span<const double> gap = part.contact.gap();
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < grid.nx; ++i) least = std::min({least, gap[grid.at(i, 0)], gap[grid.at(i, grid.ny - 1)]});
    for (int j = 0; j < grid.ny; ++j) least = std::min({least, gap[grid.at(0, j)], gap[grid.at(grid.nx - 1, j)]});
    return 2.0 * std::numbers::pi * case_.pad.radius * std::max(-part.contact.law().energy(least), 0.0);
}

void ElasticPad::observe(FieldSnapshot& snapshot) const
{
    const Part& part = parts_.front();
    snapshot.values.clear();
    const auto add = [&](std::span<const double> field) { snapshot.values.emplace_back(field.begin(), field.end()); };
    add(part.contact.gap());
    add(part.contact.pressure());
    if (part.contact.adheres()) add(part.contact.adhesion());
    if (!part.surface.empty()) add(part.surface);
}

std::vector<std::string> ElasticPad::remarks() const
{
    std::vector<UniformGrid> grids;
    for (const Part& part : parts_) grids.push_back(part.patch.grid);
    return elasticRemarks(case_, grids, topography_);
}

bool losesFeatures(const Case& c, const DiskTopography& surface, const UniformGrid& grid)
{
    return hasFile(c.diskSurface) && !surface.flat() && hasFeaturesBelowCell(c, surfaceSampling(surface, grid));
}

std::vector<std::string> elasticRemarks(const Case& c, std::span<const UniformGrid> patches,
                                        const DiskTopography& surface)
{
    const double modulus = contactModulus(c.elastic.pair);
    std::vector<std::string> list;
    if (edgesHangOnCells(c))
        list.push_back("elastic.cell is " + formatQuantity(c.elastic.cell, "um") +
                       ", but adhesion parts the surfaces over a zone of " +
                       formatQuantity(std::round(adhesionZone(c) * 1e10) / 1e10, "um") +
                       " at the edges of a contact: where they are smooth, these hang on the cells and jump from one "
                       "to the next, so that the errors of the cells are not known; cells of half that length follow "
                       "them smoothly");
    if (c.adhesion.kind == AdhesionKind::VanDerWaals && c.adhesion.hamakerB > 0.0)
        list.push_back("van-der-waals repels by itself before the surfaces touch: that repulsion counts with the "
                       "adhesion force, and bears no "
                       "friction");
    if (!patches.empty() && !surface.flat()) addSampling(c, patches.front(), surface, list);
    if (patches.size() < 2) return list;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < patches.size(); ++i)
        for (std::size_t k = i + 1; k < patches.size(); ++k)
            nearest = std::min(nearest, patchDistance(patches[i], patches[k]));
    // Boussinesq: F/(pi E* r).
    const double perNewton = 1.0 / (std::numbers::pi * modulus * nearest);
    list.push_back(std::to_string(patches.size()) + " patches are solved as if each were alone; the nearest two are " +
                   formatQuantity(std::round(nearest * 1e7) / 1e7, "um") +
                   " apart, so that a force of 1 mN on one would lower the disk under the other by " +
                   formatQuantity(std::round(perNewton * 1e-3 * 1e13) / 1e13, "nm") + ", which is left out");
    return list;
}

std::optional<SurfaceStatistics> ElasticPad::surfaceStatistics() const
{
    if (topography_.flat()) return std::nullopt;
    return touchdown::surfaceStatistics(case_.diskSurface, topography_);
}

RecordedFields ElasticPad::fields(const Case& c)
{
    const DiskTopography surface = c.pad.shape == PadShape::Slider ? diskTopography(c) : DiskTopography();
    return elasticFields(c, patchesOf(c, surface));
}

RecordedFields elasticFields(const Case& c, const SliderPatches& patches)
{
    RecordedFields fields;
    if (patches.patches.empty()) return fields;
    const UniformGrid& grid = patches.patches.front().grid;
    fields.grid = {lines(grid.x0, grid.dx, grid.nx), lines(grid.y0, grid.dy, grid.ny)};
    fields.quantities = {{"gap", "m", "nm", "Gap of the deformed surfaces"},
                         {"contact_pressure", "Pa", "MPa", "Contact pressure"}};
    if (c.adhesion.acts()) fields.quantities.push_back({"adhesion_pressure", "Pa", "MPa", "Adhesion pressure"});
    if (c.diskSurface.kind != DiskSurfaceKind::Flat)
        fields.quantities.push_back({"disk_surface", "m", "nm", "Height of the disk's surface"});
    return fields;
}

} // namespace touchdown
