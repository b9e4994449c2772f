// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/sampled_values.h"

#include <algorithm>

#include "core/case/case.h"
#include "core/simulation/recording/last_sample.h"
#include "core/studies/runs/measured_run.h"

namespace touchdown {

std::span<const double> evenSamples(const Case& c, const MeasuredRun& run, std::span<const double> column, double begin)
{
    const auto first = std::size_t(std::ranges::lower_bound(run.time, begin) - run.time.begin());
    const std::span<const double> samples = column.subspan(std::min(first, column.size()));
    const bool between = samples.size() > 1 && isBetweenSamples(run.time.back(), c.run.sampleInterval);
    return samples.first(samples.size() - between);
}

std::span<const double> tailSamples(const Case& c, const MeasuredRun& run, std::span<const double> column)
{
    return evenSamples(c, run, column, (1.0 - tailShare) * run.time.back());
}

double tailSwing(const Case& c, const MeasuredRun& run, const std::string& quantity, std::span<const double> column)
{
    if (const Statistics* tail = valueIn(run.summary.tail, quantity)) return tail->max - tail->min;
    const auto [least, most] = std::ranges::minmax(tailSamples(c, run, column));
    return most - least;
}

} // namespace touchdown
