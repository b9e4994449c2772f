// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/elastic_contact.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/numerics/vector_clones.h"
#include "core/physics/contact/contact_message.h"

namespace touchdown {
namespace {

constexpr int fewestCells = 16; // along a side of a grid that has a coarser one
constexpr double coarseTolerance = 1e-2;
constexpr int mostCoarseIterations = 30;
constexpr int mostCarried = 32; // solutions whose displacement comes from the one before

/// What a field's gap and error take over all cells; by eight cells side by side, whatever the width of vectors.
struct Extremes {
    double lowest = INFINITY, highest = -INFINITY; // displacement [m]
    double peak = 0.0;                             // pressure [Pa]
    double all = 0.0;                              // finite if all numbers are
};

TOUCHDOWN_VECTOR_CLONES Extremes setGaps(std::size_t cells, const double* s, const double* u, const double* p,
                                         double* gap)
{
    constexpr std::size_t lanes = 8;
    double lowest[lanes], highest[lanes], peak[lanes] = {}, all[lanes] = {};
    std::fill_n(lowest, lanes, INFINITY);
    std::fill_n(highest, lanes, -INFINITY);
    const auto visit = [&](std::size_t at, std::size_t k) {
        gap[at] = s[at] + u[at];
        lowest[k] = u[at] < lowest[k] ? u[at] : lowest[k];
        highest[k] = u[at] > highest[k] ? u[at] : highest[k];
        peak[k] = p[at] > peak[k] ? p[at] : peak[k];
        all[k] += gap[at] + p[at];
    };
    std::size_t at = 0;
    for (; at + lanes <= cells; at += lanes)
#pragma GCC ivdep
        for (std::size_t k = 0; k < lanes; ++k) visit(at + k, k);
    for (std::size_t k = 0; at + k < cells; ++k) visit(at + k, k);
    Extremes extremes;
    for (std::size_t k = 0; k < lanes; ++k) {
        extremes.lowest = std::min(extremes.lowest, lowest[k]);
        extremes.highest = std::max(extremes.highest, highest[k]);
        extremes.peak = std::max(extremes.peak, peak[k]);
        extremes.all += all[k];
    }
    return extremes;
}

} // namespace

ElasticContact::ElasticContact(HalfSpace space, const ElasticContactOptions& options)
    : space_(std::move(space)), options_(options), cells_(space_)
{
    const std::size_t cells = space_.grid().cells();
    for (auto* field : {&pressure_, &displacement_, &gap_, &lastPressure_, &lastDisplacement_, &pressureBefore_,
                        &displacementBefore_, &change_, &direction_, &image_})
        field->assign(cells, 0.0);
    residual_.assign(cells + 2 * cells_.margin(), 0.0);
    const UniformGrid& grid = space_.grid();
    if (grid.nx % 2 != 0 || grid.ny % 2 != 0 || std::min(grid.nx, grid.ny) < fewestCells) return;
    const UniformGrid coarse{grid.nx / 2, grid.ny / 2, 2.0 * grid.dx, 2.0 * grid.dy, grid.x0, grid.y0};
    coarser_ = std::make_unique<ElasticContact>(
        HalfSpace(coarse, space_.modulus(), space_.edges(), options.goOn),
        ElasticContactOptions{coarseTolerance, mostCoarseIterations, options.hardness, options.goOn});
    coarseSeparation_.assign(coarse.cells(), 0.0);
}

void ElasticContact::reset()
{
    std::fill(pressure_.begin(), pressure_.end(), 0.0);
    std::fill(displacement_.begin(), displacement_.end(), 0.0);
    displacementHolds_ = true;
    solved_ = 0;
    carried_ = 0;
}

double ElasticContact::contactArea() const
{
    const auto cells = std::count_if(pressure_.begin(), pressure_.end(), [](double p) { return p > 0.0; });
    return static_cast<double>(cells) * space_.grid().cellArea();
}

double ElasticContact::largestPressure() const { return options_.hardness > 0.0 ? options_.hardness : INFINITY; }

ElasticContactSummary ElasticContact::refuse(std::string message)
{
    reset();
    std::fill(gap_.begin(), gap_.end(), 0.0);
    ElasticContactSummary summary;
    summary.message = std::move(message);
    return summary;
}

ElasticContactSummary ElasticContact::solve(std::span<const double> separation)
{
    assert(separation.size() == pressure_.size());
    double least = INFINITY;
    double mean = 0.0;
    for (const double s : separation) {
        least = std::min(least, s);
        mean += s;
    }
    mean /= static_cast<double>(separation.size());
    if (!std::isfinite(mean)) return refuse("The separation of the surfaces is not a finite number everywhere.");
    if (least >= 0.0) {
        reset();
        std::copy(separation.begin(), separation.end(), gap_.begin());
        ElasticContactSummary summary;
        summary.converged = true;
        return summary;
    }
    if (space_.edges() == HalfSpaceEdges::Periodic && options_.hardness <= 0.0 && mean <= 0.0)
        return refuse(overlapMessage(-mean));
    return iterate(separation);
}

ElasticContactSummary ElasticContact::iterate(std::span<const double> separation)
{
    iterations_ = 0;
    rises_ = 0;
    stopped_ = false;
    ElasticContactSummary summary;
    start(separation);
    measure(separation, summary);
    if (summary.error > options_.tolerance) extrapolate(separation, solved_ > 1);
    solved_ = std::min(solved_ + 1, 2);
    for (;;) {
        measure(separation, summary);
        summary.iterations = iterations_;
        summary.converged = summary.error <= options_.tolerance;
        const bool ends = stopped_ || iterations_ >= options_.maximumIterations;
        if (summary.converged || (bounded_ && ends) || !std::isfinite(summary.error)) break;
        pressureBefore_ = pressure_;
        displacementBefore_ = displacement_;
        if (!step(options_.maximumIterations - iterations_)) summary.error = INFINITY;
        if (!std::isfinite(summary.error)) break;
        if (project()) {
            displace();
            descend();
        }
    }
    if (!std::isfinite(summary.error))
        return refuse("The numbers of the contact are too large or too small to compute with.");
    summary.load = std::accumulate(pressure_.begin(), pressure_.end(), 0.0) * space_.grid().cellArea();
    if (stopped_ && !summary.converged)
        summary.message = "The contact was stopped before it converged.";
    else if (!summary.converged)
        summary.message = sentence("The contact did not converge in %d iterations: the error is %.2g, %.2g was asked.",
                                   iterations_, summary.error, options_.tolerance);
    return summary;
}

void ElasticContact::displace()
{
    space_.displace(pressure_, displacement_);
    displacementHolds_ = true;
    ++iterations_;
}

// From the last pressure.
void ElasticContact::start(std::span<const double> separation)
{
    if (solved_ == 0 && coarser_) startFromCoarser(separation);
    // Steps add to the displacement, and the extrapolation lets its rounding grow from solution to solution.
    if (++carried_ > mostCarried) {
        space_.displace(lastPressure_, lastDisplacement_);
        ++iterations_;
        displacementHolds_ = false;
        carried_ = 0;
    }
    if (!displacementHolds_) displace();
}

void ElasticContact::startFromCoarser(std::span<const double> separation)
{
    const auto nx = static_cast<std::size_t>(space_.grid().nx);
    const std::size_t coarseX = nx / 2;
    for (std::size_t c = 0; c < coarseSeparation_.size(); ++c) {
        const double* corner = separation.data() + 2 * (c / coarseX * nx + c % coarseX);
        coarseSeparation_[c] = 0.25 * ((corner[0] + corner[1]) + (corner[nx] + corner[nx + 1]));
    }
    coarser_->reset();
    coarser_->iterate(coarseSeparation_);
    for (std::size_t i = 0; i < pressure_.size(); ++i)
        pressure_[i] = coarser_->pressure_[i / nx / 2 * coarseX + i % nx / 2];
    displacementHolds_ = false;
}

// Sets the gap, its error, and the cells whose pressure is to change.
void ElasticContact::measure(std::span<const double> separation, ElasticContactSummary& summary)
{
    const double hardness = largestPressure();
    const std::size_t cells = pressure_.size();
    const Extremes extremes = setGaps(cells, separation.data(), displacement_.data(), pressure_.data(), gap_.data());
    double worst = 0.0;
    bounded_ = true;
    cells_.clear();
    for (std::size_t i = 0; i < cells; ++i) {
        const double p = pressure_[i];
        if ((p == 0.0 && gap_[i] >= 0.0) || (p == hardness && gap_[i] <= 0.0)) continue;
        bounded_ = bounded_ && p >= 0.0 && p <= hardness;
        worst = std::max(worst, std::abs(gap_[i]));
        cells_.add(i);
    }
    // Where the displacement is nearly uniform, as under a uniform periodic pressure, a cell's own is the scale.
    const double scale = std::max(extremes.highest - extremes.lowest, 0.1 * extremes.peak * space_.ownCompliance());
    summary.error = !bounded_ ? 1.0 : worst == 0.0 ? 0.0 : scale > 0.0 ? worst / scale : 1.0;
    if (!std::isfinite(extremes.all + scale)) summary.error = INFINITY;
    // Before anything is displaced, what is to come is of the size of the overlap.
    wrongGap_ = options_.tolerance * std::max(scale, worst);
}

} // namespace touchdown
