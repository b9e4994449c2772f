// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film_gaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace touchdown {

namespace {

/// Divides faces and cells into rows and pieces.
class Sampler {
    /// Gaps of flying sliders are some ten nanometres above the recess [m].
    static constexpr double typicalLift = 20e-9;
    /// Pieces whose gaps differ by less than this count as one, and rows of such pieces whose lengths differ by less than
    /// this of the path: what is lost is of second order in it [-].
    static constexpr double alike = 0.05;

public:
    Sampler(const Recess& recess, FilmGaps& gaps) : recess_(recess), gaps_(gaps) {}

    /// A path along `axis` from `start` to `end`, across a face from `low` to `high` at `face`.
    CutPlace cutFace(std::size_t at, int axis, double start, double end, double face, double low, double high)
    {
        CutPlace place{at, size(gaps_.rows), 0};
        breaks(1 - axis, face, low, high);
        const auto addRow = [&](double position, double width) {
            const std::uint32_t first = size(gaps_.pieces);
            addPieces(axis, position, start, end, face, 1.0);
            gaps_.rows.push_back({width, first, size(gaps_.pieces)});
            if (gaps_.rows.size() - place.rows > 1) joinRows(end - start);
        };
        if (breaks_.empty()) {
            // An edge meets the path beside the face: where it does so alike at both ends, it does so everywhere.
            const double width = high - low;
            addRow(low + 0.125 * width, 0.25 * width);
            addRow(high - 0.125 * width, 0.25 * width);
            if (gaps_.rows.size() - place.rows == 1) gaps_.rows.back().width = width;
            else {
                addRow(low + 0.375 * width, 0.25 * width);
                addRow(high - 0.375 * width, 0.25 * width);
            }
        } else
            forRows(low, high, addRow);
        place.rowEnd = size(gaps_.rows);
        return place;
    }

    CutPlace cutCell(std::size_t at, double x0, double x1, double y0, double y1)
    {
        CutPlace place{at, size(gaps_.rows), 0};
        const std::uint32_t first = size(gaps_.pieces);
        // Corners and oblique edges are met where they enter and leave.
        std::vector<double> all;
        for (const double x : {x0, 0.5 * (x0 + x1), x1}) {
            breaks(1, x, y0, y1);
            all.insert(all.end(), breaks_.begin(), breaks_.end());
        }
        std::sort(all.begin(), all.end());
        breaks_ = all;
        forRows(y0, y1, [&](double position, double width) { addPieces(0, position, x0, x1, x0, width); });
        gaps_.rows.push_back({1.0, first, size(gaps_.pieces)});
        place.rowEnd = size(gaps_.rows);
        return place;
    }

    /// A wall so gentle that one sample stands for the path: small change over its length and width, and no jump.
    bool isGentle(int axis, double start, double end, double low, double high) const
    {
        constexpr std::size_t samples = 9, rowSamples = 5;
        std::array<std::array<double, samples>, rowSamples> s;
        double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
        for (const std::size_t k : {0u, 8u, 4u, 2u, 6u, 1u, 3u, 5u, 7u}) // far ones first: most walls show there that they are steep
            for (const std::size_t row : {0u, 4u, 2u, 1u, 3u}) {
                const double share = static_cast<double>(k) / (samples - 1), shareAcross = static_cast<double>(row) / (rowSamples - 1);
                const double value = at(axis, start + (end - start) * share, low + (high - low) * shareAcross);
                s[row][k] = value;
                lowest = std::min(lowest, value);
                highest = std::max(highest, value);
                if (isStep(lowest, highest)) return false;
            }
        double largestStep = 0.0;
        for (std::size_t row = 0; row < rowSamples; ++row)
            for (std::size_t k = 0; k < samples; ++k) {
                if (k > 0) largestStep = std::max(largestStep, std::abs(s[row][k] - s[row][k - 1]));
                if (row > 0) largestStep = std::max(largestStep, std::abs(s[row][k] - s[row - 1][k]));
            }
        return largestStep <= 0.5 * (highest - lowest);
    }

