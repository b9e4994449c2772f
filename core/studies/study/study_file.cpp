// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_file.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/formats/csv_cell.h"
#include "core/formats/decimal.h"
#include "core/formats/hdf5_file.h"
#include "core/formats/text_file.h"
#include "core/results/file_header.h"
#include "core/studies/study/item_journal.h"

namespace touchdown {

namespace {

constexpr int betweenWrites = 20; // times that one took, so that states of the file take a twentieth of the time

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

std::string unitText(const std::string& unit) { return unit.empty() ? "1" : unit; }

void putNumbers(const Hdf5Group& table, const StudyColumn& column, const std::vector<StudyValue>& values)
{
    std::vector<double> numbers, known;
    for (const StudyValue& value : values) {
        const double* number = numberIn(value);
        numbers.push_back(number == nullptr ? 0.0 : *number);
        known.push_back(number == nullptr ? 0.0 : 1.0);
    }
    table.put(column.name, numbers, column.unit, column.longName).set("display_unit", unitText(column.displayUnit));
    if (std::ranges::find(known, 0.0) != known.end())
        table.put(column.name + "_known", known, "1", "1 where " + column.name + " is known");
}

void writeTable(const Hdf5Group& group, const StudyTable& table)
{
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const StudyColumn& column = table.columns[i];
        std::vector<StudyValue> values;
        for (const auto& row : table.rows) values.push_back(row[i]);
        const auto isText = [](const StudyValue& value) { return std::holds_alternative<std::string>(value); };
        if (std::ranges::none_of(values, isText)) {
            putNumbers(group, column, values);
            continue;
        }
        std::vector<std::string> texts;
        for (const StudyValue& value : values) texts.push_back(textIn(value));
        group.put(column.name, texts, "1", column.longName);
    }
}

void writeAxis(const Hdf5Group& panel, const std::string& name, const ChartAxis& axis)
{
    panel.set(name + "_label", axis.label);
    panel.set(name + "_unit", unitText(axis.unit));
    panel.set(name + "_display_unit", unitText(axis.displayUnit));
    panel.set(name + "_logarithmic", std::int64_t{axis.logarithmic});
}

void writeSeries(const Hdf5Group& group, const ChartSeries& series)
{
    group.set("name", series.name);
    group.set("line", name(series.line));
    group.set("markers", std::int64_t{series.markers});
    group.set("quiet", std::int64_t{series.quiet});
    std::vector<ChartPoint> points = series.points;
    std::erase_if(points, [](const ChartPoint& point) { return !std::isfinite(point.x) || !std::isfinite(point.y); });
    const auto put = [&](const char* name, const auto& member) {
        std::vector<decltype(member(points.front()))> values;
        for (const ChartPoint& point : points) values.push_back(member(point));
        group.put(name, values);
    };
    put("x", [](const ChartPoint& point) { return point.x; });
    put("y", [](const ChartPoint& point) { return point.y; });
    put("x_error", [](const ChartPoint& point) { return point.xError; });
    put("y_error", [](const ChartPoint& point) { return point.yError; });
    put("label", [](const ChartPoint& point) { return point.label; });
    put("kind", [](const ChartPoint& point) { return std::string(name(point.kind)); });
    put("chosen", [](const ChartPoint& point) { return point.chosen ? 1.0 : 0.0; });
}

void writeBand(const Hdf5Group& group, const ChartBand& band)
{
    group.set("along", band.alongX ? "x" : "y");
    group.set("label", band.label);
    if (std::isfinite(band.lower)) group.set("lower", band.lower);
    if (std::isfinite(band.upper)) group.set("upper", band.upper);
}

void writeMap(const Hdf5Group& group, const ChartMap& map)
{
    std::vector<std::string> names;
    std::vector<double> severities, shades;
    for (const ChartClass& each : map.classes) {
        names.push_back(each.name);
        severities.push_back(each.severity);
        shades.push_back(each.shade);
    }
    group.put("x", map.x);
    group.put("y", map.y);
    group.put("cells", std::vector<double>(map.cells.begin(), map.cells.end()));
    group.put("class_name", names);
    group.put("class_severity", severities);
    group.put("class_shade", shades);
    group.put("details", map.details);
}

/// A group with one member for each element, numbered from 1.
void writeNumbered(const Hdf5Group& parent, const std::string& name, const auto& list, const auto& write)
{
    const Hdf5Group group = parent.create(name);
    std::size_t number = 0;
    for (const auto& each : list) write(group.create(std::to_string(++number)), each);
}

void writePanel(const Hdf5Group& group, const ChartPanel& panel)
{
    writeAxis(group, "x", panel.x);
    writeAxis(group, "y", panel.y);
    group.set("equal_scales", std::int64_t{panel.equalScales});
    writeNumbered(group, "series", panel.series, writeSeries);
    writeNumbered(group, "bands", panel.bands, writeBand);
    if (panel.map) writeMap(group.create("map"), *panel.map);
}

void writeChart(const Hdf5Group& group, const StudyChart& chart)
{
    group.set("title", chart.title);
    group.set("caption", chart.caption);
    writeNumbered(group, "panels", chart.panels, writePanel);
}

void writeItems(const Hdf5Group& group, const std::vector<StudyItem>& items)
{
    std::vector<std::string> keys, rows;
    for (const StudyItem& item : items) {
        keys.push_back(item.key);
        rows.push_back(rowText(item.row));
    }
    group.put("key", keys, "1", "Keys of the items");
    group.put("row", rows, "1", "What came of each");
}

void writeReport(const Hdf5Group& file, const StudyReport& report, const StudySubject& subject)
{
    writeFileHeader(file, studyFormat, studyFormatMajor, studyFormatMinor, dateNow(), report.title);
    file.set("kind", report.kind);
    file.set("status", name(report.status));
    file.set("message", report.message);
    file.set("wall_seconds", report.wallSeconds);
    writeCaseGroup(file, subject.value, subject.caseText);
    const Hdf5Group study = file.create("study");
    study.put("text", subject.studyText, "1", "The study as it was given");
    study.put("options", subject.options, "1", "Values of the study that were changed by --option");
    file.put("findings", report.findings, "1", "What the study found");
    file.put("warnings", report.warnings, "1", "What weakens that");
    const Hdf5Group tables = file.create("tables");
    for (const StudyTable& table : report.tables) writeTable(tables.create(table.name), table);
    writeNumbered(file, "charts", report.charts, writeChart);
    if (!report.items.empty()) writeItems(file.create("items"), report.items);
    if (report.found)
        file.create("found").put("text", formatCase(*report.found), "1", "The case that the study advises");
}

} // namespace

