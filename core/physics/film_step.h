// SPDX-License-Identifier: GPL-3.0-or-later
//
// The film in time, step by step, implicitly: R(p) + d(V p)/dt = 0 with the new attitude's volumes V and, from the contents
// m = V p of the steps before, with r = dt/(last dt),
//
//   Euler  d(V p)/dt = (V p - m1)/dt                                              first order
//   BDF2   d(V p)/dt = ((1 + 2 r)/(1 + r) V p - (1 + r) m1 + r^2/(1 + r) m2)/dt   second order (Gear 1971; variable steps)
//
// BDF2 begins with a step of Euler, whose error is small enough for second order. Each step is solved by Newton's method from the
// pressures extrapolated in time; the Jacobian of an earlier step serves as long as it converges well.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/physics/film_newton.h"
#include "core/physics/gas_film.h"

namespace touchdown {

enum class FilmTimeMethod : std::uint8_t { Euler, Bdf2 };

struct FilmStepOptions {
    FilmTimeMethod method = FilmTimeMethod::Bdf2;
    double tolerance = 1e-5;    // of the residual: sum of the cells' |R|, against the flow through the film [-]
    int maximumIterations = 12; // of Newton's method
};

struct FilmStepResult {
    bool converged = false;
    int iterations = 0;      // of Newton's method
    int linearisations = 0;
    int solves = 0;          // preconditioned iterations
    double residual = 0.0;   // reached [-]
};

/// A step may be tried with several attitudes and lengths before one is accepted. Allocates at construction alone.
class FilmStepper {
public:
    FilmStepper(GasFilm& film, const FilmStepOptions& options);

    /// Begins at the film's attitude with these pressures (padded).
    void start(std::span<const double> p);
    /// Solves for the pressures `dt` [s] after the last accepted ones, the slider at `attitude`.
    FilmStepResult step(double dt, const Attitude& attitude);
    /// Makes the last step's pressures the ones to go on from.
    void accept();

    /// Of the last step; padded [Pa].
    std::span<const double> pressure() const { return p_; }
    /// Of the film at the last step's attitude and length, with what its cells store.
    FilmLinearSolver& linear() { return linear_; }

private:
    void setHistory(double dt);
    void guess(double dt);
    void linearise(FilmStepResult& result);
    double residualAt(std::span<const double> p);

    struct Past {
        std::vector<double> pressure, content; // [Pa], V p [Pa m^3]
        double dt = 0.0;                       // that led there; zero at the start [s]
    };

    GasFilm& film_;
    FilmStepOptions options_;
    FilmLinearSolver linear_;
    std::array<Past, 2> past_; // the last accepted one and the one before
    std::vector<double> p_, residual_, right_, change_, history_;
    double dt_ = 0.0;              // of the last step [s]
    double perTime_ = 0.0;         // of V p in the storage [1/s]
    double linearisedPerTime_ = 0.0; // at the last linearisation; zero: none yet
    bool tried_ = false;           // p_ solves another try of the same step
};

} // namespace touchdown
