// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_file.h"

#include <algorithm>
#include <cmath>

#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/formats/csv_cell.h"
#include "core/formats/decimal.h"
#include "core/formats/hdf5_file.h"
#include "core/formats/text_file.h"
#include "core/results/results_layout.h"

namespace touchdown {

namespace {

/// A number of a table, if it is one.
const double* numberIn(const StudyValue& value)
{
    const double* number = std::get_if<double>(&value);
    return number != nullptr && std::isfinite(*number) ? number : nullptr;
}

std::string textIn(const StudyValue& value)
{
    if (const double* number = numberIn(value)) return decimalText(*number);
    const auto* text = std::get_if<std::string>(&value);
    return text == nullptr ? std::string() : *text;
}

void writeFlag(hid_t object, const std::string& name, bool flag)
{
    writeHdf5Attribute(object, name, std::int64_t{flag});
}

void writeNumbers(hid_t table, const StudyColumn& column, const std::vector<StudyValue>& values)
{
    std::vector<double> numbers, known;
    for (const StudyValue& value : values) {
        const double* number = numberIn(value);
        numbers.push_back(number == nullptr ? 0.0 : *number);
        known.push_back(number == nullptr ? 0.0 : 1.0);
    }
    const Hdf5Handle array = writeHdf5Array(table, column.name, numbers);
    describeHdf5(array, column.unit.empty() ? "1" : column.unit, column.longName);
    writeHdf5Attribute(array, "display_unit", column.displayUnit.empty() ? std::string("1") : column.displayUnit);
    if (std::ranges::find(known, 0.0) != known.end())
        describeHdf5(writeHdf5Array(table, column.name + "_known", known), "1", "1 where " + column.name + " is known");
}

void writeTable(hid_t tables, const StudyTable& table)
{
    const Hdf5Handle group = createHdf5Group(tables, table.name);
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const StudyColumn& column = table.columns[i];
        std::vector<StudyValue> values;
        for (const auto& row : table.rows) values.push_back(row[i]);
        const auto isText = [](const StudyValue& value) { return std::holds_alternative<std::string>(value); };
        if (std::ranges::none_of(values, isText)) {
            writeNumbers(group, column, values);
            continue;
        }
        std::vector<std::string> texts;
        for (const StudyValue& value : values) texts.push_back(textIn(value));
        describeHdf5(writeHdf5Array(group, column.name, texts), "1", column.longName);
    }
}

void writeAxis(hid_t panel, const std::string& name, const ChartAxis& axis)
{
    writeHdf5Attribute(panel, name + "_label", axis.label);
    writeHdf5Attribute(panel, name + "_unit", axis.unit.empty() ? std::string("1") : axis.unit);
    writeHdf5Attribute(panel, name + "_display_unit", axis.displayUnit.empty() ? std::string("1") : axis.displayUnit);
    writeFlag(panel, name + "_logarithmic", axis.logarithmic);
}

void writeSeries(hid_t group, const ChartSeries& series)
{
    writeHdf5Attribute(group, "name", series.name);
    writeHdf5Attribute(group, "line", std::string(name(series.line)));
    writeFlag(group, "markers", series.markers);
    writeFlag(group, "quiet", series.quiet);
    std::vector<double> x, y, xError, yError, chosen;
    std::vector<std::string> labels, kinds;
    for (const ChartPoint& point : series.points) {
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
        x.push_back(point.x);
        y.push_back(point.y);
        xError.push_back(point.xError);
        yError.push_back(point.yError);
        chosen.push_back(point.chosen ? 1.0 : 0.0);
        labels.push_back(point.label);
        kinds.emplace_back(name(point.kind));
    }
    writeHdf5Array(group, "x", x);
    writeHdf5Array(group, "y", y);
    writeHdf5Array(group, "x_error", xError);
    writeHdf5Array(group, "y_error", yError);
    writeHdf5Array(group, "label", labels);
    writeHdf5Array(group, "kind", kinds);
    writeHdf5Array(group, "chosen", chosen);
}

void writeBand(hid_t group, const ChartBand& band)
{
    writeHdf5Attribute(group, "along", std::string(band.alongX ? "x" : "y"));
    writeHdf5Attribute(group, "label", band.label);
    if (std::isfinite(band.lower)) writeHdf5Attribute(group, "lower", band.lower);
    if (std::isfinite(band.upper)) writeHdf5Attribute(group, "upper", band.upper);
}

void writeMap(hid_t group, const ChartMap& map)
{
    writeHdf5Array(group, "x", map.x);
    writeHdf5Array(group, "y", map.y);
    writeHdf5Array(group, "cells", std::vector<double>(map.cells.begin(), map.cells.end()));
    std::vector<std::string> names;
    std::vector<double> severities;
    for (const ChartClass& each : map.classes) {
        names.push_back(each.name);
        severities.push_back(each.severity);
    }
    writeHdf5Array(group, "class_name", names);
    writeHdf5Array(group, "class_severity", severities);
    writeHdf5Array(group, "details", map.details);
}

/// A group with one for each, from 1.
template <class List, class Write>
void writeNumbered(hid_t parent, const std::string& name, const List& list, const Write& write)
{
    const Hdf5Handle group = createHdf5Group(parent, name);
    std::size_t number = 0;
    for (const auto& each : list) write(createHdf5Group(group, std::to_string(++number)), each);
}

void writePanel(hid_t group, const ChartPanel& panel)
{
    writeAxis(group, "x", panel.x);
    writeAxis(group, "y", panel.y);
    writeFlag(group, "equal_scales", panel.equalScales);
    writeNumbered(group, "series", panel.series, writeSeries);
    writeNumbered(group, "bands", panel.bands, writeBand);
    if (panel.map) writeMap(createHdf5Group(group, "map"), *panel.map);
}

void writeChart(hid_t group, const StudyChart& chart)
{
    writeHdf5Attribute(group, "title", chart.title);
    writeHdf5Attribute(group, "caption", chart.caption);
    writeNumbered(group, "panels", chart.panels, writePanel);
}

} // namespace

