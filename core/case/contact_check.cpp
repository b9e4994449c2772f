// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/contact_check.h"

#include <algorithm>
#include <cmath>

#include "core/case/contact_kind.h"
#include "core/case/contact_law.h"
#include "core/case/contact_patches.h"
#include "core/formats/decimal.h"
#include "core/formats/units.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

using Problems = std::vector<CaseProblem>;

std::string inMicrometres(double length) { return fewDigits(length, "um", 4); }

constexpr double mostSnapshotBytes = 4e9;
constexpr double mapsOfFilm = 2.0; // gap and pressure

std::string inMillions(double cells) { return decimalText(cells, -6, 3) + " million cells"; }
std::string inGigabytes(double bytes) { return decimalText(bytes, -9, 3) + " GB"; }

/// A side must be a whole number of cells, up to rounding, and not too many.
void checkSide(const char* key, double side, double cell, Problems& problems)
{
    const double cells = std::round(side / cell);
    const std::string ofCells = inMicrometres(side) + " with elastic.cell = " + inMicrometres(cell);
    if (cells < fewestPatchCells || cells > mostPatchCells)
        problems.push_back({key,
                            ofCells + " makes " + decimalText(cells, 0, 6) + " cells; from " +
                                std::to_string(fewestPatchCells) + " to " + std::to_string(mostPatchCells) +
                                " are possible",
                            {"elastic.cell"}});
    else if (std::abs(side - cells * cell) > 1e-6 * cell)
        problems.push_back(
            {key,
             ofCells + " is not a whole number of cells; the nearest length is " + inMicrometres(cells * cell),
             {"elastic.cell"}});
}

void checkPad(const Case& c, Problems& problems)
{
    checkPatch(c, problems);
    if (c.pad.shape == PadShape::Slider && c.elastic.periodic)
        problems.push_back(
            {"elastic.periodic", "must be false with pad.shape \"slider\", whose pads do not repeat", {"pad.shape"}});
}

/// The cells of the patch must resolve the disk's surface.
void checkSampling(const Case& c, Problems& problems)
{
    const double cell = c.elastic.cell;
    const auto refuse = [&](const std::string& limit, const char* otherKey) {
        problems.push_back({"elastic.cell", inMicrometres(cell) + " must be at most " + limit, {otherKey}});
    };
    if (hasRoughness(c.diskSurface) && cell > c.diskSurface.cell * (1.0 + 1e-9))
        refuse("disk.surface.cell (" + inMicrometres(c.diskSurface.cell) + "), the cell of the surface's map",
               "disk.surface.cell");
    if (!hasWaves(c.diskSurface)) return;
    const double shortest = *std::ranges::min_element(c.diskSurface.waveLengths);
    if (cell > 0.25 * shortest)
        refuse("a quarter of the shortest wave of disk.surface.wave_lengths (" + inMicrometres(shortest) + ")",
               "disk.surface.wave_lengths");
}

/// A periodic half-space is rigid under its mean pressure, so the mean gap must stay open.
void checkPeriodic(const Case& c, Problems& problems)
{
    if (!c.elastic.periodic || c.elastic.hardness > 0.0) return;
    const double mean = c.pad.shape == PadShape::Sphere
                            ? (c.pad.length * c.pad.length + c.pad.width * c.pad.width) / (24.0 * c.pad.radius)
                            : 0.0;
    if (c.approach.closest + mean <= 0.0)
        problems.push_back({"approach.closest",
                            inNanometres(c.approach.closest) + " must be greater than " + inNanometres(0.0 - mean) +
                                " with elastic.periodic: a patch that repeats can be pressed flat, but no further",
                            {"elastic.periodic"}});
}

/// The window keeps the snapshots in memory.
void checkMemory(const Case& c, double values, const std::string& what, Problems& problems)
{
    const double bytes = values * (c.run.fieldSnapshots + 1.0) * sizeof(double);
    if (c.run.fieldSnapshots > 0 && bytes > mostSnapshotBytes)
        problems.push_back({"run.field_snapshots", std::to_string(c.run.fieldSnapshots) + " of " + what + " take " +
                                                       inGigabytes(bytes) + "; at most " +
                                                       inGigabytes(mostSnapshotBytes) + " are possible"});
}

/// Fields of a contact patch: gap and contact pressure, adhesion if it acts, and the disk's surface if it is not flat.
double patchFields(const Case& c)
{
    return 2.0 + (c.adhesion.acts() ? 1.0 : 0.0) + (c.diskSurface.kind != DiskSurfaceKind::Flat ? 1.0 : 0.0);
}

void checkElasticPad(const Case& c, Problems& problems)
{
    const std::size_t before = problems.size();
    checkPad(c, problems);
    checkDiskSurface(c.diskSurface, problems);
    if (problems.size() == before) checkSampling(c, problems);
    // On a flat disk, because the heights of the surface take time to make: the run repeats the check with them.
    if (c.pad.shape == PadShape::Slider && problems.empty())
        if (const std::string problem = patchesOf(c, DiskTopography()).problem; !problem.empty())
            problems.push_back(
                {"initial.pitch", problem + "; tilt the slider more, or take a larger elastic.cell", {"elastic.cell"}});
    checkPeriodic(c, problems);
    if (c.pad.shape == PadShape::Slider) return;
    const double cells = c.pad.length / c.elastic.cell * (c.pad.width / c.elastic.cell);
    checkMemory(c, cells * patchFields(c), inMillions(cells), problems);
}

