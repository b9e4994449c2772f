// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <QFontInfo>
#include <QFontMetricsF>

namespace touchdown {

namespace {

constexpr double leastArea = 3.0, leastStep = 0.8; // of the numbers at the left, in their heights

QFont titleFont(const QFont& text)
{
    QFont heavy = text;
    heavy.setWeight(QFont::DemiBold);
    return heavy;
}

/// Heights of the title above the area and of the numbers below it [px].
std::pair<double, double> aroundArea(const QFont& font, bool xNumbers)
{
    const double text = QFontMetricsF(plotTextFont(font)).height();
    const double numbers = QFontMetricsF(plotNumberFont(font)).height();
    return {std::ceil(text + 2.0 * PlotFrame::gap),
            xNumbers ? PlotFrame::tickLength + numbers + text + PlotFrame::gap + 4.0 : PlotFrame::gap};
}

/// Smaller where it has no room; shortened only where it could not be read any more.
void paintFitting(QPainter& painter, const QRectF& box, const QString& text, QFont font, double least)
{
    const double wanted = QFontMetricsF(font).horizontalAdvance(text);
    if (wanted > box.width())
        font.setPixelSize(std::max(static_cast<int>(std::lround(least * font.pixelSize())),
                                   static_cast<int>(font.pixelSize() * box.width() / wanted)));
    painter.setFont(font);
    painter.drawText(box, Qt::AlignCenter, QFontMetricsF(font).elidedText(text, Qt::ElideRight, box.width()));
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

double alignedPixel(double pixel) { return std::floor(pixel) + 0.5; }

QRectF PlotFrame::areaWithin(const QSizeF& size, const QFont& font, const QString& widestNumber, double right,
                             bool xNumbers)
{
    const double text = QFontMetricsF(plotTextFont(font)).height();
    const QFontMetricsF numbers(plotNumberFont(font));
    const double left = gap + text + gap + numbers.horizontalAdvance(widestNumber) + tickLength;
    const auto [above, below] = aroundArea(font, xNumbers);
    return {std::ceil(left), above, std::max(20.0, std::floor(size.width() - left - right)),
            std::max(20.0, std::floor(size.height() - above - below))};
}

int PlotFrame::leastHeight(const QFont& font, bool xNumbers)
{
    const auto [above, below] = aroundArea(font, xNumbers);
    return static_cast<int>(std::ceil(above + leastArea * QFontMetricsF(plotNumberFont(font)).height() + below));
}

QRectF PlotFrame::curveArea(const QSizeF& size, const QFont& font, bool xNumbers, const LabelRoom& labels)
{
    const QFontMetricsF numbers(plotNumberFont(font));
    double right = numbers.horizontalAdvance(QStringLiteral("00.0")) / 2.0 + gap;
    if (labels.width > 0.0)
        right = std::max(
            right, std::min(leader + labels.width + 2.0, (labels.paper ? mostOnPaper : mostLabels) * size.width()));
    QRectF area = areaWithin(size, font, QStringLiteral("\u2212000.000"), right, xNumbers);
    if (labels.above) area.setTop(std::min(area.top() + std::ceil(numbers.height() + leader), area.bottom() - 20.0));
    return area;
}

PlotFrame::PlotFrame(const QRectF& plotArea, const QFont& font, const PlotAxis& xAxis, const PlotAxis& yAxis,
                     int mostUp)
    : area(plotArea), textFont(plotTextFont(font)), numberFont(plotNumberFont(font)), x(&xAxis), y(&yAxis)
{
    const QFontMetricsF numbers(numberFont);
    const double width = numbers.horizontalAdvance(QStringLiteral("00000.000"));
    xTicks = x->ticks(std::min(12, static_cast<int>(area.width() / width)));
    yTicks = y->ticks(std::min(mostUp, static_cast<int>(area.height() / (2.0 * numbers.height()))));
}

void PlotFrame::paintNumbers(QPainter& painter, const PlotTheme& theme, double width, bool xNumbers) const
{
    painter.setFont(numberFont);
    const QFontMetricsF metrics(numberFont);
    const double height = metrics.height();
    double below = std::numeric_limits<double>::infinity(); // the last number
    for (const AxisTick& tick : yTicks) {
        if (!tick.major) continue;
        const double at = alignedPixel(up(y->position(tick.value)));
        painter.setPen(QPen(theme.axis, 1.0));
        painter.drawLine(QPointF(area.left() - tickLength, at), QPointF(area.left(), at));
        if (below - at < leastStep * height) continue;
        below = at;
        painter.setPen(theme.mutedText);
        painter.drawText(QRectF(0.0, at - height / 2.0, area.left() - tickLength - 3.0, height),
                         Qt::AlignRight | Qt::AlignVCenter, tick.text);
    }
    double free = 0.0; // no number begins left of this
    for (const AxisTick& tick : xTicks) {
        if (!tick.major) continue;
        const double at = alignedPixel(across(x->position(tick.value)));
        painter.setPen(QPen(theme.axis, 1.0));
        painter.drawLine(QPointF(at, area.bottom()), QPointF(at, area.bottom() + tickLength));
        const double half = metrics.horizontalAdvance(tick.text) / 2.0 + 1.0;
        const double left = std::min(at - half, width - 2.0 * half - 2.0);
        if (!xNumbers || left < free) continue;
        painter.setPen(theme.mutedText);
        painter.drawText(QRectF(left, area.bottom() + tickLength + 1.0, 2.0 * half, height), Qt::AlignCenter,
                         tick.text);
        free = left + 2.0 * half + gap;
    }
}

void PlotFrame::paintAxisTitles(QPainter& painter, const PlotTheme& theme, bool xTitle) const
{
    const double height = QFontMetricsF(textFont).height();
    painter.setPen(theme.text);
    if (xTitle) {
        const double top = area.bottom() + tickLength + QFontMetricsF(numberFont).height() + 2.0;
        paintFitting(painter, QRectF(area.left(), top, area.width(), height + 2.0), x->text(), textFont, least);
    }
    painter.save();
    painter.translate(gap, area.center().y());
    painter.rotate(-90.0);
    const double length = area.height() + height; // may reach a little over the ends
    QString text = y->text();
    const QFontMetricsF metrics(textFont);
    if (const double room = length / least; metrics.horizontalAdvance(text) > room) { // the unit stays whole
        const QString unit = text.mid(std::max<qsizetype>(0, text.lastIndexOf(u'[')));
        text = metrics.elidedText(text.chopped(unit.size()), Qt::ElideRight, room - metrics.horizontalAdvance(unit)) +
               unit;
    }
    paintFitting(painter, QRectF(-length / 2.0, 0.0, length, height), text, textFont, least);
    painter.restore();
}

void PlotFrame::paintTitle(QPainter& painter, const PlotTheme& theme, const QString& title, double width,
                           bool lines) const
{
    const QFont heavy = titleFont(textFont);
    painter.setFont(heavy);
    painter.setPen(theme.text);
    const QRectF row(area.left(), gap, width, lineHeight());
    if (lines)
        painter.drawText(QRectF(row.topLeft(), QSizeF(width, titleHeight(title, width))), Qt::TextWordWrap, title);
    else
        painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                         QFontMetricsF(heavy).elidedText(title, Qt::ElideRight, width));
}

double PlotFrame::titleHeight(const QString& title, double width) const
{
    if (title.isEmpty()) return 0.0;
    return QFontMetricsF(titleFont(textFont)).boundingRect({0.0, 0.0, width, 1e5}, Qt::TextWordWrap, title).height();
}

double PlotFrame::lineHeight() const { return QFontMetricsF(textFont).height(); }

double PlotFrame::numberHeight() const { return QFontMetricsF(numberFont).height(); }

double PlotFrame::titleWidth(const QString& title, double width) const
{
    const QFontMetricsF metrics(titleFont(textFont));
    return metrics.horizontalAdvance(metrics.elidedText(title, Qt::ElideRight, width));
}

} // namespace touchdown
