// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_gaps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "core/physics/slider/recess.h"

namespace touchdown {

namespace {

/// Divides faces and cells into rows and pieces.
class Sampler {
    /// A range of recesses counts as one recess where it is below this share of the lowest, plus this much [-], [m].
    static constexpr double alikeShare = 0.15, alikeRange = 0.5e-9;
    /// Rows count as one where their pieces are alike and those' lengths differ by less than this of the path [-].
    static constexpr double alikeLength = 0.05;

    static constexpr double largest = std::numeric_limits<double>::infinity();

public:
    /// Gaps that differ so much that flows do.
    static bool isStep(double lowest, double highest)
    {
        return highest - lowest >= 0.3 * (std::max(0.0, lowest) + typicalLift);
    }

    Sampler(const Recess& recess, FilmGaps& gaps) : recess_(recess), gaps_(gaps) {}

    double at(int axis, double along, double across) const
    {
        return axis == 0 ? recess_.at(along, across) : recess_.at(across, along);
    }

    /// A path along `axis` from `start` to `end`, across a face from `low` to `high` at `face`: adds its rows, unless
    /// it is so gentle that one number stands for it: small change over its length and width, and no jump.
    bool divideFace(int axis, double start, double end, double face, double low, double high)
    {
        const std::size_t firstRow = gaps_.rows.size(), firstPiece = gaps_.pieces.size();
        lowest_ = largest;
        highest_ = -largest;
        largestJump_ = 0.0;
        stepBelow_ = stepAbove_ = false;
        breaks(1 - axis, face, low, high);
        const auto addRow = [&](double position, double width) {
            const std::uint32_t first = size(gaps_.pieces);
            addPieces(axis, position, start, end, face);
            gaps_.rows.push_back({width, first, size(gaps_.pieces)});
        };
        const double width = high - low;
        std::erase_if(breaks_, [&](double at) { return at - low <= 1e-9 * width || high - at <= 1e-9 * width; });
        if (breaks_.empty()) {
            // An edge meets the path beside the face.
            addRow(low + 0.25 * width, 0.5 * width);
            addRow(high - 0.25 * width, 0.5 * width);
        } else {
            // A row between neighbouring breaks.
            ends_ = breaks_;
            ends_.push_back(high);
            double from = low, meanBefore = 0.0;
            for (const double to : ends_) {
                if (to - from <= 1e-9 * width) continue;
                addRow(0.5 * (from + to), to - from);
                if (from > low) largestJump_ = std::max(largestJump_, std::abs(mean_ - meanBefore));
                meanBefore = mean_;
                from = to;
            }
        }
        const bool gentle =
            !isStep(lowest_, highest_) && largestJump_ <= std::max(0.5 * (highest_ - lowest_), alikeRange);
        if (!gentle) {
            joinRows(firstRow, end - start);
            return true;
        }
        gaps_.rows.resize(firstRow);
        gaps_.pieces.resize(firstPiece);
        return false;
    }

    /// Whether a vertical step crosses the last path below its face, above it; a wall, however steep, is none.
    bool stepsBelow() const { return stepBelow_; }
    bool stepsAbove() const { return stepAbove_; }

private:
    template <typename Container>
    static std::uint32_t size(const Container& container)
    {
        return static_cast<std::uint32_t>(container.size());
    }

    void breaks(int axis, double across, double from, double to)
    {
        breaks_.clear();
        if (axis == 0)
            recess_.breaksAlongX(across, from, to, breaks_);
        else
            recess_.breaksAlongY(across, from, to, breaks_);
    }

