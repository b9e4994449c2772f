// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace touchdown {

/// Spearman's rank correlation (Spearman 1904): of the ranks of the values, equal values sharing their mean rank; 0
/// where one of the lists does not change. Both are as long; their numbers are finite.
double rankCorrelation(const std::vector<double>& x, const std::vector<double>& y);

} // namespace touchdown
