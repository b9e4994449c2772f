// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's method for the steady film at a fixed attitude, with the exact Jacobian: generalised minimal residuals,
// preconditioned by multigrid. Where a step raises the residual, the film is advanced in time instead (pseudo-transient
// continuation, Kelley & Keyes 1998): a film at a fixed attitude always becomes steady.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/numerics/gmres.h"
#include "core/numerics/multigrid.h"
#include "core/physics/film/film_stencil.h"

namespace touchdown {

class GasFilm;

struct FilmOptions {
    double tolerance = 1e-7; // of the residual: sum of the cells' |R|, against the flow through the film [-]
    int maximumIterations = 60;
};

struct FilmSolution {
    bool converged = false;
    bool cancelled = false;
    int iterations = 0;    // Newton steps, or multigrid cycles
    int solves = 0;        // preconditioned iterations
    double residual = 0.0; // reached [-]
};

/// Called at each iteration and within its linear solution: number, residual. Return false to stop.
using FilmMonitor = std::function<bool(int, double)>;

/// The linear systems of one film: multigrid and Krylov vectors, allocated once.
class FilmLinearSolver {
public:
    explicit FilmLinearSolver(const GasFilm& film);

    /// Takes the film's linearisation, plus `shift` times the cells' volumes on the diagonal [1/s].
    void prepare(double shift = 0.0);
    /// out = J v to single precision (film_stencil.h), with the film's present storage; padded, zero rings.
    void apply(std::span<const double> v, std::span<double> out);
    /// Allocates what films in time need; else the first calls do.
    void reserve();
    /// v = approximately J^-1 b, padded: by factors along x and y; by these and coarser grids, both of a film in time;
    /// by a full cycle.
    void relax(std::span<const double> b, std::span<double> v) { multigrid_.solveFactors(b, v); }
    void halfCycle(std::span<const double> b, std::span<double> v) { multigrid_.halfCycle(b, v); }
    void cycle(std::span<const double> b, std::span<double> v)
    {
        setNinePoints(false);
        multigrid_.precondition(b, v);
    }
    /// x = J^-1 b from the guess x; padded.
    GmresResult solve(std::span<const double> b, std::span<double> x, const GmresOptions& options);

    /// What was made since prepare(), in a film in time, written or read after the same prepare().
    void pass(auto& stream)
    {
        bool hasNine = hasNine_;
        stream(hasNine, nineVolumes_);
        if (!stream.reads() || !hasNine) return;
        stream.require(nineVolumes_.size() == diagonal_.size());
        setNinePoints(false, nineVolumes_);
    }

    /// The same for J^T x = b. Its monotone part is convection the other way, with its divergence on the diagonal.
    void prepareTransposed();
    GmresResult solveTransposed(std::span<const double> b, std::span<double> x, const GmresOptions& options);

private:
    /// Makes full cycles end with all nine points, where they are needed.
    void setNinePoints(bool transposed);
    void setNinePoints(bool transposed, std::span<const double> volumes);
    void addShift(std::span<const double> v, std::span<double> out) const;

    const GasFilm& film_;
    FilmStencil stencil_;
    Multigrid<double> multigrid_;
    Gmres<double> gmres_;
    FaceFlows<double> work_;
    std::vector<double> diagonal_;
    std::array<std::vector<double>, 2> effective_, convection_; // what multigrid takes
    double shift_ = 0.0;
    double perTime_ = 0.0; // of the storage, when the linearisation was taken [1/s]
    bool hasNine_ = false;
    std::vector<double> nineVolumes_; // with which they were made, in a film in time [m^3]
};

class FilmNewton {
public:
    explicit FilmNewton(GasFilm& film);

    /// Solves R(p) = 0 from the guess p (padded). Ends with the film linearised at p.
    FilmSolution solve(std::span<double> p, const FilmOptions& options, const FilmMonitor& monitor = {});

    FilmLinearSolver& linear() { return linear_; }
    const std::vector<double>& residual() const { return residual_; }

private:
    GasFilm& film_;
    FilmLinearSolver linear_;
    std::vector<double> residual_, step_, right_, best_;
};

/// Sum of |R| over the cells, against the flow through the film [-].
double residualNorm(const GasFilm& film, std::span<const double> residual);
/// p += step, each pressure at most tripled or cut to a third, so that none is lost below zero.
void addBounded(std::span<double> p, std::span<const double> step);

} // namespace touchdown
