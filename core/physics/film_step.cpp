// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film_step.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/vector_clones.h"

namespace touchdown {

namespace {

constexpr double linearShare = 0.4;       // of what may be left, for the rest of the linear systems
constexpr double errorPerChange = 2.0 / 11; // of a step's discretisation in time
constexpr int mostRepeats = 4, longestUnmeasured = 20;
constexpr double bending = 3.0; // by how much a change against ambient changes the Jacobian: of gaps whose pressure it is all in [-]

/// Eight sums side by side, whatever the width of vectors.
TOUCHDOWN_VECTOR_CLONES double product(std::span<const double> a, std::span<const double> b)
{
    std::array<double, 8> sums{};
    const std::size_t whole = a.size() / 8 * 8;
    for (std::size_t i = 0; i < whole; i += 8)
        for (std::size_t k = 0; k < 8; ++k) sums[k] += a[i + k] * b[i + k];
    for (std::size_t i = whole; i < a.size(); ++i) sums[0] += a[i] * b[i];
    return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

/// Of cells as in setHistory.
TOUCHDOWN_VECTOR_CLONES void setHistories(std::size_t count, double last, double before, const double* volume,
                                          const double* content1, const double* content2, double* history)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const double stored = last * content1[k] - before * content2[k];
        history[k] = volume[k] > 0.0 ? stored : 0.0;
    }
}

/// Of cells as in guess.
TOUCHDOWN_VECTOR_CLONES void extrapolate(std::size_t count, double byLast, double byBefore, const double* last,
                                         const double* before, const double* beforeThat, double* p)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const double p1 = last[k], p2 = before[k], p3 = beforeThat[k];
        const double guess = p1 + byLast * (p1 - p2) - byBefore * (p2 - p3), least = 0.5 * p1, most = 2.0 * p1;
        const double raised = guess < least ? least : guess;
        p[k] = raised > most ? most : raised;
    }
}

TOUCHDOWN_VECTOR_CLONES void setContents(std::size_t count, const double* volume, const double* p, double* pressure,
                                         double* content)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        pressure[k] = p[k];
        content[k] = volume[k] * p[k];
    }
}

/// out -= part v
TOUCHDOWN_VECTOR_CLONES void subtract(double part, const std::vector<double>& v, std::vector<double>& out)
{
    const double* from = v.data();
    double* to = out.data();
#pragma GCC ivdep
    for (std::size_t i = 0; i < v.size(); ++i) to[i] -= part * from[i];
}

} // namespace

FilmStepper::FilmStepper(GasFilm& film, const FilmStepOptions& options) : film_(film), options_(options), linear_(film)
{
    const std::size_t size = film.pad().size();
    for (auto* field : {&p_, &residual_, &right_, &change_, &rest_, &history_}) field->assign(size, 0.0);
    for (auto* vectors : {&directions_, &images_})
        for (auto& vector : *vectors) vector.assign(size, 0.0);
    for (Past& past : past_)
        for (auto* field : {&past.pressure, &past.content}) field->assign(size, 0.0);
}

void FilmStepper::start(std::span<const double> p)
{
    std::copy(p.begin(), p.end(), p_.begin());
    for (Past& past : past_) past.dt = 0.0;
    dt_ = 0.0;
    remember();
    linearisedPerTime_ = 0.0;
}

bool FilmStepper::accept()
{
    if (!converged_) return false;
    remember();
    return true;
}

void FilmStepper::follow(const Attitude& attitude, std::span<const double> change)
{
    film_.setAttitude(attitude);
    addBounded(p_, change);
}

void FilmStepper::remember()
{
    std::rotate(past_.begin(), past_.end() - 1, past_.end());
    Past& last = past_[0];
    last.dt = dt_;
    setContents(p_.size(), film_.volumes().data(), p_.data(), last.pressure.data(), last.content.data());
    converged_ = false;
}

void FilmStepper::setHistory(double dt)
{
    const bool second = options_.method == FilmTimeMethod::Bdf2 && past_[0].dt > 0.0;
    const double r = second ? dt / past_[0].dt : 0.0; // r = 0 is Euler
    perTime_ = (1.0 + 2.0 * r) / (1.0 + r) / dt;
    const double last = (1.0 + r) / dt, before = r * r / (1.0 + r) / dt;
    // A cell that has closed has pressed its air out; what was left is lost.
    setHistories(history_.size(), last, before, film_.volumes().data(), past_[0].content.data(),
                 past_[1].content.data(), history_.data());
    film_.setStorage(perTime_, history_);
}

/// Through the last three pressures (Newton's divided differences), or as many as there are; each at most doubled or halved.
void FilmStepper::guess(double dt)
{
    const double h1 = past_[0].dt, h2 = past_[1].dt;
    const double slope = h1 > 0.0 ? dt / h1 : 0.0;
    const double bend = h1 > 0.0 && h2 > 0.0 ? dt * (dt + h1) / (h1 + h2) : 0.0;
    extrapolated_ = bend > 0.0;
    const double byLast = bend > 0.0 ? slope + bend / h1 : slope, byBefore = bend > 0.0 ? bend / h2 : 0.0;
    extrapolate(p_.size(), byLast, byBefore, past_[0].pressure.data(), past_[1].pressure.data(),
                past_[2].pressure.data(), p_.data());
}

double FilmStepper::size(std::span<const double> change) const
{
    return std::sqrt(product(change, change) / static_cast<double>(film_.pad().cells())) / film_.ambient();
}

void FilmStepper::linearise(FilmStepResult& result)
{
    film_.linearise(p_, residual_);
    linear_.prepare();
    linearisedPerTime_ = perTime_;
    age_ = measuredAge_ = repeats_ = 0;
    solver_ = Solver::Factors;
    contraction_ = 0.0;
    ++result.linearisations;
}

