// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_labels.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace touchdown {

namespace {

constexpr double markerGap = 2.0; // between marker and text [px]
constexpr int mostCrossings = 3;  // lines under a readable text

bool crosses(const QLineF& line, const QRectF& box)
{
    if (std::max(line.x1(), line.x2()) < box.left() || std::min(line.x1(), line.x2()) > box.right() ||
        std::max(line.y1(), line.y2()) < box.top() || std::min(line.y1(), line.y2()) > box.bottom())
        return false;
    if (box.contains(line.p1()) || box.contains(line.p2())) return true;
    // The line misses the box if all corners lie on the same side of it.
    const auto side = [&line](const QPointF& p) {
        return line.dx() * (p.y() - line.y1()) - line.dy() * (p.x() - line.x1());
    };
    const std::array sides{side(box.topLeft()), side(box.topRight()), side(box.bottomLeft()), side(box.bottomRight())};
    const auto [low, high] = std::ranges::minmax(sides);
    return low <= 0.0 && high >= 0.0;
}

/// Beside, above, below and at the corners of the marker; the best one first.
std::array<QRectF, 8> candidates(const LabelRequest& label)
{
    const double w = label.size.width(), h = label.size.height();
    const double far = label.radius + markerGap, corner = 0.75 * label.radius + markerGap;
    const double x = label.at.x(), y = label.at.y();
    const auto box = [&](double left, double top) { return QRectF(QPointF(left, top), label.size); };
    return {box(x + far, y - 0.5 * h),           box(x + corner, y - corner - h), box(x - 0.5 * w, y - far - h),
            box(x - corner - w, y - corner - h), box(x - far - w, y - 0.5 * h),   box(x + corner, y + corner),
            box(x - 0.5 * w, y + far),           box(x - corner - w, y + corner)};
}

} // namespace

std::vector<std::optional<QRectF>> placeLabels(const std::vector<LabelRequest>& labels, const QRectF& bounds,
                                               std::vector<QRectF>& taken, const std::vector<QLineF>& lines)
{
    std::vector<std::size_t> order(labels.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_partition(order, [&labels](std::size_t i) { return labels[i].important; });

    std::vector<std::optional<QRectF>> places(labels.size());
    for (const std::size_t i : order) {
        std::ptrdiff_t fewest = mostCrossings + 1;
        for (const QRectF& box : candidates(labels[i])) {
            if (!bounds.contains(box)) continue;
            if (std::ranges::any_of(taken, [&box](const QRectF& other) { return other.intersects(box); })) continue;
            const auto count = std::ranges::count_if(lines, [&box](const QLineF& line) { return crosses(line, box); });
            if (count >= fewest) continue;
            fewest = count;
            places[i] = box;
            if (count == 0) break;
        }
        if (places[i]) taken.push_back(*places[i]);
    }
    return places;
}

} // namespace touchdown
