// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film_gaps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchdown {

namespace {

/// Divides faces and cells into rows and pieces.
class Sampler {
    /// Gaps of flying sliders are some ten nanometres above the recess [m].
    static constexpr double typicalLift = 20e-9;

public:
    Sampler(const Recess& recess, FilmGaps& gaps) : recess_(recess), gaps_(gaps) {}

    /// A path along `axis` from `start` to `end`, across a face from `low` to `high` at `face`.
    CutPlace cutFace(std::size_t at, int axis, double start, double end, double face, double low, double high)
    {
        CutPlace place{at, size(gaps_.rows), 0};
        divideAcross(axis, face, low, high);
        for (const auto& [position, width] : rows_) {
            const std::uint32_t first = size(gaps_.pieces);
            addPieces(axis, position, start, end, face, 1.0);
            gaps_.rows.push_back({width, first, size(gaps_.pieces)});
        }
        place.rowEnd = size(gaps_.rows);
        return place;
    }

    CutPlace cutCell(std::size_t at, double x0, double x1, double y0, double y1)
    {
        CutPlace place{at, size(gaps_.rows), 0};
        const std::uint32_t first = size(gaps_.pieces);
        divideAcross(0, 0.5 * (x0 + x1), y0, y1);
        for (const auto& [position, width] : rows_) addPieces(0, position, x0, x1, x0, width);
        gaps_.rows.push_back({1.0, first, size(gaps_.pieces)});
        place.rowEnd = size(gaps_.rows);
        return place;
    }

    /// A wall so gentle along the path that one sample stands for it: small change, and no jump.
    bool isGentle(int axis, double start, double end, double across) const
    {
        constexpr int samples = 8;
        double lowest = at(axis, start, across), highest = lowest, largestStep = 0.0, last = lowest;
        for (int k = 1; k <= samples; ++k) {
            const double s = at(axis, start + (end - start) * k / samples, across);
            lowest = std::min(lowest, s);
            highest = std::max(highest, s);
            largestStep = std::max(largestStep, std::abs(s - last));
            last = s;
        }
        return highest - lowest < 0.3 * (std::max(0.0, lowest) + typicalLift) && largestStep <= 0.5 * (highest - lowest);
    }

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

    /// Rows across a path along `axis`: between the breaks along the face two at Gauss points, or four where there are none.
    void divideAcross(int axis, double face, double low, double high)
    {
        rows_.clear();
        breaks(1 - axis, face, low, high);
        breaks_.push_back(high);
        const bool whole = breaks_.size() == 1;
        double from = low;
        for (const double to : breaks_) {
            const double width = to - from;
            if (width <= 1e-9 * (high - low)) continue;
            if (whole)
                for (int k = 0; k < 4; ++k) rows_.emplace_back(from + (k + 0.5) / 4 * width, width / 4);
            else {
                constexpr double gauss = 0.21132486540518708; // (1 - 1/sqrt(3))/2
                rows_.emplace_back(from + gauss * width, width / 2);
                rows_.emplace_back(to - gauss * width, width / 2);
            }
            from = to;
        }
    }

    void addPieces(int axis, double across, double start, double end, double face, double scale)
    {
        breaks(axis, across, start, end);
        if (face > start && face < end) breaks_.insert(std::upper_bound(breaks_.begin(), breaks_.end(), face), face);
        breaks_.push_back(end);
        double from = start;
        for (const double to : breaks_) {
            const double length = to - from;
            if (length <= 1e-9 * (end - start)) continue;
            const double low = at(axis, from + 0.02 * length, across);
            const double high = at(axis, to - 0.02 * length, across);
            // A slope is followed by samples so near that the gap changes little from one to the next.
            const double change = std::abs(high - low) / (std::max(0.0, std::min(low, high)) + typicalLift);
            const int samples = change < 0.02 ? 1 : std::clamp(static_cast<int>(std::ceil(2.0 * change)), 2, 4);
            for (int k = 0; k < samples; ++k) {
                const double along = from + (k + 0.5) / samples * length;
                gaps_.pieces.push_back({scale * length / samples, at(axis, along, across), axis == 0 ? along : across,
                                        axis == 0 ? across : along, from - face + k * length / samples});
            }
            from = to;
        }
    }

    const Recess& recess_;
    FilmGaps& gaps_;
    std::vector<double> breaks_;
    std::vector<std::pair<double, double>> rows_; // position, width
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
                                    sampler.isGentle(axis, start, end, 0.5 * (low + high));
                if (smooth)
                    f.recess[at] = axis == 0 ? recess.at(f.pathMid[line], 0.5 * (low + high))
                                             : recess.at(0.5 * (low + high), f.pathMid[line]);
                else f.cut.push_back(sampler.cutFace(at, axis, start, end, lines[line], low, high));
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
        }
}

} // namespace touchdown
