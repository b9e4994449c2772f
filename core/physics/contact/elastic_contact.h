// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frictionless contact of an elastic half-space with a rigid smooth pad on a grid: p >= 0, g >= 0, p g = 0 with the gap
// g = s + u(p), s the separation of the undeformed surfaces. With a hardness H: p <= H, and where p = H the gap may be
// negative: there the softer body has flowed (elastic - perfectly plastic, Almqvist et al. 2007).
//
// The solution has the least energy p.(u/2 + s) of all pressures between the bounds (Kalker 1977). It is found by
// conjugate gradients on FFT convolutions, after Polonsky & Keer (1999; Stanley & Kato 1997), with three changes that
// save most convolutions. Their method changes the cells in contact at each step and needs two convolutions for it.
// Here a few steps are taken on the same cells; then cells whose pressure left the bounds are fixed there and cells
// whose gap has the wrong sign are freed (primal-dual active sets, Hintermueller, Ito & Kunisch 2002). The steps are
// preconditioned (contact_cells.h). If the energy rises often, changes that raise it are cut to the point of least
// energy, or replaced by a short step along the gradient where there is no such point.
//
// Each solution starts from the point of least energy on the line through the last two. The first starts from the
// solution on a grid of cells twice as large, and so on, where the numbers of cells are even and at least sixteen.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/physics/contact/contact_cells.h"
#include "core/physics/contact/half_space.h"

namespace touchdown {

struct ElasticContactOptions {
    /// Without adhesion: the largest wrong gap, |g| under pressure, -g elsewhere, g under the hardness, against the
    /// largest difference of displacements, or a tenth of the highest pressure's displacement of its own cell [-]. With
    /// adhesion: the largest deviation of a pressure from the law against the largest pressure, and of a gap from s + C
    /// (p + f) against the largest displacement.
    double tolerance = 1e-8;
    int maximumIterations = 50000;
    double hardness = 0.0;        // H [Pa]; 0: none
    std::function<bool()> goOn{}; // asked at each step, also on coarser grids; false ends the solution, unconverged
};

struct ElasticContactSummary {
    bool converged = false;
    int iterations = 0;  // each one convolution on the grid itself; 0 where nothing could touch
    double error = 0.0;  // as the tolerance measures it [-]
    double load = 0.0;   // of p, >= 0 [N]
    std::string message; // a sentence, when not converged
};

class ElasticContact {
public:
    explicit ElasticContact(HalfSpace space, const ElasticContactOptions& options = {});

    /// At the given separation [m] of the undeformed surfaces, one value for each cell, negative where they overlap.
    /// Allocates nothing unless it fails. The mean pressure does not displace a periodic half-space: without a hardness
    /// the separation's mean must be positive.
    ElasticContactSummary solve(std::span<const double> separation);

    std::span<const double> pressure() const { return pressure_; } // [Pa]
    std::span<const double> gap() const { return gap_; }           // of the deformed surfaces [m]
    double contactArea() const;                                    // [m^2]
    HalfSpace& space() { return space_; }
    /// Forgets the last solution.
    void reset();
    /// All that the next solution depends on, written or read.
    void pass(auto& stream)
    {
        for (auto* field : {&pressure_, &displacement_, &gap_, &lastPressure_, &lastDisplacement_})
            stream.fixed(*field);
        stream(displacementHolds_, solved_, carried_, bounded_);
    }

private:
    ElasticContactSummary refuse(std::string message);
    ElasticContactSummary iterate(std::span<const double> separation);
    void start(std::span<const double> separation);
    void startFromCoarser(std::span<const double> separation);
    void extrapolate(std::span<const double> separation, bool follows);
    void measure(std::span<const double> separation, ElasticContactSummary& summary);
    bool step(int mostIterations);
    bool project();
    void descend();
    void displace();
    double largestPressure() const;

    HalfSpace space_;
    ElasticContactOptions options_;
    ContactCells cells_; // whose pressure is sought
    std::vector<double> pressure_, displacement_, gap_;
    std::vector<double> lastPressure_, lastDisplacement_; // of the solution before the last
    std::vector<double> pressureBefore_, displacementBefore_;
    std::vector<double> residual_, change_, direction_, image_; // of conjugate gradients
    bool displacementHolds_ = true;                             // displacement_ is of pressure_
    int solved_ = 0;                                            // solutions behind this one, at most two count
    int carried_ = 0;     // solutions since both displacements were those of their pressures but for rounding
    bool bounded_ = true; // pressure_ is within its bounds
    std::unique_ptr<ElasticContact> coarser_; // of half the cells along each side, where there are many
    std::vector<double> coarseSeparation_;
    double wrongGap_ = 0.0; // that the tolerance allows [m]
    int iterations_ = 0, rises_ = 0;
    bool stopped_ = false;
};

} // namespace touchdown
