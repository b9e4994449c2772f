// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/elastic_patch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "core/simulation/contact/disk_under_film.h"

namespace touchdown {
namespace {

/// A try so near to the last one starts from it [m].
constexpr double sameState = 1e-12;

/// Above the reach of the patch: a recess beside it, where nothing touches [m].
constexpr double deep = 1e-7;

constexpr double reachOfPull = 10.0; // of an attraction, in its own lengths [-]
constexpr int stepsDown = 20;        // to a state with adhesion

constexpr double looserThanAlone = 1e4; // [-]
constexpr double loosest = 1e-2;        // [-]

bool underFilm(const Case& c) { return c.model != ModelKind::Contact; }

/// A pad's tilt is part of its shape.
ContactPatch shapeOf(const Case& c, ContactPatch patch)
{
    if (underFilm(c)) return patch;
    patch.recess = patch.height;
    patch.recessAt = patch.heightAt;
    return patch;
}

/// Place of the first cell of `part` on `whole`.
std::size_t firstCell(const UniformGrid& whole, const UniformGrid& part)
{
    return whole.at(static_cast<int>(std::lround((part.x0 - whole.x0) / whole.dx)),
                    static_cast<int>(std::lround((part.y0 - whole.y0) / whole.dy)));
}

ElasticContactOptions optionsOf(const Case& c, const std::function<bool()>& goOn)
{
    const double tolerance = c.elastic.tolerance;
    return {.tolerance = underFilm(c) ? std::min(looserThanAlone * tolerance, loosest) : tolerance,
            .maximumIterations = c.elastic.maximumIterations,
            .hardness = c.elastic.hardness,
            .goOn = goOn};
}

std::vector<double> lines(double first, double step, int count)
{
    std::vector<double> result;
    for (int i = 0; i <= count; ++i) result.push_back(first + i * step);
    return result;
}

} // namespace

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

ElasticPatch::ElasticPatch(const Case& c, ContactPatch patch, const DiskTopography& surface,
                           const std::function<bool()>& goOn)
    : whole_(shapeOf(c, std::move(patch))),
      solved_(underFilm(c) ? withoutMargin(whole_, c.elastic.patchReach + deep) : whole_),
      first_(firstCell(whole_.grid, solved_.grid)),
      length_(c.slider.length),
      width_(c.slider.width),
      modulus_(contactModulus(c.elastic.pair)),
      edges_(!underFilm(c) && c.elastic.periodic ? HalfSpaceEdges::Periodic : HalfSpaceEdges::Free),
      adhesion_(c.adhesion),
      options_(optionsOf(c, goOn)),
      topography_(surface),
      velocity_(surfaceVelocity(c, surface)),
      lever_(c),
      contact_(HalfSpace(solved_.grid, modulus_, edges_, goOn), c.adhesion, options_),
      displacement_(whole_.grid.cells(), 0.0),
      surface_(surface.flat() ? 0 : solved_.grid.cells()),
      separation_(solved_.grid.cells()),
      surfaceTime_(std::numeric_limits<double>::quiet_NaN())
{
    if (solved_.grid.cells() < whole_.grid.cells()) space_.emplace(whole_.grid, modulus_, edges_, goOn);
}

double ElasticPatch::clearance(const Attitude& attitude) const
{
    double least = std::numeric_limits<double>::infinity();
    forHeights(attitude, [&](std::size_t, double height) { least = std::min(least, height); });
    return least;
}

/// Calls visit(cell, height over the mean plane) for each.
template <typename Visit>
void ElasticPatch::forHeights(const Attitude& attitude, const Visit& visit) const
{
    std::size_t at = 0;
    for (int j = 0; j < solved_.grid.ny; ++j) {
        const double row = attitude.height - attitude.roll * (solved_.grid.y(j) - 0.5 * width_);
        for (int i = 0; i < solved_.grid.nx; ++i, ++at)
            visit(at, row + attitude.pitch * (length_ - solved_.grid.x(i)) + solved_.recess[at]);
    }
}

void ElasticPatch::setSeparation(const Attitude& attitude, double time)
{
    const bool moves = velocity_.x != 0.0 || velocity_.y != 0.0;
    if (!surface_.empty() && (std::isnan(surfaceTime_) || (moves && time != surfaceTime_))) {
        topography_.heights(solved_.grid, velocity_.x * time, velocity_.y * time, surface_);
        surfaceTime_ = time;
    }
    forHeights(attitude, [&](std::size_t at, double height) {
        separation_[at] = height - (surface_.empty() ? 0.0 : surface_[at]);
    });
}

void ElasticPatch::separationOn(const UniformGrid& grid, std::span<double> separation) const
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

ContactState ElasticPatch::state() const
{
    return {.grid = solved_.grid,
            .modulus = modulus_,
            .edges = edges_,
            .hardness = options_.hardness,
            .pressure = contact_.pressure()};
}

SeparationOn ElasticPatch::separation() const
{
    return [this](const UniformGrid& grid, std::span<double> s) { separationOn(grid, s); };
}

bool ElasticPatch::isCutOff() const { return touchdown::isCutOff(state(), separation()); }

ContactGridError ElasticPatch::gridError(const std::function<bool()>& goOn) const
{
    return contact_.adheres() ? adhesiveError(goOn) : contactGridError(state(), separation(), goOn);
}

// With adhesion a state depends on its history: what a straight way down to it gives on both grids is compared.
ContactGridError ElasticPatch::adhesiveError(const std::function<bool()>& goOn) const
{
    ElasticContactOptions options = options_;
    options.goOn = goOn;
    struct Touching {
        AdhesiveContactSummary summary;
        long long cells = 0;
    };
    const auto comeDown = [&](const UniformGrid& grid) {
        AdhesiveContact contact(HalfSpace(grid, modulus_, edges_, goOn), adhesion_, options);
        std::vector<double> separation(grid.cells()), lifted(grid.cells());
        separationOn(grid, separation);
        const double lift = std::max(-*std::ranges::min_element(separation), 0.0) +
                            reachOfPull * std::max(adhesion_.equilibriumDistance, contact.law().peakGap());
        Touching end;
        end.summary.converged = true;
        for (int step = 1; step <= stepsDown && end.summary.converged; ++step) {
            const double above = lift * (stepsDown - step) / stepsDown;
            std::ranges::transform(separation, lifted.begin(), [&](double s) { return s + above; });
            end.summary = contact.solve(lifted);
        }
        end.cells = std::ranges::count_if(contact.pressure(), [](double p) { return p > 0.0; });
        return end;
    };
    const UniformGrid coarse = coarsened(solved_.grid);
    const auto [own, cells] = comeDown(solved_.grid);
    const auto [other, coarseCells] = comeDown(coarse);
    const double area = static_cast<double>(cells) * solved_.grid.cellArea();
    return {.known = own.converged && other.converged,
            .force = moreThanCoarse *
                     std::max(std::abs(own.load - other.load), std::abs(own.adhesionForce - other.adhesionForce)),
            .area = moreThanCoarse * std::abs(area - static_cast<double>(coarseCells) * coarse.cellArea()),
            .cell = coarse.dx,
            .other = other.load,
            .cells = cells};
}

/// Beyond a circle around a sphere: the integral of f(s) 2 pi r dr, with r dr = R ds.
double ElasticPatch::attractionAround(double radius) const
{
    const UniformGrid& grid = solved_.grid;
    const std::span<const double> gap = contact_.gap();
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < grid.nx; ++i) least = std::min({least, gap[grid.at(i, 0)], gap[grid.at(i, grid.ny - 1)]});
    for (int j = 0; j < grid.ny; ++j) least = std::min({least, gap[grid.at(0, j)], gap[grid.at(grid.nx - 1, j)]});
    return 2.0 * std::numbers::pi * radius * std::max(-contact_.law().energy(least), 0.0);
}

