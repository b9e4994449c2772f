// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/coupled_step.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "core/numerics/wall_clock.h"

namespace touchdown {

namespace {

constexpr double slopeError = 0.02; // of the stiffness of film and contact, as long as none is measured [-]
constexpr double forgetting = 0.9;  // of a contraction once measured, per step [-]
constexpr double longestForFourth =
    1.4; // omega dt up to which the fourth order rule is used; it is stable up to sqrt 6 [-]
constexpr double worthRenewing = 0.1; // contraction beyond which the film's responses have changed [-]
constexpr double slowestRate = 1e6;   // 2 pi times a frequency below those of an air bearing [rad/s]

/// Adds the time until its end to a sum.
class Stopwatch {
public:
    explicit Stopwatch(double& seconds) : seconds_(seconds), begin_(wallClock()) {}
    Stopwatch(const Stopwatch&) = delete;
    ~Stopwatch() { seconds_ += wallClock() - begin_; }

private:
    double& seconds_;
    double begin_;
};

/// In lengths of the slider, so that an elimination weighs like with like.
Vector3 solveScaled(const Matrix3& matrix, const Vector3& right, double length, double width)
{
    const Eigen::DiagonalMatrix<double, 3> scale(1.0, 1.0 / length, 1.0 / width);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> m(matrix.front().data());
    const Eigen::Map<const Eigen::Vector3d> b(right.data());
    const Eigen::Matrix3d scaled = scale * m * scale;
    const Eigen::Vector3d x = scale * scaled.partialPivLu().solve(scale * b);
    return {x[0], x[1], x[2]};
}

} // namespace

CoupledStepper::CoupledStepper(GasFilm& film, const SliderBody& body, SliderContact* contact, DiskUnderFilm* disk,
                               const CoupledStepOptions& options)
    : film_(film),
      loads_(film),
      body_(body),
      contact_(contact),
      disk_(disk),
      options_(options),
      stepper_(film, options.film),
      response_(film, loads_, body)
{
    for (auto* field : {&change_, &surface_}) field->assign(film.pad().size(), 0.0);
}

void CoupledStepper::setSurface(double time)
{
    const Stopwatch watch(cost_.diskSeconds);
    const bool rough = disk_ && !disk_->flat();
    if (rough) {
        if (!(surfaceTime_ == time) || deformed_) disk_->at(time, surface_);
    } else if (deformed_) {
        std::fill(surface_.begin(), surface_.end(), 0.0);
    }
    surfaceTime_ = time;
    deformed_ = inReach_ && contact_->deform(surface_);
    film_.setSurface(rough || deformed_ ? std::span<const double>(surface_) : std::span<const double>());
}

void CoupledStepper::askContact(const Attitude& attitude, double time)
{
    const double begin = wallClock();
    inReach_ = contact_ && !contact_->outOfReach(attitude);
    if (contact_) ++(inReach_ ? cost_.contactSolves : cost_.contactSkipped);
    // Also out of reach, so that a law with memory knows it.
    if (contact_) contactForces_ = contact_->at(attitude, time);
    const double seconds = wallClock() - begin;
    cost_.contactSeconds += seconds;
    if (inReach_) cost_.contactSolveSeconds += seconds;
    contactStiffness_ = inReach_ ? contact_->stiffness() : Matrix3{};
}

Vector3 CoupledStepper::filmForceAt(std::span<const double> p)
{
    const Stopwatch watch(cost_.forceSeconds);
    const std::array<double, 5> force = loads_.loadAndShear(p);
    shear_ = {force[3], force[4]};
    return {force[0], force[1] - body_.shearArm() * force[3], force[2] - body_.shearArm() * force[4]};
}

void CoupledStepper::start(std::span<const double> p, const SliderMotion& motion, double time)
{
    motion_ = motion;
    time_ = time;
    const Attitude attitude = body_.attitude(motion_.q);
    askContact(attitude, time);
    if (contact_) contact_->accept();
    setSurface(time);
    film_.setAttitude(attitude);
    stepper_.start(p);
    filmForce_ = filmForceAt(stepper_.pressure());
    starting_ = true;
    response_.forget();
    contraction_ = 0.0;
    jerk_ = stiffJerk_ = {};
    lastDt_ = 0.0;
    setAcceleration();
}

void CoupledStepper::setAcceleration()
{
    const Vector3 contact = contactForces_.load(), suspension = body_.suspension(motion_.q, motion_.v);
    for (std::size_t k = 0; k < 3; ++k)
        motion_.a[k] = (filmForce_[k] + contact[k] + suspension[k]) / body_.inertia()[k];
    if (body_.holdsRoll()) motion_.a[2] = 0.0;
}

void CoupledStepper::restartAcceleration()
{
    askContact(body_.attitude(motion_.q), time_);
    setAcceleration();
    jerk_ = stiffJerk_ = stiffJerk(motion_.v);
    lastDt_ = 0.0;
    acceptedRate_ = fastestRate();
}

/// Of the acceleration's rate of change what stiffness makes.
Vector3 CoupledStepper::stiffJerk(const Vector3& v) const
{
    Vector3 jerk{};
    for (std::size_t k = 0; k < 3; ++k) {
        jerk[k] = -body_.springs()[k] * v[k];
        for (std::size_t m = 0; m < 3; ++m) jerk[k] -= (response_.stiffness()[k][m] + contactStiffness_[k][m]) * v[m];
        jerk[k] /= body_.inertia()[k];
    }
    if (body_.holdsRoll()) jerk[2] = 0.0;
    return jerk;
}

/// Solves (M `perSquare` + C `perTime` + K + stiffness of contact and film) x = right [1/s^2], [1/s].
Vector3 CoupledStepper::solveBody(const Vector3& right, double perSquare, double perTime, bool stiff) const
{
    Matrix3 matrix{};
    for (std::size_t k = 0; stiff && k < 3; ++k)
        for (std::size_t m = 0; m < 3; ++m) matrix[k][m] = response_.stiffness()[k][m] + contactStiffness_[k][m];
    for (std::size_t k = 0; k < 3; ++k)
        matrix[k][k] += body_.inertia()[k] * perSquare + body_.dampers()[k] * perTime + body_.springs()[k];
    Vector3 b = right;
    if (body_.holdsRoll()) {
        for (std::size_t k = 0; k < 3; ++k) matrix[2][k] = matrix[k][2] = 0.0;
        matrix[2][2] = body_.inertia()[2] * perSquare;
        b[2] = 0.0;
    }
    return solveScaled(matrix, b, film_.gaps().length, film_.gaps().width);
}

/// Of film and contact in what a change of the attitude meets [-].
double CoupledStepper::stiffShare(double perSquare) const
{
    double share = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double stiffness = std::abs(response_.stiffness()[k][k]) + std::abs(contactStiffness_[k][k]);
        share = std::max(share, stiffness / (stiffness + body_.inertia()[k] * perSquare));
    }
    return share;
}

