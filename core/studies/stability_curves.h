// SPDX-License-Identifier: GPL-3.0-or-later
//
// Panels, tables and sentences of which the linear picture of stability is made.
#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "core/numerics/stability_region.h"
#include "core/studies/stability_picture.h"

namespace touchdown {

struct LinearMethod {
    std::string name;     // "rk4"
    std::string sentence; // as the subject of a sentence
    Growth growth;
    bool isTheCases = false;
};

/// Of the fastest rate [-].
double dampingRatio(const LocalMotion& motion);

ChartPanel regionPanel(const std::vector<LinearMethod>& methods, const PlaneWindow& window);
/// Eigenvalues times the step, of both halves of the plane.
void addEigenvalues(ChartPanel& panel, const std::vector<LocalMotion>& motions, double step);

/// Growth of an oscillation with this damping ratio, against omega h.
ChartPanel growthPanel(const std::vector<LinearMethod>& methods, double damping, double from, double to);
void addGrowth(ChartPanel& panel, const std::string& name, const std::function<double(double)>& growth, double from, double to);
void addStepBands(ChartPanel& panel, const std::vector<LocalMotion>& motions, double step);

StudyTable limitTable(const std::vector<LinearMethod>& methods, const std::vector<LocalMotion>& motions, double step);
StudyTable eigenvalueTable(const std::vector<LocalMotion>& motions);
/// A sentence for each method. `which`: "its step of "; `adaptive`: the step is a mean of many.
void tellLimits(const std::vector<LinearMethod>& methods, const std::vector<LocalMotion>& motions, double step, const std::string& which,
                bool adaptive, LinearPicture& picture);

/// As makeLinearPicture; of springs, of a film.
bool makeSpringPicture(const Case& c, LinearPicture& picture, const std::function<bool()>& goOn);
bool makeFilmPicture(const Case& c, LinearPicture& picture, const std::function<bool()>& goOn);

} // namespace touchdown
