// SPDX-License-Identifier: GPL-3.0-or-later
//
// The places of everything in a panel, and what is under the pointer.
#include "ui/studies/study_panel.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>

#include "core/studies/study/study.h"
#include "ui/plot/plot_painter.h"
#include "ui/style/foreign_text.h"
#include "ui/style/readable.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr double reach = 20.0; // [widths of the area] lines end this far outside: painters fail at larger coordinates
constexpr double near = 9.0;   // of a pointer to a point [px]

QString plain(const std::string& text) { return escapedForTip(readable(text)); }

QString valueLine(const PlotAxis& axis, double value, double error)
{
    QString number = axis.reading(value);
    if (error > 0.0) number += QStringLiteral(" ± ") + axis.reading(error);
    if (!axis.label.unit.isEmpty()) number += QChar(0x00A0) + axis.label.unit;
    return QStringLiteral("%1: %2").arg(escapedForTip(axis.label.title), escapedForTip(number));
}

} // namespace

QSizeF leastPanelSize(const QFont& font)
{
    const double em = QFontMetricsF(plotTextFont(font)).height();
    return {19.0 * em, 13.5 * em};
}

StudyPanel::StudyPanel(const ChartPanel& panel, const ChartStyles& styles, const PlotTheme& theme, const QFont& font,
                       const QRectF& box, const std::optional<PanelRange>& zoomed)
    : panel_(panel),
      styles_(styles),
      theme_(theme),
      textFont_(plotTextFont(font)),
      numberFont_(plotNumberFont(font)),
      radius_(0.29 * textFont_.pixelSize()),
      axes_(panelAxes(panel, zoomed)),
      box_(box)
{
    if (panel.map) {
        xEdges_ = cellEdges(panel.map->x, panel.x.logarithmic);
        yEdges_ = cellEdges(panel.map->y, panel.y.logarithmic);
    }
    layOut();
}

void StudyPanel::layOut()
{
    const QFontMetricsF text(textFont_), numbers(numberFont_);
    const double top = std::ceil(0.5 * numbers.height() + 2.0);
    const double bottom = PlotFrame::tickLength + 1.0 + numbers.height() + 2.0 + text.height();
    const double right = 1.2 * numbers.horizontalAdvance(QStringLiteral("00"));
    area_ = {std::ceil(box_.left()), std::ceil(box_.top() + top), box_.width(),
             std::floor(std::max(20.0, box_.height() - top - bottom))};
    const auto place = [&] {
        double widest = 0.0;
        for (const AxisTick& tick : frame().yTicks) widest = std::max(widest, numbers.horizontalAdvance(tick.text));
        const double left = std::ceil(text.height() + PlotFrame::gap + widest + PlotFrame::tickLength + 3.0);
        area_.setLeft(std::ceil(box_.left() + left));
        area_.setWidth(std::max(20.0, std::floor(box_.width() - left - right)));
    };
    place();
    if (!panel_.equalScales) return;
    equaliseScales(axes_, area_.size());
    place();
    equaliseScales(axes_, area_.size());
}

double StudyPanel::across(double x) const
{
    return area_.left() + std::clamp(axes_.x.position(x), -reach, reach) * area_.width();
}

double StudyPanel::up(double y) const
{
    return area_.bottom() - std::clamp(axes_.y.position(y), -reach, reach) * area_.height();
}

QPointF StudyPanel::toPixel(double x, double y) const { return {across(x), up(y)}; }

PanelRange StudyPanel::rangeOf(const QRectF& box) const
{
    const QRectF part = box.intersected(area_);
    const auto alongX = [this](double pixel) { return (pixel - area_.left()) / area_.width(); };
    const auto alongY = [this](double pixel) { return (area_.bottom() - pixel) / area_.height(); };
    return {axes_.x.part(alongX(part.left()), alongX(part.right())),
            axes_.y.part(alongY(part.bottom()), alongY(part.top()))};
}

QRectF StudyPanel::bandBox(const ChartBand& band) const
{
    const auto pixel = [&](double value, bool lower) {
        if (band.alongX)
            return std::isfinite(value) ? std::clamp(across(value), area_.left(), area_.right())
                   : lower              ? area_.left()
                                        : area_.right();
        return std::isfinite(value) ? std::clamp(up(value), area_.top(), area_.bottom())
               : lower              ? area_.bottom()
                                    : area_.top();
    };
    const double from = pixel(band.lower, true), to = pixel(band.upper, false);
    return band.alongX ? QRectF(QPointF(from, area_.top()), QPointF(to, area_.bottom())).normalized()
                       : QRectF(QPointF(area_.left(), from), QPointF(area_.right(), to)).normalized();
}

