// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a study finds, whatever it studied: sentences, charts and tables, so that one command, one file format and one
// page of the workbench show them all.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/case/case.h"

namespace touchdown {

enum class StudyStatus : std::uint8_t {
    Completed,
    Cancelled,
    Failed,
    Interrupted // in a file: its program was killed, or is still at work
};
inline std::string_view name(StudyStatus status)
{
    constexpr std::array<std::string_view, 4> names{"completed", "cancelled", "failed", "interrupted"};
    static_assert(names.size() == static_cast<std::size_t>(StudyStatus::Interrupted) + 1);
    return names[static_cast<std::size_t>(status)];
}

struct ChartAxis {
    std::string label{};       // "Largest error of the flying height"
    std::string unit{};        // SI, of the numbers; empty when dimensionless
    std::string displayUnit{}; // "nm"; empty when dimensionless
    bool logarithmic = false;  // then every number that is drawn is > 0
};

/// How a point came out.
enum class PointKind : std::uint8_t {
    Good,       // drawn full
    WrongState, // looks right and ends in another state than the reference: drawn hollow
    Failed      // no valid answer: drawn as a cross
};
inline std::string_view name(PointKind kind)
{
    constexpr std::array<std::string_view, 3> names{"good", "wrong-state", "failed"};
    static_assert(names.size() == static_cast<std::size_t>(PointKind::Failed) + 1);
    return names[static_cast<std::size_t>(kind)];
}

struct ChartPoint {
    double x = 0.0, y = 0.0; // [units of the axes]; finite
    std::string label{};     // its setting, "10 ns"; empty: none is drawn
    PointKind kind = PointKind::Good;
    bool chosen = false;               // the default of the program, or the advice: ringed
    double xError = 0.0, yError = 0.0; // half of an error bar's length; 0: none [units of the axes]
};

enum class ChartLine : std::uint8_t { None, Solid, Dashed, Steps };
inline std::string_view name(ChartLine line)
{
    constexpr std::array<std::string_view, 4> names{"none", "solid", "dashed", "steps"};
    static_assert(names.size() == static_cast<std::size_t>(ChartLine::Steps) + 1);
    return names[static_cast<std::size_t>(line)];
}

/// Points in the order in which a line joins them; a point of kind Failed is not joined.
struct ChartSeries {
    std::string name{};
    std::vector<ChartPoint> points{};
    ChartLine line = ChartLine::Solid;
    bool markers = true;
    bool quiet = false; // thin and grey: the Pareto front, the edge of a stability region, a guide
};

/// A shaded part of a panel, or a line across it where both ends are equal: what the reference itself does not know.
struct ChartBand {
    bool alongX = true;              // between two values of x; else of y
    double lower = 0.0, upper = 0.0; // [unit of that axis]; an infinite end reaches to the panel's edge
    std::string label{};
};

/// How a cell of a map came out.
struct ChartClass {
    std::string name;    // "agrees with the reference"
    int severity = 0;    // 0 good .. 3 failed: chooses the colour; classes of equal severity differ by pattern
    double shade = -1.0; // of a scale, 0 low .. 1 high, which chooses the colour instead; below 0: of none
};

/// Cells coloured by class: row by row, x runs first.
struct ChartMap {
    std::vector<double> x, y; // in rising order, the middles of the cells [units of the axes]
    std::vector<ChartClass> classes;
    std::vector<int> cells;           // x.size() * y.size() indices into classes; -1: not known
    std::vector<std::string> details; // the same size, or empty: a sentence about each cell
};

struct ChartPanel {
    ChartAxis x{}, y{};
    std::vector<ChartSeries> series{};
    std::vector<ChartBand> bands{};
    std::optional<ChartMap> map{};
    bool equalScales = false; // a unit of x is as long as one of y: the complex plane
};

/// Panels side by side. A series has one colour and one legend entry by its name, whatever panel it is in.
struct StudyChart {
    std::string title{};
    std::string caption{}; // a sentence or more below it: how to read it, what is uncertain
    std::vector<ChartPanel> panels{};
};

struct StudyColumn {
    std::string name;   // "largest_error"
    std::string unit{}; // SI; empty when dimensionless, and for texts
    std::string displayUnit{};
    std::string longName{}; // "Largest error over the trajectory"
    bool secondary = false; // left out where there is little room
};
/// Monostate: not known, or it has no meaning.
using StudyValue = std::variant<std::monostate, double, std::string>;
/// A number where it is known.
inline StudyValue known(bool isKnown, double value) { return isKnown ? StudyValue(value) : StudyValue(); }
inline StudyValue ifFinite(double value) { return known(std::isfinite(value), value); }
inline StudyValue known(const std::optional<double>& value) { return known(value.has_value(), value.value_or(0.0)); }
struct StudyTable {
    std::string name; // "runs": a word of [a-z0-9_], a group of the HDF5 file
    std::vector<StudyColumn> columns{};
    std::vector<std::vector<StudyValue>> rows{}; // each as long as `columns`; numbers are finite
};

/// A row of a study that is a list (item_study.h), with the key of its item.
struct StudyItem {
    std::string key;
    std::vector<StudyValue> row;
};

struct StudyReport {
    StudyStatus status = StudyStatus::Completed;
    std::string message; // why it ended so, in a sentence; empty when completed
    std::string kind;    // "work-precision"
    std::string title;
    std::vector<std::string> findings; // sentences, the most important one first
    std::vector<std::string> warnings; // sentences: what weakens them
    std::vector<StudyChart> charts;
    std::vector<StudyTable> tables; // the first one is what --csv writes
    std::optional<Case> found;      // a case that the study advises
    std::vector<StudyItem> items{}; // of a list, in its order: with them it can be continued
    double wallSeconds = 0.0;
};

struct StudyProgress {
    double share = 0.0;                 // done, 0..1, by expected time
    std::string doing{};                // "rk4, 10 ns"
    const StudyReport* soFar = nullptr; // when there is more to show than before
};
/// Return false to stop. Called on the thread of the study, at least every 50 ms.
using StudyCallback = std::function<bool(const StudyProgress&)>;

/// A study that is ready: performs it on up to `jobs` threads. Never throws for numerics.
using StudyPerformance = std::function<StudyReport(int jobs, const StudyCallback& callback)>;

} // namespace touchdown
