// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_step.h"

#include <algorithm>
#include <cmath>

#include "core/physics/film/film_step_vectors.h"
#include "core/physics/film/gas_film.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

constexpr double linearShare = 0.4;           // of what may be left, for the rest of the linear systems
constexpr double firstErrorPerChange = 0.001; // of a step that had no parabola to begin with, cautiously
constexpr int mostRepeats = 4, longestUnmeasured = 40;
constexpr double mostOfMeasured = 4.0; // change of a step against the one of which kappa was measured
constexpr double bending =
    3.0; // by how much a change against ambient changes the Jacobian: of gaps whose pressure it is all in [-]

} // namespace

FilmStepper::FilmStepper(GasFilm& film, const FilmStepOptions& options) : film_(film), options_(options), linear_(film)
{
    const std::size_t size = film.pad().size();
    linear_.reserve();
    rowLoads_.resize(static_cast<std::size_t>(film.pad().ny));
    at_.surface.reserve(size);
    for (auto* field : {&p_, &residual_, &right_, &change_, &rest_, &history_, &foreseen_, &linearisedVolume_,
                        &at_.pressure, &at_.history, &at_.spread})
        field->assign(size, 0.0);
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
    closings_ = 0;
    remember();
    linearisedPerTime_ = 0.0;
    unmeasured_ = longestUnmeasured;
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

std::array<double, 3> FilmStepper::timeErrorLoad() const
{
    const PaddedGrid& pad = film_.pad();
    const FilmGaps& gaps = film_.gaps();
    std::array<double, 3> load{};
    if (!extrapolated_) return load;
    const auto setRow = [&](int j) {
        double force = 0.0, torque = 0.0;
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            const double volume = film_.volumes()[at];
            const double cell = volume > 0.0 ? (p_[at] - foreseen_[at] / volume) * film_.areas()[at] : 0.0;
            force += cell;
            torque += cell * (0.5 * gaps.length - gaps.grid.centreX(i));
        }
        rowLoads_[static_cast<std::size_t>(j)] = {force, torque};
    };
    Team::mine().items(pad.ny, 24, 1, [&](int first, int end, int) {
        for (int j = first; j < end; ++j) setRow(j);
    });
    for (int j = 0; j < pad.ny; ++j) {
        const auto [force, torque] = rowLoads_[static_cast<std::size_t>(j)];
        load[0] += force;
        load[1] += torque;
        load[2] -= force * (gaps.grid.centreY(j) - 0.5 * gaps.width);
    }
    for (double& part : load) part *= errorPerChange_;
    return load;
}

void FilmStepper::remember()
{
    std::rotate(past_.begin(), past_.end() - 1, past_.end());
    Past& last = past_[0];
    last.dt = dt_;
    const long long closed = setContents(p_.size(), film_.volumes().data(), p_.data(), past_[1].content.data(),
                                         last.pressure.data(), last.content.data());
    if (past_[0].dt > 0.0) closings_ += closed;
    converged_ = false;
}

void FilmStepper::setHistory(double dt)
{
    const double h1 = past_[0].dt, h2 = past_[1].dt;
    const auto [perTime, share, taken, fitted] = backwardDifference(options_.method, dt, h1, h2, rate_);
    perTime_ = perTime;
    fitted_ = fitted;
    // Milne's device, for lengths that differ.
    const double error = (1.0 - taken) / ((dt + h1 + h2) * perTime_);
    errorPerChange_ = error / (1.0 + error);
    // A cell that has closed has pressed its air out; what was left is lost.
    setHistories(history_.size(), share, film_.volumes().data(), past_[0].content.data(), past_[1].content.data(),
                 past_[2].content.data(), history_.data());
    film_.setStorage(perTime_, history_);
    film_.spreadAs(past_[0].pressure);
}

/// Lagrange's polynomial through the last contents, at most four, or the forecast fitted to the rate, over the new
/// volumes; at most doubled or halved.
void FilmStepper::guess(double dt)
{
    const double h1 = past_[0].dt, h2 = past_[1].dt, h3 = past_[2].dt;
    std::array<double, 3> parabola{1.0, 0.0, 0.0};
    std::array<double, 4> third{};
    extrapolated_ = h1 > 0.0 && h2 > 0.0;
    if (extrapolated_) {
        parabola = {(dt + h1) * (dt + h1 + h2) / (h1 * (h1 + h2)), -dt * (dt + h1 + h2) / (h1 * h2),
                    dt * (dt + h1) / ((h1 + h2) * h2)};
    } else if (h1 > 0.0) {
        parabola = {1.0 + dt / h1, -dt / h1, 0.0};
    }
    if (extrapolated_ && h3 > 0.0) {
        const double factor = dt * (dt + h1) * (dt + h1 + h2); // times p[t1, t2, t3, t4]
        third = {factor / (h1 * (h1 + h2) * (h1 + h2 + h3)), -factor / (h1 * h2 * (h2 + h3)),
                 factor / ((h1 + h2) * h2 * h3), -factor / ((h1 + h2 + h3) * (h2 + h3) * h3)};
    }
    if (options_.method == FilmTimeMethod::Fitted)
        if (const auto weights = fittedForecast(dt, h1, h2, h3, rate_))
            for (std::size_t j = 0; j < 4; ++j) third[j] = (*weights)[j] - (j < 3 ? parabola[j] : 0.0);
    extrapolate(p_.size(), parabola, third,
                {past_[0].content.data(), past_[1].content.data(), past_[2].content.data(), past_[3].content.data()},
                past_[0].pressure.data(), film_.volumes().data(), p_.data(), foreseen_.data());
}

