// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/settled_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace touchdown {

using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr int firstLook = 8;             // after so many periods, then after twice as many, and so on
constexpr double nearlyRepeats = 0.3;    // of the size of the motion [-]
constexpr double clearlyNearer = 0.5;    // a longer period must repeat better by that factor [-]
constexpr double comesNearer = 0.8;      // of the distance at the look before [-]
constexpr double closeEnough = 0.1;      // distance of the repeating motion, in its size [-]
constexpr double aboveNoise = 30.0;      // residual, in errors of one step of the integrator [-]
constexpr double repeats = 1e-8;         // of the size of the motion, for residual and last change of Newton [-]
constexpr double repeatsByItself = 1e-9; // of the size of the motion, without Newton [-]
constexpr double shorterRepeats = 1e-3;  // a part of n periods may be the period [-]
constexpr double sameHarmonic = 1e-3;    // [-]
constexpr double alreadyThere = 1e-7;    // distance from the repeating motion, of the size of the motion [-]
constexpr int periodsOfUnsettled = 64;   // over which a motion that has not settled is measured

/// The smallest n after which the last of the states nearly repeats; 0 where there is none.
int likelyPeriod(const std::vector<ForcedState>& states, int longest, const VectorXd& units)
{
    int best = 0;
    double least = nearlyRepeats;
    for (int n = 1; n <= longest && std::size_t(n) < states.size(); ++n) {
        const double distance = apart(states.back(), states[states.size() - 1 - std::size_t(n)], units);
        if (distance >= (best == 0 ? 1.0 : clearlyNearer) * least) continue;
        best = n;
        least = distance;
    }
    return best;
}

/// Measures n periods from a state into the motion; the end is the state after them.
void measureFrom(const ForcedSlider& slider, const ForcedState& from, int n, ForcedMotion& motion)
{
    const ForcedPeriods way = slider.run(from, {.periods = n, .measurements = true});
    motion.problem = way.problem;
    motion.harmonic = way.harmonic;
    motion.least = way.least;
    motion.most = way.most;
    motion.leastSpacing = way.leastSpacing;
    motion.touchDowns = double(way.touchDowns) / n;
    motion.contactShare = way.contactShare;
    motion.end = way.end;
}

} // namespace

double apart(const ForcedState& a, const ForcedState& b, const VectorXd& size)
{
    return (a.y - b.y).cwiseQuotient(size).norm();
}

std::optional<RepeatingMotion> repeatingNear(const ForcedSlider& slider, const ForcedState& start, int n,
                                             const VectorXd& size, const NewtonOptions& newton,
                                             const std::function<bool()>& goOn)
{
    const ForcedRequest request{.periods = n, .derivative = true, .rough = newton.rough};
    ForcedState at = start;
    for (int k = 0; k < newton.mostSteps; ++k) {
        if (goOn && !goOn()) return {};
        const ForcedPeriods way = slider.run(at, request);
        if (!way.problem.empty()) return {};
        const VectorXd units = slider.units(way.swing);
        const double enough = std::max(repeats, aboveNoise * slider.stepError(newton.rough) / units[0]);
        const VectorXd residual = (way.end.y - at.y).cwiseQuotient(units);
        const MatrixXd slope = units.cwiseInverse().asDiagonal() * way.derivative * units.asDiagonal();
        const VectorXd change = (MatrixXd::Identity(slope.rows(), slope.cols()) - slope).fullPivLu().solve(residual);
        if (!change.allFinite()) return {};
        if (residual.norm() <= enough && change.norm() <= enough) {
            const double multiplier = Eigen::EigenSolver<MatrixXd>(slope, false).eigenvalues().cwiseAbs().maxCoeff();
            if (!(multiplier < 1.0) || !(way.end.mode == at.mode)) return {};
            for (int part = 1; part < n; ++part) {
                if (n % part != 0) continue;
                const ForcedPeriods shorter = slider.run(at, {.periods = part, .rough = newton.rough});
                if (!shorter.problem.empty() || apart(shorter.end, at, units) > shorterRepeats) continue;
                // Where the n periods hardly decay, their Newton step leaves more than the part's own does.
                if (auto found =
                        repeatingNear(slider, at, part, units, {.reach = shorterRepeats, .rough = newton.rough}, goOn))
                    return found;
            }
            return RepeatingMotion{at, n, multiplier, units};
        }
        at.y += units.cwiseProduct(change);
        at = slider.continued(at);
        if (apart(at, start, size) > newton.reach) return {};
    }
    return {};
}