    void addPieces(int axis, double across, double start, double end, double face)
    {
        breaks(axis, across, start, end);
        if (face > start && face < end) breaks_.insert(std::upper_bound(breaks_.begin(), breaks_.end(), face), face);
        breaks_.push_back(end);
        samples_.clear();
        double from = start, before = 0.0, sum = 0.0;
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
            before = high;
            sum += 0.5 * (low + high) * length;
            lowest_ = std::min({lowest_, low, high});
            highest_ = std::max({highest_, low, high});
            // A slope is followed by samples so near that the gap changes little from one to the next.
            const double whole = gap(std::max(low, high)) / gap(std::min(low, high)) - 1.0;
            const int count = whole < 0.02 ? 1 : std::clamp(static_cast<int>(std::ceil(2.0 * whole)), 2, 4);
            for (int k = 0; k < count; ++k) {
                const double share = (k + 0.5) / count, along = from + share * length;
                const double recess = low + (share - 0.02) / 0.96 * (high - low);
                samples_.push_back({length / count, recess, axis == 0 ? along : across, axis == 0 ? across : along,
                                    from - face + k * length / count});
            }
            from = to;
        }
        mean_ = sum / (end - start);
        joinSamples();
    }

    /// A gap as it may be in flight [m].
    static double gap(double recess) { return std::max(0.0, recess) + typicalLift; }
    /// Whether one number can stand for a range of recesses.
    static bool areAlike(double lowest, double highest)
    {
        return highest - lowest < alikeShare * std::max(0.0, lowest) + alikeRange;
    }

    /// Joins similar neighbouring samples on one side of the face to pieces, from the face outwards, with the gap h of
    /// their resistance in series: the mean of h^-3 is that of mean(h) - 2 variance(h)/mean(h), to second order.
    void joinSamples()
    {
        const auto above =
            std::find_if(samples_.begin(), samples_.end(), [](const GapPiece& s) { return s.start >= 0.0; });
        const std::size_t first = gaps_.pieces.size();
        joinAlike(std::make_reverse_iterator(above), samples_.rend());
        std::reverse(gaps_.pieces.begin() + static_cast<std::ptrdiff_t>(first), gaps_.pieces.end());
        joinAlike(above, samples_.end());
    }
    template <typename Iterator>
    void joinAlike(Iterator from, Iterator to)
    {
        double lowest = 0.0, highest = 0.0; // of the last piece
        for (Iterator sample = from; sample != to; ++sample) {
            lowest = std::min(lowest, sample->recess);
            highest = std::max(highest, sample->recess);
            if (sample != from && areAlike(lowest, highest)) {
                GapPiece& piece = gaps_.pieces.back();
                const double share = sample->extent / (piece.extent + sample->extent);
                piece.extent += sample->extent;
                piece.start = std::min(piece.start, sample->start);
                moveTo(piece, *sample, share);
            } else {
                gaps_.pieces.push_back(*sample);
                lowest = highest = sample->recess;
            }
        }
    }

    /// Position and recess between those of two pieces, and twice their variance over the gap taken off.
    static void moveTo(GapPiece& a, const GapPiece& b, double share)
    {
        const double difference = b.recess - a.recess;
        for (double GapPiece::*member : {&GapPiece::recess, &GapPiece::x, &GapPiece::y})
            a.*member += share * (b.*member - a.*member);
        a.recess -= 2.0 * share * (1.0 - share) * difference * difference / gap(a.recess);
    }

    /// Joins the face's rows where their pieces are similar: the mean of h^3 is that of mean(h) + variance(h)/mean(h).
    void joinRows(std::size_t firstRow, double pathLength)
    {
        const std::size_t count = gaps_.rows.size() - firstRow;
        const GapRow first = gaps_.rows[firstRow];
        const std::uint32_t depth = first.pieceEnd - first.pieces;
        for (std::size_t r = firstRow; r < gaps_.rows.size(); ++r)
            if (gaps_.rows[r].pieceEnd - gaps_.rows[r].pieces != depth) return;
        for (std::uint32_t k = 0; k < depth; ++k) {
            double lowest = largest, highest = -largest, shortest = largest, longest = 0.0;
            for (std::uint32_t r = 0; r < count; ++r) {
                const GapPiece& piece = gaps_.pieces[first.pieces + r * depth + k];
                lowest = std::min(lowest, piece.recess);
                highest = std::max(highest, piece.recess);
                shortest = std::min(shortest, piece.extent);
                longest = std::max(longest, piece.extent);
            }
            if (!areAlike(lowest, highest) || longest - shortest > alikeLength * pathLength) return;
        }
        double width = 0.0;
        for (std::uint32_t r = 0; r < count; ++r) width += gaps_.rows[firstRow + r].width;
        for (std::uint32_t k = 0; k < depth; ++k) {
            GapPiece mean{};
            double square = 0.0;
            for (std::uint32_t r = 0; r < count; ++r) {
                const GapPiece& piece = gaps_.pieces[first.pieces + r * depth + k];
                const double share = gaps_.rows[firstRow + r].width / width;
                for (double GapPiece::*member :
                     {&GapPiece::extent, &GapPiece::recess, &GapPiece::x, &GapPiece::y, &GapPiece::start})
                    mean.*member += share * piece.*member;
                square += share * piece.recess * piece.recess;
            }
            mean.recess += std::max(0.0, square - mean.recess * mean.recess) / gap(mean.recess);
            gaps_.pieces[first.pieces + k] = mean;
        }
        gaps_.rows.resize(firstRow + 1);
        gaps_.rows.back().width = width;
        gaps_.pieces.resize(first.pieceEnd);
    }

