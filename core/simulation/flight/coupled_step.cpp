// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/coupled_step.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/backward_difference.h"
#include "core/physics/film/gas_film.h"
#include "core/work/state_stream.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

constexpr double positionShare = 5e-3;     // of a step's error, for the error of its iteration
constexpr double filmShare = 0.1;          // and for the film's residual, as the displacement of a slider by its force
constexpr double filmTimeShare = 0.3;      // of the film's own error in time [-]
constexpr double typicalScale = 10e-9;     // over which a film's force changes by the load [m]
constexpr double contactSlopeError = 0.02; // of the stiffness of the contact, as long as none is measured [-]
constexpr double forgetting = 0.9;         // of a contraction once measured, per step [-]
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
    return scale * solvePartialPivoting(scale * matrix * scale, scale * right);
}

/// to += sign A x, term by term, so that the sum does not depend on how the product is vectorised.
void addTo(Vector3& to, double sign, const Matrix3& a, const Vector3& x)
{
    for (int m = 0; m < 3; ++m) to += sign * a.col(m) * x[m];
}

} // namespace

CoupledStepOptions steppingOf(const Case& c, const GasFilm& film)
{
    CoupledStepOptions options;
    options.coupling = c.film.motion == FilmMotion::Linear ? FilmCoupling::Monolithic : c.film.coupling;
    options.tolerance = positionShare * c.run.stepError;
    options.film.share = filmTimeShare;
    options.film.tolerance = std::max(1e-9, filmShare * c.run.stepError / typicalScale * c.suspension.preload /
                                                (film.ambient() * c.slider.length * c.slider.width));
    return options;
}

CoupledStepper::CoupledStepper(FilmInTime& film, const SliderBody& body, SliderContact* contact,
                               const CoupledStepOptions& options)
    : film_(film), body_(body), contact_(contact), options_(options)
{}

void CoupledStepper::setSurface(double time)
{
    const Stopwatch watch(cost_.diskSeconds);
    film_.setDisk(time, inReach_);
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
    contactStiffness_ = inReach_ ? contact_->stiffness() : Matrix3(Matrix3::Zero());
}

void CoupledStepper::setFilmForce()
{
    const Stopwatch watch(cost_.forceSeconds);
    filmForce_ = film_.force();
}

void CoupledStepper::start(const SliderMotion& motion, double time)
{
    motion_ = motion;
    time_ = time;
    askContact(body_.attitude(motion_.q), time);
    if (contact_) contact_->accept();
    setSurface(time);
    film_.start(motion_, time);
    setFilmForce();
    starting_ = true;
    contraction_ = 0.0;
    jerk_ = shiftJerk_ = Vector3::Zero();
    lastDt_ = 0.0;
    lengths_ = {};
    motion_.a = accelerationBy(forceOn(motion_));
}

Vector3 CoupledStepper::forceOn(const SliderMotion& at) const
{
    const Vector3 contact = contactForces_.load(), suspension = body_.suspension(at.q, at.v);
    return filmForce_ + contact + suspension;
}

Vector3 CoupledStepper::accelerationBy(const Vector3& force) const
{
    Vector3 acceleration = force.cwiseQuotient(body_.inertia());
    if (body_.holdsRoll()) acceleration[2] = 0.0;
    return acceleration;
}

void CoupledStepper::restartAcceleration()
{
    askContact(body_.attitude(motion_.q), time_);
    motion_.a = accelerationBy(forceOn(motion_));
    jerk_ = shiftJerk_ = stiffJerk(motion_.v);
    lastDt_ = 0.0;
    lengths_ = {};
    acceptedRate_ = fastestRate();
}

/// Part of the acceleration's rate of change that stiffness causes.
Vector3 CoupledStepper::stiffJerk(const Vector3& v) const
{
    Vector3 jerk = -body_.springs().cwiseProduct(v);
    addTo(jerk, -1.0, film_.stiffness() + contactStiffness_, v);
    return accelerationBy(jerk);
}

/// Solves (M `perSquare` + C `perTime` + K + stiffness of contact and film) x = right [1/s^2], [1/s].
Vector3 CoupledStepper::solveBody(const Vector3& right, double perSquare, double perTime, bool stiff) const
{
    Matrix3 matrix = Matrix3::Zero();
    if (stiff) matrix = film_.stiffness() + contactStiffness_;
    matrix.diagonal() += body_.inertia() * perSquare + body_.dampers() * perTime + body_.springs();
    Vector3 b = right;
    if (body_.holdsRoll()) {
        matrix.row(2).setZero();
        matrix.col(2).setZero();
        matrix(2, 2) = body_.inertia()[2] * perSquare;
        b[2] = 0.0;
    }
    return solveScaled(matrix, b, body_.length(), body_.width());
}

