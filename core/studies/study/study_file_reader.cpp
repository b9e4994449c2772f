// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_file_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

#include "core/case_files/case_reader.h"
#include "core/formats/hdf5_file.h"
#include "core/formats/hdf5_inspection.h"
#include "core/formats/reader_process.h"
#include "core/results/file_header.h"
#include "core/results/stored_values.h"
#include "core/studies/study/item_journal.h"
#include "core/studies/study/stored_report.h"
#include "core/studies/study/study_file.h"

namespace touchdown {

namespace {

/// The one of `all` with this name.
template <class Kind>
Kind named(const std::string& text, std::initializer_list<Kind> all, Kind otherwise)
{
    for (const Kind kind : all)
        if (text == name(kind)) return kind;
    return otherwise;
}

std::string unitOf(std::string text) { return text == "1" ? std::string() : text; }

bool flag(const Hdf5Object& object, const std::string& name) { return object.numberAttribute(name) == 1.0; }

/// Columns of one array have one length.
void checkLength(std::size_t length, std::size_t expected, const std::string& name)
{
    if (length != expected)
        throw Hdf5Error(name + " has " + std::to_string(length) + " elements instead of " + std::to_string(expected));
}

std::vector<StudyValue> readValues(const Hdf5Group& table, const std::string& name)
{
    const Hdf5Dataset dataset = table.get(name);
    std::vector<StudyValue> values;
    if (dataset.holdsTexts()) {
        for (std::string& text : dataset.texts())
            text.empty() ? values.emplace_back() : values.emplace_back(std::move(text));
        return values;
    }
    const std::vector<double> numbers = dataset.column();
    checkFinite(numbers, name);
    const std::string mark = name + "_known";
    const std::vector<double> isKnown =
        table.has(mark) ? table.get(mark).column() : std::vector<double>(numbers.size(), 1.0);
    checkLength(isKnown.size(), numbers.size(), mark);
    for (std::size_t i = 0; i < numbers.size(); ++i) values.push_back(known(isKnown[i] != 0.0, numbers[i]));
    return values;
}

StudyTable readTable(const Hdf5Group& group, const std::string& tableName)
{
    StudyTable table{tableName};
    const std::vector<std::string> names = group.names();
    for (const std::string& column : names) {
        constexpr std::string_view mark = "_known";
        if (column.ends_with(mark) &&
            std::ranges::find(names, column.substr(0, column.size() - mark.size())) != names.end())
            continue;
        const Hdf5Dataset dataset = group.get(column);
        table.columns.push_back({column, unitOf(dataset.attribute("unit")), unitOf(dataset.attribute("display_unit")),
                                 dataset.attribute("long_name")});
        const std::vector<StudyValue> values = readValues(group, column);
        if (table.columns.size() == 1) table.rows.resize(values.size());
        checkLength(values.size(), table.rows.size(), column);
        for (std::size_t i = 0; i < values.size(); ++i) table.rows[i].push_back(values[i]);
    }
    return table;
}

ChartAxis readAxis(const Hdf5Group& panel, const std::string& name)
{
    return {panel.attribute(name + "_label"), unitOf(panel.attribute(name + "_unit")),
            unitOf(panel.attribute(name + "_display_unit")), flag(panel, name + "_logarithmic")};
}

ChartSeries readSeries(const Hdf5Group& group)
{
    ChartSeries series;
    series.name = group.attribute("name");
    series.line = named(group.attribute("line"),
                        {ChartLine::None, ChartLine::Solid, ChartLine::Dashed, ChartLine::Steps}, ChartLine::Solid);
    series.markers = flag(group, "markers");
    series.quiet = flag(group, "quiet");
    const auto column = [&](const char* name) { return group.get(name).column(); };
    const std::vector<double> x = column("x"), y = column("y"), xError = column("x_error"), yError = column("y_error"),
                              chosen = column("chosen");
    const std::vector<std::string> labels = group.get("label").texts(), kinds = group.get("kind").texts();
    for (const std::size_t length :
         {y.size(), xError.size(), yError.size(), chosen.size(), labels.size(), kinds.size()})
        checkLength(length, x.size(), "series " + series.name);
    for (const auto& numbers : {x, y, xError, yError}) checkFinite(numbers, "series " + series.name);
    for (std::size_t i = 0; i < x.size(); ++i) {
        ChartPoint point{x[i], y[i], labels[i]};
        point.kind = named(kinds[i], {PointKind::Good, PointKind::WrongState, PointKind::Failed}, PointKind::Good);
        point.chosen = chosen[i] != 0.0;
        point.xError = xError[i];
        point.yError = yError[i];
        series.points.push_back(point);
    }
    return series;
}

ChartBand readBand(const Hdf5Group& group)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double lower = group.numberAttribute("lower"), upper = group.numberAttribute("upper");
    return {group.attribute("along") == "x", std::isnan(lower) ? -infinity : lower,
            std::isnan(upper) ? infinity : upper, group.attribute("label")};
}

ChartMap readMap(const Hdf5Group& group)
{
    ChartMap map;
    map.x = group.get("x").column();
    map.y = group.get("y").column();
    for (const auto& places : {map.x, map.y}) {
        checkFinite(places, "a map");
        if (!std::ranges::is_sorted(places)) throw Hdf5Error("the places of a map do not rise");
    }
    const std::vector<std::string> names = group.get("class_name").texts();
    const std::vector<double> severities = group.get("class_severity").column();
    checkLength(severities.size(), names.size(), "class_severity");
    checkFinite(severities, "class_severity");
    const std::vector<double> shades =
        group.has("class_shade") ? group.get("class_shade").column() : std::vector<double>(names.size(), -1.0);
    checkLength(shades.size(), names.size(), "class_shade");
    checkFinite(shades, "class_shade");
    for (std::size_t i = 0; i < names.size(); ++i)
        map.classes.push_back({names[i], static_cast<int>(std::clamp(severities[i], 0.0, 3.0)), shades[i]});
    const std::vector<double> cells = group.get("cells").column();
    checkLength(cells.size(), map.x.size() * map.y.size(), "cells");
    for (const double cell : cells) {
        if (!(cell >= -1.0 && cell < static_cast<double>(names.size()))) throw Hdf5Error("a cell has no class");
        map.cells.push_back(static_cast<int>(cell));
    }
    map.details = group.get("details").texts();
    if (!map.details.empty()) checkLength(map.details.size(), cells.size(), "details");
    return map;
}

/// All members of a group, numbered from 1.
template <class Element>
std::vector<Element> readNumbered(const Hdf5Group& parent, const std::string& name, Element (*read)(const Hdf5Group&))
{
    const Hdf5Group group = parent.group(name);
    std::vector<Element> list;
    for (const std::string& number : group.names()) list.push_back(read(group.group(number)));
    return list;
}

ChartPanel readPanel(const Hdf5Group& group)
{
    ChartPanel panel;
    panel.x = readAxis(group, "x");
    panel.y = readAxis(group, "y");
    panel.equalScales = flag(group, "equal_scales");
    panel.series = readNumbered(group, "series", readSeries);
    panel.bands = readNumbered(group, "bands", readBand);
    if (group.has("map")) panel.map = readMap(group.group("map"));
    return panel;
}

StudyChart readChart(const Hdf5Group& group)
{
    return {group.attribute("title"), group.attribute("caption"), readNumbered(group, "panels", readPanel)};
}

std::vector<StudyItem> readItems(const Hdf5Group& group)
{
    const std::vector<std::string> keys = group.get("key").texts(), rows = group.get("row").texts();
    checkLength(rows.size(), keys.size(), "row");
    std::vector<StudyItem> items;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        auto row = readRow(rows[i]);
        if (!row) throw Hdf5Error("the row of item " + std::to_string(i + 1) + " is none");
        items.push_back({keys[i], std::move(*row)});
    }
    return items;
}