    const Recess& recess_;
    FilmGaps& gaps_;
    std::vector<double> breaks_, ends_;
    std::vector<GapPiece> samples_;
    double mean_ = 0.0;                                       // recess of the last row [m]
    double lowest_ = 0.0, highest_ = 0.0, largestJump_ = 0.0; // of the face [m]
    bool stepBelow_ = false, stepAbove_ = false;
};

/// Paths between cell centres; the outermost end at the outline.
void setPaths(FilmGaps::Faces& faces, const std::vector<double>& lines)
{
    const std::size_t count = lines.size();
    std::vector<double> ends(count + 1);
    ends.front() = lines.front();
    ends.back() = lines.back();
    for (std::size_t i = 0; i + 1 < count; ++i) ends[i + 1] = 0.5 * (lines[i] + lines[i + 1]);
    for (std::size_t i = 0; i < count; ++i) {
        faces.pathMid.push_back(0.5 * (ends[i] + ends[i + 1]));
        faces.pathLength.push_back(ends[i + 1] - ends[i]);
        faces.upperShare.push_back((lines[i] - ends[i]) / (ends[i + 1] - ends[i]));
    }
}

} // namespace

FilmGaps::FilmGaps(const Recess& recess, CellGrid cells, const std::function<bool()>& goOn)
    : grid(std::move(cells)), pad{grid.nx(), grid.ny()}, length(recess.length()), width(recess.width())
{
    const auto goesOn = [&] { return !goOn || goOn(); };
    Sampler sampler(recess, *this);
    setPaths(faces[0], grid.x);
    setPaths(faces[1], grid.y);
    // At the cells' centres; in the rings, at the outline beside them.
    meanRecess.assign(pad.size(), 0.0);
    for (int j = -1; j <= pad.ny && goesOn(); ++j)
        for (int i = -1; i <= pad.nx; ++i) {
            const auto place = [](const std::vector<double>& lines, int k, int count) {
                const std::size_t line = static_cast<std::size_t>(std::clamp(k, 0, count));
                return k < 0 || k == count ? lines[line] : 0.5 * (lines[line] + lines[line + 1]);
            };
            meanRecess[pad.at(i, j)] = recess.at(place(grid.x, i, pad.nx), place(grid.y, j, pad.ny));
        }
    std::vector<bool> stepped(pad.size(), false);
    for (int axis = 0; axis < 2; ++axis) {
        Faces& f = faces[static_cast<std::size_t>(axis)];
        f.recess.assign(pad.size(), 0.0);
        f.rise.assign(pad.size(), 0.0);
        const std::vector<double>& lines = axis == 0 ? grid.x : grid.y;
        const std::vector<double>& acrossLines = axis == 0 ? grid.y : grid.x;
        for (int j = 0; j < pad.ny + (axis == 1) && goesOn(); ++j)
            for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                const std::size_t line = static_cast<std::size_t>(axis == 0 ? i : j);
                const std::size_t across = static_cast<std::size_t>(axis == 0 ? j : i);
                const double low = acrossLines[across], high = acrossLines[across + 1], middle = 0.5 * (low + high);
                const double start = f.pathMid[line] - 0.5 * f.pathLength[line];
                const double end = start + f.pathLength[line];
                const std::size_t at = pad.at(i, j), before = at - pad.step(axis);
                const std::uint32_t firstRow = static_cast<std::uint32_t>(rows.size());
                const bool smooth =
                    axis == 0 ? recess.isSmooth(start, end, low, high) : recess.isSmooth(low, high, start, end);
                if (smooth || !sampler.divideFace(axis, start, end, lines[line], low, high)) {
                    f.recess[at] = sampler.at(axis, f.pathMid[line], middle);
                    f.rise[at] = meanRecess[at] - meanRecess[before];
                    if (Sampler::isStep(std::min(meanRecess[at], meanRecess[before]),
                                        std::max(meanRecess[at], meanRecess[before]))) {
                        // A ramp, or an edge at the very end of the path, which is beside it.
                        const double inset = 1e-6 * f.pathLength[line];
                        f.rise[at] = sampler.at(axis, end - inset, middle) - sampler.at(axis, start + inset, middle);
                    }
                    continue;
                }
                f.cut.push_back({at, firstRow, static_cast<std::uint32_t>(rows.size())});
                if (sampler.stepsBelow()) stepped[before] = true;
                if (sampler.stepsAbove()) stepped[at] = true;
            }
    }
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i)
            if (stepped[pad.at(i, j)]) steppedCells.push_back(pad.at(i, j));
    setCutCells();
    setCrossFeed();
}

