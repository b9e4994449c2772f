// SPDX-License-Identifier: GPL-3.0-or-later
//
// The times of samples, which quantities that are sampled together share. They never decrease. The first time of each
// block of samples stays in memory, so that a search reads at most one block from the disk.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "ui/plot/sample_column.h"

namespace touchdown {

class SampleTimes {
public:
    static constexpr std::size_t blockSize = 64; // samples

    SampleTimes() = default;
    /// The first `count` times of another axis.
    SampleTimes(const SampleTimes& other, std::size_t count);

    /// See SampleColumn::twin().
    std::shared_ptr<SampleTimes> twin() const;

    std::size_t size() const { return column_.size(); }
    /// The start of a block never waits for the disk.
    double operator[](std::size_t index) const
    {
        return index % blockSize == 0 ? starts_[index / blockSize] : column_[index];
    }
    /// Not before the last one.
    void push_back(double time);

    /// The first block at or after `from` that begins at `time` or later; the number of blocks if there is none. Quick
    /// if that block is near.
    std::size_t blockFrom(double time, std::size_t from = 0) const;
    /// The first sample at `time` or later.
    std::size_t lowerBound(double time) const;
    /// The same where `block` is blockFrom(time) and not 0.
    std::size_t lowerBoundBefore(std::size_t block, double time) const;
    /// The first sample later than `time`.
    std::size_t upperBound(double time) const;

    SampleColumn& column() { return column_; }
    const SampleColumn& column() const { return column_; }
    void shrink();
    std::size_t bytesInMemory() const { return column_.bytesInMemory() + starts_.capacity() * sizeof(double); }

private:
    template <class IsBefore>
    std::size_t firstNot(std::size_t block, const IsBefore& isBefore) const;

    SampleColumn column_;
    std::vector<double> starts_; // of each block, also of the last one
};

} // namespace touchdown
