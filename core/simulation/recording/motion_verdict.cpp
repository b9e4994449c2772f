// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/motion_verdict.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/formats/units.h"
#include "core/numerics/moments.h"
#include "core/numerics/spectrum.h"

namespace touchdown {

namespace {

using Rule = MotionRule;
constexpr double smallestGrowth = 1.5;          // of a small swing, from part to part [-]
constexpr double roundOff = 1e-13;              // of a swing at rest [m]
constexpr double mostPerSample = 0.8;           // changes that samples can show: a period is 2.5 of them
constexpr std::array shares{0.1, 0.2, 1.0 / 3}; // of the last part, of the time after the landing

/// Changes of a signal from below a low value to above a high one and back.
struct Changes {
    int count = 0;
    std::array<double, 2> first{}, last{}; // of the rises and falls, as they come: where they end [samples]

    /// From one to the next in the same direction, in the mean [samples]; 0 where there is no whole one.
    double period() const
    {
        const int halves = std::max(count - 1, 0), rises = halves / 2, falls = (halves - 1) / 2; // periods of each
        return rises > 0 ? (last[0] - first[0] + last[1] - first[1]) / (rises + falls) : 0.0;
    }
};
/// The same, their number alone.
int countChanges(std::span<const double> signal, double low, double high)
{
    int count = 0, side = 0;
    for (const double value : signal) {
        const int now = value < low ? -1 : value > high ? 1 : side;
        if (side != 0 && now != side) ++count;
        side = now;
    }
    return count;
}

/// Extremes and contact over a range of samples.
class Part {
public:
    Part(const MotionSamples& samples, std::size_t begin, std::size_t end) : samples_(samples), begin_(begin), end_(end)
    {}

