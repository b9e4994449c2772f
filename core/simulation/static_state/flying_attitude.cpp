// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/flying_attitude.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "core/physics/film/film_slopes.h"
#include "core/physics/film/gas_film.h"
#include "core/physics/slider/minimum_spacing.h"

namespace touchdown {

namespace {

Attitude changed(const Attitude& attitude, const Vector3& change, double share)
{
    return {attitude.height + share * change[0], attitude.pitch + share * change[1], attitude.roll + share * change[2]};
}

/// Asks the monitor whether to continue; after it returned false it is not asked again. The arguments must last.
auto asking(const AttitudeMonitor& monitor, const Attitude& attitude, AttitudeSolution& result)
{
    return [&monitor, &attitude, &result] {
        result.cancelled =
            result.cancelled || (monitor && !monitor(result.iterations, result.residual, result.loadError, attitude));
        return !result.cancelled;
    };
}

/// Stiffness of a roll that is held; any value holds it exactly [N m/rad].
constexpr double holding = 1.0;

} // namespace

FlyingAttitude::FlyingAttitude(GasFilm& film, FilmLoads& loads, const SliderLoad& load, const MinimumSpacing& spacing)
    : film_(film),
      loads_(loads),
      load_(load),
      spacing_(spacing),
      newton_(film),
      attitudeWork_(film.gaps()),
      residual_(film.pad().size()),
      right_(film.pad().size()),
      filmStep_(film.pad().size()),
      best_(film.pad().size())
{
    for (std::size_t k = 0; k < 3; ++k) {
        responses_[k].assign(film.pad().size(), 0.0);
        balanceRows_[k].assign(film.pad().size(), 0.0);
    }
}

Vector3 FlyingAttitude::imbalanceOf(const std::array<double, 5>& forces, const Attitude& attitude) const
{
    // Shear acts below the pivot: towards the trailing edge it presses the nose down, towards the outer the inner edge.
    return {forces[0] - load_.preload,
            forces[1] + load_.pitchTorque - load_.pitchStiffness * (attitude.pitch - load_.staticPitch) -
                load_.shearArm * forces[3],
            load_.holdsRoll ? -holding * (attitude.roll - load_.heldRoll)
                            : forces[2] + load_.rollTorque - load_.rollStiffness * (attitude.roll - load_.staticRoll) -
                                  load_.shearArm * forces[4]};
}

Vector3 FlyingAttitude::imbalance(std::span<const double> p)
{
    const std::array<double, 3> load = loads_.load(p);
    const std::array<double, 2> shear = loads_.shear(p);
    return imbalanceOf({load[0], load[1], load[2], shear[0], shear[1]}, film_.attitude());
}

double FlyingAttitude::loadError(const Vector3& g) const
{
    const double length = film_.gaps().length;
    return (std::abs(g[0]) + (std::abs(g[1]) + std::abs(g[2])) / length) / loadScale();
}

double FlyingAttitude::loadScale() const
{
    if (load_.preload > 0.0) return load_.preload;
    return 1e-3 * film_.ambient() * film_.gaps().length * film_.gaps().width;
}

double FlyingAttitude::linearise(std::span<const double> p, const Attitude& attitude)
{
    film_.setAttitude(attitude);
    film_.linearise(p, residual_);
    loads_.derivatives(p, forces_);
    if (slopes_) {
        columns_ = slopes_->flow;
        forces_.byAttitude = slopes_->forces;
    } else {
        film_.attitudeColumns(p, columns_, attitudeWork_);
    }
    imbalance_ = imbalanceOf(forces_.value, attitude);
    for (std::size_t k = 0; k < 3; ++k) {
        balanceRows_[k] = forces_.byPressure[k];
        if (k == 0) continue;
        for (std::size_t at = 0; at < balanceRows_[k].size(); ++at)
            balanceRows_[k][at] -= load_.shearArm * forces_.byPressure[k + 2][at];
    }
    if (load_.holdsRoll) std::fill(balanceRows_[2].begin(), balanceRows_[2].end(), 0.0);
    newton_.linear().prepare();
    return residualNorm(film_, residual_);
}

Vector3 FlyingAttitude::balanceProduct(std::span<const double> v) const
{
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t at = 0; at < v.size(); ++at) sum[k] += balanceRows_[k][at] * v[at];
    return sum;
}

