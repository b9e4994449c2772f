// SPDX-License-Identifier: GPL-3.0-or-later
//
// One cycle of sustained bouncing: Newton's method on P(x) - x = 0 (return_map.h), and its figures.
//
// Over one period the energy of the slider returns to its value: what contact and friction give is what the dashpots of
// air springs and suspension take. The sum of the parts is the residual of that balance.
#pragma once

#include <array>
#include <complex>
#include <string>

#include "core/studies/cycles/return_map.h"

namespace touchdown {

struct LimitCycle {
    double value = 0.0; // of the parameter [its unit]
    Vector3 x = Vector3::Zero();
    int crossings = 1;                               // of the section, in one period
    int touchDowns = 0;                              // from flying, in one period
    double period = 0.0;                             // [s]
    SwingOf separation, minimumSpacing;              // [m]
    std::array<std::complex<double>, 3> multipliers; // of Floquet, by falling magnitude [-]
    CycleEnergies energies;                          // a part that is zero but for round-off is 0 [J]
    double cycleWork = 0.0;                          // W of the contact law [J]
    std::vector<CycleSwitch> switches;
    double frequency() const { return 1.0 / period; }
    double amplitude() const { return 0.5 * (minimumSpacing.most - minimumSpacing.least); }
    double largestMultiplier() const { return std::abs(multipliers[0]); }
    bool stable() const { return largestMultiplier() < 1.0; }
    /// Of the energy balance, of its largest part [-].
    double residual() const;
};

std::array<std::complex<double>, 3> multipliersOf(const Matrix3& derivative);

struct CycleSolution {
    bool found = false;
    Vector3 x = Vector3::Zero();
    int crossings = 1;
    std::string problem; // why there is none, in a sentence without a full stop
};
/// The cycle of at most `crossings` near x; the slider must return within `limit` [s].
CycleSolution solveCycle(const ReturnMap& map, Vector3 x, int crossings, double limit);

/// Its figures at a value of the parameter. The period is 0 where x is no point of a cycle.
LimitCycle figuresOf(const ReturnMap& map, const Case& c, double value, const Vector3& x, int crossings, double limit);

/// Two cycles of the same case are the same.
bool sameCycle(const LimitCycle& a, const LimitCycle& b);

/// "take-off": the first switch that is lost or appears; "" where both lists are the same.
std::string firstDifference(const SpringModel& model, const std::vector<CycleSwitch>& before,
                            const std::vector<CycleSwitch>& now);

} // namespace touchdown