/// Counts the cells of the patches where a slider on its film can touch; false where they are too many.
bool checkSliderPatches(const Case& c, double& cells, Problems& problems)
{
    const SliderPatches found = filmPatches(c);
    if (!found.problem.empty()) {
        problems.push_back(
            {"elastic.patch_reach",
             found.problem + "; take a smaller reach, another elastic.patch_pitch or a larger elastic.cell",
             {"elastic.patch_pitch", "elastic.cell"}});
        return false;
    }
    cells = static_cast<double>(found.patches.front().grid.cells());
    return true;
}

void checkMenisci(const Case& c, Problems& problems)
{
    if (c.meniscus.breakingLength < c.meniscus.filmThickness)
        problems.push_back({"meniscus.breaking_length",
                            inNanometres(c.meniscus.breakingLength) + " must be at least meniscus.film_thickness (" +
                                inNanometres(c.meniscus.filmThickness) + ")",
                            {"meniscus.film_thickness"}});
}

/// The pad is a part of the slider.
void checkPadUnderSlider(const Case& c, Problems& problems)
{
    const auto check = [&](const std::string& side, double pad, double slider) {
        if (pad > slider)
            problems.push_back({"pad." + side,
                                "must be at most slider." + side + " (" + formatQuantity(slider, "mm") + ")",
                                {"slider." + side}});
    };
    check("length", c.pad.length, c.slider.length);
    check("width", c.pad.width, c.slider.width);
}

} // namespace

void checkPatch(const Case& c, Problems& problems)
{
    if (c.pad.shape == PadShape::Slider) return;
    checkSide("pad.length", c.pad.length, c.elastic.cell, problems);
    checkSide("pad.width", c.pad.width, c.elastic.cell, problems);
}

void checkCharacteristic(const Case& c, Problems& problems)
{
    const auto law = characteristic(c);
    if (law && law->takeOff < law->touchDown)
        problems.push_back({"ono_yamane.take_off",
                            "d_e = " + inNanometres(law->takeOff) +
                                " must be at least ono_yamane.touch_down (d_s = " + inNanometres(law->touchDown) + ")",
                            {"ono_yamane.touch_down"}});
}

void warnOfCreatedEnergy(const OnoYamane& parameters, Problems& warnings)
{
    const double work = OnoYamaneLaw(parameters).cycleWork();
    if (work >= 0.0 || parameters.takeOff <= parameters.touchDown) return;
    warnings.push_back(
        {"ono_yamane.meniscus_force",
         "W = " + fewDigits(work, "pJ", 3) +
             " is negative: each touch-down and take-off gives this energy to the slider, as no real contact does, so "
             "that it can bounce for ever; W is zero at f_m = " +
             fewDigits(meniscusForceForWork(parameters, 0.0), "mN", 6)});
}

void checkContact(const Case& c, Problems& problems)
{
    if (c.approach.closest >= c.approach.start)
        problems.push_back({"approach.closest",
                            inNanometres(c.approach.closest) + " must be less than approach.start (" +
                                inNanometres(c.approach.start) + ")",
                            {"approach.start"}});
    switch (c.contact) {
    case ContactKind::None: break;
    case ContactKind::OnoYamane: checkCharacteristic(c, problems); break;
    case ContactKind::Elastic: checkElasticPad(c, problems); break;
    case ContactKind::Asperity: break;
    case ContactKind::MultiAsperity: checkMenisci(c, problems); break;
    }
}

void checkDiskSurface(const DiskSurface& surface, Problems& problems)
{
    for (const DiskSurfaceProblem& problem : diskSurfaceProblems(surface))
        problems.push_back({"disk.surface." + problem.key, problem.sentence, {"disk.surface"}});
    if (surface.kind == DiskSurfaceKind::Combined && !hasWaves(surface) && !hasRoughness(surface) &&
        !hasFile(surface) && !hasBumps(surface))
        problems.push_back(
            {"disk.surface.kind", "is \"combined\", but no part is given; take \"flat\"", {"disk.surface"}});
}

void checkMovingDisk(const Case& c, Problems& problems)
{
    checkDiskSurface(c.diskSurface, problems);
    if (c.diskSurface.kind != DiskSurfaceKind::Flat && c.diskSurface.motion == SurfaceMotion::Moving &&
        c.disk.speed == 0.0)
        problems.push_back(
            {"disk.surface.motion", "is \"moving\", but disk.speed is 0; take \"still\"", {"disk.speed"}});
}

void checkFilmContact(const Case& c, Problems& problems)
{
    const std::size_t before = problems.size();
    checkMovingDisk(c, problems);
    const double filmCells = (c.film.nodes[0] - 1.0) * (c.film.nodes[1] - 1.0);
    double patchCells = 0.0;
    switch (c.contact) {
    case ContactKind::None: break;
    case ContactKind::OnoYamane: checkCharacteristic(c, problems); break;
    case ContactKind::Elastic:
        if (problems.size() == before) checkSampling(c, problems);
        // The search needs a valid surface.
        if (problems.empty() && !checkSliderPatches(c, patchCells, problems)) return;
        break;
    case ContactKind::Asperity: break;
    case ContactKind::MultiAsperity:
        checkMenisci(c, problems);
        checkPadUnderSlider(c, problems);
        break;
    }
    const double values = mapsOfFilm * filmCells + patchFields(c) * patchCells;
    const std::string patch = patchCells > 0.0 ? " and the patch's " + inMillions(patchCells) : "";
    checkMemory(c, values, "the film's " + inMillions(filmCells) + patch, problems);
}

} // namespace touchdown