void FlyingAttitude::solveColumns(double tolerance, AttitudeSolution& count, const std::function<bool()>& goOn)
{
    hasResponses_ = true;
    for (std::size_t k = 0; k < 3 && !count.cancelled; ++k)
        count.solves +=
            newton_.linear()
                .solve(columns_[k], responses_[k], {.tolerance = tolerance, .maximumIterations = 80, .goOn = goOn})
                .iterations;
}

/// dG/da with the film following.
Matrix3 FlyingAttitude::balanceSlopes() const
{
    Matrix3 slopes = Matrix3::Zero();
    for (std::size_t m = 0; m < 3; ++m) {
        const Vector3 film = balanceProduct(responses_[m]);
        for (std::size_t k = 0; k < 3; ++k) {
            slopes(k, m) = forces_.byAttitude[k][m] - film[k];
            if (k > 0) slopes(k, m) -= load_.shearArm * forces_.byAttitude[k + 2][m];
        }
    }
    slopes(1, 1) -= load_.pitchStiffness;
    slopes(2, 2) -= load_.rollStiffness;
    if (load_.holdsRoll) slopes.row(2) << 0.0, 0.0, -holding;
    return slopes;
}

/// Solves (-dG/da + leading S) da = right, S a stiffness of the slider's size: with a large share the attitude follows
/// the forces, as a slider without inertia would, and so comes to a stable equilibrium.
Vector3 FlyingAttitude::attitudeStep(const Vector3& right, double leading) const
{
    const double length = film_.gaps().length, width = film_.gaps().width;
    Matrix3 matrix = -balanceSlopes();
    // Over which the film's force changes [m]: that of a flying slider, or half of what lies below.
    const double scaleHeight = std::max(10e-9, 0.5 * spacing_.at(film_.attitude()).spacing);
    const double stiffness = leading * loadScale() / scaleHeight;
    matrix(0, 0) += stiffness;
    matrix(1, 1) += stiffness * length * length / 12.0;
    matrix(2, 2) += stiffness * width * width / 12.0;
    // Rows and columns in lengths of the slider, so that the elimination weighs like with like.
    const Vector3 scale(1.0, 1.0 / length, 1.0 / width);
    return scale.asDiagonal() *
           solveFullPivoting(scale.asDiagonal() * matrix * scale.asDiagonal(), scale.asDiagonal() * right);
}

/// Share of a step that changes the gap at no corner by more than half and keeps a third of the minimum spacing.
double FlyingAttitude::stepShare(const Attitude& attitude, const Vector3& change) const
{
    const double length = film_.gaps().length, width = film_.gaps().width;
    constexpr double least = 20e-9; // [m]
    double share = 1.0;
    for (const double x : {0.0, length})
        for (const double y : {0.0, width}) {
            const double gap = film_.gaps().lift(attitude, x, y);
            const double rise = change[0] + change[1] * (length - x) - change[2] * (y - 0.5 * width);
            share = std::min(share, 0.5 * (std::max(gap, 0.0) + least) / std::max(std::abs(rise), 1e-300));
        }
    const double spacing = spacing_.at(attitude).spacing;
    if (spacing > 0.0)
        for (int k = 0; k < 40 && spacing_.at(changed(attitude, change, share)).spacing < spacing / 3.0; ++k)
            share *= 0.7;
    return share;
}

void FlyingAttitude::step(std::span<double> p, Attitude& attitude, const Vector3& change, double share,
                          std::span<const double> filmStep) const
{
    std::vector<double> total(filmStep.begin(), filmStep.end());
    for (std::size_t at = 0; at < total.size(); ++at) {
        for (std::size_t k = 0; k < 3; ++k) total[at] -= responses_[k][at] * change[k];
        total[at] *= share;
    }
    addBounded(p, total);
    attitude = changed(attitude, change, share);
}

double FlyingAttitude::highestCorner(const Attitude& attitude) const
{
    const FilmGaps& gaps = film_.gaps();
    double highest = gaps.lift(attitude, 0.0, 0.0);
    for (const double x : {0.0, gaps.length})
        for (const double y : {0.0, gaps.width}) highest = std::max(highest, gaps.lift(attitude, x, y));
    return highest;
}

