// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/contact_patches.h"

#include <algorithm>

#include "core/physics/contact/adhesion.h"

namespace touchdown {

namespace {

/// The attraction falls to about a thousandth of its largest value within so many of its own lengths.
constexpr double adhesionReach = 10.0;

double reachOf(const Case& c, const DiskTopography& surface)
{
    double reach = surface.highest() - c.approach.closest;
    if (c.adhesion.acts()) {
        const AdhesionLaw law(c.adhesion);
        reach += adhesionReach * std::max(c.adhesion.equilibriumDistance, law.peakGap());
    }
    return std::max(reach, 0.0);
}

} // namespace

SliderPatches patchesOf(const Case& c, const DiskTopography& surface)
{
    SliderPatches result;
    switch (c.pad.shape) {
    case PadShape::Flat: result.patches.push_back(flatPatch(c.pad.length, c.pad.width, c.elastic.cell)); break;
    case PadShape::Sphere:
        result.patches.push_back(spherePatch(c.pad.length, c.pad.width, c.elastic.cell, c.pad.radius));
        break;
    case PadShape::Slider:
        result = sliderPatches(c.surface, c.slider.length, c.slider.width, c.initial.pitch, c.initial.roll,
                               c.elastic.cell, reachOf(c, surface), mostPatchCells);
        break;
    }
    return result;
}

SliderPatches filmPatches(const Case& c, const std::function<bool()>& goOn)
{
    return sliderPatches(c.surface, c.slider.length, c.slider.width, c.elastic.patchPitch, 0.0, c.elastic.cell,
                         c.elastic.patchReach, mostPatchCells, goOn);
}

} // namespace touchdown
