// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics of a run while it advances, in bounded memory.
#pragma once

#include <cstddef>
#include <vector>

#include "core/case/case.h"
#include "core/simulation/recording/motion_verdict.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

/// Count, mean, variance and extremes of blocks of equal length; when there are too many, neighbours are merged.
class BlockStatistics {
public:
    void add(double value);
    /// Over the samples from the share `begin` to `end` of all (0..1), to whole blocks. At least one block.
    Statistics over(double begin, double end) const;

private:
    struct Block {
        double count = 0.0, mean = 0.0, squares = 0.0; // squares: sum of (x - mean)^2
        double min = 0.0, max = 0.0;
        void merge(const Block& other);
    };
    static constexpr std::size_t mostBlocks = 4096;
    std::vector<Block> blocks_;
    std::size_t blockLength_ = 1; // samples
};

/// Takes the samples of a run and fills the statistical part of its Summary.
class RunStatistics {
public:
    RunStatistics(const Case& c, const std::vector<Quantity>& quantities);
    void add(const SampleBatch& batch);
    /// Sets tail, motion, bouncingRule and peaks of a summary with its end time and events.
    void finish(Summary& summary) const;

private:
    void judgeMotion(Summary& summary) const;
    MotionEvidence evidenceOf(const Summary& summary, bool third) const;

    const Case& case_;
    const std::vector<Quantity>& quantities_;
    bool oscillates_;                  // a pad that is moved does not
    std::vector<std::size_t> columns_; // of the tail quantities
    std::vector<BlockStatistics> blocks_;
    std::size_t spacingColumn_;
    std::vector<double> spacing_;    // the newest samples of the minimum spacing [m]
    std::size_t beforeSpectrum_ = 0; // of these, before the spectrum's start
    std::size_t samples_ = 0;
};

/// Welch options for signals sampled every `interval` [s].
WelchOptions welchOptions(const SpectrumCase& spectrum, double interval);

} // namespace touchdown