/// From what the first change adds to the guess; where that is no parabola, cautiously.
void FilmStepper::setTimeError(const FilmStepResult& result)
{
    if (result.iterations == 0 && fresh_) timeError_ = (extrapolated_ ? errorPerChange : 0.001) * size(change_);
}

std::optional<double> FilmStepper::iterate(FilmStepResult& result)
{
    const auto approximate = [&](std::span<double> out) {
        if (solver_ == Solver::Factors) linear_.relax(right_, out);
        else linear_.cycle(right_, out);
        ++result.solves;
    };
    // What is smooth first: factors would leave some of it in each step, always to the same side.
    linear_.halfCycle(right_, change_);
    ++result.solves;
    setTimeError(result);
    const double first = size(change_);
    if (first == 0.0) return 0.0;
    linear_.apply(change_, right_);
    for (std::size_t at = 0; at < right_.size(); ++at) right_[at] = -residual_[at] - right_[at];
    approximate(rest_);
    double now = size(rest_), contraction = std::max(contraction_, now / first);
    // The rest is the next change, but for what is not yet in it.
    const auto left = [&] { return contraction < 1.0 ? contraction / (1.0 - contraction) * now : first; };
    if (left() <= linearShare * allowed()) {
        subtract(-1.0, rest_, change_);
        return left();
    }
    for (std::size_t k = 0; k < mostDirections; ++k) {
        if (now == 0.0) return 0.0;
        std::vector<double>&d = directions_[k], &q = images_[k];
        std::copy(rest_.begin(), rest_.end(), d.begin());
        linear_.apply(d, right_);
        approximate(q);
        for (std::size_t n = 0; n < k; ++n) {
            const double part = product(images_[n], q) / squares_[n];
            subtract(part, images_[n], q);
            subtract(part, directions_[n], d);
        }
        squares_[k] = product(q, q);
        if (!(squares_[k] > 0.0)) return std::nullopt;
        const double part = product(q, rest_) / squares_[k];
        subtract(-part, d, change_);
        subtract(part, q, rest_);
        const double last = now;
        now = size(rest_);
        // Where the half cycle spoilt a few cells, the first direction mends them.
        contraction = k == 0 && contraction >= 1.0 ? now / last : std::max(contraction, now / last);
        if (k < 3 && result.iterations == 0) contraction_ = contraction;
        if (!(contraction < 1.0)) return std::nullopt;
        setTimeError(result);
        if (left() > linearShare * allowed()) continue;
        subtract(-1.0, rest_, change_);
        return left();
    }
    return std::nullopt;
}

double FilmStepper::solveLinear(FilmStepResult& result)
{
    while (true) {
        std::fill(change_.begin(), change_.end(), 0.0);
        for (std::size_t at = 0; at < right_.size(); ++at) right_[at] = -residual_[at];
        if (solver_ == Solver::Krylov) break;
        if (const std::optional<double> rest = iterate(result)) return *rest;
        solver_ = solver_ == Solver::Factors ? Solver::Cycles : Solver::Krylov;
        contraction_ = 0.0;
    }
    // Residuals weigh cells otherwise than pressures do: a margin of ten.
    for (double forcing = 0.01;;) {
        const GmresResult linear = linear_.solve(right_, change_, {.tolerance = forcing, .maximumIterations = 20});
        result.solves += linear.iterations;
        setTimeError(result);
        const double rest = 10.0 * linear.residual * size(change_);
        if (rest <= linearShare * allowed() || !linear.converged || forcing <= 1e-12) return rest;
        forcing = std::max(1e-12, 0.5 * forcing * linearShare * allowed() / rest);
    }
}

FilmStepResult FilmStepper::step(double dt, const Attitude& attitude)
{
    film_.setAttitude(attitude);
    setHistory(dt);
    // Another try of the same length begins where the last one ended.
    fresh_ = !converged_ || dt != dt_;
    if (fresh_) {
        guess(dt);
        timeError_ = 0.0;
    }
    dt_ = dt;
    converged_ = false;
    ++age_;

    FilmStepResult result;
    if (std::abs(linearisedPerTime_ - perTime_) > 0.3 * perTime_ || repeats_ >= mostRepeats) linearise(result);
    else film_.residual(p_, residual_);
    const bool measures = age_ > 0 && (age_ >= 3 * measuredAge_ || age_ >= measuredAge_ + longestUnmeasured);
    if (measures) solver_ = Solver::Factors;
    double before = 0.0; // size of the last change
    while (result.iterations < options_.maximumIterations) {
        const double rest = solveLinear(result);
        addBounded(p_, change_);
        ++result.iterations;
        const double now = size(change_);
        if (!std::isfinite(now)) break;
        const bool second = result.iterations > 1;
        if (second) {
            kappa_ = before > 0.0 ? now / before : 0.0;
            measuredAge_ = age_;
        }
        const bool known = second || !measures;
        double kappa = 1.0;
        if (known) kappa = kappa_ * std::max(1.0, static_cast<double>(age_) / std::max(1, measuredAge_));
        // A Jacobian of the guess itself leaves what is of second order.
        if (age_ == 0 && !second) kappa = std::min(1.0, bending * now);
        result.error = std::max(rest, kappa * now);
        result.timeError = timeError_;
        converged_ = result.converged = result.error <= allowed();
        if (converged_) break;
        if (known && age_ > 0) ++repeats_;
        if (second && now > 0.3 * before) linearise(result);
        else film_.residual(p_, residual_);
        before = now;
    }
    if (!converged_) linearisedPerTime_ = 0.0; // the next try begins anew
    return result;
}

} // namespace touchdown