ForcedMotion measured(const ForcedSlider& slider, const RepeatingMotion& repeating)
{
    ForcedMotion motion;
    motion.frequency = slider.frequency();
    motion.period = repeating.period;
    motion.multiplier = repeating.multiplier;
    motion.size = repeating.size;
    measureFrom(slider, repeating.at, repeating.period, motion);
    if (!motion.valid()) motion.period = 0;
    return motion;
}

ForcedMotion settledMotion(const ForcedSlider& slider, const ForcedState& start, const SettleOptions& options)
{
    ForcedMotion motion;
    motion.frequency = slider.frequency();
    std::vector<ForcedState> states{slider.continued(start)};
    ForcedState before = states.front(); // at the last look
    int look = firstLook;
    const Eigen::Index positions = slider.positions();
    VectorXd lowest = states.front().y.head(positions), highest = lowest; // since then
    for (int k = 1; k <= options.mostPeriods; ++k) {
        if (options.goOn && !options.goOn()) {
            motion.problem = "stopped";
            return motion;
        }
        const ForcedPeriods way = slider.run(states.back(), {.rough = true});
        if (!way.problem.empty()) {
            motion.problem = way.problem;
            return motion;
        }
        states.push_back(way.end);
        lowest = lowest.cwiseMin(way.end.y.head(positions));
        highest = highest.cwiseMax(way.end.y.head(positions));
        if (k != look && k != options.mostPeriods) continue;
        look *= 2;
        const ForcedState& last = states.back();
        const VectorXd units = slider.units(way.swing),
                       size = slider.units(way.swing.cwiseMax(0.5 * (highest - lowest)));
        if (const int n = likelyPeriod(states, options.longestPeriod, size)) {
            std::optional<RepeatingMotion> found = repeatingNear(slider, last, n, size, {.rough = true}, options.goOn);
            const bool byItself = apart(last, states[states.size() - 1 - std::size_t(n)], units) <= repeatsByItself;
            if (found && !byItself) {
                const double distance = apart(last, found->at, units);
                const bool nearer = distance <= comesNearer * apart(before, found->at, units);
                if (distance > alreadyThere && !(nearer && distance <= closeEnough)) found.reset();
            }
            if (found)
                found =
                    repeatingNear(slider, found->at, found->period, found->size, {.reach = closeEnough}, options.goOn);
            if (found || byItself) {
                motion.period = found ? found->period : n;
                motion.size = found ? found->size : units;
                if (found) motion.multiplier = found->multiplier;
                measureFrom(slider, found ? found->at : last, motion.period, motion);
                if (!motion.valid()) motion.period = 0;
                return motion;
            }
        }
        before = last;
        lowest = highest = last.y.head(positions);
    }
    measureFrom(slider, states.back(), periodsOfUnsettled, motion);
    return motion;
}

bool sameMotion(const ForcedMotion& a, const ForcedMotion& b)
{
    return a.settled() && b.settled() && a.period == b.period &&
           std::abs(a.harmonic - b.harmonic) <= sameHarmonic * std::max(a.amplitude(), b.amplitude()) &&
           std::abs(a.leastSpacing - b.leastSpacing) <= sameHarmonic * std::max(a.size[0], b.size[0]) &&
           std::abs(a.contactShare - b.contactShare) <= sameHarmonic;
}

} // namespace touchdown
