// SPDX-License-Identifier: GPL-3.0-or-later
//
// The small pictures of the galleries, from real results: touchdown-gallery-pictures FOLDER SECONDS [NAME...] writes
// one PNG for each sample case and each sample study. A study that takes longer than SECONDS gets none. They are drawn
// in colours between light and dark on a transparent ground, so that they suit both themes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <QColor>
#include <QDir>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPolygonF>

#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study_plan.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

constexpr int width = 240, height = 160; // twice what the gallery shows [px]
constexpr double margin = 10.0;          // [px]
const QColor axisColour("#8a94a0");
const std::array<QColor, 6> curveColours{"#3b8ed0", "#e08a2e", "#3fa66a", "#c05a9a", "#8a78d8", "#b0a030"};
const std::array<QColor, 4> severityColours{"#7fb2e0", "#dcbc50", "#e0843a", "#b83a52"};

/// From the numbers of an axis to the unit interval.
struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    bool logarithmic = false;

    double scaled(double value) const { return logarithmic ? std::log(value) : value; }
    void add(double value)
    {
        if (!std::isfinite(value) || (logarithmic && !(value > 0.0))) return;
        low = std::min(low, scaled(value));
        high = std::max(high, scaled(value));
    }
    double at(double value) const { return high > low ? (scaled(value) - low) / (high - low) : 0.5; }
};

class Picture {
public:
    Picture(Range x, Range y) : x_(x), y_(y), image_(width, height, QImage::Format_ARGB32)
    {
        image_.fill(Qt::transparent);
        painter_.begin(&image_);
        painter_.setRenderHint(QPainter::Antialiasing);
    }

