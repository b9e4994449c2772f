// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's method on the law of adhesion itself. With the law's tangents at the present gaps, D = -dq/dg,
//
//   contact   C dq = -g
//   near      C dq + dq/D = (q_law - q)/D + g_law - g
//   far       dq - f' C dq = q_law - q,   f' > 0: the attraction falls with the gap
//
// by GMRES, preconditioned as the descent, and on cells that soften by the own compliance.
#include "core/physics/contact/adhesive_contact.h"

#include <algorithm>
#include <cmath>

namespace touchdown {
namespace {

constexpr int mostIterations = 12;     // more are needed where it is nearly singular: a cell is about to snap
constexpr double residualShare = 0.03; // to which the linear system is solved
constexpr double mostSoftening = 0.9;  // of a cell against its own compliance, that its preconditioner knows [-]

} // namespace

// Whether a cell softens by more than the half-space alone would hold it with all others at rest: no minimum is there.
bool AdhesiveContact::snaps() const
{
    for (std::size_t i = 0; i < present_.size(); ++i)
        if (tangents_.state[i] == AdhesiveCell::State::Far &&
            cell_.law().derivative(tangents_.gap[i]) >= space_->ownStiffness())
            return true;
    return false;
}

// From the tangents that linearise() has set, whose error is given. Whether it halved it; otherwise all is as it was.
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
        for (std::size_t i = 0; i < n; ++i) {
            out[i] = weight_[i] > 0.0 ? (out[i] + v[i] / tangents_.stiffness[i]) / c : v[i] - softening_[i] * out[i];
        }
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
    const double tolerance = std::max(residualShare, 0.3 * options_.tolerance / error);
    gmres_->solve(apply, preconditioned, std::span<const double>(residual_), std::span<double>(change_),
                  {.tolerance = tolerance, .maximumIterations = mostIterations});

    totalBefore_ = now_.total;
    displacementBefore_ = now_.displacement;
    for (std::size_t i = 0; i < n; ++i)
        now_.total[i] = weight_[i] > 0.0 ? std::clamp(now_.total[i] + change_[i], cell_.lowest(offset_[i]),
                                                      cell_.highest(offset_[i]))
                                         : now_.total[i] + change_[i];
    displace();
    double curvature = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double moved = now_.displacement[i] - displacementBefore_[i];
        // In contact what remains of the gap is closed, against no law.
        const double stiffness = tangents_.state[i] == Contact ? 0.0
                                 : weight_[i] > 0.0            ? tangents_.stiffness[i]
                                                               : -softening_[i];
        curvature += moved * ((now_.total[i] - totalBefore_[i]) + stiffness * moved);
    }
    if (curvature > 0.0) {
        setOffsets();
        if (linearise() < 0.5 * error) return true;
    }
    now_.total = totalBefore_;
    now_.displacement = displacementBefore_;
    return false;
}

} // namespace touchdown
