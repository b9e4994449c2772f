// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/gaps/gap_sampler.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "core/physics/slider/recess.h"

namespace touchdown {

namespace {

/// A range of recesses counts as one recess where it is below this share of the lowest, plus this much [-], [m].
constexpr double alikeShare = 0.15, alikeRange = 0.5e-9;
/// Rows count as one where their pieces are alike and those' lengths differ by less than this of the path [-].
constexpr double alikeLength = 0.05;

/// A slope along a path is resolved where its gaps differ by less than the one ratio, and so sharp that the pressure
/// changes across it alone where by more than the other [-].
constexpr double resolvedRatio = 3.0, sharpRatio = 6.0;
/// Slopes below this belong to forms and ramps [-].
constexpr double steepSlope = 0.05;

constexpr double largest = std::numeric_limits<double>::infinity();

/// A gap as it may be in flight [m].
double gap(double recess) { return std::max(0.0, recess) + typicalLift; }

/// Whether one number can stand for a range of recesses.
bool areAlike(double lowest, double highest)
{
    return highest - lowest < alikeShare * std::max(0.0, lowest) + alikeRange;
}

/// Into how many parts a slope between two recesses is divided, so that the gap changes little from one to the next.
int slopeParts(double a, double b)
{
    const double ratio = gap(std::max(a, b)) / gap(std::min(a, b));
    return ratio < 1.02 ? 1 : std::max(2, static_cast<int>(std::ceil(2.0 * std::log2(ratio))));
}

/// Position and recess between those of two pieces, and twice their variance over the gap taken off.
void moveTo(GapPiece& a, const GapPiece& b, double share)
{
    const double difference = b.recess - a.recess;
    for (double GapPiece::*member : {&GapPiece::recess, &GapPiece::x, &GapPiece::y, &GapPiece::own, &GapPiece::other})
        a.*member += share * (b.*member - a.*member);
    a.recess -= 2.0 * share * (1.0 - share) * difference * difference / gap(a.recess);
}

} // namespace

bool GapSampler::isStep(double lowest, double highest)
{
    return highest - lowest >= 0.3 * (std::max(0.0, lowest) + typicalLift);
}

double GapSampler::at(int axis, double along, double across) const
{
    return axis == 0 ? recess_.at(along, across) : recess_.at(across, along);
}

void GapSampler::clear()
{
    rows_.clear();
    pieces_.clear();
    means_.clear();
    lowest_ = largest;
    highest_ = -largest;
    largestJump_ = 0.0;
    stepBelow_ = stepAbove_ = false;
}

bool GapSampler::divide(const FacePath& path)
{
    clear();
    breaks(1 - path.axis, path.face, path.low, path.high);
    const double width = path.high - path.low;
    std::erase_if(breaks_, [&](double at) { return at - path.low <= 1e-9 * width || path.high - at <= 1e-9 * width; });
    if (breaks_.empty()) {
        // An edge meets the path beside the face, or it runs along a slope.
        addRows(path, path.low, path.high);
        if (rows_.size() == 1) {
            clear();
            addRow(path, path.low + 0.25 * width, 0.5 * width);
            addRow(path, path.high - 0.25 * width, 0.5 * width);
        }
    } else {
        ends_ = breaks_;
        ends_.push_back(path.high);
        double from = path.low;
        for (const double to : ends_) {
            if (to - from <= 1e-9 * width) continue;
            const std::size_t first = means_.size();
            addRows(path, from, to);
            if (first > 0) largestJump_ = std::max(largestJump_, std::abs(means_[first] - means_[first - 1]));
            from = to;
        }
    }
    if (!isStep(lowest_, highest_) && largestJump_ <= std::max(0.5 * (highest_ - lowest_), alikeRange)) return false;
    joinRows(path.end - path.start);
    return true;
}

void GapSampler::setMiddleRow(const FacePath& path)
{
    clear();
    addRow(path, 0.5 * (path.low + path.high), path.high - path.low);
}

void GapSampler::breaks(int axis, double across, double from, double to)
{
    breaks_.clear();
    if (axis == 0)
        recess_.breaksAlongX(across, from, to, breaks_);
    else
        recess_.breaksAlongY(across, from, to, breaks_);
}

/// Rows side by side between two breaks, as many as the slope there needs.
void GapSampler::addRows(const FacePath& path, double from, double to)
{
    const double width = to - from;
    const int count =
        slopeParts(at(path.axis, path.face, from + 0.02 * width), at(path.axis, path.face, to - 0.02 * width));
    for (int k = 0; k < count; ++k) addRow(path, from + (k + 0.5) / count * width, width / count);
}

void GapSampler::addRow(const FacePath& path, double middle, double width)
{
    const std::uint32_t first = static_cast<std::uint32_t>(pieces_.size());
    addPieces(path, middle);
    rows_.push_back({middle, width, atFace_, first, static_cast<std::uint32_t>(pieces_.size())});
}

void GapSampler::addPieces(const FacePath& path, double across)
{
    const auto& [axis, start, end, face, lowSide, highSide] = path;
    breaks(axis, across, start, end);
    if (face > start && face < end) breaks_.insert(std::upper_bound(breaks_.begin(), breaks_.end(), face), face);
    breaks_.push_back(end);
    samples_.clear();
    double from = start, before = 0.0, sum = 0.0;
    atFace_ = largest;
    for (const double to : breaks_) {
        const double length = to - from;
        if (length <= 1e-9 * (end - start)) continue;
        // Nearly straight from break to break.
        const double low = at(axis, from + 0.02 * length, across);
        const double high = at(axis, to - 0.02 * length, across);
        if (from > start) {
            largestJump_ = std::max(largestJump_, std::abs(low - before));
            if (isStep(std::min(low, before), std::max(low, before))) {
                stepBelow_ = stepBelow_ || from < face;
                stepAbove_ = stepAbove_ || from > face;
            }
        }
        // Where an edge lies on the face, the shallow side.
        if (to >= face && from <= face) atFace_ = std::min(atFace_, from < face ? high : low);
        before = high;
        sum += 0.5 * (low + high) * length;
        lowest_ = std::min({lowest_, low, high});
        highest_ = std::max({highest_, low, high});
        // A slope is followed by samples.
        const int count = slopeParts(low, high);
        // From end to end, and by equal ratios of the gap.
        const double first = low - (high - low) * (0.02 / 0.96), last = high + (high - low) * (0.02 / 0.96);
        const double ratio = gap(last) / gap(first);
        double begin = 0.0;
        for (int k = 0; k < count; ++k) {
            const double stop = k + 1 == count || std::abs(ratio - 1.0) < 0.01
                                    ? (k + 1.0) / count
                                    : (std::pow(ratio, (k + 1.0) / count) - 1.0) / (ratio - 1.0);
            const double along = from + 0.5 * (begin + stop) * length, difference = (stop - begin) * (last - first);
            double recess = first + 0.5 * (begin + stop) * (last - first);
            recess -= difference * difference / (6.0 * gap(recess));
            // In `own` the slope along the path, in `lead` the middle between the breaks, until the slopes are sampled.
            samples_.push_back({(stop - begin) * length, recess, axis == 0 ? along : across, axis == 0 ? across : along,
                                from - face + begin * length, (last - first) / length, 0.0, from + 0.5 * length});
            begin = stop;
        }
        from = to;
    }
    means_.push_back(sum / (end - start));
    double shallowest = largest, deepest = -largest;
    for (const GapPiece& sample : samples_) {
        shallowest = std::min(shallowest, sample.recess);
        deepest = std::max(deepest, sample.recess);
    }
    const double within =
        std::clamp((gap(deepest) / gap(shallowest) - resolvedRatio) / (sharpRatio - resolvedRatio), 0.0, 1.0);
    double known = largest, aside = 0.0; // slope across the path, from where it is known [m], [-]
    for (GapPiece& sample : samples_) {
        constexpr double beside = 5e-9;                      // [m]
        const double slope = std::exchange(sample.own, 0.0); // along the path [-]
        const double along = std::exchange(sample.lead, 0.0);
        if (within == 0.0 || slope == 0.0) continue;
        if (along != known)
            aside = (at(axis, along, across + beside) - at(axis, along, across - beside)) / (2.0 * beside);
        known = along;
        const double square = slope * slope + aside * aside;
        if (!(square > steepSlope * steepSlope)) continue;
        // (m_a - n_a m_n)(c - c_s) of path_flow.h: (m_a (1 - n_a^2) - m_b n_a n_b) times the rise above the shallow
        // end.
        const double rise = within * (sample.recess - shallowest);
        sample.own = aside * aside / square * rise;
        sample.other = slope * aside / square * rise;
    }
    joinSamples();
}

/// Joins similar neighbouring samples on one side of the face to pieces, from the face outwards, with the gap h of
/// their resistance in series: the mean of h^-3 is that of mean(h) - 2 variance(h)/mean(h), to second order.
void GapSampler::joinSamples()
{
    const auto above = std::find_if(samples_.begin(), samples_.end(), [](const GapPiece& s) { return s.start >= 0.0; });
    const std::size_t first = pieces_.size();
    joinAlike(std::make_reverse_iterator(above), samples_.rend());
    std::reverse(pieces_.begin() + static_cast<std::ptrdiff_t>(first), pieces_.end());
    joinAlike(above, samples_.end());
}

template <typename Iterator>
void GapSampler::joinAlike(Iterator from, Iterator to)
{
    double lowest = 0.0, highest = 0.0; // of the last piece
    for (Iterator sample = from; sample != to; ++sample) {
        lowest = std::min(lowest, sample->recess);
        highest = std::max(highest, sample->recess);
        if (sample != from && areAlike(lowest, highest)) {
            GapPiece& piece = pieces_.back();
            const double share = sample->extent / (piece.extent + sample->extent);
            piece.extent += sample->extent;
            piece.start = std::min(piece.start, sample->start);
            moveTo(piece, *sample, share);
        } else {
            pieces_.push_back(*sample);
            lowest = highest = sample->recess;
        }
    }
}

/// Joins the face's rows where their pieces are similar: the mean of h^3 is that of mean(h) + variance(h)/mean(h).
void GapSampler::joinRows(double pathLength)
{
    const std::size_t count = rows_.size();
    const std::uint32_t depth = rows_.front().pieceEnd;
    for (const SampledRow& row : rows_)
        if (row.pieceEnd - row.pieces != depth) return;
    for (std::uint32_t k = 0; k < depth; ++k) {
        double lowest = largest, highest = -largest, shortest = largest, longest = 0.0;
        for (std::uint32_t r = 0; r < count; ++r) {
            const GapPiece& piece = pieces_[r * depth + k];
            lowest = std::min(lowest, piece.recess);
            highest = std::max(highest, piece.recess);
            shortest = std::min(shortest, piece.extent);
            longest = std::max(longest, piece.extent);
        }
        if (!areAlike(lowest, highest) || longest - shortest > alikeLength * pathLength) return;
    }
    double width = 0.0;
    for (const SampledRow& row : rows_) width += row.width;
    SampledRow mean{0.0, width, 0.0, 0, depth};
    for (const SampledRow& row : rows_) {
        mean.middle += row.width / width * row.middle;
        mean.recess += row.width / width * row.recess;
    }
    for (std::uint32_t k = 0; k < depth; ++k) {
        GapPiece piece{};
        double square = 0.0;
        for (std::uint32_t r = 0; r < count; ++r) {
            const GapPiece& part = pieces_[r * depth + k];
            const double share = rows_[r].width / width;
            for (double GapPiece::*member : {&GapPiece::extent, &GapPiece::recess, &GapPiece::x, &GapPiece::y,
                                             &GapPiece::start, &GapPiece::own, &GapPiece::other})
                piece.*member += share * part.*member;
            square += share * part.recess * part.recess;
        }
        piece.recess += std::max(0.0, square - piece.recess * piece.recess) / gap(piece.recess);
        pieces_[k] = piece;
    }
    rows_.assign(1, mean);
    pieces_.resize(depth);
}

} // namespace touchdown