AttitudeSolution FlyingAttitude::giveUp(NoBalance why, const SearchWatch& watch, std::span<double> p,
                                        Attitude& attitude, AttitudeSolution result)
{
    result.why = why;
    result.leastSaneError = watch.leastSaneError();
    if (const auto& sane = watch.lastSane()) {
        result.sane = true;
        attitude = sane->attitude;
        result.residual = sane->state.residual;
        result.loadError = sane->state.loadError;
        std::copy(watch.sanePressure().begin(), watch.sanePressure().end(), p.begin());
        film_.setAttitude(attitude);
        result.imbalance = imbalance(p);
    }
    return result;
}

AttitudeSolution FlyingAttitude::approach(std::span<double> p, Attitude& attitude, const AttitudeOptions& options,
                                          const AttitudeMonitor& monitor)
{
    AttitudeSolution result;
    hasResponses_ = false;
    std::fill(filmStep_.begin(), filmStep_.end(), 0.0);
    // Rails that dip into the disk are lifted out of it first: there is no balance of film alone down there.
    constexpr double clear = 5e-9; // [m]
    attitude.height += std::max(0.0, clear - spacing_.at(attitude).spacing);
    double leading = 1.0, best = 0.0;
    SearchWatch watch(highestCorner(attitude), options.patience, options.throughDisk);
    Attitude from = attitude;
    bool again = false;
    const auto goOn = asking(monitor, attitude, result);
    for (;; ++result.iterations) {
        film_.setAttitude(attitude);
        const auto solveHere = [&] {
            const FilmSolution film =
                solveFilm(p, {.tolerance = options.filmTolerance, .maximumIterations = options.maximumIterations},
                          [&](int, double residual) { return result.residual = residual, goOn(); });
            result.solves += film.solves;
            return film;
        };
        FilmSolution film = solveHere();
        if (!film.converged && !film.cancelled) {
            // From a spoilt pressure nothing may be found; at rest the air is everywhere the same.
            const double spacing = spacing_.at(attitude).spacing;
            std::fill(p.begin(), p.end(), film_.ambient());
            if (spacing >= SearchWatch::leastSane) film = solveHere();
            const NoBalance why = film.converged || film.cancelled ? NoBalance::None : watch.unsolved(spacing);
            if (why != NoBalance::None) {
                result.residual = film.residual;
                return giveUp(why, watch, p, attitude, result);
            }
        }
        result.residual = film.residual;
        if (!goOn()) return result;
        linearise(p, attitude);
        result.imbalance = imbalance_;
        result.loadError = loadError(imbalance_);
        result.converged = film.converged && result.loadError <= options.loadTolerance;
        if (result.converged || result.iterations >= 4 * options.maximumIterations) return result;
        const NoBalance why = watch.look(
            attitude,
            {spacing_.at(attitude).spacing, highestCorner(attitude), film.residual, result.loadError, film.converged},
            p);
        if (why != NoBalance::None) return giveUp(why, watch, p, attitude, result);
        if (again && (!(result.loadError < 4.0 * best) || !film.converged)) {
            // Too far: back, and more along the forces.
            attitude = from;
            std::copy(best_.begin(), best_.end(), p.begin());
            film_.setAttitude(attitude);
            leading = std::max(4.0 * leading, 0.1);
            solveHere();
            if (!goOn()) return result;
            linearise(p, attitude);
            result.loadError = best;
        } else if (again) {
            leading *= std::clamp(result.loadError / best, 0.1, 1.5);
            if (leading < 1e-3 || result.loadError < 0.02) leading = 0.0;
        }
        again = true;
        best = result.loadError;
        from = attitude;
        std::copy(p.begin(), p.end(), best_.begin());
        if (!goOn()) return result;
        solveColumns(1e-3, result, goOn);
        if (result.cancelled) return result;
        const Vector3 change = attitudeStep(imbalance_, leading);
        step(p, attitude, change, stepShare(attitude, change), filmStep_);
    }
}

