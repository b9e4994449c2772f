// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_painter.h"

#include <algorithm>

#include <QFontMetricsF>

#include "ui/plot/plot_path.h"

namespace touchdown {

PlotPainter::PlotPainter(const PlotWidget& plot, const PlotTheme& theme)
    : plot_(plot), theme_(theme), area_(plot.plotArea()), frame_(area_, plot.font(), plot.xAxis(), plot.yAxis(), 9)
{}

void PlotPainter::paintBehind(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    QColor minor = theme_.grid;
    minor.setAlphaF(0.45F);
    const auto gridPen = [&](const AxisTick& tick) { return QPen(tick.major ? theme_.grid : minor, 1.0); };
    for (const AxisTick& tick : frame_.xTicks) {
        const double x = alignedPixel(frame_.across(plot_.xAxis().position(tick.value)));
        painter.setPen(gridPen(tick));
        painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
    }
    for (const AxisTick& tick : frame_.yTicks) {
        const double y = alignedPixel(frame_.up(plot_.yAxis().position(tick.value)));
        painter.setPen(gridPen(tick));
        painter.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
    }
    paintReferenceLines(painter);
    paintShadedAreas(painter);
}

void PlotPainter::paintAbove(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme_.axis, 1.0));
    const double left = alignedPixel(area_.left());
    const double bottom = alignedPixel(area_.bottom());
    painter.drawLine(QPointF(left, area_.top()), QPointF(left, bottom));
    painter.drawLine(QPointF(left, bottom), QPointF(area_.right(), bottom));
    frame_.paintNumbers(painter, theme_, plot_.width(), plot_.xNumbersVisible());
    frame_.paintAxisTitles(painter, theme_, plot_.xNumbersVisible());
    paintHeader(painter);
    paintReferenceLabels(painter);
    paintEventMarks(painter);
    paintArrows(painter);
    paintDots(painter);
    paintPointMarks(painter);
}

