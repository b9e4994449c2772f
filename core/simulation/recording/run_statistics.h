// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics of a run while it advances, in bounded memory.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/case/case.h"
#include "core/simulation/recording/motion_verdict.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

/// Count, mean, variance and extremes of blocks of equal length; when there are too many, neighbours are merged.
class BlockStatistics {
public:
    void add(double value) { add(value, value, value); }
    /// A sample, and the extremes since the sample before. Only the last sample may have a weight less than 1, where
    /// the time since the sample before is that part of an interval.
    void add(double value, double least, double most, double weight = 1.0);
    /// Over the samples from the share `begin` to `end` of their time (0..1), to whole blocks. At least one block.
    Statistics over(double begin, double end) const;
    void pass(auto& stream) { stream(blocks_, blockLength_); }

private:
    struct Block {
        double count = 0.0, mean = 0.0, squares = 0.0; // squares: sum of (x - mean)^2; each sample by its weight
        double min = 0.0, max = 0.0;
        void merge(const Block& other);
    };
    static constexpr std::size_t mostBlocks = 4096;
    std::vector<Block> blocks_;
    std::size_t blockLength_ = 1; // samples
};

/// What acts between pad and disk in a sample. Ono & Yamane's menisci hold the pad where its asperities do not touch
/// any more; adhesion of surfaces reaches beyond contact.
class TouchColumns {
public:
    TouchColumns(const Case& c, const std::vector<Quantity>& quantities);
    /// `valueOf(column)` is the value of a column [N].
    template <class ValueOf>
    bool touches(ValueOf&& valueOf) const
    {
        return acts(contact_, valueOf) || (menisci_ && acts(adhesion_, valueOf));
    }
    /// From afar, too.
    template <class ValueOf>
    bool acts(ValueOf&& valueOf) const
    {
        return acts(contact_, valueOf) || acts(adhesion_, valueOf);
    }
    /// Between two samples, from the extremes of each column there.
    Touch between(std::span<const double> least, std::span<const double> most) const;

private:
    template <class ValueOf>
    static bool acts(int column, ValueOf&& valueOf)
    {
        return column >= 0 && valueOf(static_cast<std::size_t>(column)) != 0.0;
    }
    int contact_, adhesion_;
    bool menisci_;
};

/// Takes the samples of a run and fills the statistical part of its Summary.
class RunStatistics {
public:
    RunStatistics(const Case& c, const std::vector<Quantity>& quantities);
    /// How often the disk's surface comes again under a slider.
    void moveOver(const SurfaceRecurrence& surface) { motion_.surface = surface; }
    /// By quantity: the values, and their extremes since the sample before.
    void addSample(double time, std::span<const double> values, std::span<const double> least,
                   std::span<const double> most);
    /// Sets tail, extremes, verdict and peaks of a summary with its end time and events.
    void finish(Summary& summary) const;
    void pass(auto& stream)
    {
        stream.fixed(blocks_);
        stream.fixed(extremes_);
        stream(motion_.spacing, motion_.least, motion_.most, motion_.touch, motion_.first, beforeSpectrum_, newestTime_,
               samples_);
        const std::size_t count = motion_.spacing.size();
        stream.require(motion_.least.size() == count && motion_.most.size() == count && motion_.touch.size() == count &&
                       beforeSpectrum_ <= count);
    }

private:
    const Case& case_;
    const std::vector<Quantity>& quantities_;
    bool oscillates_;                  // a pad that is moved does not
    std::vector<std::size_t> columns_; // of the tail quantities
    std::vector<BlockStatistics> blocks_;
    std::vector<Extremes> extremes_; // of all quantities over the whole run
    std::size_t spacingColumn_;
    TouchColumns touch_;
    MotionSamples motion_;           // the newest samples
    std::size_t beforeSpectrum_ = 0; // of these, before the spectrum's start
    double newestTime_ = 0.0;        // of the newest sample [s]
    std::size_t samples_ = 0;
};

/// Welch options for signals sampled every `interval` [s].
WelchOptions welchOptions(const SpectrumCase& spectrum, double interval);

} // namespace touchdown
