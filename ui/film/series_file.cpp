// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <QDir>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/formats/units.h"
#include "core/results/steady_reader.h"
#include "core/results/steady_writer.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "ui/film/series_plots.h"
#include "ui/style/quantity_format.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

bool samePoint(const SteadySeriesPoint& a, const SteadySeriesPoint& b)
{
    return a.radius == b.radius && a.skew == b.skew && a.speed == b.speed && a.altitude == b.altitude;
}

QByteArray csvText(QString text)
{
    if (text.contains(u',') || text.contains(u'"')) text = u'"' + text.replace(u'"', QLatin1String("\"\"")) + u'"';
    return text.toUtf8();
}

} // namespace

Case listing(const Case& c, const std::vector<SteadySeriesPoint>& points)
{
    if (points.empty() || std::ranges::equal(points, seriesOf(c), samePoint)) return c;
    Case listed = withoutSeries(c);
    const auto differs = [&](const auto& value) {
        return std::ranges::any_of(points, [&](const auto& point) { return value(point) != value(points.front()); });
    };
    const bool speeds = differs([](const SteadySeriesPoint& point) { return point.speed; });
    const bool altitudes = differs([](const SteadySeriesPoint& point) { return point.altitude; });
    for (const SteadySeriesPoint& point : points) {
        if (speeds) {
            listed.steady.speeds.push_back(point.speed);
        } else if (altitudes) {
            listed.steady.altitudes.push_back(point.altitude.value_or(0.0));
        } else {
            listed.steady.radii.push_back(point.radius);
            listed.steady.skews.push_back(point.skew);
        }
    }
    return listed;
}

QString writeSeries(const QString& file, const StoredSeries& series)
{
    const std::vector<SteadySeriesPoint> points = seriesOf(series.value);
    SteadyWriter writer;
    std::string problem =
        writer.open(std::filesystem::path(file.toStdString()), series.value, formatCase(series.value));
    SteadyStatus worst = SteadyStatus::Converged;
    for (std::size_t i = 0; i < std::min(points.size(), series.results.size()) && problem.empty(); ++i) {
        worst = std::max(worst, series.results[i].status);
        problem = writer.add(points[i], series.results[i]);
    }
    if (problem.empty()) problem = writer.finish(worst, "");
    return QString::fromStdString(problem);
}

StoredSeries readSeries(const QString& file)
{
    StoredSteady stored = readSteady(std::filesystem::path(file.toStdString()));
    if (!stored.problem.empty()) return {{}, {}, sentence(stored.problem)};
    const CaseDocument document = parseCase(stored.caseText, file.toStdString());
    if (stored.states.empty() || stored.states.size() > seriesOf(document.value).size())
        return {{}, {}, tr("%1 holds no series of static states.").arg(QDir::toNativeSeparators(file))};
    return {document.value, std::move(stored.states), {}};
}

QByteArray csvOf(const std::vector<SeriesState>& states)
{
    QByteArray text;
    for (const SeriesState& state : states) {
        QByteArrayList heads, cells;
        const auto add = [&](const SteadyQuantity& each, bool known) {
            const QString unit = QString::fromStdString(each.quantity.displayUnit);
            heads << csvText(QStringLiteral("%1 [%2]").arg(QString::fromStdString(each.quantity.name), unit));
            cells << (known ? QByteArray::number(each.value / unitFactor(each.quantity.displayUnit), 'g', 12)
                            : QByteArray());
        };
        for (const SteadyQuantity& each : seriesQuantities(state.point)) add(each, true);
        for (const SteadyQuantity& each : steadyQuantities(state.result))
            add(each, state.result.status == SteadyStatus::Converged && std::isfinite(each.value));
        heads << "status"
              << "message";
        cells << csvText(statusText(name(state.result.status)))
              << csvText(QString::fromStdString(state.result.message));
        if (text.isEmpty()) text = heads.join(',') + '\n';
        text += cells.join(',') + '\n';
    }
    return text;
}

} // namespace touchdown
