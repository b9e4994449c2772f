// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/nested_grid.h"

#include <algorithm>

namespace touchdown {

namespace {

std::vector<double> everySecond(const std::vector<double>& lines)
{
    std::vector<double> result;
    for (std::size_t k = 0; k + 1 < lines.size(); k += 2) result.push_back(lines[k]);
    result.push_back(lines.back());
    return result;
}

} // namespace

CellGrid everySecondLine(const CellGrid& fine) { return {everySecond(fine.x), everySecond(fine.y)}; }

GridTransfer::GridTransfer(const CellGrid& fine)
    : fine_{fine.nx(), fine.ny()},
      coarse_{(fine.nx() + 1) / 2, (fine.ny() + 1) / 2},
      x_(axisOf(fine.x)),
      y_(axisOf(fine.y))
{}

GridTransfer::Axis GridTransfer::axisOf(const std::vector<double>& lines)
{
    const std::vector<double> coarse = everySecond(lines);
    const int cells = static_cast<int>(coarse.size()) - 1;
    // Beyond the first and the last cell the outline counts, where the field is zero.
    const auto node = [&](int cell) {
        if (cell < 0) return coarse.front();
        if (cell >= cells) return coarse.back();
        return 0.5 * (coarse[static_cast<std::size_t>(cell)] + coarse[static_cast<std::size_t>(cell) + 1]);
    };
    Axis axis;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        const int own = static_cast<int>(i / 2);
        const std::size_t k = i / 2;
        const double centre = 0.5 * (lines[i] + lines[i + 1]);
        const int other = centre < node(own) ? own - 1 : own + 1;
        axis.share.push_back((lines[i + 1] - lines[i]) / (coarse[k + 1] - coarse[k]));
        axis.other.push_back(other);
        axis.part.push_back((centre - node(own)) / (node(other) - node(own)));
    }
    return axis;
}

void GridTransfer::sum(std::span<const double> fine, std::span<double> coarse) const
{
    std::fill(coarse.begin(), coarse.end(), 0.0);
    for (int j = 0; j < fine_.ny; ++j)
        for (int i = 0; i < fine_.nx; ++i) coarse[coarse_.at(i / 2, j / 2)] += fine[fine_.at(i, j)];
}

void GridTransfer::mean(std::span<const double> fine, std::span<double> coarse) const
{
    for (int j = 0; j < coarse_.ny; ++j)
        for (int i = 0; i < coarse_.nx; ++i) coarse[coarse_.at(i, j)] = 0.0;
    for (int j = 0; j < fine_.ny; ++j) {
        const double share = y_.share[static_cast<std::size_t>(j)];
        for (int i = 0; i < fine_.nx; ++i)
            coarse[coarse_.at(i / 2, j / 2)] += share * x_.share[static_cast<std::size_t>(i)] * fine[fine_.at(i, j)];
    }
}

void GridTransfer::interpolate(std::span<const double> coarse, std::span<double> fine) const
{
    for (int j = 0; j < fine_.ny; ++j) {
        const double partY = y_.part[static_cast<std::size_t>(j)];
        const double* own = coarse.data() + coarse_.at(0, j / 2);
        const double* other = coarse.data() + coarse_.at(0, y_.other[static_cast<std::size_t>(j)]);
        for (int i = 0; i < fine_.nx; ++i) {
            const double partX = x_.part[static_cast<std::size_t>(i)];
            const int I = i / 2, next = x_.other[static_cast<std::size_t>(i)];
            fine[fine_.at(i, j)] = (1.0 - partY) * ((1.0 - partX) * own[I] + partX * own[next]) +
                                   partY * ((1.0 - partX) * other[I] + partX * other[next]);
        }
    }
}

} // namespace touchdown