/// A cell is the upper half of the path below it and the lower half of the one above.
void FilmGaps::setCutCells()
{
    auto place = faces[0].cut.begin();
    const auto end = faces[0].cut.end();
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            while (place != end && place->at < at) ++place;
            const bool cutBelow = place != end && place->at == at;
            const auto above = cutBelow ? place + 1 : place;
            const bool cutAbove = above != end && above->at == at + 1;
            if (!cutBelow && !cutAbove) {
                // An edge may run through the very centre, between the paths.
                const double below = faces[0].recess[at], beyond = faces[0].recess[at + 1];
                const double mean = 0.5 * (below + beyond);
                if (std::abs(meanRecess[at] - mean) > 0.25 * std::abs(beyond - below) &&
                    Sampler::isStep(std::min(below, beyond), std::max(below, beyond)))
                    meanRecess[at] = mean;
                continue;
            }
            const std::uint32_t first = static_cast<std::uint32_t>(pieces.size());
            const auto addHalf = [&](bool cut, const CutPlace* half, bool upper) {
                if (!cut) {
                    const double x = grid.centreX(i) + (upper ? -0.25 : 0.25) * grid.widthX(i);
                    pieces.push_back({0.5 * grid.widthX(i) * grid.widthY(j), faces[0].recess[upper ? at : at + 1], x,
                                      grid.centreY(j), 0.0});
                    return;
                }
                for (std::uint32_t r = half->rows; r < half->rowEnd; ++r)
                    for (std::uint32_t k = rows[r].pieces; k < rows[r].pieceEnd; ++k) {
                        GapPiece piece = pieces[k];
                        if ((piece.start < 0.0) == upper) continue;
                        piece.extent *= rows[r].width;
                        pieces.push_back(piece);
                    }
            };
            addHalf(cutBelow, cutBelow ? &*place : nullptr, true);
            addHalf(cutAbove, cutAbove ? &*above : nullptr, false);
            const std::uint32_t last = static_cast<std::uint32_t>(pieces.size());
            cutCells.push_back(
                {at, static_cast<std::uint32_t>(rows.size()), static_cast<std::uint32_t>(rows.size()) + 1});
            rows.push_back({1.0, first, last});
            double volume = 0.0, area = 0.0;
            for (std::uint32_t k = first; k < last; ++k) {
                volume += pieces[k].extent * pieces[k].recess;
                area += pieces[k].extent;
            }
            meanRecess[at] = volume / area;
        }
}

} // namespace touchdown
