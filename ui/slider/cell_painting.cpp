// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/cell_painting.h"

#include <algorithm>
#include <cmath>

#include "ui/slider/slider_plan.h"

namespace touchdown {

namespace {

constexpr double finest = 3.0; // pixels of a picture for a pixel of the screen

} // namespace

int cellIndex(const std::vector<double>& lines, double at)
{
    if (lines.size() < 2 || !(at >= lines.front()) || at > lines.back()) return -1;
    const auto above = std::upper_bound(lines.begin() + 1, lines.end() - 1, at);
    return static_cast<int>(above - lines.begin()) - 1;
}

void paintCells(QPainter& painter, const SliderPlan& plan, const std::vector<double>& values, const ColourScale& scale)
{
    // Pixels of the device, so that borders are sharp on fine screens and in pictures.
    const QRectF area = plan.planArea();
    const double finer = std::clamp(painter.deviceTransform().m11(), 1.0, finest);
    const int columns = static_cast<int>(std::ceil(area.width() * finer));
    const int rows = static_cast<int>(std::ceil(area.height() * finer));

    std::vector<QRgb> colours(values.size());
    std::ranges::transform(values, colours.begin(), [&scale](double v) { return scale.colour(v) | 0xff000000U; });
    std::vector<int> cellOfColumn(static_cast<std::size_t>(columns));
    for (int k = 0; k < columns; ++k)
        cellOfColumn[static_cast<std::size_t>(k)] =
            cellIndex(plan.grid().x, plan.toSlider({area.left() + (k + 0.5) / finer, 0.0}).x);

    QImage image(columns, rows, QImage::Format_ARGB32_Premultiplied);
    int drawnRow = -2; // of cells, in the line above
    for (int k = 0; k < rows; ++k) {
        const int j = cellIndex(plan.grid().y, plan.toSlider({0.0, area.top() + (k + 0.5) / finer}).y);
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(k));
        if (j == drawnRow) {
            std::copy_n(reinterpret_cast<const QRgb*>(image.constScanLine(k - 1)), columns, line);
            continue;
        }
        drawnRow = j;
        const auto first = static_cast<std::size_t>(std::max(j, 0)) * static_cast<std::size_t>(plan.grid().nx());
        for (int c = 0; c < columns; ++c) {
            const int i = cellOfColumn[static_cast<std::size_t>(c)];
            line[c] = i < 0 || j < 0 ? 0U : colours[first + static_cast<std::size_t>(i)];
        }
    }
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.drawImage(QRectF(area.topLeft(), QSizeF(columns, rows) / finer), image);
    painter.restore();
}

} // namespace touchdown