double FilmStepper::size(std::span<const double> change) const
{
    return std::sqrt(product(change, change) / static_cast<double>(film_.pad().cells())) / film_.ambient();
}

void FilmStepper::linearise(FilmStepResult& result)
{
    film_.linearise(p_, residual_);
    linear_.prepare();
    copyAll(film_.volumes(), linearisedVolume_);
    at_.attitude = film_.attitude();
    copyAll(p_, at_.pressure);
    copyAll(history_, at_.history);
    copyAll(past_[0].pressure, at_.spread);
    at_.surface.assign(film_.surface().begin(), film_.surface().end());
    linearisedPerTime_ = perTime_;
    age_ = repeats_ = 0;
    solver_ = Solver::Factors;
    contraction_ = 0.0;
    ++result.linearisations;
}

void FilmStepper::linearise(const Linearised& at)
{
    film_.setSurface(at.surface);
    film_.setAttitude(at.attitude);
    film_.setStorage(linearisedPerTime_, at.history);
    film_.spreadAs(at.spread);
    film_.linearise(at.pressure, residual_);
    linear_.prepare();
    std::ranges::copy(film_.volumes(), linearisedVolume_.begin());
}

/// From what the first change adds to the guess.
void FilmStepper::setTimeError(const FilmStepResult& result)
{
    if (result.iterations > 0 || !fresh_) return;
    const double square =
        unforeseenSquares(change_, p_, foreseen_, film_.volumes()) / static_cast<double>(film_.pad().cells());
    timeError_ = (extrapolated_ ? errorPerChange_ : firstErrorPerChange) * std::sqrt(square) / film_.ambient();
}

std::optional<double> FilmStepper::iterate(FilmStepResult& result)
{
    const auto approximate = [&](std::span<double> out) {
        if (solver_ == Solver::Factors)
            linear_.relax(right_, out);
        else
            linear_.cycle(right_, out);
        ++result.solves;
    };
    // What is smooth first: factors would leave some of it in each step, always to the same side.
    linear_.halfCycle(right_, change_);
    ++result.solves;
    setTimeError(result);
    const double first = size(change_);
    if (first == 0.0) return 0.0;
    linear_.apply(change_, right_);
    setLeft(residual_, right_);
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
        copyAll(rest_, d);
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
        clearAll(change_);
        setNegative(residual_, right_);
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
    if (std::abs(linearisedPerTime_ - perTime_) > 0.3 * perTime_ || repeats_ >= mostRepeats)
        linearise(result);
    else
        film_.residual(p_, residual_);
    if (++unmeasured_ > longestUnmeasured) solver_ = Solver::Factors;
    double before = 0.0; // size of the last change
    while (result.iterations < options_.maximumIterations) {
        const double rest = solveLinear(result);
        if (age_ > 0) {
            // The flows' part of J has changed about in proportion to the gaps, the storage is up to date: the square
            // root of the ratio is best.
            scaleToVolumes(change_.size(), linearisedVolume_.data(), film_.volumes().data(), change_.data());
            setTimeError(result);
        }
        addBounded(p_, change_);
        ++result.iterations;
        const double now = size(change_);
        if (!std::isfinite(now)) break;
        const bool second = result.iterations > 1;
        if (second && age_ > 0) {
            kappaPerStep_ = before > 0.0 ? now / before / age_ : 0.0;
            largestMeasured_ = mostOfMeasured * before;
            unmeasured_ = 0;
        }
        // What was measured holds for changes of about that size.
        const bool known = age_ > 0 && unmeasured_ <= longestUnmeasured && now <= largestMeasured_;
        double kappa = known ? kappaPerStep_ * age_ : 1.0;
        if (second) kappa = before > 0.0 ? now / before : 0.0;
        // A Jacobian of the guess itself leaves what is of second order.
        else if (age_ == 0)
            kappa = std::min(1.0, bending * now);
        result.error = std::max(rest, kappa * now);
        result.timeError = timeError_;
        converged_ = result.converged = result.error <= allowed();
        if (converged_) break;
        if (known) ++repeats_;
        if (second && now > 0.3 * before)
            linearise(result);
        else
            film_.residual(p_, residual_);
        before = now;
    }
    if (!converged_) linearisedPerTime_ = 0.0; // the next try begins anew
    return result;
}

} // namespace touchdown
