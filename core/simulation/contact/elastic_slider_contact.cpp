// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/elastic_slider_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/case/contact_patches.h"
#include "core/formats/units.h"
#include "core/simulation/contact/elastic_pad.h"

namespace touchdown {
namespace {

/// Adhesion that is neglected where it counts as out of reach, as a share of the preload [-].
constexpr double leastPull = 1e-5;
/// Nothing reaches farther [m].
constexpr double farthestAway = 1e-6;

/// The gap at which the attraction is below a pressure [m].
double reachOf(const AdhesionLaw& law, double pressure)
{
    double near = law.peakGap(), far = farthestAway;
    if (-law.pressure(near) <= pressure) return near;
    if (-law.pressure(far) > pressure) return far;
    while (far - near > 1e-3 * far) {
        const double middle = 0.5 * (near + far);
        (-law.pressure(middle) > pressure ? near : far) = middle;
    }
    return far;
}

} // namespace

ElasticSliderContact::ElasticSliderContact(const Case& c, const MinimumSpacing& spacing, const DiskTopography& surface,
                                           const CellGrid& grid, const PaddedGrid& pad,
                                           const std::function<bool()>& goOn)
    : case_(c), spacing_(spacing), surface_(surface), pad_(pad), highest_(surface.highest()), lever_(c)
{
    longestStep_ = longestStepOver(c, surface, c.elastic.cell, goOn);
    for (ContactPatch& patch : filmPatches(c, goOn).patches) {
        if (goOn && !goOn()) return;
        const double area = static_cast<double>(patch.grid.cells()) * patch.grid.cellArea();
        double reach = highest_;
        if (c.adhesion.acts())
            reach += reachOf(AdhesionLaw(c.adhesion), leastPull * std::abs(c.suspension.preload) / area);
        parts_.push_back({ElasticPatch(c, std::move(patch), surface, goOn), reach});
        parts_.back().patch.overlap(grid);
    }
}

const SliderContactForces& ElasticSliderContact::at(const Attitude& attitude, double time)
{
    forces_ = {};
    stiffness_.setZero();
    for (Part& part : parts_) {
        part.near = part.patch.clearance(attitude) <= part.reach;
        if (!part.near) {
            part.patch.part(attitude, time);
            continue;
        }
        const PatchForces& patch = part.patch.tryAt(attitude, time);
        forces_.contact += patch.contact[0];
        forces_.adhesion += patch.adhesion[0];
        forces_.pitchTorque += patch.contact[1] + patch.adhesion[1];
        forces_.rollTorque += patch.contact[2] + patch.adhesion[2];
        const UniformGrid& grid = part.patch.grid();
        const ContactLever::Rubbing rubbing =
            lever_.rubbing(grid.x0 + 0.5 * grid.nx * grid.dx, grid.y0 + 0.5 * grid.ny * grid.dy);
        forces_.friction += rubbing.force * patch.contact[0];
        forces_.pitchTorque += rubbing.pitchTorque * patch.contact[0];
        forces_.rollTorque += rubbing.rollTorque * patch.contact[0];
        forces_.area += patch.area;
        forces_.peakPressure = std::max(forces_.peakPressure, patch.peakPressure);
        forces_.storedEnergy += patch.storedEnergy;
        forces_.iterations += patch.iterations;
        if (forces_.problem.empty()) forces_.problem = patch.problem;
        stiffness_ += patch.stiffness;
    }
    last_ = {attitude, time, forces_.contact};
    return forces_;
}

bool ElasticSliderContact::outOfReach(const Attitude& attitude) const
{
    return std::ranges::none_of(parts_, [&](const Part& part) { return part.patch.clearance(attitude) <= part.reach; });
}

double ElasticSliderContact::reach() const
{
    double reach = highest_;
    for (const Part& part : parts_) reach = std::max(reach, part.reach);
    return reach;
}

/// Out of a contact: from pressedBy deeper.
void ElasticSliderContact::begin(ContactBranch branch, const Attitude& attitude)
{
    for (Part& part : parts_) {
        part.patch.part(attitude, 0.0);
        part.patch.accept();
    }
    if (branch == ContactBranch::TouchDown || !case_.adhesion.acts()) return;
    constexpr double pressedBy = 1e-9; // [m]
    Attitude deeper = attitude;
    for (int step = 4; step >= 0; --step) {
        deeper.height = attitude.height - pressedBy * step / 4;
        at(deeper, 0.0);
        for (Part& part : parts_) part.patch.accept();
    }
}

void ElasticSliderContact::accept()
{
    for (Part& part : parts_) part.patch.accept();
    if (last_.contact > hardest_.contact) hardest_ = last_;
}

SliderContact::Doubts ElasticSliderContact::doubts(const std::function<bool()>& goOn)
{
    Doubts doubts;
    if (!(hardest_.contact > 0.0)) return doubts;
    const SliderContactForces& forces = at(hardest_.attitude, hardest_.time);
    doubts.contact = forces.contact;
    doubts.adhesion = forces.adhesion;
    if (!parts_.empty()) doubts.of.belowCell = losesFeatures(case_, surface_, parts_.front().patch.grid());
    for (const Part& part : parts_) {
        if (!part.near) continue;
        doubts.of.cutOff = doubts.of.cutOff || part.patch.isCutOff();
        doubts.of.add(part.patch.gridError(goOn));
    }
    return doubts;
}

bool ElasticSliderContact::deform(std::span<double> height) const
{
    bool any = false;
    for (const Part& part : parts_) {
        if (part.near) part.patch.deform(pad_, height);
        any = any || part.near;
    }
    return any;
}

void ElasticSliderContact::clearTouching(std::span<double> field) const
{
    for (const Part& part : parts_)
        if (part.near) part.patch.clearTouching(pad_, field);
}

void ElasticSliderContact::observe(FieldSnapshot& snapshot) const
{
    snapshot.values.clear();
    if (!parts_.empty()) parts_.front().patch.observe(snapshot);
}

std::vector<std::string> ElasticSliderContact::remarks() const
{
    std::vector<UniformGrid> grids;
    for (const Part& part : parts_) grids.push_back(part.patch.grid());
    return elasticRemarks(case_, grids, surface_);
}

std::string ElasticSliderContact::problemAt(const Attitude& attitude) const
{
    const MinimumSpacing::Place place = spacing_.at(attitude);
    if (place.spacing >= highest_) return {};
    const double cell = case_.elastic.cell; // by which a patch may miss the slider's own edge
    for (const Part& part : parts_) {
        const UniformGrid& grid = part.patch.grid();
        if (place.at.x >= grid.x0 - cell && place.at.x <= grid.x0 + grid.nx * grid.dx + cell &&
            place.at.y >= grid.y0 - cell && place.at.y <= grid.y0 + grid.ny * grid.dy + cell)
            return {};
    }
    const auto micrometres = [](double length) { return formatQuantity(std::round(length * 1e7) / 1e7, "um"); };
    return "The slider came down to " + formatQuantity(std::round(place.spacing * 1e12) / 1e12, "nm") +
           " over the disk's mean plane at x = " + micrometres(place.at.x) + ", y = " + micrometres(place.at.y) +
           ", where no contact is modelled: give elastic.patch_pitch the pitch at which it touches, or take a greater "
           "elastic.patch_reach";
}

} // namespace touchdown
