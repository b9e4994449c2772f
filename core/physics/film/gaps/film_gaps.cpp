// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/gaps/film_gaps.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

#include "core/physics/film/gaps/cut_rows.h"
#include "core/physics/film/gaps/gap_sampler.h"
#include "core/physics/slider/recess.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

constexpr int leastSampledRows = 8; // sampled by a thread

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

/// The faces of some rows across one axis, sampled.
struct SampledRows {
    GapSampler sampler;
    CutRowArranger arranger;
    std::vector<std::size_t> stepped; // cells, padded indices

    SampledRows(FilmGaps& gaps, const Recess& recess, std::size_t axis) : sampler(recess), arranger(gaps, sampler, axis)
    {}
};

} // namespace

FilmGaps::FilmGaps(const Recess& recess, CellGrid cells, const std::function<bool()>& goOn)
    : grid(std::move(cells)), pad{grid.nx(), grid.ny()}, length(recess.length()), width(recess.width())
{
    Team& team = Team::mine();
    std::atomic<bool> stopped = false;
    // Asked on the calling thread alone.
    const auto goesOn = [&](int thread) {
        if (thread == 0 && !stopped && goOn && !goOn()) stopped = true;
        return !stopped;
    };
    setPaths(faces[0], grid.x);
    setPaths(faces[1], grid.y);
    // In the rings, at the outline beside them.
    centreRecess.assign(pad.size(), 0.0);
    const auto place = [](const std::vector<double>& lines, int k, int count) {
        const std::size_t line = static_cast<std::size_t>(std::clamp(k, 0, count));
        return k < 0 || k == count ? lines[line] : 0.5 * (lines[line] + lines[line + 1]);
    };
    team.items(pad.ny + 2, leastSampledRows, 1, [&](int first, int end, int thread) {
        for (int j = first - 1; j < end - 1 && goesOn(thread); ++j)
            for (int i = -1; i <= pad.nx; ++i)
                centreRecess[pad.at(i, j)] = recess.at(place(grid.x, i, pad.nx), place(grid.y, j, pad.ny));
    });
    meanRecess = centreRecess;
    std::vector<bool> stepped(pad.size(), false);
    for (int axis = 0; axis < 2; ++axis) {
        Faces& f = faces[static_cast<std::size_t>(axis)];
        f.recess.assign(pad.size(), 0.0);
        f.rise.assign(pad.size(), 0.0);
        const int count = pad.ny + (axis == 1), blocks = team.blocksOf(count, leastSampledRows, 2);
        std::vector<std::unique_ptr<SampledRows>> sampled;
        for (int b = 0; b < blocks; ++b)
            sampled.push_back(std::make_unique<SampledRows>(*this, recess, static_cast<std::size_t>(axis)));
        team.run(blocks, [&](int b, int thread) {
            const Block rowsOfBlock = Team::block(count, b, blocks);
            SampledRows& out = *sampled[static_cast<std::size_t>(b)];
            for (int j = rowsOfBlock.first; j < rowsOfBlock.end && goesOn(thread); ++j)
                sampleRow(recess, axis, j, out.sampler, out.arranger, out.stepped);
        });
        CutRowArranger& arranger = sampled.front()->arranger;
        for (const auto& block : sampled) {
            if (block != sampled.front()) arranger.append(block->arranger);
            for (const std::size_t at : block->stepped) stepped[at] = true;
        }
        arranger.finish();
        if (axis == 0) setCutCells(arranger);
    }
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i)
            if (stepped[pad.at(i, j)]) steppedCells.push_back(pad.at(i, j));
    setCrossFeed();
}

void FilmGaps::sampleRow(const Recess& recess, int axis, int j, GapSampler& sampler, CutRowArranger& arranger,
                         std::vector<std::size_t>& stepped)
{
    Faces& f = faces[static_cast<std::size_t>(axis)];
    for (int i = 0; i < pad.nx + (axis == 0); ++i) {
        const std::size_t at = pad.at(i, j), before = at - pad.step(axis);
        const FacePath path = arranger.pathOf(at);
        const auto& [_, start, end, face, low, high] = path;
        const bool smooth = axis == 0 ? recess.isSmooth(start, end, low, high) : recess.isSmooth(low, high, start, end);
        if (!smooth && sampler.divide(path)) {
            arranger.add(at, path);
            if (sampler.stepsBelow()) stepped.push_back(before);
            if (sampler.stepsAbove()) stepped.push_back(at);
            continue;
        }
        const double middle = 0.5 * (low + high);
        f.recess[at] = sampler.at(axis, 0.5 * (start + end), middle);
        f.rise[at] = centreRecess[at] - centreRecess[before];
        if (GapSampler::isStep(std::min(centreRecess[at], centreRecess[before]),
                               std::max(centreRecess[at], centreRecess[before]))) {
            // A ramp, or an edge at the very end of the path, which is beside it.
            const double inset = 1e-6 * (end - start);
            f.rise[at] = sampler.at(axis, end - inset, middle) - sampler.at(axis, start + inset, middle);
        }
    }
}

/// A cell is the upper half of the path below it and the lower half of the one above.
void FilmGaps::setCutCells(const CutRowArranger& sampled)
{
    auto place = sampled.faces().begin();
    const auto end = sampled.faces().end();
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
                    GapSampler::isStep(std::min(below, beyond), std::max(below, beyond)))
                    meanRecess[at] = mean;
                continue;
            }
            const std::uint32_t first = static_cast<std::uint32_t>(pieces.size());
            const auto addHalf = [&](bool cut, const SampledFace* half, bool upper) {
                if (!cut) {
                    const double x = grid.centreX(i) + (upper ? -0.25 : 0.25) * grid.widthX(i);
                    pieces.push_back({0.5 * grid.widthX(i) * grid.widthY(j), faces[0].recess[upper ? at : at + 1], x,
                                      grid.centreY(j), 0.0});
                    return;
                }
                for (std::uint32_t r = half->rows; r < half->rowEnd; ++r)
                    for (std::uint32_t k = sampled.rows()[r].pieces; k < sampled.rows()[r].pieceEnd; ++k) {
                        GapPiece piece = sampled.pieces()[k];
                        if ((piece.start < 0.0) == upper) continue;
                        piece.extent *= sampled.rows()[r].width;
                        pieces.push_back(piece);
                    }
            };
            addHalf(cutBelow, cutBelow ? &*place : nullptr, true);
            addHalf(cutAbove, cutAbove ? &*above : nullptr, false);
            const std::uint32_t last = static_cast<std::uint32_t>(pieces.size());
            cutCells.push_back(
                {at, static_cast<std::uint32_t>(rows.size()), static_cast<std::uint32_t>(rows.size()) + 1});
            rows.push_back({1.0, first, last, Feed::None});
            double volume = 0.0, area = 0.0;
            for (std::uint32_t k = first; k < last; ++k) {
                volume += pieces[k].extent * pieces[k].recess;
                area += pieces[k].extent;
            }
            meanRecess[at] = volume / area;
        }
}

} // namespace touchdown
