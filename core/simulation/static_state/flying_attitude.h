// SPDX-License-Identifier: GPL-3.0-or-later
//
// The attitude at which film and suspension balance, on one grid. Unknowns are the film's pressure p and the attitude
// a:
//
//   R(p, a) = 0                                        the film
//   G(p, a) = load and shear of the film - suspension = 0   force [N], pitch and roll torque about the centre [N m]
//
// Newton's step of both uses the film's linear systems only: with J X = dR/da and J x = -R, (dG/da - dG/dp X) da = -(G
// + dG/dp x), dp = x - X da. The same matrix is the film's stiffness; its transpose with three adjoint films gives the
// sensitivities to any parameter.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/physics/film/film_faces.h"
#include "core/physics/film/film_loads.h"
#include "core/physics/film/film_newton.h"
#include "core/simulation/static_state/search_watch.h"
#include "core/simulation/static_state/slider_body.h"

namespace touchdown {

class MinimumSpacing;
struct FilmSlopes;

struct AttitudeOptions {
    double filmTolerance = 1e-7; // FilmCase::tolerance [-]
    double loadTolerance = 1e-6; // SteadyCase::loadTolerance [-]
    int maximumIterations = 60;
    int patience = 100;      // attitudes without a smaller load error before the search is given up
    bool throughDisk = true; // whether the search may pass through attitudes with rails inside the disk
};

struct AttitudeSolution {
    bool converged = false, cancelled = false;
    int iterations = 0, solves = 0;
    double residual = 0.0, loadError = 0.0; // [-]
    Vector3 imbalance = Vector3::Zero();    // G [N], [N m]
    /// Why the search was given up. Pressure and attitude are then those of the last sane state, if there is one.
    NoBalance why = NoBalance::None;
    bool sane = false;           // given up: there is a last sane state
    double leastSaneError = 1.0; // given up: the least load error of all sane states [-]
};

/// Called at each iteration and within it: number, film's residual, load error, attitude. Return false to stop.
using AttitudeMonitor = std::function<bool(int, double, double, const Attitude&)>;

class FlyingAttitude {
public:
    /// All must last; the loads are those of the film.
    FlyingAttitude(GasFilm& film, FilmLoads& loads, const SliderLoad& load, const MinimumSpacing& spacing);

    /// Its films of a change of attitude are the guess for those of the next stiffness, on the same grid.
    void startFrom(const FlyingAttitude& other) { responses_ = other.responses_; }

    /// Solves the film at the film's attitude; by Newton's method unless another way is set.
    using FilmSolve = std::function<FilmSolution(std::span<double>, const FilmOptions&, const FilmMonitor&)>;
    void setFilmSolve(FilmSolve solve) { solveFilm_ = std::move(solve); }
    FilmSolution solveFilm(std::span<double> p, const FilmOptions& options, const FilmMonitor& monitor = {})
    {
        return solveFilm_ ? solveFilm_(p, options, monitor) : newton_.solve(p, options, monitor);
    }

    /// From now on these are the film's slopes, at its present attitude; null: its own. They must last.
    void setSlopes(const FilmSlopes* slopes) { slopes_ = slopes; }

    /// From far: the film is solved at each attitude, which follows the forces until Newton's method converges.
    AttitudeSolution approach(std::span<double> p, Attitude& attitude, const AttitudeOptions& options,
                              const AttitudeMonitor& monitor = {});
    /// From near: Newton on film and attitude together; then `approach` if that does not converge.
    AttitudeSolution solve(std::span<double> p, Attitude& attitude, const AttitudeOptions& options,
                           const AttitudeMonitor& monitor = {});

    /// -d(load)/da with the film following, load = force, pitch and roll torque of the pressure alone, at the solution;
    /// rows by load, columns by attitude [N/m, N/rad; N m/m, N m/rad]. Solves three films to 1e-7.
    Matrix3 stiffness(std::span<const double> p);
    /// The same within some per cent, at the p and attitude of the last search: from the three films of its last steps,
    /// or solved where it took none.
    Matrix3 roughStiffness(std::span<const double> p);
    /// The stiffness with the torques of the shear, as in the balance; where `goOn` returns false the result is
    /// invalid.
    Matrix3 balanceStiffness(std::span<const double> p, const std::function<bool()>& goOn = {})
    {
        solveColumnsAt(p, 1e-7, goOn);
        return currentStiffness(load_.shearArm);
    }

    /// d(attitude)/d(parameter) = -(adjoint . dR/dparameter + balance . dG/dparameter), prepared once.
    struct Adjoint {
        std::array<std::vector<double>, 3> film; // padded
        Matrix3 balance = Matrix3::Zero();
    };
    /// `added`: stiffness of what else acts on the slider, by the attitude.
    Adjoint adjoint(std::span<const double> p, const Matrix3& added = Matrix3::Zero());

    /// G at p and the film's attitude.
    Vector3 imbalance(std::span<const double> p);
    double loadError(const Vector3& imbalance) const;
    /// What forces are compared with: the preload, or where there is none 1/1000 of ambient pressure times area [N].
    double loadScale() const;

private:
    /// Linearises everything at p; returns the film's residual norm.
    double linearise(std::span<const double> p, const Attitude& attitude);
    void solveColumns(double tolerance, AttitudeSolution& count, const std::function<bool()>& goOn = {});
    Matrix3 balanceSlopes() const;
    void solveColumnsAt(std::span<const double> p, double tolerance, const std::function<bool()>& goOn = {});
    /// From the last linearisation and the last columns.
    Matrix3 currentStiffness(double shearArm) const;
    Vector3 attitudeStep(const Vector3& right, double leading) const;
    double stepShare(const Attitude& attitude, const Vector3& step) const;
    /// Of recess 0, the highest above the disk's mean plane [m].
    double highestCorner(const Attitude& attitude) const;
    AttitudeSolution giveUp(NoBalance why, const SearchWatch& watch, std::span<double> p, Attitude& attitude,
                            AttitudeSolution result);
    Vector3 imbalanceOf(const std::array<double, 5>& forces, const Attitude& attitude) const;
    Vector3 balanceProduct(std::span<const double> v) const;
    void step(std::span<double> p, Attitude& attitude, const Vector3& change, double share,
              std::span<const double> filmStep) const;

    GasFilm& film_;
    FilmLoads& loads_;
    SliderLoad load_;
    const MinimumSpacing& spacing_;
    FilmNewton newton_;
    FilmSolve solveFilm_;
    FilmLoads::Derivatives forces_;
    AttitudeWork attitudeWork_;
    std::array<std::vector<double>, 3> columns_, responses_, balanceRows_;
    std::vector<double> residual_, right_, filmStep_, best_;
    const FilmSlopes* slopes_ = nullptr;
    Vector3 imbalance_ = Vector3::Zero();
    bool hasResponses_ = false;
};

} // namespace touchdown
