// SPDX-License-Identifier: GPL-3.0-or-later
//
// Panels, tables and sentences of which the linear picture of stability is made.
#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "core/numerics/stability_region.h"
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

struct LinearMethod {
    std::string name;     // "rk4"
    std::string sentence; // what its steps are of: "rk4 (switches located or not)"
    Growth growth;
    bool isTheCases = false;
};

/// Of the fastest rate [-].
double dampingRatio(const LocalMotion& motion);

/// The upper half of the plane, of which the lower one is the mirror image, with the eigenvalues times the step. It
/// shows every bounded region whole.
ChartPanel regionPanel(const std::vector<LinearMethod>& methods, const std::vector<LocalMotion>& motions, double step);

/// Growth of an oscillation with this damping ratio, against omega h from 0.01 to 10; lines at |lambda| h of the
/// motions.
ChartPanel growthPanel(const std::vector<LinearMethod>& methods, double damping,
                       const std::vector<LocalMotion>& motions, double step);
void addGrowth(ChartPanel& panel, const std::string& name, const std::function<double(double)>& growth);

StudyTable limitTable(const std::vector<LinearMethod>& methods, const std::vector<LocalMotion>& motions, double step);
StudyTable eigenvalueTable(const std::vector<LocalMotion>& motions);
/// The step of the case, as it is or as it comes out.
struct CaseStep {
    double length = 0.0;   // [s]
    std::string text;      // "steps of 350 ns on average"
    bool adaptive = false; // it is a mean of many, or the longest of them
};
/// "Steps of rk4 are stable up to 158 ns; the first to blow up is the motion in contact (2860 kHz)"; infinite: no
/// motion does.
std::string limitSentence(const std::string& subject, double limit, const std::string& first);
std::string motionText(const LocalMotion& motion);
/// A sentence for each method.
void tellLimits(const std::vector<LinearMethod>& methods, const std::vector<LocalMotion>& motions, const CaseStep& step,
                StudyReport& picture);

} // namespace touchdown
