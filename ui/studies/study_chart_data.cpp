// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_chart_data.h"

#include <QTextStream>

#include "core/formats/units.h"

namespace touchdown {

namespace {

QString quoted(const std::string& text)
{
    return QLatin1Char('"') + QString::fromStdString(text).replace(QLatin1Char('"'), QStringLiteral("\"\"")) +
           QLatin1Char('"');
}

std::string axisName(const ChartAxis& axis)
{
    return axis.unit.empty() ? axis.label : axis.label + " [" + axis.unit + "]";
}

} // namespace

void writeChartCsv(const StudyChart& chart, QIODevice& device)
{
    QTextStream out(&device);
    const auto number = [](double value) { return QString::fromStdString(formatNumber(value)); };
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        const ChartPanel& panel = chart.panels[i];
        out << "panel,name,label,kind," << quoted(axisName(panel.x)) << ',' << quoted(axisName(panel.y)) << '\n';
        const auto row = [&](const std::string& name, const std::string& label, std::string_view kind, double x,
                             double y) {
            out << i + 1 << ',' << quoted(name) << ',' << quoted(label) << ',' << quoted(std::string(kind)) << ','
                << number(x) << ',' << number(y) << '\n';
        };
        for (const ChartSeries& series : panel.series)
            for (const ChartPoint& point : series.points)
                row(series.name, point.label, name(point.kind), point.x, point.y);
        if (!panel.map) continue;
        const ChartMap& map = *panel.map;
        for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
            const int which = map.cells[cell];
            row(which < 0 ? "not known" : map.classes[static_cast<std::size_t>(which)].name,
                cell < map.details.size() ? map.details[cell] : "", "cell", map.x[cell % map.x.size()],
                map.y[cell / map.x.size()]);
        }
    }
}

} // namespace touchdown