double CoupledStepper::follow(const Vector3& change)
{
    const double left = response_.follow(change, change_);
    stepper_.follow(body_.attitude(tried_.q), change_);
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t m = 0; m < 3; ++m) filmForce_[k] -= response_.stiffness()[k][m] * change[m];
    return left;
}

FilmStepResult CoupledStepper::stepFilm(double dt, const Attitude& attitude)
{
    const Stopwatch watch(cost_.filmSeconds);
    const FilmStepResult film = stepper_.step(dt, attitude);
    ++cost_.filmSolves;
    cost_.linearisations += film.linearisations;
    cost_.jacobiansKept += film.linearisations == 0;
    return film;
}

/// Where a step meets stiffness on its way for which its rule is not stable, it is taken again by the other one, whose
/// error then tells whether it is too long.
CoupledStepResult CoupledStepper::step(double dt)
{
    const CoupledStepResult first = tryStep(dt, true);
    if (!first.converged() || !fourth_ || fastestRate() * dt <= longestForFourth) return first;
    CoupledStepResult result = tryStep(dt, false);
    result.iterations += first.iterations;
    result.filmIterations += first.filmIterations;
    result.linearisations += first.linearisations;
    result.solves += first.solves;
    return result;
}

CoupledStepResult CoupledStepper::tryStep(double dt, bool fourth)
{
    CoupledStepResult result;
    dt_ = dt;
    const bool monolithic = options_.coupling == FilmCoupling::Monolithic;
    const double time = time_ + dt;
    setRule(dt, fourth);
    const double perSquare = 1.0 / (later_ * dt * dt), perTime = 0.5 * dt * perSquare;
    for (std::size_t k = 0; k < 3; ++k) {
        rate_[k] = motion_.v[k] + shift_ * stiffJerk_[k];
        tried_.q[k] = motion_.q[k] + dt * (rate_[k] + dt * (0.5 * motion_.a[k] + later_ * dt * jerk_[k]));
    }
    contraction_ *= forgetting;
    double before = 0.0, measured = 0.0; // size of the last change; contraction
    const auto fail = [&](CoupledFailure failure) {
        result.failure = failure;
        return result;
    };
    while (result.iterations < options_.maximumIterations) {
        ++result.iterations;
        if (options_.goOn && !options_.goOn()) return fail(CoupledFailure::Stopped);
        const Attitude attitude = body_.attitude(tried_.q);
        askContact(attitude, time);
        if (!contactForces_.problem.empty()) return fail(CoupledFailure::Contact);
        setSurface(time);
        const FilmStepResult film = stepFilm(dt, attitude);
        result.filmIterations += film.iterations;
        result.linearisations += film.linearisations;
        result.solves += film.solves;
        result.filmError = film.error;
        if (!film.converged) return fail(CoupledFailure::Film);
        if (monolithic && response_.isOld()) {
            const Stopwatch watch(cost_.responseSeconds);
            result.solves += response_.renew(stepper_.pressure(), stepper_.linear(), options_.goOn);
            if (!response_.known()) return fail(CoupledFailure::Stopped);
        }
        filmForce_ = filmForceAt(stepper_.pressure());

        const Vector3 contact = contactForces_.load();
        Vector3 balance{};
        setVelocity(dt);
        const Vector3 suspension = body_.suspension(tried_.q, tried_.v);
        for (std::size_t k = 0; k < 3; ++k)
            balance[k] = filmForce_[k] + contact[k] + suspension[k] - body_.inertia()[k] * tried_.a[k];
        if (body_.holdsRoll()) balance[2] = 0.0;
        const Vector3 change = solveBody(balance, perSquare, perTime, monolithic);
        contraction_ = std::max(contraction_, slopeError * stiffShare(perSquare));
        const double size = body_.displacement(change);
        if (!std::isfinite(size)) return fail(CoupledFailure::NotFinite);
        if (result.iterations > 1) {
            // What is as small as rounding contracts no more.
            if (size > options_.tolerance) contraction_ = measured = size / before;
            if (contraction_ > 1.0 && size > 10.0 * options_.tolerance && result.iterations > 3)
                return fail(CoupledFailure::Iteration);
        }
        before = size;
        const double left = contraction_ < 1.0 ? contraction_ / (1.0 - contraction_) * size : size;
        const double load = std::max(std::abs(body_.load()[0]), 1e-300);
        result.forceBalance =
            (std::abs(balance[0]) + (std::abs(balance[1]) + std::abs(balance[2])) / film_.gaps().length) / load;
        if (monolithic) {
            for (std::size_t k = 0; k < 3; ++k) tried_.q[k] += change[k];
            const double filmLeft = follow(change);
            result.filmError += filmLeft;
            result.positionLeft = left;
            result.forceBalance *= contraction_;
            if (left > options_.tolerance || filmLeft > stepper_.allowed()) continue;
        } else if (size > options_.tolerance) {
            for (std::size_t k = 0; k < 3; ++k) tried_.q[k] += change[k];
            continue;
        } else {
            result.positionLeft = size;
        }
        if (measured > worthRenewing) response_.outdate();
        finishMotion(dt, monolithic ? change : Vector3{});
        setTimeError(dt, result);
        return result;
    }
    return fail(CoupledFailure::Iteration);
}

