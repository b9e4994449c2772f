// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_newton.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/gas_film.h"
#include "core/work/block_sums.h"

namespace touchdown {

double residualNorm(const GasFilm& film, std::span<const double> residual)
{
    const double sum = sumOfBlocks(residual.size(), [&](std::size_t first, std::size_t count) {
        return sumInLanes(count, [&](std::size_t k) { return std::abs(residual[first + k]); });
    });
    return sum / film.flowScale();
}

FilmLinearSolver::FilmLinearSolver(const GasFilm& film)
    : film_(film),
      stencil_(film.pad()),
      multigrid_(film.pad()),
      gmres_(film.pad().size()),
      diagonal_(film.pad().size(), 0.0)
{
    work_.resize(film.pad().size());
    for (auto* pair : {&effective_, &convection_})
        for (auto& field : *pair) field.assign(film.pad().size(), 0.0);
}

void FilmLinearSolver::prepare(double shift)
{
    shift_ = shift;
    inBlocks(diagonal_.size(), [&](std::size_t first, std::size_t count) {
        for (std::size_t at = first; at < first + count; ++at)
            diagonal_[at] = (shift + film_.storagePerTime()) * film_.volumes()[at];
    });
    const auto& faces = film_.faces();
    film_.setStencil(stencil_);
    hasNine_ = false;
    const std::array<FaceOperator, 2> flows{FaceOperator{faces[0].diffusion, faces[0].effective, faces[0].convection},
                                            FaceOperator{faces[1].diffusion, faces[1].effective, faces[1].convection}};
    perTime_ = film_.storagePerTime();
    if (perTime_ == 0.0) {
        multigrid_.setOperator(flows, diagonal_);
        return;
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
        stencil_.addStored(axis, perTime_, film_.volumes(), {faces[axis].effective, faces[axis].convection},
                           effective_[axis], convection_[axis]);
    const std::array<FaceOperator, 2> all{FaceOperator{faces[0].diffusion, effective_[0], convection_[0]},
                                          FaceOperator{faces[1].diffusion, effective_[1], convection_[1]}};
    multigrid_.setOperator(all, diagonal_);
    multigrid_.setFactors(all, flows, diagonal_);
}

void FilmLinearSolver::setNinePoints(bool transposed) { setNinePoints(transposed, film_.volumes()); }

void FilmLinearSolver::setNinePoints(bool transposed, std::span<const double> volumes)
{
    if (hasNine_ || !film_.isComplete()) return;
    hasNine_ = true;
    if (perTime_ == 0.0) {
        multigrid_.setFinest(stencil_.points(), diagonal_, transposed);
        return;
    }
    assert(shift_ == 0.0);
    stencil_.setStorage(volumes);
    if (nineVolumes_.data() != volumes.data()) nineVolumes_.assign(volumes.begin(), volumes.end());
    multigrid_.setFinest(stencil_.points(), {}, transposed, stencil_.storagePoints(), perTime_);
}

void FilmLinearSolver::reserve()
{
    stencil_.reserve();
    multigrid_.reserve();
    nineVolumes_.reserve(film_.pad().size());
}

void FilmLinearSolver::apply(std::span<const double> v, std::span<double> out)
{
    stencil_.apply(v, film_.storagePerTime(), film_.volumes(), out);
    addShift(v, out);
}

void FilmLinearSolver::addShift(std::span<const double> v, std::span<double> out) const
{
    if (shift_ == 0.0) return;
    inBlocks(v.size(), [&](std::size_t first, std::size_t count) {
        for (std::size_t at = first; at < first + count; ++at) out[at] += shift_ * film_.volumes()[at] * v[at];
    });
}

GmresResult FilmLinearSolver::solve(std::span<const double> b, std::span<double> x, const GmresOptions& options)
{
    setNinePoints(false);
    const auto apply = [this](std::span<const double> v, std::span<double> out) {
        film_.applyJacobian(v, out, work_);
        addShift(v, out);
    };
    const auto precondition = [this](std::span<const double> v, std::span<double> out) {
        multigrid_.precondition(v, out);
    };
    return gmres_.solve(apply, precondition, b, x, options);
}

void FilmLinearSolver::prepareTransposed()
{
    const PaddedGrid& pad = film_.pad();
    const auto& faces = film_.faces();
    const std::vector<double>&x = faces[0].convection, &y = faces[1].convection;
    std::fill(diagonal_.begin(), diagonal_.end(), 0.0);
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            diagonal_[at] =
                (x[at + 1] - x[at]) + (y[at + pad.stride()] - y[at]) + film_.storagePerTime() * film_.volumes()[at];
        }
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (std::size_t at = 0; at < pad.size(); ++at) convection_[axis][at] = -faces[axis].convection[at];
    multigrid_.setOperator({FaceOperator{faces[0].diffusion, faces[0].effective, convection_[0]},
                            FaceOperator{faces[1].diffusion, faces[1].effective, convection_[1]}},
                           diagonal_);
    hasNine_ = false;
    perTime_ = film_.storagePerTime();
    shift_ = 0.0;
    film_.setStencil(stencil_);
    std::fill(diagonal_.begin(), diagonal_.end(), 0.0);
    setNinePoints(true);
}

GmresResult FilmLinearSolver::solveTransposed(std::span<const double> b, std::span<double> x,
                                              const GmresOptions& options)
{
    const auto apply = [this](std::span<const double> v, std::span<double> out) {
        film_.applyTransposedJacobian(v, out, work_);
    };
    const auto precondition = [this](std::span<const double> v, std::span<double> out) {
        multigrid_.precondition(v, out);
    };
    return gmres_.solve(apply, precondition, b, x, options);
}

FilmNewton::FilmNewton(GasFilm& film)
    : film_(film),
      linear_(film),
      residual_(film.pad().size()),
      step_(film.pad().size()),
      right_(film.pad().size()),
      best_(film.pad().size())
{}

FilmSolution FilmNewton::solve(std::span<double> p, const FilmOptions& options, const FilmMonitor& monitor)
{
    FilmSolution result;
    film_.linearise(p, residual_);
    result.residual = residualNorm(film_, residual_);
    // A pseudo time step of the time the disk takes to pass the slider, when one is needed.
    const double passage = film_.passage();
    double shift = 0.0;
    int accepted = 0, slow = 0;
    std::copy(p.begin(), p.end(), best_.begin());
    const auto goOn = [&] {
        result.cancelled = monitor && !monitor(result.iterations, result.residual);
        return !result.cancelled;
    };
    while (true) {
        if (!goOn()) return result;
        result.converged = result.residual <= options.tolerance;
        if (result.converged || result.iterations >= options.maximumIterations) return result;

        linear_.prepare(shift);
        for (std::size_t at = 0; at < right_.size(); ++at) right_[at] = -residual_[at];
        std::fill(step_.begin(), step_.end(), 0.0);
        // By the convergence of Newton's method (Eisenstat & Walker 1996), and no more exact than the tolerance.
        const double deserved = std::clamp(0.1 * std::sqrt(result.residual), 1e-4, 0.03);
        const double forcing = std::max(deserved, std::min(0.1, 0.3 * options.tolerance / result.residual));
        const GmresResult linear =
            linear_.solve(right_, step_, {.tolerance = forcing, .maximumIterations = 60, .goOn = goOn});
        if (result.cancelled) return result;
        result.solves += linear.iterations;
        addBounded(p, step_);
        film_.linearise(p, residual_);
        const double residual = residualNorm(film_, residual_);
        ++result.iterations;
        // The first steps may make the sum of residuals larger while the pressure finds its shape.
        const bool acceptable =
            std::isfinite(residual) && residual < (accepted < 3 && shift == 0.0 ? 20.0 : 1.5) * result.residual;
        if (acceptable) {
            ++accepted;
            // Three steps that hardly help: let the film settle for a few passages of the disk.
            slow = shift == 0.0 && residual > 0.7 * result.residual ? slow + 1 : 0;
            shift *= std::clamp(residual / result.residual, 0.1, 0.5);
            if (shift < 0.01 * passage) shift = 0.0;
            if (slow >= 3) {
                shift = 10.0 * passage;
                slow = 0;
            }
            result.residual = residual;
            std::copy(p.begin(), p.end(), best_.begin());
        } else {
            shift = shift == 0.0 ? 10.0 * passage : 8.0 * shift;
            std::copy(best_.begin(), best_.end(), p.begin());
            film_.linearise(p, residual_);
        }
    }
}

} // namespace touchdown