AttitudeSolution FlyingAttitude::solve(std::span<double> p, Attitude& attitude, const AttitudeOptions& options,
                                       const AttitudeMonitor& monitor)
{
    AttitudeSolution result;
    const Attitude start = attitude;
    std::vector<double> startPressure(p.begin(), p.end());
    const auto goOn = asking(monitor, attitude, result);
    // While the film is far from solved an attitude's step means little, and the film alone is cheap.
    film_.setAttitude(attitude);
    const FilmSolution alone = solveFilm(p, {.tolerance = 1e-3, .maximumIterations = options.maximumIterations},
                                         [&](int, double residual) { return result.residual = residual, goOn(); });
    result.solves = alone.solves;
    if (result.cancelled) return result;
    double before = 0.0;
    for (; result.iterations <= 12; ++result.iterations) {
        result.residual = linearise(p, attitude);
        result.imbalance = imbalance_;
        result.loadError = loadError(imbalance_);
        if (!goOn()) return result;
        result.converged = result.residual <= options.filmTolerance && result.loadError <= options.loadTolerance;
        if (result.converged) return result;
        const double size = result.residual + result.loadError;
        if (!std::isfinite(size) || (result.iterations > 1 && size > 2.0 * before)) break;
        before = size;
        const double tolerance = std::clamp(0.1 * std::sqrt(size), 1e-4, 0.01);
        for (std::size_t at = 0; at < right_.size(); ++at) right_[at] = -residual_[at];
        std::fill(filmStep_.begin(), filmStep_.end(), 0.0);
        const double forcing = std::max(tolerance, std::min(0.1, 0.1 * options.filmTolerance / result.residual));
        result.solves += newton_.linear()
                             .solve(right_, filmStep_, {.tolerance = forcing, .maximumIterations = 80, .goOn = goOn})
                             .iterations;
        // For a last small step the columns of the step before are exact enough.
        const bool isLast =
            result.iterations > 0 && size <= 10.0 * std::min(options.filmTolerance, options.loadTolerance);
        if (!isLast) solveColumns(tolerance, result, goOn);
        if (result.cancelled) return result;
        const Vector3 film = balanceProduct(filmStep_);
        const Vector3 change = attitudeStep(imbalance_ + film, 0.0);
        step(p, attitude, change, stepShare(attitude, change), filmStep_);
    }
    const AttitudeSolution first = result;
    attitude = start;
    std::copy(startPressure.begin(), startPressure.end(), p.begin());
    result = approach(p, attitude, options, monitor);
    result.iterations += first.iterations;
    result.solves += first.solves;
    return result;
}

void FlyingAttitude::solveColumnsAt(std::span<const double> p, double tolerance, const std::function<bool()>& goOn)
{
    linearise(p, film_.attitude());
    AttitudeSolution count;
    solveColumns(tolerance, count, goOn);
}

Matrix3 FlyingAttitude::stiffness(std::span<const double> p)
{
    solveColumnsAt(p, 1e-7);
    return currentStiffness(0.0);
}

Matrix3 FlyingAttitude::roughStiffness(std::span<const double> p)
{
    if (!hasResponses_) solveColumnsAt(p, 1e-3);
    return currentStiffness(0.0);
}

Matrix3 FlyingAttitude::currentStiffness(double shearArm) const
{
    Matrix3 result = Matrix3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t m = 0; m < 3; ++m) {
            const auto answer = [&](std::size_t force) {
                double film = 0.0;
                for (std::size_t at = 0; at < responses_[m].size(); ++at)
                    film += forces_.byPressure[force][at] * responses_[m][at];
                return film - forces_.byAttitude[force][m];
            };
            result(k, m) = answer(k);
            if (k > 0 && shearArm != 0.0) result(k, m) -= shearArm * answer(k + 2);
        }
    return result;
}

FlyingAttitude::Adjoint FlyingAttitude::adjoint(std::span<const double> p, const Matrix3& added)
{
    // S = dG/da - C J^-1 B (C = dG/dp, B = dR/da): balance row k = row k of S^-1, film = -that row times J^-T C^T.
    linearise(p, film_.attitude());
    AttitudeSolution count;
    solveColumns(1e-9, count);
    const Matrix3 inverse = (balanceSlopes() - added).inverse();
    std::array<std::vector<double>, 3> adjoints;
    newton_.linear().prepareTransposed();
    for (std::size_t m = 0; m < 3; ++m) {
        adjoints[m].assign(p.size(), 0.0);
        newton_.linear().solveTransposed(balanceRows_[m], adjoints[m], {.tolerance = 1e-9, .maximumIterations = 200});
    }
    Adjoint result;
    result.balance = inverse;
    for (std::size_t k = 0; k < 3; ++k) {
        result.film[k].assign(p.size(), 0.0);
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t at = 0; at < p.size(); ++at) result.film[k][at] -= inverse(k, m) * adjoints[m][at];
    }
    return result;
}

} // namespace touchdown
