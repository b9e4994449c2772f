// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's method on the law of adhesion itself. With the law's tangents at the present gaps, D = -dq/dg,
//
//   contact   C dq = -g
//   near      C dq + dq/D = (q_law - q)/D + g_law - g
//   far       dq - f' C dq = q_law - q,   f' > 0: the attraction falls with the gap
//
// by GMRES, preconditioned as the descent, and on cells that soften by the own compliance. Starts from the tangents of
// linearise(), whose error is given. Where the full step does not halve the error, it ends at the least energy along
// it. Before a saddle the energy rises along it: then the opposite step, which may be longer, leaves the saddle.
#include "core/physics/contact/adhesive_contact.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/line_minimum.h"

namespace touchdown {
namespace {

constexpr double newtonShare = 0.03;   // to which the linear system is solved
constexpr double mostSoftening = 0.9;  // of a cell against its own compliance, that its preconditioner knows [-]
constexpr double shortestStep = 0.05;  // of Newton's step, that is worth it [-]
constexpr double farthestLeap = 0.25;  // of the gap that moves most, against z0: longest way away from a saddle [-]
constexpr double mostStretched = 16.0; // against the distance of the saddle [-]

} // namespace

// Returns whether a step was taken; if not, the solution is as it was.
bool AdhesiveContact::newtonStep(double error)
{
    using enum AdhesiveCell::State;
    const std::size_t n = offset_.size();
    const double c = cell_.compliance();
    for (std::size_t i = 0; i < n; ++i) {
        softening_[i] = 0.0;
        if (weight_[i] > 0.0) {
            residual_[i] /= c;
            continue;
        }
        residual_[i] = tangents_.pressure[i] - now_.total[i];
        if (tangents_.state[i] != Far) continue;
        const double slope = cell_.law().derivative(tangents_.gap[i]);
        softening_[i] = std::max(slope, 0.0);
    }
    const auto apply = [&](std::span<const double> v, std::span<double> out) {
        space_->displace(v, out);
        countIteration();
        for (std::size_t i = 0; i < n; ++i)
            out[i] = weight_[i] > 0.0 ? (out[i] + v[i] / tangents_.stiffness[i]) / c : v[i] - softening_[i] * out[i];
    };
    const auto preconditioned = [&](std::span<const double> in, std::span<double> out) {
        precondition(in, out);
        for (std::size_t i = 0; i < n; ++i) {
            if (weight_[i] > 0.0)
                out[i] *= c;
            else
                out[i] = in[i] / (1.0 - std::min(softening_[i] * c, mostSoftening));
        }
    };
    std::fill(change_.begin(), change_.end(), 0.0);
    const double tolerance = std::max(newtonShare, 0.3 * options_.tolerance / error);
    gmres_->solve(apply, preconditioned, residual_, change_,
                  {.tolerance = tolerance, .maximumIterations = mostNewtonIterations});

    totalBefore_ = now_.total;
    displacementBefore_ = now_.displacement;
    stepBy(1.0);
    double curvature = 0.0, farthest = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double moved = now_.displacement[i] - displacementBefore_[i];
        farthest = std::max(farthest, std::abs(moved));
        // In contact what remains of the gap is closed, against no law.
        const double stiffness = tangents_.state[i] == Contact ? 0.0
                                 : weight_[i] > 0.0            ? tangents_.stiffness[i]
                                                               : -softening_[i];
        curvature += moved * ((now_.total[i] - totalBefore_[i]) + stiffness * moved);
    }
    const double part = partOfLeastEnergy();
    if (curvature > 0.0) {
        setOffsets();
        if (linearise() < 0.5 * error) return true;
    }
    if (part > shortestStep) {
        shorten(part);
        setOffsets();
        if (linearise() < 2.0 * error) return true;
    }
    undo();
    return part == 0.0 && leaveSaddle(std::clamp(farthestLeap * freeScale_ / farthest, 1.0, mostStretched));
}

// Against the change that Newton's method found, `times` as far.
bool AdhesiveContact::leaveSaddle(double times)
{
    setOffsets();
    linearise();
    stepBy(-times);
    const double part = partOfLeastEnergy();
    if (part * times > shortestStep) {
        shorten(part);
        return true;
    }
    undo();
    return false;
}

// By a multiple of the change, within the bounds of the tangents.
void AdhesiveContact::stepBy(double times)
{
    for (std::size_t i = 0; i < change_.size(); ++i) {
        const double next = totalBefore_[i] + times * change_[i];
        now_.total[i] = weight_[i] > 0.0 ? std::clamp(next, cell_.lowest(offset_[i]), cell_.highest(offset_[i])) : next;
    }
    displace();
}

void AdhesiveContact::undo()
{
    now_.total = totalBefore_;
    now_.displacement = displacementBefore_;
}

// The share of the present step at which Pi is least, zero where it does not fall. Its slope is the sum of
// (q - f) du; a gap below zero counts as pressed with 1/c, and the gaps of cells in contact are closed anyway.
double AdhesiveContact::partOfLeastEnergy() const
{
    using enum AdhesiveCell::State;
    const auto slope = [&](double part) {
        double sum = 0.0;
        for (std::size_t i = 0; i < now_.total.size(); ++i) {
            if (tangents_.state[i] == Contact || tangents_.state[i] == Flowed) continue;
            const double moved = now_.displacement[i] - displacementBefore_[i];
            const double total = totalBefore_[i] + part * (now_.total[i] - totalBefore_[i]);
            const double gap = now_.separation[i] + displacementBefore_[i] + part * moved;
            const double law = cell_.law().pressure(gap) - std::min(gap, 0.0) / cell_.compliance();
            sum += (total - law) * moved;
        }
        return sum;
    };
    return lineMinimum(slope);
}

} // namespace touchdown
