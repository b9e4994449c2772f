// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_painter.h"

#include "ui/plot/plot_path.h"

#include <algorithm>
#include <cmath>

#include <QFontInfo>
#include <QFontMetricsF>

namespace touchdown {

namespace {

constexpr double gap = 6.0;        // between things that belong together [px]
constexpr double tickLength = 4.0; // [px]

double aligned(double pixel)
{
    return std::floor(pixel) + 0.5; // a thin line fills one row of pixels
}

QFont heavier(QFont font)
{
    font.setWeight(QFont::DemiBold);
    return font;
}

} // namespace

QFont plotTextFont(const QFont& font)
{
    QFont inPixels = font;
    inPixels.setPixelSize(std::max(1, QFontInfo(font).pixelSize()));
    return inPixels;
}

QFont plotNumberFont(const QFont& font)
{
    QFont small = plotTextFont(font);
    small.setPixelSize(std::max(1, static_cast<int>(std::lround(0.9 * small.pixelSize()))));
    return small;
}

PlotPainter::PlotPainter(const PlotWidget& plot, const PlotTheme& theme)
    : plot_(plot),
      theme_(theme),
      textFont_(plotTextFont(plot.font())),
      numberFont_(plotNumberFont(plot.font())),
      area_(plot.plotArea())
{}

QRectF PlotPainter::plotArea(const QSizeF& size, const QFont& font, bool xNumbers)
{
    const QFontMetricsF text(plotTextFont(font));
    const QFontMetricsF numbers(plotNumberFont(font));
    const double left =
        gap + text.height() + gap + numbers.horizontalAdvance(QStringLiteral("\u2212000.000")) + tickLength;
    const double top = std::ceil(text.height() + 2.0 * gap);
    const double below = tickLength + numbers.height() + text.height() + gap + 4.0;
    const double right = numbers.horizontalAdvance(QStringLiteral("00.0")) / 2.0 + gap;
    const double bottom = xNumbers ? below : gap;
    return {std::ceil(left), top, std::max(20.0, std::floor(size.width() - left - right)),
            std::max(20.0, std::floor(size.height() - top - bottom))};
}

std::vector<AxisTick> PlotPainter::xTicks() const
{
    const double width = QFontMetricsF(numberFont_).horizontalAdvance(QStringLiteral("00000.000"));
    return plot_.xAxis().ticks(std::min(12, static_cast<int>(area_.width() / width)));
}

std::vector<AxisTick> PlotPainter::yTicks() const
{
    return plot_.yAxis().ticks(
        std::min(9, static_cast<int>(area_.height() / (2.0 * QFontMetricsF(numberFont_).height()))));
}

void PlotPainter::paintBehind(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    QColor minor = theme_.grid;
    minor.setAlphaF(0.45F);
    const auto gridPen = [&](const AxisTick& tick) { return QPen(tick.major ? theme_.grid : minor, 1.0); };
    for (const AxisTick& tick : xTicks()) {
        const double x = aligned(across(plot_.xAxis().position(tick.value)));
        painter.setPen(gridPen(tick));
        painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
    }
    for (const AxisTick& tick : yTicks()) {
        const double y = aligned(up(plot_.yAxis().position(tick.value)));
        painter.setPen(gridPen(tick));
        painter.drawLine(QPointF(area_.left(), y), QPointF(area_.right(), y));
    }
    paintReferenceLines(painter);
}

void PlotPainter::paintAbove(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme_.axis, 1.0));
    const double left = aligned(area_.left());
    const double bottom = aligned(area_.bottom());
    painter.drawLine(QPointF(left, area_.top()), QPointF(left, bottom));
    painter.drawLine(QPointF(left, bottom), QPointF(area_.right(), bottom));
    paintNumbers(painter);
    paintAxisTitles(painter);
    paintHeader(painter);
    paintReferenceLabels(painter);
    paintEventMarks(painter);
    paintArrows(painter);
    paintPointMarks(painter);
}