double CoupledStepper::fastestRate() const
{
    if (!response_.known()) return 0.0;
    Eigen::Matrix3d perMass;
    for (int k = 0; k < 3; ++k) {
        const auto row = static_cast<std::size_t>(k);
        for (int m = 0; m < 3; ++m) {
            const auto column = static_cast<std::size_t>(m);
            const double scale = (m == 0 ? 1.0 : 1.0 / film_.gaps().length) * (k == 0 ? 1.0 : film_.gaps().length);
            perMass(k, m) =
                scale * (response_.stiffness()[row][column] + contactStiffness_[row][column]) / body_.inertia()[row];
        }
        perMass(k, k) += body_.springs()[row] / body_.inertia()[row];
    }
    if (body_.holdsRoll()) perMass.row(2).setZero();
    return std::sqrt(perMass.eigenvalues().cwiseAbs().maxCoeff());
}

/// Fox & Goodwin's rule while it is far from its limit of stability, the trapezoidal rule otherwise; also in the first
/// step, whose earlier tries may know the stiffness and may not.
void CoupledStepper::setRule(double dt, bool fourth)
{
    fourth_ = fourth && !starting_ && response_.known() && acceptedRate_ * dt < longestForFourth;
    later_ = fourth_ ? 1.0 / 12 : 0.25;
    shift_ = fourth_ ? dt * dt / 12.0 : 0.0;
}