const PatchForces& ElasticPatch::tryAt(const Attitude& attitude, double time)
{
    const double moved = std::abs(attitude.height - attitude_.height) +
                         std::abs(attitude.pitch - attitude_.pitch) * length_ +
                         std::abs(attitude.roll - attitude_.roll) * width_;
    if (!(tried_ && time == time_ && moved < sameState)) contact_.recall();
    return solve(attitude, time);
}

const PatchForces& ElasticPatch::solve(const Attitude& attitude, double time)
{
    setSeparation(attitude, time);
    attitude_ = attitude;
    time_ = time;
    acts_ = true;
    const AdhesiveContactSummary summary = contact_.solve(separation_);
    forces_.iterations = summary.iterations;
    forces_.jumped = summary.jumped;
    forces_.problem = summary.converged ? std::string() : summary.message;
    tried_ = summary.converged;
    sum();
    setDisplacement();
    if (contact_.adheres()) forces_.storedEnergy = contact_.energy();
    return forces_;
}

template <typename Visit>
void ElasticPatch::forSolved(const Visit& visit) const
{
    std::size_t at = 0;
    for (int j = 0; j < solved_.grid.ny; ++j) {
        const std::size_t row = first_ + whole_.grid.at(0, j);
        for (std::size_t i = 0; i < static_cast<std::size_t>(solved_.grid.nx); ++i, ++at) visit(row + i, at);
    }
}

// In the solved cells by their gaps, in the margin by the pressures.
void ElasticPatch::setDisplacement()
{
    const std::span<const double> pressure = contact_.pressure(), adhesion = contact_.adhesion(), gap = contact_.gap();
    if (space_) {
        std::fill(displacement_.begin(), displacement_.end(), 0.0);
        forSolved([&](std::size_t to, std::size_t at) { displacement_[to] = pressure[at] + adhesion[at]; });
        space_->displace(displacement_, displacement_);
    }
    forSolved([&](std::size_t to, std::size_t at) { displacement_[to] = gap[at] - separation_[at]; });
}