/// Share of film and contact in the stiffness against a change of the attitude [-].
double CoupledStepper::stiffShare(double perSquare) const
{
    double share = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double stiffness = std::abs(film_.stiffness()(k, k)) + std::abs(contactStiffness_(k, k));
        share = std::max(share, stiffness / (stiffness + body_.inertia()[k] * perSquare));
    }
    return share;
}

double CoupledStepper::follow(const Vector3& change)
{
    const double left = film_.follow(tried_.q, change);
    addTo(filmForce_, -1.0, film_.stiffness(), change);
    return left;
}

FilmStepResult CoupledStepper::stepFilm(double dt)
{
    const Stopwatch watch(cost_.filmSeconds);
    const FilmStepResult film = film_.step(dt, motion_, tried_.q, acceptedRate_);
    ++cost_.filmSolves;
    cost_.linearisations += film.linearisations;
    cost_.jacobiansKept += film.linearisations == 0;
    return film;
}

/// A step with a stiffness for which its rule is not stable is repeated with the other rule.
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

/// At the end of the step. The film is solved at the attitude that follows from it: an error with a phase of its own
/// would change the damping.
Vector3 CoupledStepper::forecastAcceleration(double dt) const
{
    const auto [h1, h2, h3] = lengths_;
    const auto weights = fittedForecast(dt, h1, h2, h3, acceptedRate_);
    if (!fourth_ || !weights) return motion_.a + dt * jerk_;
    const auto [w1, w2, w3, w4] = *weights;
    return w1 * motion_.a + w2 * earlier_[0] + w3 * earlier_[1] + w4 * earlier_[2];
}

CoupledStepResult CoupledStepper::tryStep(double dt, bool fourth)
{
    CoupledStepResult result;
    dt_ = dt;
    const bool monolithic = options_.coupling == FilmCoupling::Monolithic;
    const double time = time_ + dt;
    setRule(dt, fourth);
    const double perSquare = 1.0 / (later_ * dt * dt), perTime = 0.5 * dt * perSquare;
    rate_ = motion_.v + shift_ * shiftJerk_;
    tried_.q = motion_.q + dt * (rate_ + dt * ((0.5 - later_) * motion_.a + later_ * forecastAcceleration(dt)));
    contraction_ *= forgetting;
    double before = 0.0, measured = 0.0; // size of the last change; contraction
    const auto fail = [&](CoupledFailure failure) {
        result.failure = failure;
        return result;
    };
    while (result.iterations < options_.maximumIterations) {
        ++result.iterations;
        if (options_.goOn && !options_.goOn()) return fail(CoupledFailure::Stopped);
        askContact(body_.attitude(tried_.q), time);
        if (!contactForces_.problem.empty()) return fail(CoupledFailure::Contact);
        setSurface(time);
        const FilmStepResult film = stepFilm(dt);
        result.filmIterations += film.iterations;
        result.linearisations += film.linearisations;
        result.solves += film.solves;
        result.filmError = film.error;
        if (!film.converged) return fail(CoupledFailure::Film);
        if (monolithic && film_.isResponseOld()) {
            const Stopwatch watch(cost_.responseSeconds);
            result.solves += film_.renewResponse(inReach_, options_.goOn);
            if (!film_.isResponseKnown()) return fail(CoupledFailure::Stopped);
        }
        setFilmForce();

        setVelocity(dt);
        Vector3 balance = forceOn(tried_) - body_.inertia().cwiseProduct(tried_.a);
        if (body_.holdsRoll()) balance[2] = 0.0;
        const Vector3 change = solveBody(balance, perSquare, perTime, monolithic);
        const double slopeError = std::max(film_.stiffnessError(), contact_ ? contactSlopeError : 0.0);
        contraction_ = std::max(contraction_, slopeError * stiffShare(perSquare));
        const double size = body_.displacement(change);
        if (!std::isfinite(size)) return fail(CoupledFailure::NotFinite);
        if (result.iterations > 1) {
            // A change of the size of rounding contracts no more.
            if (size > options_.tolerance) contraction_ = measured = size / before;
            if (contraction_ > 1.0 && size > 10.0 * options_.tolerance && result.iterations > 3)
                return fail(CoupledFailure::Iteration);
        }
        before = size;
        const double left = contraction_ < 1.0 ? contraction_ / (1.0 - contraction_) * size : size;
        const double preload = std::abs(body_.load()[0]);
        const double load = preload > 0.0 ? preload : film_.ambientForce();
        result.forceBalance =
            (std::abs(balance[0]) + (std::abs(balance[1]) + std::abs(balance[2])) / body_.length()) / load;
        if (monolithic) {
            tried_.q += change;
            const double filmLeft = follow(change);
            result.filmError += filmLeft;
            result.positionLeft = left;
            result.forceBalance *= contraction_;
            if (left > options_.tolerance || filmLeft > film_.allowed()) continue;
        } else if (size > options_.tolerance) {
            tried_.q += change;
            continue;
        } else {
            result.positionLeft = size;
        }
        if (measured > worthRenewing) film_.outdateResponse();
        finishMotion(dt, monolithic ? change : Vector3(Vector3::Zero()));
        setTimeError(dt, result);
        return result;
    }
    return fail(CoupledFailure::Iteration);
}

