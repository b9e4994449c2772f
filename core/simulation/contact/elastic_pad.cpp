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

namespace touchdown {

namespace {

constexpr double unresolvedShare = 0.1; // of a measured surface's RMS, between cells: a wave of 7 cells [-]
constexpr double lostShare = 0.01;      // of the RMS, that counts [-]
constexpr double cellsOfBump = 4.0;
constexpr double leastRms = 1e-12; // [m]; below it is flat
constexpr double seamShare = 1e-6; // of the surface's whole height: rounding [-]

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
    : case_(c), topography_(diskTopography(c, goOn))
{
    for (ContactPatch& patch : patchesOf(c, topography_).patches)
        patches_.emplace_back(c, coarser ? coarsened(patch) : std::move(patch), topography_, goOn);
}

std::size_t ElasticPad::cells() const
{
    std::size_t count = 0;
    for (const ElasticPatch& patch : patches_) count += patch.grid().cells();
    return count;
}

const ContactForces& ElasticPad::move(double separation, double time)
{
    forces_ = {};
    forces_.separation = separation;
    forces_.minimumGap = std::numeric_limits<double>::infinity();
    jumped_ = false;
    for (ElasticPatch& one : patches_) {
        const PatchForces& patch = one.solve({.height = separation}, time);
        forces_.contact += patch.contact[0];
        forces_.adhesion += patch.adhesion[0];
        forces_.area += patch.area;
        forces_.peakPressure = std::max(forces_.peakPressure, patch.peakPressure);
        forces_.minimumGap = std::min(forces_.minimumGap, patch.minimumGap);
        forces_.energy += patch.storedEnergy;
        forces_.iterations += patch.iterations;
        if (forces_.problem.empty()) forces_.problem = patch.problem;
        jumped_ = jumped_ || patch.jumped;
    }
    return forces_;
}

void ElasticPad::remember(std::size_t place)
{
    for (ElasticPatch& patch : patches_) patch.remember(place);
}

void ElasticPad::recall(std::size_t place)
{
    for (ElasticPatch& patch : patches_) patch.recall(place);
}

/// With adhesion the error of the grid is that of the whole way (contact_doubts.h).
ContactDoubts ElasticPad::doubts(const std::function<bool()>& goOn) const
{
    ContactDoubts doubts;
    if (!patches_.empty()) doubts.belowCell = losesFeatures(case_, topography_, patches_.front().grid());
    for (const ElasticPatch& patch : patches_) {
        doubts.cutOff = doubts.cutOff || patch.isCutOff();
        if (!case_.adhesion.acts())
            doubts.add(patch.gridError(goOn));
        else if (case_.pad.shape == PadShape::Sphere && !case_.elastic.periodic)
            doubts.adhesionBeyond += patch.attractionAround(case_.pad.radius);
    }
    return doubts;
}

void ElasticPad::observe(FieldSnapshot& snapshot) const { patches_.front().observe(snapshot); }

std::vector<std::string> ElasticPad::remarks() const
{
    std::vector<UniformGrid> grids;
    for (const ElasticPatch& patch : patches_) grids.push_back(patch.grid());
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

} // namespace touchdown