// Forces, their rough stiffness, and the elastic energy p u/2.
void ElasticPatch::sum()
{
    const std::span<const double> pressure = contact_.pressure(), adhesion = contact_.adhesion(), gap = contact_.gap();
    const double cell = solved_.grid.cellArea();
    double count = 0.0, peak = 0.0, energy = 0.0;
    Vector3 contact = Vector3::Zero(), attraction = Vector3::Zero();
    std::size_t at = 0;
    for (int j = 0; j < solved_.grid.ny; ++j) {
        double rowContact = 0.0, rowContactPitch = 0.0, rowAdhesion = 0.0, rowAdhesionPitch = 0.0;
        const double roll = lever_.arms(0.0, solved_.grid.y(j))[2];
        for (int i = 0; i < solved_.grid.nx; ++i, ++at) {
            const double pitch = 0.5 * length_ - solved_.grid.x(i);
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
    // Where nothing flows, a gap below zero is what the solver's tolerance left.
    const double least = *std::ranges::min_element(gap);
    forces_.minimumGap = options_.hardness > 0.0 ? least : std::max(least, 0.0);
    forces_.storedEnergy = 0.5 * energy * cell;
    // A punch as large as the contact, 2 E* a, a = sqrt(A/pi) (Johnson 1985, section 3.4), at its centre of pressure.
    forces_.stiffness.setZero();
    if (contact[0] > 0.0) {
        const Vector3 arms{1.0, contact[1] / contact[0], contact[2] / contact[0]};
        const Vector3 perArm = 2.0 * modulus_ * std::sqrt(forces_.area / std::numbers::pi) * arms;
        forces_.stiffness = perArm * arms.transpose();
    }
}

void ElasticPatch::part(const Attitude& attitude, double time)
{
    attitude_ = attitude;
    time_ = time;
    acts_ = tried_ = false;
}

void ElasticPatch::accept()
{
    tried_ = false;
    if (!contact_.adheres() || !(acts_ || remembers_)) return;
    if (!acts_) contact_.reset();
    contact_.remember();
    remembers_ = acts_;
}

std::vector<ElasticPatch::Overlap> ElasticPatch::overlaps(std::span<const double> lines, double first, double cell,
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

void ElasticPatch::overlap(const CellGrid& grid)
{
    const UniformGrid& own = whole_.grid;
    columns_ = overlaps(grid.x, own.x0, own.dx, own.nx);
    rows_ = overlaps(grid.y, own.y0, own.dy, own.ny);
}

void ElasticPatch::deform(const PaddedGrid& pad, std::span<double> height) const
{
    if (!acts_) return;
    for (const Overlap& row : rows_)
        for (const Overlap& column : columns_)
            height[pad.at(column.film, row.film)] -=
                row.share * column.share * displacement_[whole_.grid.at(column.patch, row.patch)];
}

void ElasticPatch::clearTouching(const PaddedGrid& pad, std::span<double> field) const
{
    if (!acts_) return;
    const int x0 = static_cast<int>(first_) % whole_.grid.nx, y0 = static_cast<int>(first_) / whole_.grid.nx;
    const std::span<const double> pressure = contact_.pressure();
    for (const Overlap& row : rows_)
        for (const Overlap& column : columns_) {
            const int i = column.patch - x0, j = row.patch - y0;
            if (i >= 0 && i < solved_.grid.nx && j >= 0 && j < solved_.grid.ny && pressure[solved_.grid.at(i, j)] > 0.0)
                field[pad.at(column.film, row.film)] = 0.0;
        }
}

void ElasticPatch::observe(FieldSnapshot& snapshot) const
{
    const UniformGrid& grid = whole_.grid;
    std::vector<double> gap(grid.cells());
    separationOn(grid, gap);
    const auto add = [&](std::span<const double> field) {
        std::vector<double>& values = snapshot.values.emplace_back(grid.cells(), 0.0);
        if (acts_) forSolved([&](std::size_t to, std::size_t at) { values[to] = field[at]; });
    };
    if (acts_) {
        std::ranges::transform(gap, displacement_, gap.begin(), std::plus());
        forSolved([&](std::size_t to, std::size_t at) { gap[to] = contact_.gap()[at]; });
    }
    snapshot.values.clear();
    snapshot.values.push_back(std::move(gap));
    add(contact_.pressure());
    if (contact_.adheres()) add(contact_.adhesion());
    if (surface_.empty()) return;
    topography_.heights(grid, velocity_.x * time_, velocity_.y * time_, snapshot.values.emplace_back(grid.cells()));
}

} // namespace touchdown