    /// Whether a vertical step stands in a cell; a wall, however steep, is none.
    bool jumps(double x0, double x1, double y0, double y1)
    {
        constexpr double beside = 1e-11; // [m]
        for (int axis = 0; axis < 2; ++axis) {
            const double from = axis == 0 ? x0 : y0, to = axis == 0 ? x1 : y1;
            for (const double share : {0.05, 0.35, 0.65, 0.95}) {
                const double across = axis == 0 ? y0 + share * (y1 - y0) : x0 + share * (x1 - x0);
                breaks(axis, across, from, to);
                for (const double edge : breaks_) {
                    const double below = at(axis, edge - beside, across), above = at(axis, edge + beside, across);
                    if (isStep(std::min(below, above), std::max(below, above))) return true;
                }
            }
        }
        return false;
    }

    /// Gaps that differ so much that flows do.
    static bool isStep(double lowest, double highest) { return highest - lowest >= 0.3 * (std::max(0.0, lowest) + typicalLift); }

private:
    template <typename Container>
    static std::uint32_t size(const Container& container)
    {
        return static_cast<std::uint32_t>(container.size());
    }

    double at(int axis, double along, double across) const
    {
        return axis == 0 ? recess_.at(along, across) : recess_.at(across, along);
    }
    void breaks(int axis, double across, double from, double to)
    {
        breaks_.clear();
        if (axis == 0) recess_.breaksAlongX(across, from, to, breaks_);
        else recess_.breaksAlongY(across, from, to, breaks_);
    }

    /// Rows across: between neighbouring breaks two at Gauss points.
    template <typename AddRow>
    void forRows(double low, double high, AddRow&& addRow)
    {
        ends_.assign(breaks_.begin(), breaks_.end());
        ends_.push_back(high);
        double from = low;
        for (const double to : ends_) {
            const double width = to - from;
            if (width <= 1e-9 * (high - low)) continue;
            constexpr double gauss = 0.21132486540518708; // (1 - 1/sqrt(3))/2
            addRow(from + gauss * width, 0.5 * width);
            addRow(to - gauss * width, 0.5 * width);
            from = to;
        }
    }

    void addPieces(int axis, double across, double start, double end, double face, double scale)
    {
        breaks(axis, across, start, end);
        if (face > start && face < end) breaks_.insert(std::upper_bound(breaks_.begin(), breaks_.end(), face), face);
        breaks_.push_back(end);
        samples_.clear();
        double from = start;
        for (const double to : breaks_) {
            const double length = to - from;
            if (length <= 1e-9 * (end - start)) continue;
            // Nearly straight from break to break.
            const double low = at(axis, from + 0.02 * length, across);
            const double high = at(axis, to - 0.02 * length, across);
            // A slope is followed by samples so near that the gap changes little from one to the next.
            const double whole = gap(std::max(low, high)) / gap(std::min(low, high)) - 1.0;
            const int count = whole < 0.02 ? 1 : std::clamp(static_cast<int>(std::ceil(2.0 * whole)), 2, 4);
            for (int k = 0; k < count; ++k) {
                const double share = (k + 0.5) / count, along = from + share * length;
                const double recess = low + (share - 0.02) / 0.96 * (high - low);
                samples_.push_back({scale * length / count, recess, axis == 0 ? along : across, axis == 0 ? across : along,
                                    from - face + k * length / count});
            }
            from = to;
        }
        joinSamples();
    }

    /// As it may be in flight; never closed.
    static double gap(double recess) { return std::max(recess + typicalLift, 0.25 * typicalLift); }
    static bool areAlike(double narrow, double wide) { return wide < (1.0 + alike) * narrow; }

    /// Makes pieces of the samples: one of neighbours on one side of the face that are alike.
    void joinSamples()
    {
        const std::size_t first = gaps_.pieces.size();
        double narrow = 0.0, wide = 0.0; // of the last piece
        for (const GapPiece& sample : samples_) {
            const double h = gap(sample.recess);
            if (gaps_.pieces.size() > first && (sample.start < 0.0) == (gaps_.pieces.back().start < 0.0) &&
                areAlike(std::min(narrow, h), std::max(wide, h))) {
                GapPiece& piece = gaps_.pieces.back();
                const double share = sample.extent / (piece.extent + sample.extent);
                for (double GapPiece::*member : {&GapPiece::recess, &GapPiece::x, &GapPiece::y})
                    piece.*member += share * (sample.*member - piece.*member);
                piece.extent += sample.extent;
                narrow = std::min(narrow, h);
                wide = std::max(wide, h);
            } else {
                gaps_.pieces.push_back(sample);
                narrow = wide = h;
            }
        }
    }

