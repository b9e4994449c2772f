// SPDX-License-Identifier: GPL-3.0-or-later
//
// One cycle of sustained bouncing: Newton's method on P(x) - x = 0 (bouncing_slider.h), and its figures.
//
// Over one period the energy of the slider returns to its value: what contact and friction give is what the dashpots of
// air springs and suspension take. The sum of the parts is the residual of that balance.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "core/studies/cycles/bouncing_slider.h"

namespace touchdown {

struct LimitCycle {
    double value = 0.0; // of the parameter [its unit]
    Eigen::VectorXd x;
    int crossings = 1;                             // of the section, in one period
    int touchDowns = 0;                            // from flying, in one period
    double period = 0.0;                           // [s]
    SwingOf separation, minimumSpacing;            // [m]
    std::vector<std::complex<double>> multipliers; // of Floquet, by falling magnitude [-]
    CycleEnergies energies;                        // a part that is zero but for round-off is 0 [J]
    double cycleWork = 0.0;                        // W of the contact law [J]
    std::vector<CycleSwitch> switches;
    double modelError = 0.0; // as of Return [-]
    bool tooFar = false;
    double frequency() const { return 1.0 / period; }
    double amplitude() const { return 0.5 * (minimumSpacing.most - minimumSpacing.least); }
    double largestMultiplier() const { return std::abs(multipliers[0]); }
    bool stable() const { return largestMultiplier() < 1.0; }
    /// Of the energy balance, of its largest part [-].
    double residual() const;
};

std::vector<std::complex<double>> multipliersOf(const Eigen::MatrixXd& derivative);

struct CycleSolution {
    bool found = false;
    Eigen::VectorXd x;
    int crossings = 1;
    std::string problem; // why there is none, in a sentence without a full stop
};
/// The cycle of at most `crossings` near x; the slider must return within `limit` [s].
CycleSolution solveCycle(const BouncingSlider& slider, Eigen::VectorXd x, int crossings, double limit);

/// Its figures at a value of the parameter. The period is 0 where x is no point of a cycle.
LimitCycle figuresOf(const BouncingSlider& slider, double value, const Eigen::VectorXd& x, int crossings, double limit);

/// "take-off": the first switch that is lost or appears; "" where both lists are the same.
std::string firstDifference(const BouncingSlider& slider, const std::vector<CycleSwitch>& before,
                            const std::vector<CycleSwitch>& now);

} // namespace touchdown