StudyReport interruptedReport(StudyReport soFar)
{
    soFar.findings.clear();
    soFar.status = StudyStatus::Interrupted;
    soFar.message = "the study was interrupted; what it had not found yet is missing";
    return soFar;
}

std::string StudyWriter::open(const std::filesystem::path& file, StudySubject subject)
{
    lock_.reset();
    pending_.reset();
    if (std::string problem = checkOutputFile(file); !problem.empty()) return problem;
    try {
        lock_ = std::make_unique<OutputLock>(file);
    } catch (const std::exception& failure) {
        return "cannot write to " + file.string() + ": " + failure.what();
    }
    subject_ = std::move(subject);
    begin_ = Clock::now();
    written_ = begin_ - interval_;
    return {};
}

std::string StudyWriter::update(const StudyReport* soFar)
{
    if (!lock_) return "no file of a study is open";
    if (soFar != nullptr) pending_ = *soFar;
    const Clock::time_point now = Clock::now();
    if (!pending_ || now - written_ < std::max<Clock::duration>(interval_, betweenWrites * tookToWrite_)) return {};
    StudyReport report = interruptedReport(std::move(*pending_));
    pending_.reset();
    report.kind = subject_.kind;
    if (report.title.empty()) report.title = subject_.title;
    report.wallSeconds = std::chrono::duration<double>(now - begin_).count();
    const Clock::time_point begin = Clock::now();
    std::string problem = write(report);
    written_ = Clock::now();
    tookToWrite_ = written_ - begin;
    return problem;
}

std::string StudyWriter::finish(const StudyReport& report)
{
    if (!lock_) return "no file of a study is open";
    std::string problem = write(report);
    lock_.reset();
    return problem;
}

std::string StudyWriter::write(const StudyReport& report)
{
    return writeHdf5File(*lock_, "the study", [&](const Hdf5Group& file) { writeReport(file, report, subject_); });
}

std::string writeStudy(const std::filesystem::path& path, const StudyReport& report, const Case& c,
                       const std::string& caseText, const std::string& studyText,
                       const std::vector<std::string>& options)
{
    StudyWriter writer;
    std::string problem = writer.open(path, {report.kind, report.title, c, caseText, studyText, options});
    return problem.empty() ? writer.finish(report) : problem;
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
