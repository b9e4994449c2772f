// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchdown {

FilmStepper::FilmStepper(GasFilm& film, const FilmStepOptions& options) : film_(film), options_(options), linear_(film)
{
    const std::size_t size = film.pad().size();
    for (auto* field : {&p_, &residual_, &right_, &change_, &history_}) field->assign(size, 0.0);
    for (Past& past : past_)
        for (auto* field : {&past.pressure, &past.content}) field->assign(size, 0.0);
}

void FilmStepper::start(std::span<const double> p)
{
    std::copy(p.begin(), p.end(), p_.begin());
    dt_ = 0.0;
    accept();
    past_[1] = past_[0];
    linearisedPerTime_ = 0.0;
}

void FilmStepper::accept()
{
    std::swap(past_[0], past_[1]);
    Past& last = past_[0];
    last.dt = dt_;
    for (std::size_t at = 0; at < p_.size(); ++at) {
        last.pressure[at] = p_[at];
        last.content[at] = film_.volumes()[at] * p_[at];
    }
    tried_ = false;
}

void FilmStepper::setHistory(double dt)
{
    const bool second = options_.method == FilmTimeMethod::Bdf2 && past_[0].dt > 0.0;
    const double r = second ? dt / past_[0].dt : 0.0; // r = 0 is Euler
    perTime_ = (1.0 + 2.0 * r) / (1.0 + r) / dt;
    const double last = (1.0 + r) / dt, before = r * r / (1.0 + r) / dt;
    // A cell that has closed has pressed its air out; what was left is lost.
    for (std::size_t at = 0; at < history_.size(); ++at)
        history_[at] = film_.volumes()[at] > 0.0 ? last * past_[0].content[at] - before * past_[1].content[at] : 0.0;
    film_.setStorage(perTime_, history_);
}

/// Straight on from the last two pressures, each at most doubled or halved.
void FilmStepper::guess(double dt)
{
    const double r = past_[0].dt > 0.0 ? dt / past_[0].dt : 0.0;
    for (std::size_t at = 0; at < p_.size(); ++at) {
        const double last = past_[0].pressure[at];
        p_[at] = std::clamp(last + r * (last - past_[1].pressure[at]), 0.5 * last, 2.0 * last);
    }
}

double FilmStepper::residualAt(std::span<const double> p)
{
    film_.residual(p, residual_);
    return residualNorm(film_, residual_);
}

void FilmStepper::linearise(FilmStepResult& result)
{
    film_.linearise(p_, residual_);
    result.residual = residualNorm(film_, residual_);
    linear_.prepare();
    linearisedPerTime_ = perTime_;
    ++result.linearisations;
}

FilmStepResult FilmStepper::step(double dt, const Attitude& attitude)
{
    film_.setAttitude(attitude);
    setHistory(dt);
    if (!tried_) guess(dt);
    tried_ = true;
    dt_ = dt;

    FilmStepResult result;
    const bool stale = std::abs(linearisedPerTime_ - perTime_) > 0.3 * perTime_;
    if (stale) linearise(result);
    else result.residual = residualAt(p_);
    while (true) {
        result.converged = result.residual <= options_.tolerance;
        if (result.converged || result.iterations >= options_.maximumIterations || !std::isfinite(result.residual)) break;
        for (std::size_t at = 0; at < right_.size(); ++at) right_[at] = -residual_[at];
        std::fill(change_.begin(), change_.end(), 0.0);
        // As exact as the last digit asked for, where the Jacobian is.
        const double forcing = std::clamp(0.3 * options_.tolerance / result.residual, 1e-3, 0.1);
        result.solves += linear_.solve(right_, change_, {.tolerance = forcing, .maximumIterations = 20}).iterations;
        addBounded(p_, change_);
        ++result.iterations;
        const double before = result.residual;
        result.residual = residualAt(p_);
        if (result.residual > options_.tolerance && !(result.residual < 0.1 * before)) linearise(result);
    }
    if (!std::isfinite(result.residual)) tried_ = false; // the next try begins anew
    return result;
}

} // namespace touchdown
