// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values of a column of samples of a run: over its last tenth, or from any time on.
#pragma once

#include <span>
#include <string>

namespace touchdown {

struct Case;
struct MeasuredRun;

/// The samples from `begin` [s] on, at equal intervals: without a last one between two of them, if there are others.
std::span<const double> evenSamples(const Case& c, const MeasuredRun& run, std::span<const double> column,
                                    double begin);
/// Those over the last tenth of the run, which has samples.
std::span<const double> tailSamples(const Case& c, const MeasuredRun& run, std::span<const double> column);
/// Peak to peak there: between samples, too, where the run itself states it. There is a sample [unit of the column].
double tailSwing(const Case& c, const MeasuredRun& run, const std::string& quantity, std::span<const double> column);

} // namespace touchdown
