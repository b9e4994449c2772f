// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reports as studies make them, with numbers that are made up.
#pragma once

#include <cmath>
#include <limits>

#include "core/case_files/case_file.h"
#include "core/studies/study/study.h"

namespace touchdown {

/// Errors 10^-p over times in ms: three methods, one point hollow, one failed, one chosen, a band and a front.
inline StudyChart samplePrecisionChart()
{
    StudyChart chart;
    chart.title = "Accuracy against speed: 2-DOF slider, drop from 12 nm";
    chart.caption = "Error of the flying height over the trajectory against the CPU time of a run, least of 5. Below "
                    "the band the reference "
                    "itself is not known. Points are named by their step or tolerance.";
    const auto series = [](const char* name, double order, double cost, double first) {
        ChartSeries s{name, {}, ChartLine::Solid, true, false};
        for (int i = 0; i < 5; ++i) {
            const double step = std::pow(10.0, -7.0 - 0.5 * i);
            const int tenths = static_cast<int>(std::lround(step * 1e10));
            s.points.push_back(
                {cost * 1e-7 / step, first * std::pow(step / 1e-7, order), std::to_string(tenths / 10) + " ns"});
        }
        return s;
    };
    ChartPanel time{{"CPU time of a run", "s", "ms", true},
                    {"Largest error of the flying height", "m", "nm", true},
                    {},
                    {},
                    {},
                    false};
    time.series = {series("rk4", 1.0, 2e-3, 3e-10), series("rk4-events", 4.0, 3e-3, 3e-10),
                   series("newmark", 2.0, 1.5e-3, 4e-9)};
    time.series[0].points[0].kind = PointKind::WrongState;
    time.series[2].points[0].kind = PointKind::Failed;
    time.series[1].points[2].chosen = true;
    ChartSeries front{"Pareto front", {}, ChartLine::Steps, false, true};
    for (const ChartPoint& p : time.series[1].points) front.points.push_back({p.x, p.y});
    time.series.push_back(front);
    time.bands = {{false, 0.0, 2e-17, "not known of the reference"}};
    ChartPanel calls = time;
    calls.x = {"Evaluations of the right-hand side", "", "", true};
    for (ChartSeries& s : calls.series)
        for (ChartPoint& p : s.points) p.x *= 1e7;
    chart.panels = {time, calls};
    return chart;
}

/// Five steps by four stiffnesses; the classes go from good at the lower left to failed at the upper right.
inline StudyChart sampleMapChart()
{
    StudyChart chart;
    chart.title = "Where rk4 fails";
    chart.caption = "Each cell is a run of 1 ms.";
    ChartPanel panel{{"Step", "s", "ns", true}, {"Contact stiffness", "N/m", "MN/m", true}, {}, {}, ChartMap{}, false};
    ChartMap& map = *panel.map;
    map.x = {1e-9, 3.16e-9, 1e-8, 3.16e-8, 1e-7};
    map.y = {1e5, 1e6, 1e7, 1e8};
    map.classes = {{"agrees with the reference", 0},
                   {"ends in another state", 2},
                   {"energy drifts", 1},
                   {"chatters", 1},
                   {"diverged", 3}};
    map.cells = {0, 0, 0, 0, 2, 0, 0, 0, 3, 1, 0, 0, 2, 1, 4, 0, 3, 1, 4, -1};
    for (const int cell : map.cells)
        map.details.push_back(cell < 0 ? "" : "Cell of class " + std::to_string(cell) + ".");
    panel.bands = {{true, 1e-8, 1e-8, "case"}};
    chart.panels = {panel};
    return chart;
}

/// The boundary |1 + z| = 1 of Euler's method and two eigenvalues in it.
inline StudyChart sampleRegionChart()
{
    StudyChart chart;
    chart.title = "Stability regions";
    ChartSeries edge{"|R(z)| = 1", {}, ChartLine::Solid, false, true};
    for (int i = 0; i <= 64; ++i) edge.points.push_back({std::cos(i * 0.0981747704) - 1.0, std::sin(i * 0.0981747704)});
    ChartSeries eigenvalues{"eigenvalues times the step",
                            {{-0.5, 0.7, "pitch"}, {-0.5, -0.7, ""}, {-1.2, 0.0, "film"}},
                            ChartLine::None,
                            true,
                            false};
    ChartPanel panel{{"Re z", "", "", false},
                     {"Im z", "", "", false},
                     {edge, eigenvalues},
                     {{true, 0.0, std::numeric_limits<double>::infinity(), "growth"}},
                     {},
                     true};
    chart.panels = {panel};
    return chart;
}

inline StudyReport sampleReport()
{
    StudyReport report;
    report.kind = "work-precision";
    report.title = "Accuracy against speed";
    report.findings = {"rk4-events is 40 times faster than rk4 at the same error.", "Newmark fails at 100 ns."};
    report.warnings = {"The reference is known to 2e-8 nm only."};
    report.charts = {samplePrecisionChart(), sampleMapChart(), sampleRegionChart()};
    StudyTable runs{"runs",
                    {{"method", "", "", "Method"},
                     {"step", "s", "ns", "Step"},
                     {"largest_error", "m", "nm", "Largest error"},
                     {"calls", "", "", "Evaluations"}},
                    {}};
    runs.rows = {{"rk4", 1e-7, 0.3e-9, 80'000.0},
                 {"rk4", 1e-8, 0.03e-9, 800'000.0},
                 {"newmark", 1e-7, std::monostate{}, 20'000.0}};
    report.tables = {runs};
    report.wallSeconds = 1.5;
    return report;
}

} // namespace touchdown
