// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/study_report.h"

#include <cmath>

#include "app/terminal/fitted_table.h"
#include "app/terminal/json_text.h"
#include "app/terminal/number_text.h"
#include "app/terminal/report_row.h"
#include "app/terminal/wrapped_text.h"
#include "core/case_files/case_file.h"

namespace touchdown {

namespace {

constexpr std::size_t mostRows = 40; // of a table for people

Json valueJson(const StudyValue& value)
{
    if (const double* number = std::get_if<double>(&value)) return jsonNumber(*number);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    return nullptr;
}

Json tableJson(const StudyTable& table)
{
    Json columns = Json::array(), rows = Json::array();
    for (const StudyColumn& column : table.columns)
        columns.push_back({{"name", column.name},
                           {"unit", column.unit},
                           {"display_unit", column.displayUnit},
                           {"long_name", column.longName}});
    for (const auto& row : table.rows) {
        Json one = Json::object();
        for (std::size_t i = 0; i < row.size(); ++i) one[table.columns[i].name] = valueJson(row[i]);
        rows.push_back(std::move(one));
    }
    return {{"name", table.name}, {"columns", columns}, {"rows", rows}};
}

Json axisJson(const ChartAxis& axis)
{
    return {{"label", axis.label},
            {"unit", axis.unit},
            {"display_unit", axis.displayUnit},
            {"logarithmic", axis.logarithmic}};
}

Json seriesJson(const ChartSeries& series)
{
    Json points = Json::array();
    for (const ChartPoint& point : series.points)
        points.push_back({{"x", jsonNumber(point.x)},
                          {"y", jsonNumber(point.y)},
                          {"x_error", jsonNumber(point.xError)},
                          {"y_error", jsonNumber(point.yError)},
                          {"label", point.label},
                          {"kind", name(point.kind)},
                          {"chosen", point.chosen}});
    return {{"name", series.name},
            {"line", name(series.line)},
            {"markers", series.markers},
            {"quiet", series.quiet},
            {"points", points}};
}

Json mapJson(const ChartMap& map)
{
    Json classes = Json::array();
    for (const ChartClass& each : map.classes) classes.push_back({{"name", each.name}, {"severity", each.severity}});
    return {{"x", map.x}, {"y", map.y}, {"classes", classes}, {"cells", map.cells}, {"details", map.details}};
}

Json panelJson(const ChartPanel& panel)
{
    Json series = Json::array(), bands = Json::array();
    for (const ChartSeries& each : panel.series) series.push_back(seriesJson(each));
    for (const ChartBand& band : panel.bands)
        bands.push_back({{"along", band.alongX ? "x" : "y"},
                         {"lower", jsonNumber(band.lower)},
                         {"upper", jsonNumber(band.upper)},
                         {"label", band.label}});
    return {
        {"x", axisJson(panel.x)}, {"y", axisJson(panel.y)}, {"equal_scales", panel.equalScales},
        {"series", series},       {"bands", bands},         {"map", panel.map ? mapJson(*panel.map) : Json(nullptr)}};
}

Json chartJson(const StudyChart& chart)
{
    Json panels = Json::array();
    for (const ChartPanel& panel : chart.panels) panels.push_back(panelJson(panel));
    return {{"title", chart.title}, {"caption", chart.caption}, {"panels", panels}};
}

std::string headingOf(const StudyColumn& column)
{
    return column.name + (column.displayUnit.empty() ? "" : " [" + column.displayUnit + ']');
}

std::string cellText(const StudyColumn& column, const StudyValue& value)
{
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    const double* number = std::get_if<double>(&value);
    if (number == nullptr) return "-";
    constexpr double largestCount = 1e12;
    if (column.displayUnit.empty() && std::trunc(*number) == *number && std::abs(*number) < largestCount)
        return std::to_string(static_cast<long long>(*number));
    const std::string shown = displayed(*number, column.displayUnit);
    return shown.substr(0, shown.find(' ')); // the unit stands in the heading
}

/// `whole` says which option gives all of it.
std::string tableText(const StudyTable& table, std::size_t width, const std::string& whole)
{
    std::vector<FittedColumn> columns;
    for (const StudyColumn& column : table.columns) columns.push_back({headingOf(column), false, column.secondary});
    std::vector<std::vector<std::string>> rows;
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i)
            if (std::holds_alternative<std::string>(row[i])) columns[i].text = true;
        if (rows.size() == mostRows) continue;
        auto& line = rows.emplace_back();
        for (std::size_t i = 0; i < row.size(); ++i) line.push_back(cellText(table.columns[i], row[i]));
    }
    const FittedTable fitted = fittedTable(columns, rows, width);
    std::string text = table.name + ":\n" + fitted.text;
    if (rows.size() < table.rows.size())
        text += "… " + std::to_string(table.rows.size()) + " rows; all with " + whole + "\n";
    std::string names;
    for (const std::string& each : fitted.leftOut) names += (names.empty() ? "" : ", ") + each;
    if (!names.empty())
        text += wrapped("left out: " + names + "; all with " + whole, 0, width);
    else if (fitted.cut && rows.size() == table.rows.size())
        text += wrapped("texts that end with … are whole with " + whole, 0, width);
    return text;
}

} // namespace

std::string studyJson(const StudyReport& report)
{
    Json tables = Json::array(), charts = Json::array();
    for (const StudyTable& table : report.tables) tables.push_back(tableJson(table));
    for (const StudyChart& chart : report.charts) charts.push_back(chartJson(chart));
    return jsonText({{"kind", report.kind},
                     {"title", report.title},
                     {"status", name(report.status)},
                     {"message", report.message},
                     {"wall_seconds", jsonNumber(report.wallSeconds)},
                     {"findings", report.findings},
                     {"warnings", report.warnings},
                     {"tables", tables},
                     {"charts", charts},
                     {"found", report.found ? Json(formatCase(*report.found)) : Json(nullptr)}});
}

std::string studyText(const StudyReport& report, std::size_t width)
{
    std::string text = report.title + "\n";
    text +=
        reportRow("status", std::string(name(report.status)) + (report.message.empty() ? "" : ": " + report.message));
    text += reportRow("time", displayed(report.wallSeconds, "s", 3));
    if (!report.findings.empty()) text += "\n";
    for (const std::string& finding : report.findings) text += finding + "\n";
    if (!report.warnings.empty()) text += "\n";
    for (const std::string& warning : report.warnings) text += "warning: " + warning + "\n";
    for (const StudyTable& table : report.tables)
        text += "\n" + tableText(table, width, &table == &report.tables.front() ? "--csv" : "--json");
    return text;
}

} // namespace touchdown
