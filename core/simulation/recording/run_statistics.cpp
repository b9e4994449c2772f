// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/run_statistics.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/simulation/recording/motion_verdict.h"

namespace touchdown {

namespace {

constexpr std::size_t mostSpectrumSamples = std::size_t{1} << 21; // 16 MiB

} // namespace

void BlockStatistics::Block::merge(const Block& other)
{
    // Chan, Golub & LeVeque 1979: pairwise update of the sum of squares.
    const double total = count + other.count;
    const double difference = other.mean - mean;
    squares += other.squares + difference * difference * count * other.count / total;
    mean += difference * other.count / total;
    count = total;
    min = std::min(min, other.min);
    max = std::max(max, other.max);
}

void BlockStatistics::add(double value)
{
    const Block one{1.0, value, 0.0, value, value};
    if (blocks_.empty() || blocks_.back().count >= double(blockLength_)) {
        if (blocks_.size() == mostBlocks) {
            for (std::size_t i = 0; i < mostBlocks / 2; ++i) {
                blocks_[2 * i].merge(blocks_[2 * i + 1]);
                blocks_[i] = blocks_[2 * i];
            }
            blocks_.resize(mostBlocks / 2);
            blockLength_ *= 2;
        }
        blocks_.push_back(one);
    } else {
        blocks_.back().merge(one);
    }
}

Statistics BlockStatistics::over(double begin, double end) const
{
    if (blocks_.empty()) return {};
    const double count = double(blocks_.size());
    const auto first = static_cast<std::size_t>(std::min(begin * count, count - 1.0));
    const auto last = std::max(first + 1, static_cast<std::size_t>(std::ceil(end * count)));
    Block sum = blocks_[first];
    for (std::size_t i = first + 1; i < std::min(last, blocks_.size()); ++i) sum.merge(blocks_[i]);
    return {sum.mean, std::sqrt(sum.squares / sum.count), sum.min, sum.max};
}

WelchOptions welchOptions(const SpectrumCase& spectrum, double interval)
{
    WelchOptions options;
    options.window = spectrum.window;
    options.scaling = spectrum.scaling;
    options.segment =
        std::max<std::size_t>(8, static_cast<std::size_t>(std::llround(std::min(spectrum.segment / interval, 1e15))));
    options.overlap = spectrum.overlap;
    return options;
}

RunStatistics::RunStatistics(const Case& c, const std::vector<Quantity>& quantities)
    : case_(c), quantities_(quantities), oscillates_(c.model != ModelKind::Contact)
{
    for (const char* name : {"flying_height", "minimum_spacing", "pitch", "roll", "contact_force"}) {
        const int column = findQuantity(quantities, name);
        if (column >= 0) columns_.push_back(static_cast<std::size_t>(column));
    }
    blocks_.resize(columns_.size());
    spacingColumn_ = static_cast<std::size_t>(findQuantity(quantities, "minimum_spacing"));
}

void RunStatistics::add(const SampleBatch& batch)
{
    for (std::size_t i = 0; i < columns_.size(); ++i)
        for (const double value : batch.columns[columns_[i]]) blocks_[i].add(value);
    const std::vector<double>& spacing = batch.columns[spacingColumn_];
    spacing_.insert(spacing_.end(), spacing.begin(), spacing.end());
    for (const double time : batch.time)
        if (time < case_.spectrum.start) ++beforeSpectrum_;
    if (spacing_.size() > 2 * mostSpectrumSamples) {
        const std::size_t dropped = spacing_.size() - mostSpectrumSamples;
        spacing_.erase(spacing_.begin(), spacing_.begin() + static_cast<std::ptrdiff_t>(dropped));
        beforeSpectrum_ -= std::min(beforeSpectrum_, dropped);
    }
    samples_ += batch.size();
}

void RunStatistics::finish(Summary& summary) const
{
    if (samples_ == 0) return;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const std::string& name = quantities_[columns_[i]].name;
        summary.tail.emplace_back(name, blocks_[i].over(0.9, 1.0));
    }
    if (!oscillates_) return;
    if (summary.status != RunStatus::Cancelled) judgeMotion(summary);
    const Spectrum spectrum = welch(std::span(spacing_).subspan(beforeSpectrum_), case_.run.sampleInterval,
                                    welchOptions(case_.spectrum, case_.run.sampleInterval));
    summary.peaks = findPeaks(spectrum, case_.spectrum.scaling);
}

void RunStatistics::judgeMotion(Summary& summary) const
{
    for (const bool third : {false, true}) {
        const MotionEvidence evidence = evidenceOf(summary, third);
        summary.motion = motionOf(evidence);
        summary.bouncingRule = motionRule(evidence);
        if (summary.motion != Motion::TooShort || evidence.swing <= smallestSwing) return;
    }
}

MotionEvidence RunStatistics::evidenceOf(const Summary& summary, bool third) const
{
    const double share = third ? 1.0 / 3.0 : 0.1;
    const auto last = [&](double part) {
        const auto count = static_cast<std::size_t>(part * static_cast<double>(samples_));
        return std::span(spacing_).last(std::min(spacing_.size(), count));
    };
    MotionEvidence evidence{.third = third,
                            .periods = periodsOf(last(share)),
                            .movesOn = movesOn(last(0.5)),
                            .samples = last(share).size()};
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const Statistics window = blocks_[i].over(1.0 - share, 1.0);
        const Statistics before = blocks_[i].over(1.0 - 2.0 * share, 1.0 - share);
        const std::string& name = quantities_[columns_[i]].name;
        if (name == "minimum_spacing") {
            evidence.swing = window.max - window.min;
            evidence.swingBefore = before.max - before.min;
        }
        if (name == "contact_force") evidence.touches = window.max > 0.0;
    }
    // Contact shorter than the interval of the samples.
    for (const RunEvent& event : summary.events)
        if (event.time >= (1.0 - share) * summary.endTime && event.name == "touch-down") evidence.touches = true;
    return evidence;
}

} // namespace touchdown
