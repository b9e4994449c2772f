// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "core/formats/units.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr std::size_t mostPanels = 6; // of a chart
constexpr std::size_t mostClouds = 4; // axes beside each other
constexpr double mostShades = 8.0;    // of a map, about

class Charts {
public:
    explicit Charts(const SweepPoints& points) : at_(points) {}

    void addCharts(StudyReport& report) const
    {
        if (at_.task().samples)
            addClouds(report);
        else if (at_.axes() == 1)
            addCurves(report);
        else if (at_.axes() == 2)
            addMaps(report);
    }

    ChartPoint pointOf(const SweepPoint& point, std::size_t axis, std::size_t reading) const
    {
        ChartPoint drawn{.x = point.at[axis].number, .y = at_.numberOf(point, reading)};
        if (!at_.axis(axis).isNumber) drawn.label = point.at[axis].text;
        const bool hasError = reading + 1 < at_.readings() && at_.reading(reading + 1).isError;
        if (const double error = hasError ? at_.numberOf(point, reading + 1) : 0.0; std::isfinite(error))
            drawn.yError = error;
        return drawn;
    }

    void addCurves(StudyReport& report) const
    {
        StudyChart chart{"Over " + uncapitalized(at_.axis(0).text.label),
                         !at_.averages() ? "Each point is one item of the sweep; bars are stated errors."
                                         : "Each point is the mean of its items; bars are stated errors."};
        for (const std::size_t r : at_.drawn()) {
            if (chart.panels.size() == mostPanels) break;
            ChartPanel panel{at_.chartAxis(at_.axis(0)), at_.chartAxis(at_.reading(r))};
            ChartSeries series{at_.reading(r).column().longName};
            if (!at_.axis(0).isNumber) series.line = ChartLine::None;
            for (const SweepPoint& point : at_.points())
                if (const ChartPoint one = pointOf(point, 0, r); std::isfinite(one.y)) series.points.push_back(one);
            std::ranges::stable_sort(series.points, {}, &ChartPoint::x);
            panel.series.push_back(std::move(series));
            chart.panels.push_back(std::move(panel));
        }
        if (!chart.panels.empty()) report.charts.push_back(std::move(chart));
    }

    void addMaps(StudyReport& report) const
    {
        const SweepAxis &x = at_.axis(0), &y = at_.axis(1);
        if (!x.isNumber || !y.isNumber) return;
        const auto places = [](const SweepAxis& axis) {
            std::vector<double> list;
            for (const SweepValue& value : axis.values) list.push_back(value.number);
            std::ranges::sort(list);
            list.erase(std::unique(list.begin(), list.end()), list.end());
            return list;
        };
        ChartMap empty;
        empty.x = places(x);
        empty.y = places(y);
        const std::size_t cells = empty.x.size() * empty.y.size();
        if (empty.x.size() < 2 || empty.y.size() < 2) return;
        const auto cellOf = [&](const SweepPoint& point) {
            const auto place = [](const std::vector<double>& list, double value) {
                return std::size_t(std::ranges::lower_bound(list, value) - list.begin());
            };
            return place(empty.y, point.at[1].number) * empty.x.size() + place(empty.x, point.at[0].number);
        };
        for (std::size_t r = 0; r < at_.readings(); ++r) {
            const Reading& reading = at_.reading(r);
            if (reading.isError) continue;
            ChartMap map = empty;
            map.cells.assign(cells, -1);
            map.details.assign(cells, "");
            const Shades shades = reading.isText ? Shades() : addShades(map, r);
            for (const SweepPoint& point : at_.points()) {
                if (point.rows.empty()) continue;
                const std::size_t cell = cellOf(point);
                const StudyValue value = at_.valueOf(point, r);
                map.details[cell] = at_.nameOf(point) + ": " + at_.textOf(point, r) +
                                    (at_.firstProblem(point).empty() ? "" : " (" + at_.firstProblem(point) + ")");
                const double number = at_.numberOf(point, r);
                map.cells[cell] = std::isfinite(number) ? shades.of(number) : classOf(map, value);
            }
            ChartPanel panel{at_.chartAxis(x), at_.chartAxis(y)};
            panel.map = std::move(map);
            report.charts.push_back(
                {at_.chartAxis(reading).label,
                 at_.averages() ? "Each cell is the mean of its items." : "Each cell is one item of the sweep.",
                 {panel}});
        }
    }

