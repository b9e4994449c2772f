// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/slider_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/case/contact_law.h"
#include "core/case/contact_patches.h"
#include "core/physics/disk/surface_statistics.h"
#include "core/simulation/contact/disk_under_film.h"
#include "core/simulation/contact/elastic_slider_contact.h"
#include "core/simulation/contact/gap_contact.h"
#include "core/simulation/contact/pad_contact.h"

namespace touchdown {

std::unique_ptr<SliderContact> makeSliderContact(const Case& c, const MinimumSpacing& spacing,
                                                 const DiskTopography& surface, const CellGrid& grid,
                                                 const PaddedGrid& pad, const std::function<bool()>& goOn)
{
    if (contactLaw(c).recordsSurfaces)
        return std::make_unique<ElasticSliderContact>(c, spacing, surface, grid, pad, goOn);
    if (auto law = makeSeparationLaw(c)) return std::make_unique<PadContact>(c, std::move(law), spacing);
    if (auto law = gapLawOf(c))
        return std::make_unique<GapContact>(c, std::move(*law), spacing, surface, grid, pad, goOn);
    return nullptr;
}

double longestStepOver(const Case& c, const DiskTopography& surface, double shortest, const std::function<bool()>& goOn)
{
    // Displacement of the surface per step over the length in which it changes by its RMS height [-]: pi steps a wave,
    // the fewest with which the error of a step sees the wave.
    constexpr double movedPerStep = 2.0, unbounded = std::numeric_limits<double>::infinity();
    const Velocity velocity = surfaceVelocity(c, surface);
    const double speed = std::hypot(velocity.x, velocity.y);
    if (!(speed > 0.0)) return unbounded;
    const SurfaceStatistics statistics = surfaceStatistics(c.diskSurface, surface, goOn);
    const double slope = std::abs(velocity.x) >= std::abs(velocity.y) ? statistics.slopeX : statistics.slopeY;
    // What changes from cell to cell acts through the mean over many.
    const double length = slope > 0.0 ? std::max(statistics.rms / slope, shortest) : unbounded;
    return movedPerStep * length / speed;
}

RecordedFields sliderContactFields(const Case& c, const std::function<bool()>& goOn)
{
    if (!contactLaw(c).recordsSurfaces || c.run.fieldSnapshots == 0) return {};
    RecordedFields fields = elasticFields(c, filmPatches(c, goOn));
    fields.group = "contact_fields";
    return fields;
}

} // namespace touchdown
