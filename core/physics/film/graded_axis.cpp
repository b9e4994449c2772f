// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/graded_axis.h"

#include <algorithm>
#include <cmath>

namespace touchdown {

namespace {

/// The density scaled so that it holds `cells` cells while no spacing grows faster than `growth`.
std::vector<double> limitedDensity(const AxisWish& wish, int cells)
{
    const std::size_t bins = wish.density.size();
    const double bin = (wish.end - wish.start) / static_cast<double>(bins);
    double largest = 0.0;
    for (const double d : wish.density) largest = std::max(largest, d);
    std::vector<double> spacing(bins);
    double scale = 1.0;
    for (int pass = 0; pass < 12; ++pass) {
        for (std::size_t k = 0; k < bins; ++k) spacing[k] = scale / std::max(wish.density[k], 1e-6 * largest + 1e-300);
        for (std::size_t k = 1; k < bins; ++k) spacing[k] = std::min(spacing[k], spacing[k - 1] + wish.growth * bin);
        for (std::size_t k = bins - 1; k-- > 0;) spacing[k] = std::min(spacing[k], spacing[k + 1] + wish.growth * bin);
        double count = 0.0;
        for (const double s : spacing) count += bin / s;
        scale *= count / cells;
        if (std::abs(count - cells) < 1e-3 * cells) break;
    }
    for (double& s : spacing) s = 1.0 / s;
    return spacing;
}

/// Position at which the running sum of the density reaches `amount`.
double positionAt(const std::vector<double>& sums, const AxisWish& wish, double amount)
{
    const auto above = std::upper_bound(sums.begin() + 1, sums.end() - 1, amount);
    const std::size_t k = static_cast<std::size_t>(above - sums.begin());
    const double share = (amount - sums[k - 1]) / (sums[k] - sums[k - 1]);
    return wish.start +
           (wish.end - wish.start) * (static_cast<double>(k - 1) + share) / static_cast<double>(sums.size() - 1);
}

double sumAt(const std::vector<double>& sums, const AxisWish& wish, double position)
{
    const double bins = static_cast<double>(sums.size() - 1);
    const double place = std::clamp((position - wish.start) / (wish.end - wish.start) * bins, 0.0, bins);
    const std::size_t k = std::min(static_cast<std::size_t>(place), sums.size() - 2);
    return sums[k] + (place - static_cast<double>(k)) * (sums[k + 1] - sums[k]);
}

} // namespace

std::vector<double> gradedAxis(const AxisWish& wish, int cells)
{
    const std::vector<double> density = limitedDensity(wish, cells);
    std::vector<double> sums{0.0};
    for (const double d : density) sums.push_back(sums.back() + d);
    for (double& s : sums) s *= cells / sums.back();

    // Each mark, the heaviest first, takes the free line next to it.
    struct Anchor {
        int line;
        double position;
    };
    std::vector<Anchor> anchors{{0, wish.start}, {cells, wish.end}};
    std::vector<AxisMark> marks = wish.marks;
    std::stable_sort(marks.begin(), marks.end(),
                     [](const AxisMark& a, const AxisMark& b) { return a.weight > b.weight; });
    for (const AxisMark& mark : marks) {
        if (!(mark.position > wish.start && mark.position < wish.end)) continue;
        const double wanted = sumAt(sums, wish, mark.position) / wish.multiple;
        const int line = static_cast<int>(std::lround(wanted)) * wish.multiple;
        const auto next =
            std::find_if(anchors.begin(), anchors.end(), [&](const Anchor& a) { return a.position >= mark.position; });
        const auto before = next - 1;
        if (next->position == mark.position || line <= before->line || line >= next->line) continue;
        // A line must not be pulled so far that its neighbours crowd or gape.
        const double lower =
            (sumAt(sums, wish, mark.position) - sumAt(sums, wish, before->position)) / (line - before->line);
        const double upper =
            (sumAt(sums, wish, next->position) - sumAt(sums, wish, mark.position)) / (next->line - line);
        if (std::min(lower, upper) < 0.4 || std::max(lower, upper) > 2.5) continue;
        anchors.insert(next, {line, mark.position});
    }

    std::vector<double> lines(static_cast<std::size_t>(cells) + 1);
    for (std::size_t k = 0; k + 1 < anchors.size(); ++k) {
        const Anchor &from = anchors[k], &to = anchors[k + 1];
        const double first = sumAt(sums, wish, from.position), last = sumAt(sums, wish, to.position);
        for (int i = from.line; i <= to.line; ++i)
            lines[static_cast<std::size_t>(i)] =
                positionAt(sums, wish, first + (last - first) * (i - from.line) / (to.line - from.line));
        lines[static_cast<std::size_t>(from.line)] = from.position;
        lines[static_cast<std::size_t>(to.line)] = to.position;
    }
    return lines;
}

} // namespace touchdown
