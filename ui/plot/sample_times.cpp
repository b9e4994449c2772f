// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/sample_times.h"

namespace touchdown {

SampleTimes::SampleTimes(const SampleTimes& other, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i) push_back(other[i]);
}

std::shared_ptr<SampleTimes> SampleTimes::twin() const
{
    auto same = std::make_shared<SampleTimes>();
    same->column_ = column_.twin();
    same->starts_ = starts_;
    return same;
}

void SampleTimes::push_back(double time)
{
    if (column_.size() % blockSize == 0) starts_.push_back(time);
    column_.push_back(time);
}

void SampleTimes::shrink()
{
    column_.shrink();
    starts_.shrink_to_fit();
}

std::size_t SampleTimes::blockFrom(double time, std::size_t from) const
{
    const auto at = [this](std::size_t i) { return starts_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::size_t reach = 1;
    while (from + reach < starts_.size() && starts_[from + reach] < time) reach *= 2;
    from = std::min(from, starts_.size());
    const auto last = at(std::min(from + reach, starts_.size()));
    return static_cast<std::size_t>(std::lower_bound(at(from), last, time) - starts_.begin());
}

/// The first sample that is not before. `block` is the first whose start is not before, and not 0.
template <class IsBefore>
std::size_t SampleTimes::firstNot(std::size_t block, const IsBefore& isBefore) const
{
    std::size_t first = (block - 1) * blockSize + 1, last = std::min(block * blockSize, size());
    while (first < last) {
        const std::size_t middle = first + (last - first) / 2;
        if (isBefore(column_[middle]))
            first = middle + 1;
        else
            last = middle;
    }
    return first;
}

std::size_t SampleTimes::lowerBoundBefore(std::size_t block, double time) const
{
    return firstNot(block, [time](double each) { return each < time; });
}

std::size_t SampleTimes::lowerBound(double time) const
{
    const auto block = std::ranges::lower_bound(starts_, time) - starts_.begin();
    return block == 0 ? 0 : lowerBoundBefore(static_cast<std::size_t>(block), time);
}

std::size_t SampleTimes::upperBound(double time) const
{
    const auto block = std::ranges::upper_bound(starts_, time) - starts_.begin();
    return block == 0 ? 0 : firstNot(static_cast<std::size_t>(block), [time](double each) { return !(time < each); });
}

} // namespace touchdown