    QPointF at(double x, double y) const
    {
        return {margin + (width - 2.0 * margin) * x_.at(x), height - margin - (height - 2.0 * margin) * y_.at(y)};
    }
    void frame()
    {
        painter_.setPen(QPen(axisColour, 2.0));
        painter_.drawPolyline(
            QPolygonF{{margin, margin}, {margin, height - margin}, {width - margin, height - margin}});
    }
    void line(const QPolygonF& points, const QColor& colour, double thickness = 3.0)
    {
        painter_.setPen(QPen(colour, thickness, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter_.drawPolyline(points);
    }
    void dot(const QPointF& point, const QColor& colour, double radius = 4.0)
    {
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(colour);
        painter_.drawEllipse(point, radius, radius);
        painter_.setBrush(Qt::NoBrush);
    }
    void fill(const QRectF& box, const QColor& colour) { painter_.fillRect(box, colour); }
    bool save(const QString& file)
    {
        painter_.end();
        // Few colours and few levels of opacity, which a PNG stores in little room.
        const auto snapped = [](int value, int step) { return std::min(255, step * ((value + step / 2) / step)); };
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const QColor colour = image_.pixelColor(x, y);
                const int alpha = snapped(colour.alpha(), 85);
                image_.setPixelColor(x, y,
                                     alpha == 0 ? QColor(Qt::transparent)
                                                : QColor(snapped(colour.red(), 12), snapped(colour.green(), 12),
                                                         snapped(colour.blue(), 12), alpha));
            }
        return image_.save(file, "PNG", 0);
    }

private:
    Range x_, y_;
    QImage image_;
    QPainter painter_;
};

/// How many samples from the start show what happens: until some time after the curve has come to its end value, and
/// no more than some thirty oscillations.
std::size_t shownSamples(const std::vector<double>& x, const std::vector<double>& y)
{
    const auto [least, most] = std::ranges::minmax(y);
    std::size_t settled = 0;
    for (std::size_t i = 0; i < y.size(); ++i)
        if (std::abs(y[i] - y.back()) > 0.02 * (most - least)) settled = i;
    const double until = x.front() + 1.6 * (x[settled] - x.front());
    std::size_t count = 0, turns = 0;
    double extreme = y.front();
    bool rising = false;
    for (; count < x.size() && x[count] <= until && turns < 60; ++count) {
        if (rising ? y[count] > extreme : y[count] < extreme) extreme = y[count];
        if (std::abs(y[count] - extreme) < 0.02 * (most - least)) continue;
        rising = !rising;
        extreme = y[count];
        ++turns;
    }
    return std::max<std::size_t>(count, 2);
}

/// A curve over time with, in each column of pixels, the least and the greatest value only; on a logarithmic scale
/// where most of it lies low.
bool drawCurve(std::vector<double> x, std::vector<double> y, const QString& file)
{
    if (x.size() < 2) return false;
    const std::size_t shown = shownSamples(x, y);
    x.resize(shown);
    y.resize(shown);
    Range across, up;
    std::vector<double> order = y;
    std::ranges::sort(order);
    up.logarithmic = order.front() > 0.0 && order.back() > 8.0 * order[order.size() / 2];
    for (const double value : x) across.add(value);
    for (const double value : y) up.add(value);
    if (!up.logarithmic) up.add(0.0);
    if (!(up.high > up.low)) return false;
    Picture picture(across, up);
    picture.frame();
    QPolygonF points;
    for (std::size_t i = 0; i < x.size();) {
        const double column = std::floor(picture.at(x[i], y[i]).x());
        std::size_t least = i, most = i;
        for (; i < x.size() && std::floor(picture.at(x[i], y[i]).x()) == column; ++i) {
            if (y[i] < y[least]) least = i;
            if (y[i] > y[most]) most = i;
        }
        for (const std::size_t k : {std::min(least, most), std::max(least, most)}) points << picture.at(x[k], y[k]);
    }
    picture.line(points, curveColours[0]);
    return picture.save(file);
}

/// The column of a quantity and that of another one, over a run.
bool drawRun(const Case& c, const std::string& across, const std::string& up, const QString& file)
{
    const std::vector<Quantity> quantities = recordedQuantities(c);
    const int x = findQuantity(quantities, across), y = findQuantity(quantities, up);
    if (y < 0) return false;
    std::vector<double> xs, ys;
    run(c, [&](const RunUpdate& update) {
        const SampleBatch& batch = update.samples;
        const std::vector<double>& from = x < 0 ? batch.time : batch.columns[static_cast<std::size_t>(x)];
        xs.insert(xs.end(), from.begin(), from.end());
        const std::vector<double>& to = batch.columns[static_cast<std::size_t>(y)];
        ys.insert(ys.end(), to.begin(), to.end());
        return true;
    });
    const bool overTime = x < 0;
    if (overTime) return drawCurve(std::move(xs), std::move(ys), file);
    // There and back is no function: every sample is joined with the next one.
    Range wide, high;
    for (const double value : xs) wide.add(value);
    for (const double value : ys) high.add(value);
    high.add(0.0);
    Picture picture(wide, high);
    picture.frame();
    QPolygonF points;
    for (std::size_t i = 0; i < xs.size(); ++i) points << picture.at(xs[i], ys[i]);
    picture.line({picture.at(xs.front(), 0.0), picture.at(xs.back(), 0.0)}, axisColour, 1.5);
    picture.line(points, curveColours[0]);
    return picture.save(file);
}

/// In steps, which a PNG stores in little room: blue below ambient pressure, through grey to orange above it.
QColor pressureColour(double relative)
{
    constexpr int steps = 6;
    const double share = std::round(steps * std::clamp(std::abs(relative), 0.0, 1.0)) / steps;
    const QColor ground("#a4acb4"), end(relative < 0.0 ? "#2f6fb8" : "#d8622a");
    const auto mixed = [&](int from, int to) { return static_cast<int>(std::lround(std::lerp(from, to, share))); };
    return {mixed(ground.red(), end.red()), mixed(ground.green(), end.green()), mixed(ground.blue(), end.blue())};
}

/// The pressure of the static state under the slider, leading edge at the left, as wide as its true shape allows.
bool drawPressure(const Case& c, const QString& file)
{
    Case still = c;
    still.steady.stiffness = still.steady.sensitivities = still.steady.allEquilibria = false;
    const SteadyResult state = steady(still);
    if (!state.balanced() && state.pressure.empty()) return false;
    const CellGrid& grid = state.grid;
    const double ambient = state.pressure.empty() ? 0.0 : state.pressure.front();
    double most = 0.0, least = 0.0;
    for (const double value : state.pressure) {
        most = std::max(most, value - ambient);
        least = std::min(least, value - ambient);
    }
    const double length = grid.x.back() - grid.x.front(), breadth = grid.y.back() - grid.y.front();
    const double scale = std::min((width - 2.0 * margin) / length, (height - 2.0 * margin) / breadth);
    const double left = 0.5 * (width - scale * length), top = 0.5 * (height - scale * breadth);
    Picture picture({}, {});
    for (int j = 0; j < grid.ny(); ++j)
        for (int i = 0; i < grid.nx(); ++i) {
            const double over = state.pressure[static_cast<std::size_t>(j * grid.nx() + i)] - ambient;
            const double scaled = over < 0.0 ? -over / std::min(least, -1.0) : std::sqrt(over / std::max(most, 1.0));
            const auto x = [&](std::size_t k) { return std::round(left + scale * (grid.x[k] - grid.x.front())); };
            const auto y = [&](std::size_t k) { return std::round(top + scale * (grid.y[k] - grid.y.front())); };
            const auto column = static_cast<std::size_t>(i), row = static_cast<std::size_t>(j);
            picture.fill(QRectF(QPointF(x(column), y(row)), QPointF(x(column + 1), y(row + 1))),
                         pressureColour(over < 0.0 ? -std::abs(scaled) : scaled));
        }
    return picture.save(file);
}

bool drawCase(const SampleCase& sample, const QString& file)
{
    const CaseDocument document = openCase(sample.name);
    if (!document.valid()) return false;
    const Case& c = document.value;
    if (c.model == ModelKind::Contact) return drawRun(c, "minimum_spacing", "net_contact_force", file);
    if (sample.name.starts_with("film_")) return drawPressure(c, file);
    return drawRun(c, "", c.model == ModelKind::Springs ? "flying_height" : "minimum_spacing", file);
}

void drawMap(const ChartMap& map, Picture& picture)
{
    const double across = (width - 2.0 * margin) / static_cast<double>(map.x.size()),
                 up = (height - 2.0 * margin) / static_cast<double>(map.y.size());
    for (std::size_t k = 0; k < map.cells.size(); ++k) {
        if (map.cells[k] < 0) continue;
        const auto column = static_cast<double>(k % map.x.size()), row = static_cast<double>(k / map.x.size());
        const int severity = map.classes[static_cast<std::size_t>(map.cells[k])].severity;
        picture.fill(
            QRectF(QPointF(std::round(margin + column * across), std::round(height - margin - (row + 1.0) * up)),
                   QPointF(std::round(margin + (column + 1.0) * across), std::round(height - margin - row * up))),
            severityColours[static_cast<std::size_t>(std::clamp(severity, 0, 3))]);
    }
}

/// The first panel of the first chart that has points: its cells, or its curves without labels.
bool drawChart(const StudyReport& report, const QString& file)
{
    for (const StudyChart& chart : report.charts)
        for (const ChartPanel& panel : chart.panels) {
            Range x, y;
            x.logarithmic = panel.x.logarithmic;
            y.logarithmic = panel.y.logarithmic;
            std::size_t points = 0;
            for (const ChartSeries& series : panel.series)
                for (const ChartPoint& point : series.points) {
                    x.add(point.x);
                    y.add(point.y);
                    ++points;
                }
            if (points < 2 && !panel.map) continue;
            Picture picture(x, y);
            if (panel.map) {
                drawMap(*panel.map, picture);
                return picture.save(file);
            }
            picture.frame();
            std::size_t colour = 0;
            for (const ChartSeries& series : panel.series) {
                const QColor ink = series.quiet ? axisColour : curveColours[colour % curveColours.size()];
                colour += series.quiet ? 0 : 1;
                QPolygonF line;
                for (const ChartPoint& point : series.points)
                    if (std::isfinite(point.x) && std::isfinite(point.y)) line << picture.at(point.x, point.y);
                if (series.line != ChartLine::None) picture.line(line, ink, series.quiet ? 1.5 : 3.0);
                if (series.markers && series.points.size() < 60)
                    for (const QPointF& point : line) picture.dot(point, ink);
            }
            return picture.save(file);
        }
    return false;
}

bool drawStudy(const SampleStudy& sample, double limit, const QString& file)
{
    const StudyPlan plan = openStudy(sample.kind, sample.name);
    if (!plan.valid()) return false;
    const double begin = wallClock();
    const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const StudyReport report = plan.perform(threads, [&](const StudyProgress&) { return wallClock() - begin < limit; });
    return report.status != StudyStatus::Cancelled && drawChart(report, file);
}

int drawAll(const QStringList& arguments)
{
    if (arguments.size() < 3) {
        std::fputs("touchdown-gallery-pictures FOLDER SECONDS [NAME...]\n", stderr);
        return 2;
    }
    const QDir folder(arguments[1]);
    const QStringList names = arguments.mid(3);
    const auto wanted = [&](const std::string& name) {
        return names.isEmpty() || names.contains(QString::fromStdString(name));
    };
    const auto fileOf = [&](const char* prefix, const std::string& name) {
        return folder.filePath(QString::fromLatin1(prefix) + QString::fromStdString(name) + QStringLiteral(".png"));
    };
    const auto report = [](const std::string& name, bool drawn, double begin) {
        std::printf("%-40s %s, %.1f s\n", name.c_str(), drawn ? "drawn" : "NO PICTURE", wallClock() - begin);
        std::fflush(stdout);
    };
    for (const SampleCase& sample : sampleCases()) {
        const double begin = wallClock();
        if (wanted(sample.name)) report(sample.name, drawCase(sample, fileOf("case_", sample.name)), begin);
    }
    for (const SampleStudy& sample : sampleStudies()) {
        const double begin = wallClock();
        if (wanted(sample.name))
            report(sample.name, drawStudy(sample, arguments[2].toDouble(), fileOf("study_", sample.name)), begin);
    }
    return 0;
}

} // namespace

} // namespace touchdown

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    return touchdown::drawAll(QGuiApplication::arguments());
}
