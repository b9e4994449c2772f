// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/rank_correlation.h"

#include <algorithm>
#include <numeric>

#include "core/numerics/moments.h"

namespace touchdown {

namespace {

/// From 1; equal values share their mean rank.
std::vector<double> ranksOf(const std::vector<double>& values)
{
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
    std::vector<double> ranks(values.size());
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin;
        while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
        for (std::size_t k = begin; k < end; ++k) ranks[order[k]] = 0.5 * double(begin + end + 1);
        begin = end;
    }
    return ranks;
}

} // namespace

double rankCorrelation(const std::vector<double>& x, const std::vector<double>& y)
{
    const std::vector<double> a = ranksOf(x), b = ranksOf(y);
    if (a.empty()) return 0.0;
    const Moments of = momentsOf(a), with = momentsOf(b);
    if (!(of.deviation > 0.0) || !(with.deviation > 0.0)) return 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - of.mean) * (b[i] - with.mean);
    return sum / (double(a.size()) * of.deviation * with.deviation);
}

} // namespace touchdown
