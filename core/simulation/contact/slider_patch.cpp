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

/// Above the reach of the patch: a recess beside it, where nothing touches [m].
constexpr double deep = 1e-7;

constexpr double reachOfPull = 10.0;   // of an attraction, in its own lengths [-]
constexpr double moreThanCoarse = 1.5; // of a difference: the error shrinks as cell^0.74 or faster
constexpr int stepsDown = 20;          // to a state with adhesion

constexpr double looserThanAlone = 1e4; // [-]
constexpr double loosest = 1e-2;        // [-]

ContactPatch inner(const Case& c, const ContactPatch& whole)
{
    return withoutMargin(whole, c.elastic.patchReach + deep);
}

/// Place of the first cell of `part` on `whole`.
std::size_t firstCell(const UniformGrid& whole, const UniformGrid& part)
{
    return whole.at(static_cast<int>(std::lround((part.x0 - whole.x0) / whole.dx)),
                    static_cast<int>(std::lround((part.y0 - whole.y0) / whole.dy)));
}

AdhesiveContactOptions optionsOf(const Case& c, const std::function<bool()>& goOn)
{
    return {.tolerance = std::min(looserThanAlone * c.elastic.tolerance, loosest),
            .maximumIterations = c.elastic.maximumIterations,
            .hardness = c.elastic.hardness,
            .goOn = goOn};
}

} // namespace

SliderPatch::SliderPatch(const Case& c, ContactPatch patch, const DiskTopography& surface, Velocity velocity,
                         const std::function<bool()>& goOn)
    : whole_(std::move(patch)),
      grid_(inner(c, whole_).grid),
      first_(firstCell(whole_.grid, grid_)),
      recess_(inner(c, whole_).recess),
      length_(c.slider.length),
      width_(c.slider.width),
      modulus_(contactModulus(c.elastic.pair)),
      adhesion_(c.adhesion),
      options_(optionsOf(c, goOn)),
      topography_(surface),
      velocity_(velocity),
      lever_(c),
      contact_(HalfSpace(grid_, modulus_, HalfSpaceEdges::Free, goOn), c.adhesion, options_),
      space_(whole_.grid, modulus_, HalfSpaceEdges::Free, goOn),
      displacement_(whole_.grid.cells(), 0.0),
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

void SliderPatch::separationOn(const UniformGrid& grid, std::span<double> separation) const
{
    topography_.heights(grid, velocity_.x * time_, velocity_.y * time_, separation);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const double x = grid.x(i), y = grid.y(j);
            double& at = separation[grid.at(i, j)];
            at = attitude_.height + attitude_.pitch * (length_ - x) - attitude_.roll * (y - 0.5 * width_) +
                 whole_.recessAt(x, y) - at;
        }
}

void SliderPatch::addDoubts(ContactDoubts& doubts, const std::function<bool()>& goOn) const
{
    const SeparationOn separation = [this](const UniformGrid& grid, std::span<double> s) { separationOn(grid, s); };
    const ContactState state{
        .grid = grid_, .modulus = modulus_, .hardness = options_.hardness, .pressure = contact_.pressure()};
    doubts.cutOff = doubts.cutOff || isCutOff(state, separation);
    doubts.add(contact_.adheres() ? adhesiveError(goOn) : contactGridError(state, separation, goOn));
}

// With adhesion a state depends on its history: what a straight way down to it gives on both grids is compared.
ContactGridError SliderPatch::adhesiveError(const std::function<bool()>& goOn) const
{
    struct Sums {
        double contact = 0.0, adhesion = 0.0, area = 0.0;
        long long cells = 0;
        bool converged = true;
    };
    AdhesiveContactOptions options = options_;
    options.goOn = goOn;
    const auto comeDown = [&](const UniformGrid& grid) {
        AdhesiveContact contact(HalfSpace(grid, modulus_, HalfSpaceEdges::Free, goOn), adhesion_, options);
        std::vector<double> separation(grid.cells()), lifted(grid.cells());
        separationOn(grid, separation);
        const double lift = std::max(-*std::ranges::min_element(separation), 0.0) +
                            reachOfPull * std::max(adhesion_.equilibriumDistance, contact.law().peakGap());
        Sums sums;
        for (int step = 1; step <= stepsDown && sums.converged; ++step) {
            const double above = lift * (stepsDown - step) / stepsDown;
            std::ranges::transform(separation, lifted.begin(), [&](double s) { return s + above; });
            sums.converged = contact.solve(lifted).converged;
        }
        for (const double p : contact.pressure())
            if (p > 0.0) {
                sums.contact += p * grid.cellArea();
                sums.area += grid.cellArea();
                ++sums.cells;
            }
        for (const double f : contact.adhesion()) sums.adhesion += f * grid.cellArea();
        return sums;
    };
    const UniformGrid coarse = coarsened(grid_);
    const Sums own = comeDown(grid_), other = comeDown(coarse);
    return {.known = own.converged && other.converged,
            .force = moreThanCoarse *
                     std::max(std::abs(own.contact - other.contact), std::abs(own.adhesion - other.adhesion)),
            .area = moreThanCoarse * std::abs(own.area - other.area),
            .cell = coarse.dx,
            .other = other.contact,
            .cells = own.cells};
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
    setDisplacement();
    if (contact_.adheres()) forces_.storedEnergy = contact_.energy();
    return forces_;
}