StudyReport readReport(const Hdf5Group& file)
{
    StudyReport report;
    report.status =
        named(file.attribute("status"),
              {StudyStatus::Completed, StudyStatus::Cancelled, StudyStatus::Failed, StudyStatus::Interrupted},
              StudyStatus::Failed);
    report.message = file.attribute("message");
    report.kind = file.attribute("kind");
    report.title = file.attribute("title");
    report.findings = file.get("findings").texts();
    report.warnings = file.get("warnings").texts();
    report.charts = readNumbered(file, "charts", readChart);
    if (file.has("items")) report.items = readItems(file.group("items"));
    const Hdf5Group tables = file.group("tables");
    for (const std::string& table : tables.names()) report.tables.push_back(readTable(tables.group(table), table));
    if (file.has("found"))
        report.found = parseCase(file.get("found/text").text(), "the case that the study found").value;
    const double seconds = file.numberAttribute("wall_seconds");
    report.wallSeconds = std::isfinite(seconds) ? seconds : 0.0;
    return report;
}

/// The lengths and choices are those that the reader found.
bool fits(const StoredStudy& stored)
{
    const StudyReport& report = stored.report;
    const auto isTable = [](const StudyTable& table) {
        return std::ranges::all_of(table.rows, [&](const auto& row) { return row.size() == table.columns.size(); });
    };
    const auto isSeries = [](const ChartSeries& series) {
        return series.line <= ChartLine::Steps && std::ranges::all_of(series.points, [](const ChartPoint& point) {
                   return point.kind <= PointKind::Failed;
               });
    };
    const auto isMap = [](const ChartMap& map) {
        const auto isCell = [&](int cell) { return cell >= -1 && cell < static_cast<int>(map.classes.size()); };
        return map.cells.size() == map.x.size() * map.y.size() && std::ranges::all_of(map.cells, isCell) &&
               (map.details.empty() || map.details.size() == map.cells.size());
    };
    const auto isPanel = [&](const ChartPanel& panel) {
        return std::ranges::all_of(panel.series, isSeries) && (!panel.map || isMap(*panel.map));
    };
    const auto isChart = [&](const StudyChart& chart) { return std::ranges::all_of(chart.panels, isPanel); };
    return report.status <= StudyStatus::Interrupted && std::ranges::all_of(report.tables, isTable) &&
           std::ranges::all_of(report.charts, isChart);
}

} // namespace

StoredStudy readStudy(const std::filesystem::path& path) { return readByProcess<StoredStudy>("study", path, fits); }

StoredStudy readStudyDirectly(const std::filesystem::path& path)
{
    const Hdf5Access access;
    const auto refused = [](std::string problem) {
        StoredStudy nothing;
        nothing.problem = std::move(problem);
        return nothing;
    };
    if (std::string problem = notHdf5(path); !problem.empty()) return refused(std::move(problem));
    try {
        const Hdf5Group file = openHdf5File(path);
        if (std::string problem = foreignFile(path, file, studyFormat, studyFormatMajor, "the report of a study");
            !problem.empty())
            return refused(std::move(problem));
        inspectHdf5File(file, readerLimits(path).data);
        return {readReport(file),
                file.get("case/text").text(),
                file.get("study/text").text(),
                {},
                file.has("study/options") ? file.get("study/options").texts() : std::vector<std::string>()};
    } catch (const Hdf5Error& error) {
        return refused(path.string() + " is damaged or cut short: " + error.what());
    } catch (const std::bad_alloc&) {
        return refused(path.string() + " does not fit into memory");
    }
}

} // namespace touchdown
