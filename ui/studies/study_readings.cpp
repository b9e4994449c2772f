// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_readings.h"

#include <cmath>

#include <QCoreApplication>
#include <QStringList>

namespace touchdown {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("touchdown::StudyReadings", text); }

QString plain(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

QString valueLine(const PlotAxis& axis, double value, double error)
{
    QString number = axis.reading(value);
    if (error > 0.0) number += QStringLiteral(" ± ") + axis.reading(error);
    if (!axis.label.unit.isEmpty()) number += QChar(0x00A0) + axis.label.unit;
    return QStringLiteral("%1: %2").arg(axis.label.title.toHtmlEscaped(), number.toHtmlEscaped());
}

QString bandText(const StudyPanel& panel, const ChartBand& band)
{
    const PlotAxis& axis = band.alongX ? panel.axes().x : panel.axes().y;
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
    return QStringLiteral("<b>%1</b><br>%2").arg(plain(band.label), range.toHtmlEscaped());
}

} // namespace

QString reading(const StudyPanel& panel, const PanelHit& hit)
{
    QStringList lines;
    if (hit.point >= 0) {
        const ChartSeries& series = panel.panel().series[static_cast<std::size_t>(hit.series)];
        const ChartPoint& point = series.points[static_cast<std::size_t>(hit.point)];
        lines << QStringLiteral("<b>%1</b>").arg(plain(series.name)) +
                     (point.label.empty() ? QString() : QStringLiteral(" · ") + plain(point.label));
        lines << valueLine(panel.axes().x, point.x, point.xError) << valueLine(panel.axes().y, point.y, point.yError);
        if (point.kind == PointKind::WrongState) lines << tr("Ends in another state than the reference.");
        if (point.kind == PointKind::Failed) lines << tr("No valid answer.");
        if (point.chosen) lines << tr("The default of the program or the recommended setting.");
    } else if (hit.cell >= 0) {
        const ChartMap& map = *panel.panel().map;
        const auto cell = static_cast<std::size_t>(hit.cell);
        const int which = map.cells[cell];
        lines << QStringLiteral("<b>%1</b>")
                     .arg(which < 0 ? tr("Not known") : plain(map.classes[static_cast<std::size_t>(which)].name));
        lines << valueLine(panel.axes().x, map.x[cell % map.x.size()], 0.0)
              << valueLine(panel.axes().y, map.y[cell / map.x.size()], 0.0);
        if (cell < map.details.size() && !map.details[cell].empty()) lines << plain(map.details[cell]);
    } else if (hit.band >= 0) {
        lines << bandText(panel, panel.panel().bands[static_cast<std::size_t>(hit.band)]);
    }
    return lines.join(QStringLiteral("<br>"));
}

} // namespace touchdown