/// Those that the rule has at the tried position.
void CoupledStepper::setVelocity(double dt)
{
    for (std::size_t k = 0; k < 3; ++k) {
        const double way = tried_.q[k] - motion_.q[k] - dt * (rate_[k] + (0.5 - later_) * dt * motion_.a[k]);
        tried_.a[k] = way / (later_ * dt * dt);
        tried_.v[k] = rate_[k] + 0.5 * dt * (motion_.a[k] + tried_.a[k]);
    }
}

/// The acceleration is that of the forces at the solution, which `change` has just led to, so that what the iteration
/// left in the position does not come back in it from step to step.
void CoupledStepper::finishMotion(double dt, const Vector3& change)
{
    setVelocity(dt);
    const Vector3 contact = contactForces_.load(), suspension = body_.suspension(tried_.q, tried_.v);
    for (std::size_t k = 0; k < 3; ++k) {
        double force = filmForce_[k] + contact[k] + suspension[k];
        for (std::size_t m = 0; m < 3; ++m) force -= contactStiffness_[k][m] * change[m];
        tried_.a[k] = force / body_.inertia()[k];
    }
    if (body_.holdsRoll()) tried_.a[2] = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double slope = (tried_.a[k] - motion_.a[k]) / dt;
        triedJerk_[k] = lastDt_ > 0.0 ? slope + (slope - slope_[k]) * dt / (dt + lastDt_) : slope;
        triedSlope_[k] = slope;
        tried_.v[k] = rate_[k] + 0.5 * dt * (motion_.a[k] + tried_.a[k]);
    }
    if (fourth_) {
        // v - shift stiffJerk(v) = u turned round: steps of changing length then neither gain nor lose energy by their
        // shifts.
        Vector3 right;
        for (std::size_t k = 0; k < 3; ++k) right[k] = -body_.inertia()[k] * tried_.v[k] / shift_;
        tried_.v = solveBody(right, -1.0 / shift_, 0.0, true);
    }
    triedStiffJerk_ = stiffJerk(tried_.v);
}

/// Of the slider -dt^3/12 q''' for the trapezoidal rule (Hairer, Norsett & Wanner 1993, II.7); with the other one, from
/// where a change of the acceleration was not foreseen. Of the film, as the displacement that would balance its force.
void CoupledStepper::setTimeError(double dt, CoupledStepResult& result)
{
    Vector3 change{};
    for (std::size_t k = 0; k < 3; ++k)
        change[k] = (tried_.a[k] - motion_.a[k] - (fourth_ ? dt * jerk_[k] : 0.0)) * dt * dt / 12.0;
    const Vector3 film = solveBody(stepper_.timeErrorLoad(), slowestRate * slowestRate, 0.0, response_.known());
    result.timeError = body_.displacement(change) + body_.displacement(film);
}

void CoupledStepper::accept()
{
    if (!stepper_.accept()) return;
    jerk_ = triedJerk_;
    stiffJerk_ = triedStiffJerk_;
    slope_ = triedSlope_;
    lastDt_ = dt_;
    motion_ = tried_;
    time_ += dt_;
    response_.age();
    starting_ = false;
    acceptedRate_ = fastestRate();
    if (contact_) contact_->accept();
}

} // namespace touchdown
