// SPDX-License-Identifier: GPL-3.0-or-later
//
// The film in time, step by step, implicitly: R(p) + d(V p)/dt = 0 with the new attitude's volumes V, and d(V p)/dt by
// backward differences of the contents m = V p (numerics/backward_difference.h): Euler, BDF2, BDF2OPT, or the formula
// that is exact for oscillations at one rate. The first step is Euler's, whose error is small enough for second order.
// Newton's method with the Jacobian J of an earlier step starts from a forecast by the last four contents, a cubic or
// one that is exact at that rate, over the new volumes, as fast motions keep the air in place. The difference of the
// step from a parabola gives the error of its discretisation in time (2/11 of it for BDF2: Milne's device), which sets
// the tolerance of the solution.
//
// A step ends when the estimated remaining error is small enough (Hairer & Wanner 1996, IV.8): the residual of the
// linear system, from the contraction of its iterations, and kappa times the change, kappa = |second change|/|first
// change| of a step, due to the old J. kappa grows about in proportion to J's age; it is measured where a second change
// is needed, and occasionally otherwise. So most steps need one residual.
//
// The linear systems: half a cycle of multigrid for smooth errors, factors along x and y for the rest, which are good
// where storage dominates, as in short steps; full cycles where these contract slowly.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/numerics/backward_difference.h"
#include "core/physics/film/film_newton.h"
#include "core/physics/slider/attitude.h"

namespace touchdown {

using FilmTimeMethod = BackwardRule;

struct FilmStepOptions {
    FilmTimeMethod method = FilmTimeMethod::Fitted;
    // Remaining error of a step, in pressure as root mean square over the cells against ambient [-]: the larger one of
    double tolerance = 1e-9;    // this
    double share = 0.3;         // and this share of the step's error of discretisation in time, up to 1e-3
    int maximumIterations = 12; // of Newton's method
};

struct FilmStepResult {
    bool converged = false;
    int iterations = 0; // of Newton's method
    int linearisations = 0;
    int solves = 0;         // preconditioned iterations
    double error = 0.0;     // remaining, estimated as `tolerance` measures it [-]
    double timeError = 0.0; // of discretisation in time, estimated the same way; in the first steps too small [-]
};

/// A step may be tried with several attitudes and lengths before one is accepted. Allocates at construction alone.
class FilmStepper {
public:
    FilmStepper(GasFilm& film, const FilmStepOptions& options);

    /// Begins at the film's attitude with these pressures (padded).
    void start(std::span<const double> p);
    /// Angular frequency to which the next steps are fitted; zero: none, they are by BDF2OPT [rad/s].
    void setRate(double rate) { rate_ = rate; }
    /// Solves for the pressures `dt` [s] after the last accepted ones, the slider at `attitude`.
    FilmStepResult step(double dt, const Attitude& attitude);
    /// Moves the solution of the last step to a nearby attitude, where the film changes by `change` (padded) [Pa].
    void follow(const Attitude& attitude, std::span<const double> change);
    /// Makes the last step's pressures the start of the next step; false, and nothing done, if it did not converge.
    [[nodiscard]] bool accept();
    /// All that the next step depends on but the disk's surface, written or read.
    void pass(auto& stream)
    {
        for (Past& past : past_) {
            stream.fixed(past.pressure);
            stream.fixed(past.content);
            stream(past.dt);
        }
        stream.fixed(p_);
        stream(rate_, dt_, perTime_, linearisedPerTime_, age_, kappaPerStep_, largestMeasured_, unmeasured_, repeats_,
               timeError_, fresh_, extrapolated_, errorPerChange_, solver_, contraction_, closings_, fitted_,
               converged_);
        stream.fixed(at_.pressure);
        stream.fixed(at_.history);
        stream.fixed(at_.spread);
        stream(at_.surface, at_.attitude);
        stream.require(at_.surface.empty() || at_.surface.size() == p_.size());
        if (stream.reads() && linearisedPerTime_ > 0.0) linearise(at_);
        stream(linear_);
    }