template <typename Visit>
void SliderPatch::forSolved(const Visit& visit) const
{
    std::size_t at = 0;
    for (int j = 0; j < grid_.ny; ++j) {
        const std::size_t row = first_ + whole_.grid.at(0, j);
        for (std::size_t i = 0; i < static_cast<std::size_t>(grid_.nx); ++i, ++at) visit(row + i, at);
    }
}

// In the solved cells by their gaps, in the margin by the pressures.
void SliderPatch::setDisplacement()
{
    const std::span<const double> pressure = contact_.pressure(), adhesion = contact_.adhesion(), gap = contact_.gap();
    if (grid_.cells() < whole_.grid.cells()) {
        std::fill(displacement_.begin(), displacement_.end(), 0.0);
        forSolved([&](std::size_t to, std::size_t at) { displacement_[to] = pressure[at] + adhesion[at]; });
        space_.displace(displacement_, displacement_);
    }
    forSolved([&](std::size_t to, std::size_t at) { displacement_[to] = gap[at] - separation_[at]; });
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
    const UniformGrid& own = whole_.grid;
    columns_ = overlaps(grid.x, own.x0, own.dx, own.nx);
    rows_ = overlaps(grid.y, own.y0, own.dy, own.ny);
}

void SliderPatch::deform(const PaddedGrid& pad, std::span<double> height) const
{
    if (!acts_) return;
    for (const Overlap& row : rows_)
        for (const Overlap& column : columns_)
            height[pad.at(column.film, row.film)] -=
                row.share * column.share * displacement_[whole_.grid.at(column.patch, row.patch)];
}

void SliderPatch::clearTouching(const PaddedGrid& pad, std::span<double> field) const
{
    if (!acts_) return;
    const int x0 = static_cast<int>(first_) % whole_.grid.nx, y0 = static_cast<int>(first_) / whole_.grid.nx;
    const std::span<const double> pressure = contact_.pressure();
    for (const Overlap& row : rows_)
        for (const Overlap& column : columns_) {
            const int i = column.patch - x0, j = row.patch - y0;
            if (i >= 0 && i < grid_.nx && j >= 0 && j < grid_.ny && pressure[grid_.at(i, j)] > 0.0)
                field[pad.at(column.film, row.film)] = 0.0;
        }
}

void SliderPatch::observe(FieldSnapshot& snapshot) const
{
    const UniformGrid& grid = whole_.grid;
    std::vector<double> surface(grid.cells(), 0.0), gap(grid.cells());
    topography_.heights(grid, velocity_.x * time_, velocity_.y * time_, surface);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const std::size_t at = grid.at(i, j);
            gap[at] = attitude_.height + attitude_.pitch * (length_ - grid.x(i)) -
                      attitude_.roll * (grid.y(j) - 0.5 * width_) + whole_.recess[at] - surface[at] +
                      (acts_ ? displacement_[at] : 0.0);
        }
    const auto add = [&](std::span<const double> field) {
        std::vector<double>& values = snapshot.values.emplace_back(grid.cells(), 0.0);
        if (acts_) forSolved([&](std::size_t to, std::size_t at) { values[to] = field[at]; });
    };
    if (acts_) forSolved([&](std::size_t to, std::size_t at) { gap[to] = contact_.gap()[at]; });
    snapshot.values.clear();
    snapshot.values.push_back(std::move(gap));
    add(contact_.pressure());
    if (contact_.adheres()) add(contact_.adhesion());
    if (!surface_.empty()) snapshot.values.push_back(std::move(surface));
}

} // namespace touchdown
