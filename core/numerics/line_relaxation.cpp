// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/line_relaxation.h"

namespace touchdown {

LineRelaxation::LineRelaxation(const PaddedGrid& pad) : pad_(pad)
{
    for (auto* field : {&west_, &east_, &south_, &north_, &centre_, &pivotX_, &pivotY_}) field->assign(pad.size(), 0.0);
}

void LineRelaxation::setOperator(const std::array<MonotoneFaces, 2>& faces, std::span<const double> weight,
                                 double diagonal)
{
    const std::size_t up = pad_.stride();
    const auto [ex, cx] = faces[0];
    const auto [ey, cy] = faces[1];
    // Where nothing passes a cell, it keeps its pressure: v = 0.
    const auto inverse = [](double pivot) { return pivot > 0.0 ? 1.0 / pivot : 0.0; };
    for (int j = 0; j < pad_.ny; ++j)
        for (int i = 0; i < pad_.nx; ++i) {
            const std::size_t at = pad_.at(i, j);
            west_[at] = -ex[at] - 0.5 * cx[at];
            east_[at] = -ex[at + 1] + 0.5 * cx[at + 1];
            south_[at] = -ey[at] - 0.5 * cy[at];
            north_[at] = -ey[at + up] + 0.5 * cy[at + up];
            centre_[at] = (ex[at] - 0.5 * cx[at]) + (ex[at + 1] + 0.5 * cx[at + 1]) + (ey[at] - 0.5 * cy[at]) +
                          (ey[at + up] + 0.5 * cy[at + up]) + diagonal * weight[at];
            pivotX_[at] = inverse(centre_[at] - west_[at] * east_[at - 1] * pivotX_[at - 1]);
            pivotY_[at] = inverse(centre_[at] - south_[at] * north_[at - up] * pivotY_[at - up]);
        }
}

void LineRelaxation::sweepX(std::span<const double> b, std::span<double> v, int colour) const
{
    const std::size_t up = pad_.stride(), n = static_cast<std::size_t>(pad_.nx);
    for (int j = colour; j < pad_.ny; j += 2) {
        const std::size_t first = pad_.at(0, j);
        double before = 0.0;
        for (std::size_t at = first; at < first + n; ++at) {
            const double rest = b[at] - south_[at] * v[at - up] - north_[at] * v[at + up];
            before = (rest - west_[at] * before) * pivotX_[at];
            v[at] = before;
        }
        for (std::size_t at = first + n - 1; at-- > first;) v[at] -= east_[at] * pivotX_[at] * v[at + 1];
    }
}

void LineRelaxation::sweepY(std::span<const double> b, std::span<double> v, int colour) const
{
    const std::size_t up = pad_.stride();
    for (int j = 0; j < pad_.ny; ++j)
        for (int i = colour; i < pad_.nx; i += 2) {
            const std::size_t at = pad_.at(i, j);
            // The row below is done already; below the first one there are zeros.
            v[at] = (b[at] - west_[at] * v[at - 1] - east_[at] * v[at + 1] - south_[at] * v[at - up]) * pivotY_[at];
        }
    for (int j = pad_.ny - 2; j >= 0; --j)
        for (int i = colour; i < pad_.nx; i += 2) {
            const std::size_t at = pad_.at(i, j);
            v[at] -= north_[at] * pivotY_[at] * v[at + up];
        }
}

void LineRelaxation::sweep(std::span<const double> b, std::span<double> v) const
{
    for (const int colour : {0, 1}) sweepX(b, v, colour);
    for (const int colour : {0, 1}) sweepY(b, v, colour);
}

void LineRelaxation::residual(std::span<const double> b, std::span<const double> v, std::span<double> out) const
{
    const std::size_t up = pad_.stride();
    for (int j = 0; j < pad_.ny; ++j)
        for (int i = 0; i < pad_.nx; ++i) {
            const std::size_t at = pad_.at(i, j);
            out[at] = b[at] - centre_[at] * v[at] - west_[at] * v[at - 1] - east_[at] * v[at + 1] -
                      south_[at] * v[at - up] - north_[at] * v[at + up];
        }
}

} // namespace touchdown
