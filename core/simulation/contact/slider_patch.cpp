// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/slider_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace touchdown {
namespace {

/// A try so near to the last one starts from it [m].
constexpr double sameState = 1e-12;

constexpr double looserThanAlone = 1e4; // [-]
constexpr double loosest = 1e-2;        // [-]

AdhesiveContact contactOf(const Case& c, const UniformGrid& grid, const std::function<bool()>& goOn)
{
    return AdhesiveContact(HalfSpace(grid, contactModulus(c.elastic.pair), HalfSpaceEdges::Free, goOn), c.adhesion,
                           {.tolerance = std::min(looserThanAlone * c.elastic.tolerance, loosest),
                            .maximumIterations = c.elastic.maximumIterations,
                            .hardness = c.elastic.hardness,
                            .goOn = goOn});
}

} // namespace

SliderPatch::SliderPatch(const Case& c, ContactPatch patch, const DiskTopography& surface, Velocity velocity,
                         const std::function<bool()>& goOn)
    : grid_(patch.grid),
      recess_(std::move(patch.recess)),
      length_(c.slider.length),
      width_(c.slider.width),
      modulus_(contactModulus(c.elastic.pair)),
      topography_(surface),
      velocity_(velocity),
      lever_(c),
      contact_(contactOf(c, grid_, goOn)),
      surface_(surface.flat() ? 0 : grid_.cells()),
      separation_(grid_.cells()),
      surfaceTime_(std::numeric_limits<double>::quiet_NaN())
{}

double SliderPatch::clearance(const Attitude& attitude) const
{
    double least = std::numeric_limits<double>::infinity();
    forHeights(attitude, [&](std::size_t, double height) { least = std::min(least, height); });
    return least;
}

/// Calls visit(cell, height over the mean plane) for each.
template <typename Visit>
void SliderPatch::forHeights(const Attitude& attitude, const Visit& visit) const
{
    std::size_t at = 0;
    for (int j = 0; j < grid_.ny; ++j) {
        const double row = attitude.height - attitude.roll * (grid_.y(j) - 0.5 * width_);
        for (int i = 0; i < grid_.nx; ++i, ++at) visit(at, row + attitude.pitch * (length_ - grid_.x(i)) + recess_[at]);
    }
}

void SliderPatch::setSeparation(const Attitude& attitude, double time)
{
    const bool moves = velocity_.x != 0.0 || velocity_.y != 0.0;
    if (!surface_.empty() && (std::isnan(surfaceTime_) || (moves && time != surfaceTime_))) {
        topography_.heights(grid_, velocity_.x * time, velocity_.y * time, surface_);
        surfaceTime_ = time;
    }
    forHeights(attitude, [&](std::size_t at, double height) {
        separation_[at] = height - (surface_.empty() ? 0.0 : surface_[at]);
    });
}

const PatchForces& SliderPatch::solve(const Attitude& attitude, double time)
{
    const double moved = std::abs(attitude.height - attitude_.height) +
                         std::abs(attitude.pitch - attitude_.pitch) * length_ +
                         std::abs(attitude.roll - attitude_.roll) * width_;
    const bool goesOn = tried_ && time == time_ && moved < sameState;
    setSeparation(attitude, time);
    attitude_ = attitude;
    time_ = time;
    acts_ = true;
    if (!goesOn) contact_.recall();
    const AdhesiveContactSummary summary = contact_.solve(separation_);
    forces_.iterations = summary.iterations;
    forces_.problem = summary.converged ? std::string() : summary.message;
    tried_ = summary.converged;
    sum();
    if (contact_.adheres()) forces_.storedEnergy = contact_.energy();
    return forces_;
}

