// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/high_disk.h"

#include "core/case/contact_law.h"
#include "core/case/disk_setup.h"
#include "core/formats/units.h"
#include "core/simulation/static_state/disk_on_cells.h"
#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

namespace {

std::string placeOf(const DiskClearance::Place& place)
{
    return "x = " + fewDigits(place.at.x, "mm", 4) + ", y = " + fewDigits(place.at.y, "mm", 4);
}

} // namespace

std::string diskReachesSlider(const Case& c, const DiskClearance::Place& place, double time)
{
    const std::string when = time > 0.0 ? " at " + fewDigitsOfTime(time, 4) : std::string(" at the start");
    const std::string law = c.contact != noContact ? "; contact = \"" + std::string(contactLaw(c).name) +
                                                         "\" acts on the mean plane and does not see it"
                                                   : "; no law of contact acts there (contact = \"none\")";
    const double slider = place.gap + place.diskHeight;
    if (place.diskHeight == 0.0)
        return "the slider reaches the mean plane of the disk" + when + ": at " + placeOf(place) + " it is " +
               fewDigits(-slider, "nm", 3) + " below it" + law;
    return "the disk's surface reaches the slider" + when + ": at " + placeOf(place) + " it is " +
           fewDigits(place.diskHeight, "nm", 4) + " above its mean plane, and the slider " +
           fewDigits(slider, "nm", 4) + law;
}

std::string nearestDisk(const DiskClearance::Place& place)
{
    return "the disk's surface, " + fewDigits(place.diskHeight, "nm", 3) + " above its mean plane at " +
           placeOf(place) + ", is " + fewDigits(place.gap, "nm", 2) + " below the slider";
}

std::string noteOnHighDisk(const Case& c, double minimumSpacing)
{
    const DiskSurface& surface = c.diskSurface;
    if (surface.kind == DiskSurfaceKind::Flat || c.contact != noContact) return {};
    constexpr double peaks = 4.0; // of Gaussian heights on some 10,000 places
    const double highest = surface.kind == DiskSurfaceKind::Rough ? peaks * surface.rms : diskTopography(c).highest();
    if (highest < minimumSpacing) return {};
    return "the state is one above the mean plane of the disk, whose surface rises up to " +
           fewDigits(highest, "nm", 3) + " above it: in time it may reach the slider, and no law of contact acts";
}

DiskAtStart diskAtStart(const Case& c)
{
    DiskAtStart found;
    const DiskTopography disk = diskTopography(c);
    const bool given = c.initial.state == InitialState::Given;
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    const Attitude start{c.initial.nominalTrailingEdgeHeight, c.initial.pitch, c.initial.roll};
    DiskOnCells cells =
        diskOnCells(c, disk, recess, unadaptedGrid(c, {c.film.nodes[0] - 1, c.film.nodes[1] - 1}), start);
    if (!given) cells.hasMap = false; // what matters of a map depends on the gap
    found.warnings = doubtsOnDisk(cells, c.run.steps == StepControl::Fixed ? c.run.step : 0.0);
    if (!given || (c.contact != noContact && (contactLaw(c).seesDisk || disk.flat()))) return found;
    const MinimumSpacing spacing(c.surface, recess);
    const DiskClearance::Place place = DiskClearance(recess, spacing, disk, {}).at(start, 0.0);
    if (place.gap > 0.0) return found;
    if (c.contact == noContact)
        found.problem = diskReachesSlider(c, place, 0.0) + "; start higher";
    else
        found.warnings.push_back(diskReachesSlider(c, place, 0.0));
    return found;
}

} // namespace touchdown
