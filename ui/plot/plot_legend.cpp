// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_legend.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>

#include "ui/plot/plot_frame.h"

namespace touchdown {

namespace {

constexpr double leastText = 11.0; // of an entry in a row, before another has no room [heights of the text]
constexpr double leastAlone = 3.0; // of the only entry [heights of the text]

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

/// To which length texts are cut so that they fit into `room` together: those that are shorter leave it to the others.
double longestText(std::vector<double> lengths, double room)
{
    std::ranges::sort(lengths);
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const double share = room / static_cast<double>(lengths.size() - i);
        if (lengths[i] > share) return share;
        room -= lengths[i];
    }
    return lengths.empty() ? room : lengths.back();
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
    constexpr double around = Legend::sample + 3.0 * gap;
    std::vector<double> lengths;
    for (const PlotCurve* curve : named) lengths.push_back(std::ceil(metrics.horizontalAdvance(legendText(*curve))));
    const double room = row.width() - around * static_cast<double>(named.size());
    const double longest = std::max(longestText(lengths, room), leastText * metrics.height());
    double used = 0.0;
    for (std::size_t i = 0; i < named.size(); ++i) {
        const double more = i + 1 < named.size() ? moreWidth : 0.0;
        // One entry says more than the number of those without room.
        const double alone = std::max(row.width() - around - more, leastAlone * metrics.height());
        const QString text =
            metrics.elidedText(legendText(*named[i]), Qt::ElideRight, i == 0 ? std::min(longest, alone) : longest);
        const double width = around + metrics.horizontalAdvance(text);
        if (used + width + more > row.width()) break;
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
