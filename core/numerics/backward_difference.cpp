// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/backward_difference.h"

namespace touchdown {

namespace {

constexpr double thirdShare = 0.48;        // of what BDF3 adds to BDF2 (Vatsa, Carpenter & Lockard 2010)
constexpr double mostGrowthForThird = 1.5; // of a step against the last one

} // namespace

BackwardDifference backwardDifference(BackwardRule rule, double dt, double h1, double h2)
{
    const bool second = rule != BackwardRule::Euler && h1 > 0.0;
    const double r = second ? dt / h1 : 0.0; // r = 0 is Euler
    BackwardDifference result;
    result.perTime = (1.0 + 2.0 * r) / (1.0 + r) / dt;
    result.share = {(1.0 + r) / dt, -r * r / (1.0 + r) / dt, 0.0};
    if (rule == BackwardRule::Bdf2Opt && second && h2 > 0.0 && dt <= mostGrowthForThird * h1 &&
        h1 <= mostGrowthForThird * h2) {
        // Of dt (t - t2) f[t, t1, t2, t3] the parts of m and m1..m3.
        const double factor = thirdShare * dt * (dt + h1), all = dt + h1 + h2;
        result.perTime += factor / (dt * (dt + h1) * all);
        result.share[0] += factor / (dt * h1 * (h1 + h2));
        result.share[1] -= factor / ((dt + h1) * h1 * h2);
        result.share[2] += factor / (all * (h1 + h2) * h2);
        result.taken = thirdShare;
    }
    return result;
}

} // namespace touchdown
