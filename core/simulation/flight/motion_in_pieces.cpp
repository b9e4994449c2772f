// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/motion_in_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchdown {

using Eigen::VectorXcd, Eigen::VectorXd;

MotionInPieces::MotionInPieces(const FilmInPieces& film, const Driving& driving, VectorXd y, std::size_t region,
                               bool derivative, double step, double timeError)
    : film_(film), driving_(driving), region_(region), y_(std::move(y)), step_(step), timeError_(timeError)
{
    if (derivative) phi_ = Eigen::MatrixXd::Identity(y_.size(), y_.size());
}

VectorXd MotionInPieces::switchTo(std::size_t region, const VectorXd& before)
{
    region_ = region;
    return slopeAt() - before;
}

MotionInPieces::Row MotionInPieces::rowOf(const FilmInPieces::Reading& reading, Complex disk) const
{
    const auto row = reading.row.cast<Complex>();
    const Complex wave = driving_.force.size() > 0 ? (row * driving_.answers[region_])(0) : Complex(0.0);
    return {row * region().vectors, wave + disk, reading.row.dot(region().shift) + reading.constant};
}

VectorXd MotionInPieces::answerAt(double time) const
{
    if (driving_.force.size() == 0) return VectorXd::Zero(y_.size());
    return (driving_.answers[region_] * turned(time)).real();
}

void MotionInPieces::begin()
{
    begun_ = time_;
    atBegin_ = modes_ = region().inverse * (y_ - answerAt(time_) - region().shift).cast<Complex>();
    separation_ = rowOf(film_.separation());
    factor_ = (step_ * region().rates).array().exp().matrix();
    spacing_ = valueOf(separation_, modes_, time_);
    rate_ = rateOf(separation_, modes_, time_);
    measure(0.0);
}

bool MotionInPieces::sample(double dt)
{
    const double next = time_ + dt;
    const VectorXcd there = dt == step_ ? VectorXcd(modes_.cwiseProduct(factor_)) : modesAfter(dt);
    const double spacing = valueOf(separation_, there, next), rate = rateOf(separation_, there, next);
    const Interval& within = region().interval;
    // Between two times the separation may turn.
    const double reach = std::max(std::abs(rate_), std::abs(rate)) * dt;
    for (const bool upper : {false, true}) {
        const double sign = upper ? -1.0 : 1.0, border = sign * (upper ? within.upper : within.lower);
        if (!std::isfinite(border)) continue;
        const double first = sign * spacing_ - border, last = sign * spacing - border;
        if (first < 0.0 && sign * rate_ < 0.0) { // it came in beyond the border, by round-off
            cross(upper, 0.0);
            return false;
        }
        const bool turns = sign * rate_ < 0.0 && sign * rate > 0.0;
        double left = 0.0, right = dt;
        if (last >= 0.0 && (!turns || std::min(first, last) > reach)) continue;
        if (turns) {
            const double turn =
                rootOf([&](double t) { return rateOf(separation_, modesAfter(t), time_ + t); }, 0.0, dt);
            if (sign * valueOf(separation_, modesAfter(turn), time_ + turn) - border < 0.0)
                right = turn;
            else if (last >= 0.0)
                continue;
            else
                left = turn;
        } else if (first <= 0.0 && sign * rate_ > 0.0) { // it has just come in, and goes out again
            left = rootOf([&](double t) { return rateOf(separation_, modesAfter(t), time_ + t); }, 0.0, dt);
        }
        cross(upper, rootOf([&](double t) { return sign * valueOf(separation_, modesAfter(t), time_ + t) - border; },
                            left, right));
        return false;
    }
    spacing_ = spacing;
    rate_ = rate;
    advance(there, next, dt);
    return true;
}

void MotionInPieces::cross(bool upper, double dt)
{
    advance(modesAfter(dt), time_ + dt, dt);
    end();
    const FilmInPieces::Region& before = region();
    const VectorXd push = slopeAt();
    const Eigen::RowVectorXd& normal = film_.separation().row;
    const double speed = normal.dot(push);
    const VectorXd jump = switchTo(upper ? before.above : before.below, push);
    if (phi_.size() > 0 && speed != 0.0) phi_ += (jump / speed) * (normal * phi_);
    begin();
}

VectorXd MotionInPieces::slopeAt() const
{
    VectorXd slope = region().a * y_ + region().b;
    if (driving_.force.size() > 0) slope += (driving_.force * turned(time_)).real();
    return slope;
}

VectorXd MotionInPieces::positionsNow() const
{
    const Eigen::Index n = film_.positions();
    VectorXcd sum = region().vectors.topRows(n) * modes_;
    if (driving_.force.size() > 0) sum += driving_.answers[region_].head(n) * turned(time_);
    return sum.real() + region().shift.head(n);
}

void MotionInPieces::advance(VectorXcd there, double time, double dt)
{
    modes_ = std::move(there);
    time_ = time;
    measure(dt);
}

void MotionInPieces::end()
{
    const double dt = time_ - begun_;
    y_ = (region().vectors * modes_).real() + answerAt(time_) + region().shift;
    if (dt == 0.0) return;
    const VectorXcd decay = (dt * region().rates).array().exp().matrix();
    if (phi_.size() > 0) phi_ = (region().vectors * decay.asDiagonal() * region().inverse).real() * phi_;
    pieceEnds(dt, decay);
}

} // namespace touchdown
