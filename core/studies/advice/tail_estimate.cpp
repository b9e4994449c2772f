// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/tail_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

#include "core/numerics/spectrum.h"

namespace touchdown {

namespace {

constexpr double sameVariance = 0.1;        // change from block to block within which a variance stays [-]
constexpr double leak = 3e-3;               // of the spread, that a block's mean takes of a motion [-]
constexpr double slowestCreep = 0.9;        // of a mean, from block to block: slower ones have no end to be told [-]
constexpr double ringsTo = 0.1;             // of the spread: what a fit may leave [-]
constexpr std::array lessShares{0.9, 0.8};  // of the part, that predict the same
constexpr std::array seenShares{0.65, 0.5}; // of the part, that predict what was seen of it
constexpr double fewestTailSamples = 48.0;  // that tell anything

struct TailMoments {
    double mean = 0.0, variance = 0.0;
};

/// Between two times of a run [s].
struct Window {
    double from = 0.0, to = 0.0;
    double middle() const { return 0.5 * (from + to); }
};

template <typename Weight>
TailMoments moments(std::span<const double> values, Weight&& weight)
{
    // About the first, so that squares keep their digits.
    double sum = 0.0, first = 0.0, second = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double w = weight(k), d = values[k] - values[0];
        sum += w;
        first += w * d;
        second += w * d * d;
    }
    const double mean = first / sum;
    return {values[0] + mean, std::max(0.0, second / sum - mean * mean)};
}

TailMoments plain(std::span<const double> values)
{
    return moments(values, [](std::size_t) { return 1.0; });
}

TailMoments windowed(std::span<const double> values)
{
    const double step = 2.0 * std::numbers::pi / static_cast<double>(values.size());
    return moments(values, [step](std::size_t k) { return 1.0 - std::cos(step * (static_cast<double>(k) + 0.5)); });
}

/// r^n, averaged over n from a to b.
double meanPower(double r, double a, double b)
{
    const double rate = std::log(r);
    return std::abs(rate) * (b - a) < 1e-9 ? std::pow(r, a)
                                           : (std::exp(rate * b) - std::exp(rate * a)) / (rate * (b - a));
}

/// The variance over the tail, n blocks' distances after the third one, n from `from` to `to`; negative where the three
/// do not tell.
double foretoldVariance(double v1, double v2, double v3, double from, double to)
{
    const double d1 = v2 - v1, d2 = v3 - v2;
    double rest = v3, ratio = 1.0;
    if (d1 < 0.0 && d2 < 0.0) {
        ratio = d2 / d1;
        rest = ratio < 1.0 ? v3 + d2 * ratio / (1.0 - ratio) : -1.0;
        // The remainder is zero, or too small to be distinguished from zero.
        if (rest < 0.05 * v3) {
            rest = 0.0;
            ratio = std::sqrt(v3 / v1);
        }
    } else if (d1 > 0.0 && d2 > 0.0 && d2 < 0.9 * d1) {
        ratio = d2 / d1;
        rest = v3 + d2 * ratio / (1.0 - ratio);
    } else {
        return -1.0;
    }
    return rest + (v3 - rest) * meanPower(ratio, from, to);
}

TailMoments foretoldByBlocks(std::span<const double> spacing, double interval, Window window)
{
    const std::size_t block = spacing.size() / 4, first = spacing.size() - 2 * block;
    std::array<TailMoments, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = windowed(spacing.subspan(first + i * (block / 2), block));
    const double v1 = at[0].variance, v2 = at[1].variance, v3 = at[2].variance;
    const double average = (v1 + v2 + v3) / 3.0, averageMean = (at[0].mean + at[1].mean + at[2].mean) / 3.0;
    // The tail, in blocks' distances from the third one's middle.
    const double distance = 0.5 * static_cast<double>(block) * interval;
    const double middle = interval * (static_cast<double>(spacing.size()) - 0.5 * static_cast<double>(block));
    const double from = (window.from - middle) / distance, to = (window.to - middle) / distance;
    const bool stays = std::max(std::abs(v2 - v1), std::abs(v3 - v2)) <= sameVariance * average;
    const double variance = stays ? -1.0 : foretoldVariance(v1, v2, v3, from, to);
    TailMoments tail{averageMean, variance >= 0.0 ? variance : average};
    const double d1 = at[1].mean - at[0].mean, d2 = at[2].mean - at[1].mean, ratio = d2 / d1;
    if (std::abs(d1) > leak * std::sqrt(v1) && ratio > 0.0 && ratio < slowestCreep)
        // The mean creeps by itself.
        tail.mean = at[2].mean + d2 * ratio / (1.0 - ratio) * (1.0 - meanPower(ratio, from, to));
    else if (variance >= 0.0)
        tail.mean = at[2].mean + (variance - v3) * (at[2].mean - at[0].mean) / (v3 - v1);
    return tail;
}

/// What rings on. Nothing where the second half does not ring so, grows, or its mean does not stay.
std::optional<TailMoments> ringingMoments(std::span<const double> spacing, double interval, Window window,
                                          const std::vector<RingingRate>& rates)
{
    const std::span<const double> half = spacing.subspan(spacing.size() / 2);
    const std::optional<RingingFit> fit = fitRinging(half, interval, rates);
    if (!fit || fit->left > ringsTo * std::sqrt(plain(half).variance)) return {};
    for (const std::complex<double>& rate : fit->rates)
        if (rate.real() > 0.0) return {};
    const double begin = interval * static_cast<double>(spacing.size() / 2);
    const auto first = static_cast<std::size_t>(std::ceil(window.from / interval - 1e-6)),
               end = static_cast<std::size_t>(window.to / interval * (1.0 + 1e-9)) + 1;
    std::vector<double> tail;
    for (std::size_t k = first; k < end; ++k) tail.push_back(fit->at(static_cast<double>(k) * interval - begin));
    return plain(tail);
}

EndKind kindOf(std::span<const char> touching)
{
    const auto count = static_cast<std::size_t>(std::ranges::count_if(touching, [](char t) { return t != 0; }));
    return count == 0 ? EndKind::Flying : count == touching.size() ? EndKind::Contact : EndKind::Intermittent;
}

void forgetAll(TailEstimate& estimate)
{
    estimate.meanUncertainty = estimate.spreadUncertainty = std::numeric_limits<double>::infinity();
    estimate.sameKind = false;
}

TailMoments predicted(std::span<const double> spacing, double interval, Window window,
                      const std::vector<RingingRate>& rates)
{
    if (!rates.empty())
        if (const std::optional<TailMoments> ringing = ringingMoments(spacing, interval, window, rates))
            return *ringing;
    return foretoldByBlocks(spacing, interval, window);
}

} // namespace

