// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is read from the report of a study, for core/formats/passed_values.h.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/formats/passed_values.h"
#include "core/studies/study/study_file_reader.h"

namespace touchdown {

/// A value that may be absent.
template <class Value>
void passOptional(auto& stream, Value& value, auto&& members)
{
    bool present = value.has_value();
    stream(present);
    if constexpr (!std::is_const_v<Value>)
        if (present) value.emplace();
    if (present) members(*value);
}

void pass(auto& stream, Passed<StudyValue> auto& value)
{
    bool number = std::holds_alternative<double>(value), text = std::holds_alternative<std::string>(value);
    stream(number, text);
    if constexpr (!std::is_const_v<std::remove_reference_t<decltype(value)>>) {
        if (number) value = 0.0;
        if (text) value = std::string();
    }
    if (auto* const of = std::get_if<double>(&value)) stream(*of);
    if (auto* const of = std::get_if<std::string>(&value)) stream(*of);
}

void pass(auto& stream, Passed<StudyColumn> auto& column)
{
    stream(column.name, column.unit, column.displayUnit, column.longName, column.secondary);
}

void pass(auto& stream, Passed<StudyTable> auto& table) { stream(table.name, table.columns, table.rows); }

void pass(auto& stream, Passed<ChartAxis> auto& axis)
{
    stream(axis.label, axis.unit, axis.displayUnit, axis.logarithmic);
}

void pass(auto& stream, Passed<ChartPoint> auto& point)
{
    stream(point.x, point.y, point.label, point.kind, point.chosen, point.xError, point.yError);
}

void pass(auto& stream, Passed<ChartSeries> auto& series)
{
    stream(series.name, series.points, series.line, series.markers, series.quiet);
}

void pass(auto& stream, Passed<ChartBand> auto& band) { stream(band.alongX, band.lower, band.upper, band.label); }

void pass(auto& stream, Passed<ChartClass> auto& each) { stream(each.name, each.severity, each.shade); }

void pass(auto& stream, Passed<ChartMap> auto& map) { stream(map.x, map.y, map.classes, map.cells, map.details); }

void pass(auto& stream, Passed<ChartPanel> auto& panel)
{
    stream(panel.x, panel.y, panel.series, panel.bands, panel.equalScales);
    passOptional(stream, panel.map, [&](auto& map) { stream(map); });
}

void pass(auto& stream, Passed<StudyChart> auto& chart) { stream(chart.title, chart.caption, chart.panels); }

void pass(auto& stream, Passed<StudyItem> auto& item) { stream(item.key, item.row); }

void pass(auto& stream, Passed<StudyReport> auto& report)
{
    stream(report.status, report.message, report.kind, report.title, report.findings, report.warnings, report.charts,
           report.tables, report.items, report.wallSeconds);
    passOptional(stream, report.found, [&](auto& found) { // as its text
        std::string text = formatCase(found);
        stream(text);
        if constexpr (!std::is_const_v<std::remove_reference_t<decltype(found)>>)
            found = parseCase(std::move(text), "the case that the study found").value;
    });
}

void pass(auto& stream, Passed<StoredStudy> auto& stored)
{
    stream(stored.problem, stored.caseText, stored.studyText, stored.options, stored.report);
}

} // namespace touchdown
