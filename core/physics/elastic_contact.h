// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frictionless contact of an elastic half-space with a rigid smooth pad on a grid: p >= 0, g >= 0, p g = 0 with the gap
// g = s + u(p), s the separation of the undeformed surfaces. Conjugate gradients of Polonsky & Keer (1999) on FFT
// convolutions (Stanley & Kato 1997; Liu, Wang & Liu 2000). With a hardness H: p <= H, and where p = H the gap may be
// negative: there the softer body has flowed (elastic - perfectly plastic, Almqvist et al. 2007).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/physics/half_space.h"

namespace touchdown {

struct ElasticContactOptions {
    double tolerance = 1e-8;      // of force balance and complementarity, both relative [-]
    int maximumIterations = 2000;
    double hardness = 0.0;        // H [Pa]; 0: none
};

struct ElasticContactSummary {
    bool converged = false;
    int iterations = 0;           // each one convolution; 0 where nothing could touch
    double error = 0.0;           // as the tolerance measures it [-]
    double load = 0.0;            // [N]
    double approach = 0.0;        // load control: what was added to the separation [m]
    std::string message;          // a sentence, when not converged
};

/// Holds the pressure of its last solution, from which the next one starts.
class ElasticContact {
public:
    explicit ElasticContact(HalfSpace space, const ElasticContactOptions& options = {});

    /// At the given separation [m] of the undeformed surfaces, one value for each cell, negative where they overlap.
    /// Costs nothing where no separation is negative. Allocates nothing after the first call.
    ElasticContactSummary solve(std::span<const double> separation);
    /// At a given load [N], > 0: finds the uniform approach by which the separation must change, too.
    ElasticContactSummary solveLoad(std::span<const double> separation, double load);

    std::span<const double> pressure() const { return pressure_; } // [Pa]
    std::span<const double> gap() const { return gap_; }           // of the deformed surfaces [m]
    double contactArea() const;                                     // [m^2]
    HalfSpace& space() { return space_; }
    /// Forgets the last solution: the next starts from nothing.
    void reset();

private:
    HalfSpace space_;
    ElasticContactOptions options_;
    std::vector<double> pressure_, gap_;
};

} // namespace touchdown