std::string writeStudy(const std::filesystem::path& path, const StudyReport& report, const Case& c,
                       const std::string& caseText, const std::string& studyText)
{
    return writeHdf5File(path, "the study", [&](hid_t file) {
        writeFileHeader(file, studyFormat, studyFormatMajor, studyFormatMinor, dateNow(), report.title);
        writeHdf5Attribute(file, "kind", report.kind);
        writeHdf5Attribute(file, "status", std::string(name(report.status)));
        writeHdf5Attribute(file, "message", report.message);
        writeHdf5Attribute(file, "wall_seconds", report.wallSeconds);
        writeCaseGroup(file, c, caseText);
        describeHdf5(writeHdf5Scalar(createHdf5Group(file, "study"), "text", studyText), "1",
                     "The study as it was given");
        describeHdf5(writeHdf5Array(file, "findings", report.findings), "1", "What the study found");
        describeHdf5(writeHdf5Array(file, "warnings", report.warnings), "1", "What weakens that");
        const Hdf5Handle tables = createHdf5Group(file, "tables");
        for (const StudyTable& table : report.tables) writeTable(tables, table);
        writeNumbered(file, "charts", report.charts, writeChart);
        if (report.found)
            describeHdf5(writeHdf5Scalar(createHdf5Group(file, "found"), "text", formatCase(*report.found)), "1",
                         "The case that the study advises");
    });
}

std::string writeStudyCsv(const std::filesystem::path& path, const StudyReport& report)
{
    if (report.tables.empty()) return path.string() + ": the study has no table to write";
    const StudyTable& table = report.tables.front();
    std::string text;
    const auto addRow = [&](const auto& cells, const auto& of) {
        std::string row;
        for (const auto& cell : cells) row += (&cell == &cells.front() ? "" : ",") + csvCell(of(cell));
        text += row + "\r\n";
    };
    addRow(table.columns, [](const StudyColumn& column) {
        return column.name + (column.unit.empty() ? "" : " [" + column.unit + ']');
    });
    for (const auto& row : table.rows) addRow(row, textIn);
    const std::string problem = writeTextFile(path, text);
    return problem.empty() ? problem : path.string() + ": " + problem;
}

} // namespace touchdown
