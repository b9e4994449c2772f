// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/limit_cycle.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/formats/units.h"
#include "core/formats/words.h"

namespace touchdown {

using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr int mostCycleIterations = 30; // of Newton
constexpr int mostHalvings = 10;        // of one of its steps
constexpr double cycleFound = 1e-9;     // residual and last change, in units of x [-]
constexpr double shorterPeriod = 1e-6;  // distance at which a part of the crossings is a cycle by itself [-]
constexpr double energyAccuracy = 1e-9; // of an energy along a cycle, of the largest part [-]

} // namespace

double LimitCycle::residual() const
{
    const double largest = energies.largest();
    return largest > 0.0 ? std::abs(energies.sum()) / largest : 0.0;
}

std::vector<std::complex<double>> multipliersOf(const Eigen::MatrixXd& derivative)
{
    const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(derivative, false).eigenvalues();
    std::vector<std::complex<double>> all(values.begin(), values.end());
    std::ranges::stable_sort(all, std::ranges::greater(), [](const auto& value) { return std::abs(value); });
    return all;
}

CycleSolution solveCycle(const BouncingSlider& slider, VectorXd x, int crossings, double limit)
{
    CycleSolution solution;
    solution.crossings = crossings;
    const ReturnRequest request{.crossings = crossings, .limit = limit, .derivative = true};
    Return at = slider.apply(x, request);
    for (int k = 0;; ++k) {
        if (!at.returned) {
            solution.problem =
                "the slider does not come back to the touch-down height within " + fewDigitsOfTime(limit);
            return solution;
        }
        const VectorXd residual = at.x - x;
        const MatrixXd slope = at.derivative - MatrixXd::Identity(x.size(), x.size());
        const VectorXd change = slope.fullPivLu().solve(residual);
        if (residual.norm() <= cycleFound && change.norm() <= cycleFound) break;
        if (k == mostCycleIterations || !change.allFinite()) {
            solution.problem = "Newton's method found no cycle of " + counted(std::size_t(crossings), "crossing") +
                               " in " + counted(std::size_t(k), "step") + " (residual " +
                               fewDigits(residual.norm(), "") + ")";
            return solution;
        }
        // The shortest step is taken in any case: the map may have a kink there.
        double share = 1.0;
        Return next;
        for (int halving = 0; halving < mostHalvings; ++halving, share *= 0.5) {
            next = slider.apply(x - share * change, request);
            if (next.returned && (next.x - (x - share * change)).norm() < residual.norm()) break;
        }
        if (residual.norm() <= cycleFound && !(share >= 1.0)) break; // round-off
        if (share < 1e-2) {
            solution.problem = "Newton's method found no cycle of " + counted(std::size_t(crossings), "crossing") +
                               ": no step lowers the residual of " + fewDigits(residual.norm(), "");
            return solution;
        }
        x -= share * change;
        at = std::move(next);
    }
    solution.found = true;
    solution.x = x;
    for (int part = 1; part < crossings; ++part) {
        if (crossings % part != 0 || (at.passed[std::size_t(part) - 1] - x).norm() > shorterPeriod) continue;
        solution.crossings = part;
        break;
    }
    return solution;
}

LimitCycle figuresOf(const BouncingSlider& slider, double value, const VectorXd& x, int crossings, double limit)
{
    LimitCycle cycle;
    cycle.value = value;
    cycle.x = x;
    cycle.crossings = crossings;
    Return way = slider.apply(x, {.crossings = crossings, .limit = limit, .derivative = true, .measurements = true});
    if (!way.returned || !way.derivative.allFinite()) return cycle;
    cycle.period = way.time;
    cycle.separation = way.separation;
    cycle.minimumSpacing = way.minimumSpacing;
    cycle.multipliers = multipliersOf(way.derivative);
    cycle.energies = way.energies;
    for (double* part :
         {&cycle.energies.air, &cycle.energies.suspension, &cycle.energies.contact, &cycle.energies.friction})
        if (std::abs(*part) < energyAccuracy * way.energies.largest()) *part = 0.0;
    cycle.cycleWork = slider.cycleWork();
    cycle.touchDowns = static_cast<int>(std::ranges::count_if(way.switches, [](const CycleSwitch& each) {
        return each.guard == SpringModel::Pad && each.before.contact == ContactRegion::Apart;
    }));
    cycle.switches = std::move(way.switches);
    cycle.modelError = way.modelError;
    cycle.tooFar = way.tooFar;
    return cycle;
}

std::string firstDifference(const BouncingSlider& slider, const std::vector<CycleSwitch>& before,
                            const std::vector<CycleSwitch>& now)
{
    const auto [was, is] = std::ranges::mismatch(before, now);
    const bool appears = was == before.end() || (is != now.end() && now.size() > before.size());
    if (appears && is == now.end()) return {};
    const CycleSwitch& first = appears ? *is : *was;
    return slider.nameOf(first);
}

} // namespace touchdown