    /// Makes one of the last two rows where their pieces are alike.
    void joinRows(double pathLength)
    {
        GapRow &a = gaps_.rows[gaps_.rows.size() - 2], &b = gaps_.rows.back();
        const std::uint32_t count = a.pieceEnd - a.pieces;
        if (b.pieceEnd - b.pieces != count) return;
        for (std::uint32_t k = 0; k < count; ++k) {
            const GapPiece &p = gaps_.pieces[a.pieces + k], &q = gaps_.pieces[b.pieces + k];
            const double h1 = gap(p.recess), h2 = gap(q.recess);
            if (!areAlike(std::min(h1, h2), std::max(h1, h2)) || std::abs(p.extent - q.extent) > alike * pathLength) return;
        }
        const double share = b.width / (a.width + b.width);
        for (std::uint32_t k = 0; k < count; ++k) {
            GapPiece& p = gaps_.pieces[a.pieces + k];
            const GapPiece& q = gaps_.pieces[b.pieces + k];
            for (double GapPiece::*member : {&GapPiece::extent, &GapPiece::recess, &GapPiece::x, &GapPiece::y, &GapPiece::start})
                p.*member += share * (q.*member - p.*member);
        }
        a.width += b.width;
        gaps_.pieces.resize(a.pieceEnd);
        gaps_.rows.pop_back();
    }

    const Recess& recess_;
    FilmGaps& gaps_;
    std::vector<double> breaks_, ends_;
    std::vector<GapPiece> samples_;
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

FilmGaps::FilmGaps(const Recess& recess, CellGrid cells)
    : grid(std::move(cells)), pad{grid.nx(), grid.ny()}, length(recess.length()), width(recess.width())
{
    Sampler sampler(recess, *this);
    setPaths(faces[0], grid.x);
    setPaths(faces[1], grid.y);
    for (int axis = 0; axis < 2; ++axis) {
        Faces& f = faces[static_cast<std::size_t>(axis)];
        f.recess.assign(pad.size(), 0.0);
        f.rise.assign(pad.size(), 0.0);
        const std::vector<double>& lines = axis == 0 ? grid.x : grid.y;
        for (int j = 0; j < pad.ny + (axis == 1); ++j)
            for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                const std::size_t line = static_cast<std::size_t>(axis == 0 ? i : j);
                const std::size_t across = static_cast<std::size_t>(axis == 0 ? j : i);
                const std::vector<double>& acrossLines = axis == 0 ? grid.y : grid.x;
                const double low = acrossLines[across], high = acrossLines[across + 1];
                const double start = f.pathMid[line] - 0.5 * f.pathLength[line];
                const double end = start + f.pathLength[line];
                const std::size_t at = pad.at(i, j);
                const bool smooth = (axis == 0 ? recess.isSmooth(start, end, low, high)
                                               : recess.isSmooth(low, high, start, end)) ||
                                    sampler.isGentle(axis, start, end, low, high);
                if (smooth) {
                    const double middle = 0.5 * (low + high);
                    const auto recessAt = [&](double along) { return axis == 0 ? recess.at(along, middle) : recess.at(middle, along); };
                    f.recess[at] = recessAt(f.pathMid[line]);
                    f.rise[at] = recessAt(end) - recessAt(start);
                } else f.cut.push_back(sampler.cutFace(at, axis, start, end, lines[line], low, high));
            }
    }
    meanRecess.assign(pad.size(), 0.0);
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t cx = static_cast<std::size_t>(i), cy = static_cast<std::size_t>(j);
            const double x0 = grid.x[cx], x1 = grid.x[cx + 1], y0 = grid.y[cy], y1 = grid.y[cy + 1];
            const std::size_t at = pad.at(i, j);
            if (recess.isSmooth(x0, x1, y0, y1)) {
                meanRecess[at] = recess.at(0.5 * (x0 + x1), 0.5 * (y0 + y1));
                continue;
            }
            cutCells.push_back(sampler.cutCell(at, x0, x1, y0, y1));
            double volume = 0.0, area = 0.0;
            for (std::uint32_t k = rows.back().pieces; k < rows.back().pieceEnd; ++k) {
                volume += pieces[k].extent * pieces[k].recess;
                area += pieces[k].extent;
            }
            meanRecess[at] = volume / area;
            if (sampler.jumps(x0, x1, y0, y1)) steppedCells.push_back(at);
        }
}

} // namespace touchdown
