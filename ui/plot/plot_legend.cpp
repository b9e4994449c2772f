// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_legend.h"

#include <algorithm>

#include <QFontMetricsF>

#include "ui/plot/plot_frame.h"

namespace touchdown {

namespace {

constexpr double longestLegend = 170.0; // text of an entry on the screen [px]

QString legendText(const PlotCurve& curve) { return curve.legend.isEmpty() ? curve.name : curve.legend; }

/// Runs stand with the newest first, as the oldest may have no room. A raised curve keeps its place, or it would move
/// away under the pointer.
std::vector<const PlotCurve*> namedCurves(const std::vector<PlotCurve>& curves, const QString& title)
{
    std::vector<const PlotCurve*> named;
    const auto take = [&](const PlotCurve& curve) {
        const auto same = [&](const PlotCurve* other) {
            return legendText(*other) == legendText(curve) && other->style == curve.style;
        };
        if (curve.visible && curve.inLegend && !legendText(curve).isEmpty() && legendText(curve) != title &&
            std::ranges::none_of(named, same))
            named.push_back(&curve);
    };
    const bool runs = std::ranges::any_of(curves, [](const PlotCurve& curve) { return !curve.leads; });
    for (const PlotCurve& curve : curves)
        if (!runs || !curve.legend.isEmpty()) take(curve);
    for (auto curve = curves.rbegin(); curve != curves.rend(); ++curve)
        if (runs && curve->legend.isEmpty()) take(*curve);
    return named;
}

} // namespace

Legend legendInRow(const std::vector<PlotCurve>& curves, const QString& title, const QRectF& row, const QFont& font)
{
    constexpr double gap = PlotFrame::gap;
    const QFontMetricsF metrics(font);
    const std::vector<const PlotCurve*> named = namedCurves(curves, title);
    const double moreWidth = metrics.horizontalAdvance(QStringLiteral("+00"));
    Legend legend;
    legend.height = row.height();
    double used = 0.0;
    for (std::size_t i = 0; i < named.size(); ++i) {
        const QString text = metrics.elidedText(legendText(*named[i]), Qt::ElideRight, longestLegend);
        const double width = Legend::sample + gap + metrics.horizontalAdvance(text) + 2.0 * gap;
        if (used + width + (i + 1 < named.size() ? moreWidth : 0.0) > row.width()) break;
        legend.entries.push_back({named[i], text, QRectF(used, row.top(), width, row.height())});
        used += width;
    }
    legend.more = named.size() - legend.entries.size();
    const double left = row.right() - used - (legend.more > 0 ? moreWidth : -2.0 * gap);
    for (LegendEntry& entry : legend.entries) entry.box.translate(left, 0.0);
    return legend;
}

Legend legendInRows(const std::vector<PlotCurve>& curves, const QString& title, const QPointF& corner, double width,
                    const QFont& font)
{
    constexpr double before = Legend::sample + PlotFrame::gap;
    constexpr double between = 2.0 * PlotFrame::gap;
    const QFontMetricsF metrics(font);
    Legend legend;
    QPointF at = corner;
    for (const PlotCurve* curve : namedCurves(curves, title)) {
        const QString text = legendText(*curve);
        const double wanted = before + metrics.horizontalAdvance(text) + 1.0;
        if (at.x() > corner.x() && at.x() + wanted > corner.x() + width) at = {corner.x(), corner.y() + legend.height};
        QRectF box(at, QSizeF(std::min(wanted, width), metrics.height()));
        if (wanted > width)
            box.setHeight(
                metrics.boundingRect(QRectF(0.0, 0.0, width - before, 1e5), Qt::TextWrapAnywhere, text).height());
        legend.entries.push_back({curve, text, box});
        legend.height = std::max(legend.height, box.bottom() - corner.y());
        at.rx() += box.width() + between;
    }
    return legend;
}

} // namespace touchdown