QRectF StudyPanel::cellBox(int cell) const
{
    const auto columns = static_cast<int>(panel_.map->x.size());
    const auto i = static_cast<std::size_t>(cell % columns), j = static_cast<std::size_t>(cell / columns);
    return QRectF(toPixel(xEdges_[i], yEdges_[j + 1]), toPixel(xEdges_[i + 1], yEdges_[j])).normalized();
}

std::vector<QPolygonF> StudyPanel::polylines(const ChartSeries& series) const
{
    std::vector<QPolygonF> result(1);
    for (const ChartPoint& point : series.points) {
        if (point.kind == PointKind::Failed) { // no answer, no line through it
            if (!result.back().isEmpty()) result.emplace_back();
            continue;
        }
        const QPointF at = toPixel(point.x, point.y);
        if (series.line == ChartLine::Steps && !result.back().isEmpty())
            result.back() << QPointF(at.x(), result.back().back().y());
        result.back() << at;
    }
    return result;
}

std::optional<PanelHit> StudyPanel::at(const QPointF& pixel) const
{
    if (!area_.adjusted(-near, -near, near, near).contains(pixel)) return {};
    PanelHit hit;
    double nearest = near * near;
    for (std::size_t s = 0; s < panel_.series.size(); ++s)
        for (std::size_t p = 0; p < panel_.series[s].points.size(); ++p) {
            const QPointF at = toPixel(panel_.series[s].points[p].x, panel_.series[s].points[p].y);
            const QPointF away = at - pixel;
            const double distance = QPointF::dotProduct(away, away);
            if (distance > nearest || !inside(at)) continue;
            nearest = distance;
            hit.series = static_cast<int>(s);
            hit.point = static_cast<int>(p);
        }
    if (hit.point >= 0) return hit;
    if (!area_.contains(pixel)) return {};
    for (std::size_t c = 0; panel_.map && c < panel_.map->cells.size(); ++c)
        if (cellBox(static_cast<int>(c)).contains(pixel)) hit.cell = static_cast<int>(c);
    for (std::size_t b = 0; hit.cell < 0 && b < panel_.bands.size(); ++b)
        if (bandBox(panel_.bands[b]).adjusted(-3.0, -3.0, 3.0, 3.0).contains(pixel)) hit.band = static_cast<int>(b);
    if (hit == PanelHit{}) return {};
    return hit;
}

QString StudyPanel::bandText(const ChartBand& band) const
{
    const PlotAxis& axis = band.alongX ? axes_.x : axes_.y;
    const auto end = [&axis](double value) {
        return axis.reading(value) + (axis.label.unit.isEmpty() ? QString() : QChar(0x00A0) + axis.label.unit);
    };
    QString range;
    if (band.lower == band.upper)
        range = end(band.lower);
    else if (!std::isfinite(band.lower))
        range = tr("up to %1").arg(end(band.upper));
    else if (!std::isfinite(band.upper))
        range = tr("from %1").arg(end(band.lower));
    else
        range = tr("%1 to %2").arg(end(band.lower), end(band.upper));
    return QStringLiteral("<b>%1</b><br>%2").arg(plain(band.label), escapedForTip(range));
}

QString StudyPanel::reading(const PanelHit& hit) const
{
    QStringList lines;
    if (hit.point >= 0) {
        const ChartSeries& series = panel_.series[static_cast<std::size_t>(hit.series)];
        const ChartPoint& point = series.points[static_cast<std::size_t>(hit.point)];
        lines << QStringLiteral("<b>%1</b>").arg(plain(series.name)) +
                     (point.label.empty() ? QString() : QStringLiteral(" · ") + plain(point.label));
        lines << valueLine(axes_.x, point.x, point.xError) << valueLine(axes_.y, point.y, point.yError);
        if (point.kind == PointKind::WrongState) lines << tr("Ends in another state than the reference.");
        if (point.kind == PointKind::Failed) lines << tr("No valid answer.");
        if (point.chosen) lines << tr("The default of the program or the recommended setting.");
    } else if (hit.cell >= 0) {
        const ChartMap& map = *panel_.map;
        const auto cell = static_cast<std::size_t>(hit.cell);
        const int which = map.cells[cell];
        lines << QStringLiteral("<b>%1</b>")
                     .arg(which < 0 ? tr("Not computed") : plain(map.classes[static_cast<std::size_t>(which)].name));
        lines << valueLine(axes_.x, map.x[cell % map.x.size()], 0.0)
              << valueLine(axes_.y, map.y[cell / map.x.size()], 0.0);
        if (cell < map.details.size() && !map.details[cell].empty()) lines << plain(map.details[cell]);
    } else if (hit.band >= 0) {
        lines << bandText(panel_.bands[static_cast<std::size_t>(hit.band)]);
    }
    return lines.join(QStringLiteral("<br>"));
}

} // namespace touchdown
