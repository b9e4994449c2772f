// SPDX-License-Identifier: GPL-3.0-or-later
//
// The linear picture of stability: how much each method changes a small motion per step (numerics/stability_region.h),
// with the case's own eigenvalues.
//
// Springs: eigenvalues of the model's Jacobian in the static state, where an air spring is stiffest on the way of the
// case's own run, and in contact; rk4, dopri5 and newmark with the case's parameters. cvode's Adams methods change
// order and step as they go and have no one region.
//
// Film: the modes of the static state, as lambda = omega (-zeta +- i sqrt(1 - zeta^2)); Euler, BDF2 and BDF2OPT for the
// air, the trapezoidal rule and Fox & Goodwin's for the slider, and both together. A slider on a film that is a spring
// with a leak has the eigenvalues of its mode where s = 2 zeta omega, as lambda^2 + s lambda + omega^2 = 0; so the
// coupled charts are those of the mode.
#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/studies/study/study.h"

namespace touchdown {

/// Small motions of the case about one state.
struct LocalMotion {
    std::string where;                       // "closest to the disk"
    std::vector<std::complex<double>> rates; // [1/s], those with an imaginary part >= 0
    bool isMode = false;                     // an air bearing mode, whose name gives its frequency

    double fastest() const; // |lambda| [1/s]
};

/// The largest step with which a method amplifies none of these motions, except those that are unstable themselves.
/// Infinite where no step is too long.
double largestStableStep(const std::function<double(std::complex<double>)>& growth, const LocalMotion& motion);

struct LinearPicture {
    std::string problem; // why there is none: "there are no modes"; "" where there is one
    std::vector<StudyChart> charts;
    std::vector<StudyTable> tables;
    std::vector<std::string> findings, warnings;
};

/// False where `goOn`, asked about every 50 ms, said so.
bool makeLinearPicture(const Case& c, LinearPicture& picture, const std::function<bool()>& goOn);

} // namespace touchdown