    double least() const { return *std::ranges::min_element(of(samples_.least)); }
    double most() const { return *std::ranges::max_element(of(samples_.most)); }
    double swing() const { return begin_ < end_ ? most() - least() : 0.0; }
    double rms() const { return momentsOf(of(samples_.spacing)).deviation; }
    std::span<const double> spacing() const { return of(samples_.spacing); }
    std::size_t size() const { return end_ - begin_; }
    /// Changes between the lowest and the highest quarter of the range, also between samples: at least as many as these
    /// and the extremes show.
    Changes changes() const
    {
        Changes found;
        const double low = least() + 0.25 * swing(), high = most() - 0.25 * swing();
        int side = 0;
        const auto cross = [&](std::size_t i, int to) {
            if (side != 0) {
                const auto direction = static_cast<std::size_t>(found.count % 2);
                // Between samples on a straight line, where these enclose the limit.
                const double before = samples_.spacing[i - 1], now = samples_.spacing[i], limit = to > 0 ? high : low,
                             part = (limit - before) / (now - before);
                found.last[direction] = double(i) - (part > 0.0 && part < 1.0 ? 1.0 - part : 0.0);
                if (found.count++ < 2) found.first[direction] = found.last[direction];
            }
            side = to;
        };
        for (std::size_t i = begin_; i < end_ && high > low; ++i) {
            const double now = samples_.spacing[i];
            // The extremes reach back to the sample before, where the side was the present one.
            if (side < 0 && samples_.most[i] > high)
                cross(i, 1);
            else if (side > 0 && samples_.least[i] < low)
                cross(i, -1);
            if (now > high && side <= 0) cross(i, 1);
            if (now < low && side >= 0) cross(i, -1);
        }
        return found;
    }
    std::size_t switches() const
    {
        // A sample stands for the interval that it ends.
        const auto timeOf = [&](std::size_t i) { return samples_.first + (double(i) - 1.0) * samples_.interval; };
        const auto from = std::ranges::upper_bound(samples_.switches, timeOf(begin_));
        return std::size_t(std::ranges::upper_bound(from, samples_.switches.end(), timeOf(end_)) - from);
    }
    Touch touch() const
    {
        const std::span all = std::span(samples_.touch).subspan(begin_, size());
        const auto is = [](Touch wanted) { return [wanted](Touch each) { return each == wanted; }; };
        if (switches() == 0) {
            if (std::ranges::all_of(all, is(Touch::Never))) return Touch::Never;
            if (std::ranges::all_of(all, is(Touch::Always))) return Touch::Always;
        }
        return Touch::AtTimes;
    }

private:
    std::span<const double> of(const std::vector<double>& all) const { return std::span(all).subspan(begin_, size()); }
    const MotionSamples& samples_;
    std::size_t begin_, end_;
};

/// The first sample in the range that the last tenth has.
std::size_t landingOf(const MotionSamples& samples)
{
    const std::size_t count = samples.spacing.size();
    const Part tenth(samples, count - std::max<std::size_t>(1, count / 10), count);
    const double least = tenth.least(), most = tenth.most();
    for (std::size_t i = 0; i < count; ++i)
        if (samples.least[i] <= most && samples.most[i] >= least) return i;
    return 0;
}

/// Of the last part, in samples: the share of the time after the landing; over a moving surface up to half of the run
/// without the landing, where the rarest feature or the whole surface needs this, and whole periods of the surface.
double lengthOfPart(const MotionSamples& samples, std::size_t landing, double share)
{
    const double all = double(samples.spacing.size() - landing);
    double length = share * all;
    if (samples.surface.moves()) {
        const double wait = samples.surface.wait / samples.interval, period = samples.surface.period / samples.interval;
        const double most = std::min(0.5 * double(samples.spacing.size()), all);
        if (length < wait) length = std::min(wait, most);
        if (period <= most) length = std::max(1.0, std::floor(length / period)) * period;
    }
    return std::max(1.0, length);
}

/// Of the largest peak, where at least half of the variance lies about it [Hz]; else 0.
double frequencyOf(std::span<const double> signal, double interval)
{
    constexpr double about = 1.25; // the ratio of a frequency to the peak's, or the other way round
    constexpr double most = 0.5;
    const double deviation = momentsOf(signal).deviation;
    WelchOptions options;
    options.segment = std::max<std::size_t>(8, signal.size() / 2);
    const Spectrum spectrum = welch(signal, interval, options);
    if (spectrum.empty()) return 0.0;
    const std::vector<Peak> peaks = findPeaks(spectrum, options.scaling, 1, 1.0);
    const double frequency = peaks.empty() ? 0.0 : peaks.front().frequency;
    if (frequency < Rule::fewestPeriods * spectrum.frequency[1]) return 0.0;
    double variance = 0.0; // about the peak: its bin and the neighbours hold a sine
    for (std::size_t k = 0; k < spectrum.power.size(); ++k) {
        const double width = 2.0 * spectrum.frequency[1], at = spectrum.frequency[k];
        if (at > std::min(frequency / about, frequency - width) && at < std::max(frequency * about, frequency + width))
            variance += spectrum.power[k] * spectrum.frequency[1];
    }
    return variance >= most * deviation * deviation ? frequency : 0.0;
}

MotionEvidence evidenceOf(const MotionSamples& samples, std::size_t landing, double share)
{
    const std::size_t count = samples.spacing.size();
    const double wanted = lengthOfPart(samples, landing, share);
    const auto length = std::size_t(wanted);
    MotionEvidence evidence{.share = share, .parts = 0, .surface = samples.surface};
    evidence.length = wanted * samples.interval;
    evidence.duration = double(count) * samples.interval;
    // Over a moving surface the part before the last may hold the landing: it then differs, or does not matter.
    const std::size_t from = samples.surface.moves() ? 0 : landing;
    std::size_t begin = count;
    for (; evidence.parts < evidence.swings.size() && begin >= from + length; begin -= length)
        evidence.swings[evidence.parts++] = Part(samples, begin - length, begin).swing();
    evidence.oneLaw = Part(samples, begin, count).touch() != Touch::AtTimes;
    const Part last(samples, count - length, count);
    const Part before(samples, evidence.parts > 1 ? count - 2 * length : count - length, count - length);
    evidence.rms = last.rms();
    evidence.rmsBefore = evidence.parts > 1 ? before.rms() : evidence.rms;
    const Changes changes = last.changes();
    evidence.periods = 0.5 * changes.count;
    evidence.undersampled = changes.count > mostPerSample * static_cast<double>(last.size());
    evidence.touch = last.touch();
    evidence.touchBefore = evidence.parts > 1 ? before.touch() : evidence.touch;
    const std::size_t lately = std::max((count - landing) / 3, std::min(2 * length, count - landing));
    evidence.switchedLately = Part(samples, count - lately, count).touch() == Touch::AtTimes;
    evidence.samples = last.size();
    if (evidence.undersampled) return evidence;
    if (samples.surface.moves())
        evidence.frequency = frequencyOf(last.spacing(), samples.interval);
    else if (const double period = changes.period(); period > 0.0)
        evidence.frequency = 1.0 / (period * samples.interval);
    return evidence;
}

bool isSmall(const MotionEvidence& evidence) { return evidence.swing() <= Rule::smallestSwing; }

Motion motionOf(const MotionEvidence& evidence)
{
    if (evidence.samples < Rule::fewestSamples || evidence.awaitsSurface()) return Motion::TooShort;
    if (isSmall(evidence)) return evidence.movesOn() || evidence.grows() ? Motion::TooShort : Motion::AtRest;
    if (evidence.lacksPeriods()) return Motion::TooShort;
    if (evidence.decays())
        return evidence.surface.moves() || evidence.touch == Touch::AtTimes || evidence.switchedLately
                   ? Motion::TooShort
                   : Motion::Settles;
    if (!evidence.isSteady()) return Motion::TooShort;
    return evidence.touch == Touch::Never    ? Motion::Swings
           : evidence.touch == Touch::Always ? Motion::Vibrates
                                             : Motion::Bounces;
}

std::string ruleOf(const MotionEvidence& evidence, Motion motion)
{
    const auto nm = [](double x) { return formatNumber(std::round(x * 1e13) / 1e13, "nm") + " nm"; };
    const std::string share = evidence.share < 0.15 ? "tenth" : evidence.share < 0.25 ? "fifth" : "third";
    const std::string part = evidence.surface.moves() ? fewDigitsOfTime(evidence.length, 2) : share;
    if (evidence.samples < Rule::fewestSamples)
        return "the last " + part + " of the run holds " + std::to_string(evidence.samples) + " samples, and " +
               std::to_string(Rule::fewestSamples) + " are needed to tell";
    if (evidence.awaitsSurface()) {
        const bool repeats = evidence.surface.wait > 0.5 * evidence.surface.period;
        return std::string(repeats ? "the disk's surface repeats under the slider every "
                                   : "the rarest feature of the disk's surface comes under the slider within every ") +
               fewDigitsOfTime(repeats ? evidence.surface.period : evidence.surface.wait, 3) +
               (evidence.lastsSoLong()
                    ? ", and the run after the landing is " + part + ": a longer run can tell"
                    : ", and half of the run without the landing is " + part + ": a run of at least " +
                          fewDigitsOfTime(evidence.telling(), 2) + " is needed to tell");
    }
    const bool small = isSmall(evidence);
    std::string figures =
        "over the last " + part + " of the run after the landing the minimum spacing swings by " + nm(evidence.swing());
    if (!small)
        figures += (evidence.undersampled ? " in more than " : " in ") + formatNumber(evidence.periods) +
                   (evidence.periods == 1.0 ? " period" : " periods");
    if (evidence.parts > 1) figures += ", after " + nm(evidence.swings[1]) + " over the " + part + " before";
    if (!small) {
        figures += evidence.touch == Touch::Never    ? ", without contact"
                   : evidence.touch == Touch::Always ? ", always in contact"
                                                     : ", and the slider touches the disk and takes off";
    }
    switch (motion) {
    case Motion::NotJudged: break;
    case Motion::AtRest: return figures + "; up to " + nm(Rule::smallestSwing) + " counts as rest";
    case Motion::TooShort:
        if (small)
            return figures + (evidence.grows() ? ", and it grows" : ", but it was still moving on") +
                   ": a longer run can tell";
        if (evidence.lacksPeriods())
            return figures + "; " + formatNumber(Rule::fewestPeriods) + " periods are needed to tell";
        if (evidence.decays()) return figures + "; the motion still decays: a longer run can tell";
        if (evidence.surface.moves() && evidence.rmsBefore < Rule::forcedDecay * evidence.rms)
            return figures + "; the motion still grows: a longer run can tell";
        return figures + "; the contact was another shortly before: a longer run can tell";
    case Motion::Settles:
        return figures + (evidence.decaysFast()
                              ? "; less than 90 % of the swing before counts as decay"
                              : "; in the mean of three parts it is less than 97 % of that in the three before: this "
                                "counts as slow decay");
    case Motion::Swings:
    case Motion::Vibrates:
    case Motion::Bounces:
        if (evidence.surface.moves())
            return figures + "; the standard deviation is " + nm(evidence.rms) + ", after " + nm(evidence.rmsBefore) +
                   ", and at least 60 % of that before counts as sustained; the disk drives the motion, as its surface "
                   "is not flat and moves";
        return figures + "; at least 90 % of the swing before counts as sustained";
    }
    return figures;
}

} // namespace

void MotionSamples::add(double s, double lowest, double highest, Touch touching)
{
    spacing.push_back(s);
    least.push_back(lowest);
    most.push_back(highest);
    touch.push_back(touching);
}

void MotionSamples::dropFirst(std::size_t count)
{
    const auto drop = [&](auto& values) { values.erase(values.begin(), values.begin() + std::ptrdiff_t(count)); };
    drop(spacing);
    drop(least);
    drop(most);
    drop(touch);
    first += double(count) * interval;
}

bool MotionEvidence::decaysFast() const
{
    if (surface.moves()) return rms < Rule::forcedDecay * rmsBefore;
    return parts > 1 && swings[0] < Rule::smallestDecay * swings[1];
}

bool MotionEvidence::decaysSlowly() const
{
    if (surface.moves() || parts < swings.size() || !oneLaw) return false;
    return swings[0] + swings[1] + swings[2] < Rule::slowDecay * (swings[3] + swings[4] + swings[5]);
}

bool MotionEvidence::isSteady() const
{
    if (surface.moves()) return touch == touchBefore && rmsBefore >= Rule::forcedDecay * rms;
    return touch == Touch::AtTimes || !switchedLately;
}

double MotionEvidence::telling() const
{
    const double time = 1.02 * 2.0 * surface.wait; // a little more: the parts are whole samples
    const double digit = std::pow(10.0, std::floor(std::log10(time)) - 1.0);
    return std::ceil(time / digit) * digit;
}

bool MotionEvidence::grows() const
{
    return parts > 2 && swings[0] > roundOff && swings[0] > smallestGrowth * swings[1] &&
           swings[1] > smallestGrowth * swings[2];
}

bool MotionEvidence::movesOn() const
{
    if (!movedOn || parts < 3 || swings[0] <= roundOff) return movedOn && parts < 3;
    const double rate = std::max(swings[0] / swings[1], swings[1] / swings[2]);
    return !(rate < Rule::smallestDecay) || swings[0] * rate / (1.0 - rate) > Rule::smallestSwing;
}

MotionVerdict verdictOf(const MotionEvidence& evidence)
{
    MotionVerdict verdict;
    verdict.motion = motionOf(evidence);
    verdict.touch = evidence.touch;
    verdict.forced = evidence.surface.moves() && lasts(verdict.motion);
    verdict.swing = evidence.swing();
    verdict.rms = evidence.rms;
    verdict.frequency = lasts(verdict.motion) || verdict.motion == Motion::Settles ? evidence.frequency : 0.0;
    verdict.undersampled = !isSmall(evidence) && evidence.undersampled;
    verdict.rule = ruleOf(evidence, verdict.motion);
    return verdict;
}

MotionVerdict judgeMotion(const MotionSamples& samples)
{
    if (samples.spacing.empty()) return {};
    const bool forced = samples.surface.moves();
    MotionEvidence whole = evidenceOf(samples, 0, forced ? shares.back() : shares.front());
    if (isSmall(whole)) {
        whole.movedOn = movesOn(std::span(samples.spacing).last((samples.spacing.size() + 1) / 2));
        return verdictOf(whole);
    }
    const std::size_t landing = landingOf(samples);
    MotionEvidence evidence;
    for (const double share : shares) {
        if (forced && share < shares.back()) continue;
        evidence = evidenceOf(samples, landing, share);
        if (evidence.samples >= Rule::fewestSamples && evidence.periods >= Rule::fewestPeriods) break;
    }
    return verdictOf(evidence);
}

bool movesOn(std::span<const double> lastHalf)
{
    if (lastHalf.empty()) return false;
    const auto [least, most] = std::ranges::minmax(lastHalf);
    if (most - least < 3.0 * Rule::smallestSwing) return false;
    const std::span<const double> window = lastHalf.last(std::max<std::size_t>(1, lastHalf.size() / 5));
    const double mean = std::accumulate(window.begin(), window.end(), 0.0) / static_cast<double>(window.size());
    return countChanges(lastHalf, mean - 0.5 * Rule::smallestSwing, mean + 0.5 * Rule::smallestSwing) < 2;
}

bool isFolded(const MotionSamples& samples, std::size_t first)
{
    constexpr double turnedBack = 0.3;
    double excess = 0.0, amplitudes = 0.0, largest = 0.0;
    const std::size_t count = samples.spacing.size();
    const auto low = [&](std::size_t k) {
        return std::min({samples.least[k], samples.spacing[k], samples.spacing[k - 1]});
    };
    const auto high = [&](std::size_t k) {
        return std::max({samples.most[k], samples.spacing[k], samples.spacing[k - 1]});
    };
    for (std::size_t k = first + 2; k + 1 < count; ++k) {
        excess += high(k) - low(k) - std::abs(samples.spacing[k] - samples.spacing[k - 1]);
        const double amplitude =
            0.5 * (std::max({high(k - 1), high(k), high(k + 1)}) - std::min({low(k - 1), low(k), low(k + 1)}));
        amplitudes += amplitude;
        largest = std::max(largest, amplitude);
    }
    return largest > 0.5 * Rule::smallestSwing && excess > turnedBack * amplitudes;
}

} // namespace touchdown