// Forces, their rough stiffness, and the elastic energy p u/2.
void SliderPatch::sum()
{
    const std::span<const double> pressure = contact_.pressure(), adhesion = contact_.adhesion(), gap = contact_.gap();
    const double cell = grid_.cellArea();
    double count = 0.0, peak = 0.0, energy = 0.0;
    Vector3 contact = Vector3::Zero(), attraction = Vector3::Zero();
    std::size_t at = 0;
    for (int j = 0; j < grid_.ny; ++j) {
        double rowContact = 0.0, rowContactPitch = 0.0, rowAdhesion = 0.0, rowAdhesionPitch = 0.0;
        const double roll = lever_.arms(0.0, grid_.y(j))[2];
        for (int i = 0; i < grid_.nx; ++i, ++at) {
            const double pitch = 0.5 * length_ - grid_.x(i);
            if (const double p = pressure[at]; p > 0.0) {
                rowContact += p;
                rowContactPitch += pitch * p;
                count += 1.0;
                peak = std::max(peak, p);
                energy += p * (gap[at] - separation_[at]);
            }
            rowAdhesion += adhesion[at];
            rowAdhesionPitch += pitch * adhesion[at];
        }
        contact += Vector3(rowContact, rowContactPitch, roll * rowContact);
        attraction += Vector3(rowAdhesion, rowAdhesionPitch, roll * rowAdhesion);
    }
    forces_.contact = contact * cell;
    forces_.adhesion = attraction * cell;
    forces_.area = count * cell;
    forces_.peakPressure = peak;
    forces_.storedEnergy = 0.5 * energy * cell;
    // A punch as large as the contact, 2 E* a, a = sqrt(A/pi) (Johnson 1985, section 3.4), at its centre of pressure.
    forces_.stiffness.setZero();
    if (contact[0] > 0.0) {
        const Vector3 arms{1.0, contact[1] / contact[0], contact[2] / contact[0]};
        const Vector3 perArm = 2.0 * modulus_ * std::sqrt(forces_.area / std::numbers::pi) * arms;
        forces_.stiffness = perArm * arms.transpose();
    }
}

void SliderPatch::part(const Attitude& attitude, double time)
{
    attitude_ = attitude;
    time_ = time;
    acts_ = tried_ = false;
}

void SliderPatch::accept()
{
    tried_ = false;
    if (!contact_.adheres() || !(acts_ || remembers_)) return;
    if (!acts_) contact_.reset();
    contact_.remember();
    remembers_ = acts_;
}

std::vector<SliderPatch::Overlap> SliderPatch::overlaps(std::span<const double> lines, double first, double cell,
                                                        int count)
{
    std::vector<Overlap> list;
    for (int k = 0; k < count; ++k)
        for (std::size_t film = 0; film + 1 < lines.size(); ++film) {
            const double common =
                std::min(lines[film + 1], first + (k + 1) * cell) - std::max(lines[film], first + k * cell);
            if (common > 0.0) list.push_back({static_cast<int>(film), k, common / (lines[film + 1] - lines[film])});
        }
    return list;
}

void SliderPatch::overlap(const CellGrid& grid)
{
    columns_ = overlaps(grid.x, grid_.x0, grid_.dx, grid_.nx);
    rows_ = overlaps(grid.y, grid_.y0, grid_.dy, grid_.ny);
}

void SliderPatch::deform(const PaddedGrid& pad, std::span<double> height) const
{
    if (!acts_) return;
    const std::span<const double> gap = contact_.gap();
    for (const Overlap& row : rows_)
        for (const Overlap& column : columns_) {
            const std::size_t at = grid_.at(column.patch, row.patch);
            height[pad.at(column.film, row.film)] -= row.share * column.share * (gap[at] - separation_[at]);
        }
}

void SliderPatch::observe(FieldSnapshot& snapshot) const
{
    const std::size_t cells = grid_.cells();
    snapshot.values.clear();
    const auto add = [&](std::span<const double> field) { snapshot.values.emplace_back(field.begin(), field.end()); };
    const auto addNothing = [&] { snapshot.values.emplace_back(cells, 0.0); };
    if (acts_) {
        add(contact_.gap());
        add(contact_.pressure());
        if (contact_.adheres()) add(contact_.adhesion());
        if (!surface_.empty()) add(surface_);
        return;
    }
    std::vector<double> surface(cells, 0.0), gap(cells);
    topography_.heights(grid_, velocity_.x * time_, velocity_.y * time_, surface);
    forHeights(attitude_, [&](std::size_t at, double height) { gap[at] = height - surface[at]; });
    add(gap);
    addNothing();
    if (contact_.adheres()) addNothing();
    if (!surface_.empty()) add(surface);
}

} // namespace touchdown