void PlotPainter::paintHeader(QPainter& painter) const
{
    constexpr double gap = PlotFrame::gap;
    const QFontMetricsF metrics(frame_.textFont);
    const QRectF row(area_.left(), gap, area_.width(), metrics.height());
    const double room = row.width() - frame_.paintTitle(painter, theme_, plot_.title(), row.width()) - 3.0 * gap;

    std::vector<const PlotCurve*> named;
    for (const PlotCurve& curve : plot_.curves()) {
        const auto same = [&curve](const PlotCurve* other) {
            return other->name == curve.name && other->style == curve.style;
        };
        if (curve.visible && curve.inLegend && !curve.name.isEmpty() && curve.name != plot_.title() &&
            std::ranges::none_of(named, same))
            named.push_back(&curve);
    }

    constexpr double sample = 20.0; // of the line [px]
    const auto widthOf = [&](const PlotCurve& curve) {
        return sample + gap + metrics.horizontalAdvance(curve.name) + 2.0 * gap;
    };
    const double moreWidth = metrics.horizontalAdvance(QStringLiteral("+00"));
    double used = 0.0;
    std::size_t shown = 0;
    for (; shown < named.size(); ++shown) {
        const double width = widthOf(*named[shown]);
        if (used + width + (shown + 1 < named.size() ? moreWidth : 0.0) > room) break;
        used += width;
    }
    painter.setFont(frame_.textFont);
    double x = row.right() - used - (shown < named.size() ? moreWidth : -2.0 * gap);
    for (std::size_t i = 0; i < shown; ++i) {
        painter.setPen(curvePen(named[i]->style, theme_));
        painter.drawLine(QPointF(x, row.center().y()), QPointF(x + sample, row.center().y()));
        painter.setPen(theme_.mutedText);
        painter.drawText(QRectF(x + sample + gap, row.top(), widthOf(*named[i]), row.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, named[i]->name);
        x += widthOf(*named[i]);
    }
    if (shown < named.size() && !named.empty()) {
        painter.setPen(theme_.mutedText);
        painter.drawText(QRectF(x, row.top(), moreWidth, row.height()), Qt::AlignRight | Qt::AlignVCenter,
                         QStringLiteral("+%1").arg(named.size() - shown));
    }
}

void PlotPainter::paintCurves(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const auto paths = plot_.curvePaths();
    for (std::size_t i = 0; i < paths.size(); ++i) {
        painter.setPen(pathPen(plot_.curves()[i], paths[i], area_.size(), theme_));
        for (QPolygonF piece : insideArea(paths[i])) {
            for (QPointF& point : piece) point = {frame_.across(point.x()), frame_.up(point.y())};
            painter.drawPolyline(piece);
        }
    }
}

void PlotPainter::paintCursors(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(frame_.numberFont);
    for (int which = 0; which < 2; ++which) {
        const auto at = plot_.plotCursor(which);
        if (!at) continue;
        if (!plot_.isPhasePortrait()) {
            if (!plot_.xAxis().range().contains(*at)) continue;
            const double x = alignedPixel(frame_.across(plot_.xAxis().position(*at)));
            QPen pen(theme_.cursor, 1.0);
            if (which == 1) pen.setDashPattern({3.0, 3.0});
            painter.setPen(pen);
            painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
            // 1 left and 2 right of the line, so that close cursors hide neither each other's number nor the title.
            const double side = QFontMetricsF(frame_.numberFont).height();
            const QRectF tag(which == 0 ? x - side - 2.0 : x + 2.0, area_.top() + 8.0, side, side);
            painter.setPen(Qt::NoPen);
            painter.setBrush(theme_.cursor);
            painter.drawRoundedRect(tag, 3.0, 3.0);
            painter.setPen(theme_.background);
            painter.drawText(tag, Qt::AlignCenter, QString::number(which + 1));
        }
        for (const PlotCurve& curve : plot_.curves()) {
            if (!curve.visible || curve.data == nullptr) continue;
            const auto y = curve.data->valueAt(*at);
            const auto x = curve.xData != nullptr ? curve.xData->valueAt(*at) : at;
            if (!x || !y) continue;
            const QPointF centre(frame_.across(plot_.xAxis().position(*x)), frame_.up(plot_.yAxis().position(*y)));
            if (!area_.contains(centre)) continue;
            painter.setPen(QPen(theme_.background, 1.5));
            painter.setBrush(theme_.colour(curve.style));
            painter.drawEllipse(centre, 4.0, 4.0);
        }
        painter.setBrush(Qt::NoBrush);
    }
}

void PlotPainter::paintSelection(QPainter& painter, const QRectF& box) const
{
    QColor fill = theme_.selection;
    fill.setAlphaF(0.15F);
    painter.setPen(QPen(theme_.selection, 1.0));
    painter.setBrush(fill);
    painter.drawRect(box.intersected(area_));
    painter.setBrush(Qt::NoBrush);
}

void PlotPainter::paintShadedAreas(QPainter& painter) const
{
    painter.save();
    painter.setClipRect(area_);
    painter.setPen(Qt::NoPen);
    painter.setFont(frame_.numberFont);
    const QFontMetricsF metrics(frame_.numberFont);
    for (const ShadedArea& shaded : plot_.shadedAreas()) {
        QPolygonF outline;
        for (const auto& [x, y] : shaded.outline)
            outline << QPointF(frame_.across(plot_.xAxis().position(x)), frame_.up(plot_.yAxis().position(y)));
        QColor fill = theme_.colour(shaded.style);
        fill.setAlphaF(0.18F);
        painter.setBrush(fill);
        painter.drawPolygon(outline);
        if (shaded.label.isEmpty()) continue;
        QRectF box(0.0, 0.0, metrics.horizontalAdvance(shaded.label) + 4.0, metrics.height());
        box.moveCenter(outline.boundingRect().center());
        if (area_.contains(box)) paintLabel(painter, box, shaded.label, theme_.text);
        painter.setPen(Qt::NoPen);
    }
    painter.restore();
}

void PlotPainter::paintReferenceLines(QPainter& painter) const
{
    QPen pen(theme_.referenceLine, 1.0);
    pen.setDashPattern({4.0, 4.0});
    painter.setPen(pen);
    for (const ReferenceLine& line : plot_.referenceLines()) {
        if (!plot_.yAxis().range().contains(line.value)) continue;
        const double y = alignedPixel(frame_.up(plot_.yAxis().position(line.value)));
        painter.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
    }
}

void PlotPainter::paintReferenceLabels(QPainter& painter) const
{
    painter.setFont(frame_.numberFont);
    const QFontMetricsF metrics(frame_.numberFont);
    std::vector<QRectF> taken;
    for (const ReferenceLine& line : plot_.referenceLines()) {
        if (line.label.isEmpty() || !plot_.yAxis().range().contains(line.value)) continue;
        const double y = frame_.up(plot_.yAxis().position(line.value));
        QRectF box(0.0, 0.0, metrics.horizontalAdvance(line.label) + 4.0, metrics.height());
        box.moveBottomRight({area_.right() - 4.0, y - 1.0});
        if (box.top() < area_.top()) box.moveTop(y + 2.0);
        for (const QRectF& other : taken)
            if (box.intersects(other)) box.moveRight(other.left() - PlotFrame::gap);
        taken.push_back(box);
        paintLabel(painter, box, line.label, theme_.mutedText);
    }
}

void PlotPainter::paintEventMarks(QPainter& painter) const
{
    painter.setPen(QPen(theme_.referenceLine, 1.0));
    double last = -1e9;
    for (const EventMark& mark : plot_.eventMarks()) {
        if (plot_.isPhasePortrait() || !plot_.xAxis().range().contains(mark.time)) continue;
        const double x = alignedPixel(frame_.across(plot_.xAxis().position(mark.time)));
        if (x == last) continue; // thousands of bounces fall onto one column
        last = x;
        painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.top() + 6.0));
    }
}