double CoupledStepper::fastestRate() const
{
    if (!film_.isResponseKnown()) return 0.0;
    const Vector3 length(1.0, body_.length(), body_.width());
    Matrix3 stiffness = film_.stiffness() + contactStiffness_;
    stiffness.diagonal() += body_.springs();
    if (stiffness == rated_) return ratedRate_;
    Matrix3 perMass = length.cwiseQuotient(body_.inertia()).asDiagonal() * stiffness;
    perMass = perMass * length.cwiseInverse().asDiagonal();
    if (body_.holdsRoll()) perMass.row(2).setZero();
    rated_ = stiffness;
    return ratedRate_ = std::sqrt(spectralRadius(perMass));
}

/// Fox & Goodwin's rule while it is far from its limit of stability, the trapezoidal rule otherwise; also in the first
/// step, whose earlier tries may know the stiffness and may not.
void CoupledStepper::setRule(double dt, bool fourth)
{
    fourth_ = fourth && !starting_ && film_.isResponseKnown() && acceptedRate_ * dt < longestForFourth;
    later_ = fourth_ ? 1.0 / 12 : 0.25;
    shift_ = fourth_ ? dt * dt / 12.0 : 0.0;
}

/// Those that the rule has at the tried position.
void CoupledStepper::setVelocity(double dt)
{
    tried_.a = (tried_.q - motion_.q - dt * (rate_ + (0.5 - later_) * dt * motion_.a)) / (later_ * dt * dt);
    tried_.v = rate_ + 0.5 * dt * (motion_.a + tried_.a);
}

/// The acceleration is that of the forces at the solution, which `change` has just led to, so that what the iteration
/// left in the position does not come back in it from step to step. Where lengths change, the velocity is as good as
/// a': that of the last accelerations, as the film's stiffness is not known well enough in large motions.
void CoupledStepper::finishMotion(double dt, const Vector3& change)
{
    setVelocity(dt);
    Vector3 force = forceOn(tried_);
    addTo(force, -1.0, contactStiffness_, change);
    tried_.a = accelerationBy(force);
    triedJerk_ = triedSlope_ = (tried_.a - motion_.a) / dt;
    if (lastDt_ > 0.0) triedJerk_ += (triedSlope_ - slope_) * dt / (dt + lastDt_);
    tried_.v = rate_ + 0.5 * dt * (motion_.a + tried_.a);
    const BackwardDifference rate =
        backwardDifference(BackwardRule::Fitted, dt, lengths_[0], lengths_[1], acceptedRate_);
    if (rate.fitted) {
        const auto [s1, s2, s3] = rate.share;
        triedShiftJerk_ = rate.perTime * tried_.a - s1 * motion_.a - s2 * earlier_[0] - s3 * earlier_[1];
        tried_.v -= shift_ * triedShiftJerk_;
        return;
    }
    // v - shift stiffJerk(v) = u solved for v.
    if (fourth_) tried_.v = solveBody(-body_.inertia().cwiseProduct(tried_.v) / shift_, -1.0 / shift_, 0.0, true);
    triedShiftJerk_ = stiffJerk(tried_.v);
}

/// Error of the slider: -dt^3/12 q''' for the trapezoidal rule (Hairer, Norsett & Wanner 1993, II.7); for the other
/// rule, of the unpredicted change of the acceleration. Error of the film: the displacement that balances its force.
void CoupledStepper::setTimeError(double dt, CoupledStepResult& result)
{
    Vector3 change = tried_.a - motion_.a;
    if (fourth_) change -= dt * jerk_;
    change = change * dt * dt / 12.0;
    const std::array<double, 3> load = film_.timeErrorLoad();
    const Vector3 film =
        solveBody({load[0], load[1], load[2]}, slowestRate * slowestRate, 0.0, film_.isResponseKnown());
    result.timeError = body_.displacement(change) + body_.displacement(film);
}

void CoupledStepper::accept()
{
    if (!film_.accept(tried_)) return;
    jerk_ = triedJerk_;
    shiftJerk_ = triedShiftJerk_;
    slope_ = triedSlope_;
    lastDt_ = dt_;
    earlier_ = {motion_.a, earlier_[0], earlier_[1]};
    lengths_ = {dt_, lengths_[0], lengths_[1]};
    motion_ = tried_;
    time_ += dt_;
    starting_ = false;
    acceptedRate_ = fastestRate();
    if (contact_) contact_->accept();
}

void CoupledStepper::pass(StateStream& stream)
{
    stream(motion_, jerk_, slope_, shiftJerk_, earlier_, lengths_, time_, lastDt_, inReach_, filmForce_, contactForces_,
           contactStiffness_, acceptedRate_, starting_, cost_, contraction_);
    film_.pass(stream);
}

} // namespace touchdown
