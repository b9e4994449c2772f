// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of a pad that can touch the disk, and their heights: uniform patches of cells, each one a half-space of
// its own for core/physics/contact/elastic_contact.h.
//
//   flat      a rectangle, height 0
//   sphere    the paraboloid r^2/(2 R) over a rectangle around its lowest point
//   slider    the regions of an air bearing surface at a given pitch and roll that lie within `reach` of its lowest
//             point, h = pitch (L - x) - roll (y - W/2) + recess - the same there. They are found on scan lines, whose
//             pieces between two breaks of the recess are smooth. Regions become boxes; boxes are merged where their
//             distance is less than the length of the smaller one.
//
// Each patch is solved separately: the displacement F/(pi E* r) that the load F on one patch causes at a distance r
// (Boussinesq; Johnson 1985, equation 3.22a) is neglected.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

/// A length at any point of the pad [m].
using LengthAt = std::function<double(double x, double y)>;
/// Height and recess where the pad has ended [m].
inline constexpr double beyondPad = 1.0;

struct ContactPatch {
    UniformGrid grid;           // in the coordinates of pad or slider
    std::vector<double> height; // of the pad above its lowest point, at the cells' centres [m], >= 0
    std::vector<double> recess; // slider: the surface's own, there, at no pitch and roll [m]; else empty
    LengthAt heightAt;          // both at any point, also beside the patch
    LengthAt recessAt;
};

/// Length and width are whole numbers of cells, to rounding. The lowest point of the sphere is at the middle.
ContactPatch flatPatch(double length, double width, double cell);
ContactPatch spherePatch(double length, double width, double cell, double radius);

struct SliderPatches {
    std::vector<ContactPatch> patches; // the first one holds the lowest point
    SurfacePoint lowest;               // [m]
    std::string problem;               // a sentence, when there are too many cells; then no patches
};

/// `surface` is valid, length and width of the slider positive, cell > 0, reach >= 0; at most `mostCells` along or
/// across a patch. `goOn` is asked at each line and row; if it returns false there are no patches.
SliderPatches sliderPatches(const AirBearingSurface& surface, double length, double width, double pitch, double roll,
                            double cell, double reach, int mostCells, const std::function<bool()>& goOn = {});

/// The same patch on half as many cells along and across, one more where that is no whole number; of heights only.
ContactPatch coarsened(const ContactPatch& patch);

/// Without the outer rows and columns that are nowhere as low as `limit` [m]; as it is where no cell is.
ContactPatch withoutMargin(ContactPatch patch, double limit);

/// The shortest distance of two patches' boxes, 0 where they meet [m].
double patchDistance(const UniformGrid& a, const UniformGrid& b);

} // namespace touchdown
