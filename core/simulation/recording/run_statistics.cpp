// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/run_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/case/contact_law.h"
#include "core/formats/units.h"
#include "core/simulation/recording/last_sample.h"
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

void BlockStatistics::add(double value, double least, double most, double weight)
{
    const Block one{weight, value, 0.0, least, most};
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
    constexpr double rounding = 1e-9; // [blocks]
    const double count = double(blocks_.size());
    // From the first block to the last: a last sample between two others ends a part of an interval after them.
    const double length = count < 2.0 ? 0.0 : count - 2.0 + std::min(blocks_.back().count, 1.0);
    const auto first = static_cast<std::size_t>(std::clamp(std::ceil(begin * length - rounding), 0.0, count - 1.0));
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

TouchColumns::TouchColumns(const Case& c, const std::vector<Quantity>& quantities)
    : contact_(findQuantity(quantities, "contact_force")),
      adhesion_(findQuantity(quantities, "adhesion_force")),
      menisci_(contactLaw(c).menisci)
{}

Touch TouchColumns::between(std::span<const double> least, std::span<const double> most) const
{
    // Forces of contact are positive, of adhesion negative: zero is their smallest size.
    const auto isContact = [this](std::size_t column) { return column == static_cast<std::size_t>(contact_); };
    const bool any = touches([&](std::size_t column) {
        return isContact(column) ? std::max(most[column], 0.0) : std::min(least[column], 0.0);
    });
    if (!any) return Touch::Never;
    const bool always = touches([&](std::size_t column) {
        return isContact(column) ? std::max(least[column], 0.0) : std::min(most[column], 0.0);
    });
    return always ? Touch::Always : Touch::AtTimes;
}

RunStatistics::RunStatistics(const Case& c, const std::vector<Quantity>& quantities)
    : case_(c), quantities_(quantities), oscillates_(c.model != ModelKind::Contact), touch_(c, quantities)
{
    std::vector<const char*> names{"flying_height", "minimum_spacing", "pitch", "roll", "contact_force"};
    if (oscillates_) names.insert(names.end(), {"minimum_gap", "flying_height_above_disk"});
    for (const char* name : names) {
        const int column = findQuantity(quantities, name);
        if (column >= 0) columns_.push_back(static_cast<std::size_t>(column));
    }
    blocks_.resize(columns_.size());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    extremes_.assign(quantities.size(), {infinity, -infinity});
    spacingColumn_ = static_cast<std::size_t>(findQuantity(quantities, "minimum_spacing"));
    motion_.interval = c.run.sampleInterval;
}

void RunStatistics::addSample(double time, std::span<const double> values, std::span<const double> least,
                              std::span<const double> most)
{
    // The extremes before the first sample of the tail may be older than the tail.
    const double interval = case_.run.sampleInterval;
    const double tail = 0.9 * case_.run.duration - 1e-6 * interval; // less what rounding may take
    const bool entersTail = time >= tail && (samples_ == 0 || newestTime_ < tail);
    const bool between = samples_ > 0 && isBetweenSamples(time, interval);
    const double weight = between ? std::min((time - newestTime_) / interval, 1.0) : 1.0;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const std::size_t column = columns_[i];
        if (entersTail)
            blocks_[i].add(values[column], values[column], values[column], weight);
        else
            blocks_[i].add(values[column], least[column], most[column], weight);
    }
    for (std::size_t i = 0; i < extremes_.size(); ++i) {
        extremes_[i].least = std::min(extremes_[i].least, least[i]);
        extremes_[i].most = std::max(extremes_[i].most, most[i]);
    }
    ++samples_;
    newestTime_ = time;
    if (between) return;
    motion_.add(values[spacingColumn_], least[spacingColumn_], most[spacingColumn_], touch_.between(least, most));
    if (time < case_.spectrum.start) ++beforeSpectrum_;
    if (motion_.spacing.size() > 2 * mostSpectrumSamples) {
        const std::size_t dropped = motion_.spacing.size() - mostSpectrumSamples;
        motion_.dropFirst(dropped);
        beforeSpectrum_ -= std::min(beforeSpectrum_, dropped);
    }
}

void RunStatistics::finish(Summary& summary) const
{
    if (samples_ == 0) return;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const std::string& name = quantities_[columns_[i]].name;
        summary.tail.emplace_back(name, blocks_[i].over(0.9, 1.0));
    }
    for (std::size_t i = 0; i < extremes_.size(); ++i) summary.extremes.emplace_back(quantities_[i].name, extremes_[i]);
    if (!oscillates_) return;
    if (motion_.surface.moves() && std::isfinite(motion_.surface.period))
        summary.figures.push_back(
            {{"surface_repeat", "s", "ms", "Time after which the disk's surface repeats under the slider"},
             motion_.surface.period});
    const Spectrum spectrum = welch(std::span(motion_.spacing).subspan(beforeSpectrum_), case_.run.sampleInterval,
                                    welchOptions(case_.spectrum, case_.run.sampleInterval));
    summary.peaks = findPeaks(spectrum, case_.spectrum.scaling);
    if (summary.status != RunStatus::Completed) return;
    MotionSamples samples = motion_;
    for (const RunEvent& event : summary.events)
        if (event.name == "touch-down" || event.name == "take-off") samples.switches.push_back(event.time);
    summary.verdict = judgeMotion(samples);
    // The periods of a random motion are not counted.
    if (isFolded(motion_, beforeSpectrum_)) {
        summary.verdict.undersampled = true;
        summary.verdict.frequency = 0.0;
    }
    if (summary.verdict.undersampled)
        summary.warnings.push_back("a period of the motion is shorter than 2.5 samples: plots and spectra do not show "
                                   "its frequency, and what is above half of the sampling rate, " +
                                   fewDigits(0.5 / case_.run.sampleInterval, "kHz", 4) +
                                   ", appears in them at a wrong, lower one; a shorter run.sample_interval shows it");
}

} // namespace touchdown