void PlotPainter::paintArrows(QPainter& painter) const
{
    painter.setPen(Qt::NoPen);
    for (std::size_t i = 0; i < std::min(plot_.curves().size(), plot_.phasePaths().size()); ++i) {
        if (!plot_.curves()[i].arrows) continue;
        painter.setBrush(theme_.colour(plot_.curves()[i].style));
        for (const PathArrow& arrow : pathArrows(plot_.phasePaths()[i], area_.size())) {
            const QPointF along(arrow.along.x(), -arrow.along.y());
            const QPointF side(-along.y(), along.x());
            const QPointF tip = QPointF(frame_.across(arrow.tip.x()), frame_.up(arrow.tip.y())) + 4.5 * along;
            painter.drawPolygon(QPolygonF({tip, tip - 9.0 * along + 4.0 * side, tip - 9.0 * along - 4.0 * side}));
        }
    }
    painter.setBrush(Qt::NoBrush);
}

void PlotPainter::paintDots(QPainter& painter) const
{
    painter.setPen(Qt::NoPen);
    for (const PlotCurve& curve : plot_.curves()) {
        if (!curve.dots || !curve.visible || curve.data == nullptr) continue;
        painter.setBrush(theme_.colour(curve.style));
        const PlotRange& seen = plot_.xAxis().range();
        const auto [begin, end] = curve.data->samplesWithin(seen.low, seen.high);
        for (std::size_t i = begin; i < end; ++i) {
            const QPointF at(frame_.across(plot_.xAxis().position(curve.data->time(i))),
                             frame_.up(plot_.yAxis().position(curve.data->value(i))));
            if (at.y() >= area_.top() && at.y() <= area_.bottom()) painter.drawEllipse(at, 3.0, 3.0);
        }
    }
    painter.setBrush(Qt::NoBrush);
}

void PlotPainter::paintPointMarks(QPainter& painter) const
{
    struct Placed {
        const PointMark* mark;
        QPointF tip;
    };
    std::vector<Placed> placed;
    std::vector<QRectF> taken;
    painter.setPen(Qt::NoPen);
    for (const PointMark& mark : plot_.pointMarks()) {
        const QPointF at(frame_.across(plot_.xAxis().position(mark.x)), frame_.up(plot_.yAxis().position(mark.y)));
        if (!area_.contains(at)) continue;
        const QPointF tip = at - QPointF(0.0, 3.0);
        painter.setBrush(theme_.colour(mark.style));
        painter.drawPolygon(QPolygonF({tip, tip + QPointF(-4.0, -6.0), tip + QPointF(4.0, -6.0)}));
        placed.push_back({&mark, tip});
        taken.emplace_back(tip - QPointF(4.0, 6.0), QSizeF(8.0, 6.0));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setFont(frame_.numberFont);
    const QFontMetricsF metrics(frame_.numberFont);
    for (const auto& [mark, tip] : placed) {
        const QSizeF size(metrics.horizontalAdvance(mark->label) + 4.0, metrics.height());
        // The highest point may have no room above it: its label stands beside it, below the plot's upper edge.
        const double beside = std::max(tip.y() - size.height(), area_.top());
        const QPointF corners[] = {tip - QPointF(size.width() / 2.0, 7.0 + size.height()),
                                   {tip.x() + 6.0, beside},
                                   {tip.x() - 6.0 - size.width(), beside}};
        for (const QPointF& corner : corners) {
            const QRectF box(corner, size);
            const auto meets = [&](const QRectF& other) { return other.intersects(box); };
            if (!area_.contains(box) || std::ranges::any_of(taken, meets)) continue;
            taken.push_back(box);
            paintLabel(painter, box, mark->label, theme_.text);
            break; // without room anywhere the marker stands alone
        }
    }
}

void PlotPainter::paintLabel(QPainter& painter, const QRectF& box, const QString& text, const QColor& colour) const
{
    QColor paper = theme_.plotArea;
    paper.setAlphaF(0.75F);
    painter.fillRect(box, paper);
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace touchdown