void PlotPainter::paintNumbers(QPainter& painter) const
{
    painter.setFont(numberFont_);
    const QFontMetricsF metrics(numberFont_);
    const double height = metrics.height();
    for (const AxisTick& tick : yTicks()) {
        if (!tick.major) continue;
        const double y = aligned(up(plot_.yAxis().position(tick.value)));
        painter.setPen(QPen(theme_.axis, 1.0));
        painter.drawLine(QPointF(area_.left() - tickLength, y), QPointF(area_.left(), y));
        painter.setPen(theme_.mutedText);
        painter.drawText(QRectF(0.0, y - height / 2.0, area_.left() - tickLength - 3.0, height),
                         Qt::AlignRight | Qt::AlignVCenter, tick.text);
    }
    double free = 0.0; // no number begins left of this
    for (const AxisTick& tick : xTicks()) {
        if (!tick.major) continue;
        const double x = aligned(across(plot_.xAxis().position(tick.value)));
        painter.setPen(QPen(theme_.axis, 1.0));
        painter.drawLine(QPointF(x, area_.bottom()), QPointF(x, area_.bottom() + tickLength));
        const double half = metrics.horizontalAdvance(tick.text) / 2.0 + 1.0;
        const double left = std::min(x - half, plot_.width() - 2.0 * half - 2.0); // the last one may not leave the plot
        if (!plot_.xNumbersVisible() || left < free) continue;
        painter.setPen(theme_.mutedText);
        painter.drawText(QRectF(left, area_.bottom() + tickLength + 1.0, 2.0 * half, height), Qt::AlignCenter,
                         tick.text);
        free = left + 2.0 * half + gap;
    }
}

void PlotPainter::paintAxisTitles(QPainter& painter) const
{
    const QFontMetricsF metrics(textFont_);
    painter.setFont(textFont_);
    painter.setPen(theme_.text);
    if (plot_.xNumbersVisible()) {
        const double y = area_.bottom() + tickLength + QFontMetricsF(numberFont_).height() + 2.0;
        const QString text = metrics.elidedText(plot_.xAxis().text(), Qt::ElideRight, area_.width());
        painter.drawText(QRectF(area_.left(), y, area_.width(), metrics.height() + 2.0), Qt::AlignCenter, text);
    }
    painter.save();
    painter.translate(gap, area_.center().y());
    painter.rotate(-90.0);
    const double length = area_.height() + metrics.height(); // may reach a little over the ends
    const QString text = metrics.elidedText(plot_.yAxis().text(), Qt::ElideRight, length);
    painter.drawText(QRectF(-length / 2.0, 0.0, length, metrics.height()), Qt::AlignCenter, text);
    painter.restore();
}

void PlotPainter::paintHeader(QPainter& painter) const
{
    const QFont titleFont = heavier(textFont_);
    const QFontMetricsF metrics(textFont_);
    const QRectF row(area_.left(), gap, area_.width(), metrics.height());
    painter.setFont(titleFont);
    painter.setPen(theme_.text);
    const QFontMetricsF titleMetrics(titleFont);
    const QString title = titleMetrics.elidedText(plot_.title(), Qt::ElideRight, row.width());
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, title);
    double room = row.width() - titleMetrics.horizontalAdvance(title) - 3.0 * gap;

    std::vector<const PlotCurve*> named;
    for (const PlotCurve& curve : plot_.curves()) {
        const auto same = [&curve](const PlotCurve* other) {
            return other->name == curve.name && other->style == curve.style;
        };
        if (curve.visible && !curve.name.isEmpty() && curve.name != plot_.title() && std::ranges::none_of(named, same))
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
    painter.setFont(textFont_);
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
        const bool dashed = pathLength(paths[i], area_.size()) < longestDashed * area_.width();
        QPen pen = curvePen(plot_.curves()[i].style, theme_, dashed);
        if (plot_.curves()[i].xData) pen = penThereAndBack(paths[i], area_.size(), pen);
        painter.setPen(pen);
        for (QPolygonF piece : insideArea(paths[i])) {
            for (QPointF& point : piece) point = {across(point.x()), up(point.y())};
            painter.drawPolyline(piece);
        }
    }
}

void PlotPainter::paintCursors(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(numberFont_);
    for (int which = 0; which < 2; ++which) {
        const auto at = plot_.plotCursor(which);
        if (!at) continue;
        if (!plot_.isPhasePortrait()) {
            if (!plot_.xAxis().range().contains(*at)) continue;
            const double x = aligned(across(plot_.xAxis().position(*at)));
            QPen pen(theme_.cursor, 1.0);
            if (which == 1) pen.setDashPattern({3.0, 3.0});
            painter.setPen(pen);
            painter.drawLine(QPointF(x, area_.top()), QPointF(x, area_.bottom()));
            // 1 left and 2 right of the line, so that close cursors hide neither each other's number nor the title.
            const double side = QFontMetricsF(numberFont_).height();
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
            const QPointF centre(across(plot_.xAxis().position(*x)), up(plot_.yAxis().position(*y)));
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

} // namespace touchdown