    /// Of the last step; padded [Pa].
    std::span<const double> pressure() const { return p_; }
    /// Whether the last step was exact at the rate of setRate().
    bool isFitted() const { return fitted_; }
    /// How often a cell has closed since the start: its air is lost.
    long long closings() const { return closings_; }
    /// Allowed remaining error of the last step, as `tolerance` measures it [-].
    double allowed() const { return std::max(options_.tolerance, std::min(1e-3, options_.share * timeError_)); }
    /// Load of the last step's estimated error of discretisation in time: force [N], pitch and roll torque about the
    /// slider's centre [N m]; zero as long as there is no parabola.
    std::array<double, 3> timeErrorLoad() const;
    /// Of the film at the last step's attitude and length, with what its cells store.
    FilmLinearSolver& linear() { return linear_; }

private:
    void remember();
    void setHistory(double dt);
    void guess(double dt);
    /// Where the film was linearised: all that its linear systems depend on.
    struct Linearised {
        Attitude attitude;
        std::vector<double> pressure, history, spread; // padded; of GasFilm::spreadAs() [Pa], [Pa m^3/s], [Pa]
        std::vector<double> surface;                   // padded; empty: flat [m]
    };
    void linearise(FilmStepResult& result);
    /// The same again.
    void linearise(const Linearised& at);
    /// change_ = -J^-1 residual_; its residual, estimated as `tolerance` measures it.
    double solveLinear(FilmStepResult& result);
    /// By factors or cycles, with generalised conjugate residuals (Eisenstat, Elman & Schultz 1983) of the
    /// preconditioned residual, which is about the remaining change; none where they contract too slowly.
    std::optional<double> iterate(FilmStepResult& result);
    void setTimeError(const FilmStepResult& result);
    double size(std::span<const double> change) const;

    enum class Solver : std::uint8_t { Factors, Cycles, Krylov };
    struct Past {
        std::vector<double> pressure, content; // [Pa], V p [Pa m^3]
        double dt = 0.0;                       // that led there; zero at the start [s]
    };

    GasFilm& film_;
    FilmStepOptions options_;
    FilmLinearSolver linear_;
    std::array<Past, 4> past_; // from the last accepted one back
    std::vector<double> p_, residual_, right_, change_, rest_, history_;
    mutable std::vector<std::array<double, 2>> rowLoads_; // force, torque [N], [N m]
    std::vector<double> foreseen_;                        // contents by a parabola [Pa m^3]
    Linearised at_;
    std::vector<double> linearisedVolume_; // of the cells at the last linearisation [m^3]
    static constexpr std::size_t mostDirections = 8;
    std::array<std::vector<double>, mostDirections> directions_, images_;
    std::array<double, mostDirections> squares_{}; // of the images
    double rate_ = 0.0;                            // [rad/s]
    double dt_ = 0.0;                              // of the last step [s]
    double perTime_ = 0.0;                         // of V p in the storage [1/s]
    double linearisedPerTime_ = 0.0;               // at the last linearisation; zero: none yet
    int age_ = 0;                                  // of the Jacobian, in steps
    double kappaPerStep_ = 0.0;                    // of age, as last measured [-],
    double largestMeasured_ = 0.0;                 // for first changes up to this [-],
    int unmeasured_ = 0;                           // so many steps ago
    int repeats_ = 0;                              // iterations that a fresher Jacobian would have saved
    double timeError_ = 0.0;                       // of the last step [-]
    bool fresh_ = false;                           // it began with a guess,
    bool extrapolated_ = false;                    // at least a parabola
    double errorPerChange_ = 0.0;                  // of it [-]
    Solver solver_ = Solver::Factors;
    double contraction_ = 0.0; // of its corrections, as far as known [-]
    long long closings_ = 0;
    bool fitted_ = false;    // the last step
    bool converged_ = false; // the last step, and p_ solves it
};

} // namespace touchdown