bool SpacingSamples::reachEnd(double duration) const
{
    return !spacing.empty() && reached() > duration - interval * (1.0 - 1e-6);
}

SpacingSamples SpacingSamples::until(double time) const
{
    const auto count = std::min(spacing.size(), static_cast<std::size_t>(time / interval * (1.0 + 1e-9)) + 1);
    const auto end = static_cast<std::ptrdiff_t>(count);
    return {interval, {spacing.begin(), spacing.begin() + end}, {touching.begin(), touching.begin() + end}};
}

TailEstimate estimateTail(const SpacingSamples& samples, double duration, const std::vector<RingingRate>& rates)
{
    TailEstimate estimate;
    const std::span<const double> all = samples.spacing;
    const std::span<const char> touching = samples.touching;
    const std::size_t count = all.size();
    if (static_cast<double>(count) < fewestTailSamples) {
        forgetAll(estimate);
        return estimate;
    }

    const Spectrum spectrum = welch(all.subspan(count / 2), samples.interval,
                                    {.scaling = SpectrumScaling::Amplitude, .segment = count - count / 2});
    estimate.resolution = spectrum.equivalentNoiseBandwidth;
    if (const std::vector<Peak> peaks = findPeaks(spectrum, SpectrumScaling::Amplitude, 1); !peaks.empty()) {
        estimate.peakFrequency = peaks[0].frequency;
        estimate.peakAmplitude = peaks[0].amplitude;
    }
    if (samples.reachEnd(duration)) {
        const std::size_t first = std::min(
            count - 1, static_cast<std::size_t>(std::ceil((1.0 - tailShare) * duration / samples.interval - 1e-6)));
        const TailMoments tail = plain(all.subspan(first));
        estimate.mean = tail.mean;
        estimate.spread = std::sqrt(tail.variance);
        estimate.kind = kindOf(touching.subspan(first));
        return estimate;
    }
    if (static_cast<double>(count) * seenShares.back() < fewestTailSamples) {
        forgetAll(estimate);
        return estimate;
    }
    const double reached = samples.reached();
    const Window last{(1.0 - tailShare) * duration, duration};
    const TailMoments tail = predicted(all, samples.interval, last, rates);
    estimate.mean = tail.mean;
    estimate.spread = std::sqrt(tail.variance);
    estimate.kind = kindOf(touching.subspan(count - count / 4));
    // What hits is thrown back otherwise by the least difference: how long a bounce lasts no part of it tells.
    estimate.sameKind = estimate.kind != EndKind::Intermittent;
    const auto deviates = [&](const TailMoments& by, const TailMoments& from, double factor) {
        estimate.meanUncertainty = std::max(estimate.meanUncertainty, factor * std::abs(by.mean - from.mean));
        estimate.spreadUncertainty =
            std::max(estimate.spreadUncertainty, factor * std::abs(std::sqrt(by.variance) - std::sqrt(from.variance)));
    };
    for (const double share : lessShares) {
        const auto part = static_cast<std::size_t>(share * static_cast<double>(count));
        deviates(predicted(all.first(part), samples.interval, last, rates), tail, 1.0);
        estimate.sameKind = estimate.sameKind && kindOf(touching.subspan(part - part / 4, part / 4)) == estimate.kind;
    }
    for (const double share : seenShares) {
        const auto part = static_cast<std::size_t>(share * static_cast<double>(count));
        const double known = share * reached, length = std::min(tailShare * duration, reached - known);
        const double further = (last.middle() - reached) / (reached - 0.5 * length - known);
        // Every stretch of the tail's length: one of a slow wave may be met by chance.
        for (double to = reached; to - length >= known * (1.0 - 1e-9); to -= length) {
            const Window seen{to - length, to};
            const auto first = static_cast<std::size_t>(std::ceil(seen.from / samples.interval - 1e-6)),
                       end = std::min(count, static_cast<std::size_t>(seen.to / samples.interval * (1.0 + 1e-9)) + 1);
            deviates(predicted(all.first(part), samples.interval, seen, rates), plain(all.subspan(first, end - first)),
                     std::max(1.0, further));
        }
    }
    return estimate;
}

} // namespace touchdown