    /// The least and the largest value of a reading.
    std::pair<double, double> rangeOf(std::size_t reading) const
    {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const SweepPoint& point : at_.points())
            if (const double value = at_.numberOf(point, reading); std::isfinite(value)) {
                least = std::min(least, value);
                most = std::max(most, value);
            }
        return {least, most};
    }

    /// Steps of the values, each a class of a map.
    struct Shades {
        double step = 1.0;  // [unit of the reading]
        double first = 0.0; // steps that lie below the lowest one
        int count = 1;
        int of(double value) const { return int(std::clamp(std::floor(value / step) - first, 0.0, double(count - 1))); }
    };

    /// From low to high.
    Shades addShades(ChartMap& map, std::size_t reading) const
    {
        Shades shades;
        const auto [least, most] = rangeOf(reading);
        if (!(least <= most)) return shades;
        const std::string unit = at_.reading(reading).column().displayUnit;
        const double factor = unitFactor(unit), size = std::max(most - least, 1e-9 * std::abs(most));
        shades.step = (size > 0.0 ? roundStep(size / factor / mostShades) : 1.0) * factor;
        shades.first = std::floor(least / shades.step);
        shades.count = std::max(1, int(std::floor(most / shades.step) - shades.first) + 1);
        for (int k = 0; k < shades.count; ++k)
            map.classes.push_back({shadeName(shades.first + k, shades.step, unit), 0,
                                   shades.count == 1 ? 0.5 : double(k) / (shades.count - 1)});
        return shades;
    }

    static std::string shadeName(double steps, double step, const std::string& unit)
    {
        return fewDigits(roundedTo(steps * step, 6), unit, 6) + " to " +
               fewDigits(roundedTo((steps + 1.0) * step, 6), unit, 6);
    }

    /// 1, 2 or 5 times a power of ten, not below the value.
    static double roundStep(double value)
    {
        const double decade = std::pow(10.0, std::floor(std::log10(value)));
        for (const double factor : {1.0, 2.0, 5.0})
            if (factor * decade >= value * (1.0 - 1e-9)) return factor * decade;
        return 10.0 * decade;
    }

    static int classOf(ChartMap& map, const StudyValue& value)
    {
        const auto* text = std::get_if<std::string>(&value);
        const std::string name = text == nullptr ? "fails" : *text;
        auto found = std::ranges::find(map.classes, name, &ChartClass::name);
        if (found == map.classes.end()) {
            const int severity = text == nullptr ? 3 : std::min(int(map.classes.size()), 2);
            found = map.classes.insert(found, {name, severity});
        }
        return int(found - map.classes.begin());
    }

    void addClouds(StudyReport& report) const
    {
        for (const std::size_t r : at_.drawn()) {
            StudyChart chart{at_.reading(r).column().longName + " of the samples",
                             "Each point is one sample; all axes change at once."};
            for (std::size_t k = 0; k < std::min(at_.axes(), mostClouds); ++k) {
                ChartPanel panel{at_.chartAxis(at_.axis(k)), at_.chartAxis(at_.reading(r))};
                ChartSeries series{.name = "samples", .line = ChartLine::None};
                for (const SweepPoint& point : at_.points()) {
                    ChartPoint one = pointOf(point, k, r);
                    one.yError = 0.0;
                    if (std::isfinite(one.y)) series.points.push_back(std::move(one));
                }
                panel.series.push_back(std::move(series));
                chart.panels.push_back(std::move(panel));
            }
            report.charts.push_back(std::move(chart));
            if (report.charts.size() == mostPanels) break;
        }
    }

    const SweepPoints& at_;
};

} // namespace

std::vector<StudyChart> sweepCharts(const SweepPoints& points)
{
    StudyReport report;
    Charts(points).addCharts(report);
    return std::move(report.charts);
}

} // namespace touchdown
