// SPDX-License-Identifier: GPL-3.0-or-later
//
// What one axis of a sweep varies.
#pragma once

#include <string>
#include <vector>

#include "core/studies/runs/joint_key.h"

namespace touchdown {

struct SweepValue {
    double number = 0.0; // [unit of the axis]; where its key is no number, the place in the list, from 1
    std::string text{};  // as a case file writes it; of keys that are no number
};

struct SweepAxis {
    Parameter key; // of one or of several that move together
    ParameterText text;
    bool isNumber = true;
    bool logarithmic = false;
    bool average = false;               // readings are averaged over it
    std::vector<SweepValue> values{};   // of a grid, or to be drawn from
    double from = 0.0, to = 0.0;        // of samples, where there are no values [unit]
    double mean = 0.0, deviation = 0.0; // of a normal distribution between from and to; 0: even [unit]

    /// The value that a share of the probability lies below.
    SweepValue at(double share) const;
    std::string nameOf(const SweepValue& value) const;
    /// "springs_flying_height".
    std::string columnName() const;
};

} // namespace touchdown
