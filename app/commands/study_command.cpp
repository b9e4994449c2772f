// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/study_command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <thread>

#include "app/commands/case_commands.h"
#include "app/commands/list_study.h"
#include "app/terminal/console.h"
#include "app/terminal/json_text.h"
#include "app/terminal/output_target.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/refusal.h"
#include "app/terminal/report_text.h"
#include "app/terminal/text_table.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/formats/toml_document.h"
#include "core/formats/words.h"
#include "core/studies/study/study_file.h"
#include "core/studies/study/study_verdict.h"
#include "core/studies/study_plan.h"

namespace touchdown {

namespace {

constexpr std::size_t mostRows = 40; // of a printed table

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
    return shown.substr(0, shown.find(' ')); // the heading has the unit
}

/// `whole`: the option that gives the complete table.
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
    if (!fitted.leftOut.empty())
        text += wrapped("left out: " + joined(fitted.leftOut) + "; all with " + whole, 0, width);
    else if (fitted.cut && rows.size() == table.rows.size())
        text += wrapped("texts that end with … are whole with " + whole, 0, width);
    return text;
}

/// Null where the study checks nothing.
Json verdictJson(const StudyReport& report)
{
    const StudyVerdict verdict = verdictOf(report);
    return verdict == StudyVerdict::None ? Json(nullptr) : Json(name(verdict));
}

/// One object, with the charts; numbers in SI, unknown numbers as null.
std::string studyJson(const StudyReport& report)
{
    Json tables = Json::array(), charts = Json::array();
    for (const StudyTable& table : report.tables) tables.push_back(tableJson(table));
    for (const StudyChart& chart : report.charts) charts.push_back(chartJson(chart));
    return jsonText({{"kind", report.kind},
                     {"title", report.title},
                     {"status", name(report.status)},
                     {"message", report.message},
                     {"verdict", verdictJson(report)},
                     {"wall_seconds", jsonNumber(report.wallSeconds)},
                     {"findings", report.findings},
                     {"warnings", report.warnings},
                     {"tables", tables},
                     {"charts", charts},
                     {"found", report.found ? Json(formatCase(*report.found)) : Json(nullptr)}});
}

/// Findings, warnings, tables of at most `width` characters.
std::string studyText(const StudyReport& report, std::size_t width)
{
    std::string text = report.title + "\n";
    text += reportRow("status", statusText(name(report.status), report.message));
    if (const StudyVerdict verdict = verdictOf(report);
        verdict != StudyVerdict::None && report.status == StudyStatus::Completed)
        text += reportRow("verdict", std::string(name(verdict)));
    text += reportRow("time", displayed(report.wallSeconds, "s", 3));
    if (!report.findings.empty()) text += "\n";
    for (const std::string& finding : report.findings) text += finding + "\n";
    if (!report.warnings.empty()) text += "\n";
    for (const std::string& warning : report.warnings) text += "warning: " + warning + "\n";
    for (const StudyTable& table : report.tables)
        text += "\n" + tableText(table, width, &table == &report.tables.front() ? "--csv" : "--json");
    return text;
}

/// Writes the case that a study found, with the comments of its first case. Returns the problem, or "".
std::string writeFound(const std::string& file, const StudyPlan& plan, const Case& found)
{
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    return writeCaseFile(file, updateCaseText(plan.start.text, found, folder.empty() ? "." : folder));
}

/// Writes all requested files, also of a study that ended early. Returns the problems.
std::vector<std::string> writeFiles(const CommandArguments& arguments, const StudyPlan& plan, const StudyReport& report,
                                    StudyWriter& out)
{
    std::vector<std::string> problems;
    const auto keep = [&](std::string problem) {
        if (!problem.empty()) problems.push_back(std::move(problem));
    };
    if (!arguments.out.empty()) keep(out.finish(report));
    if (!arguments.csv.empty() && !report.tables.empty()) keep(writeStudyCsv(arguments.csv, report));
    if (!arguments.apply.empty() && report.found) keep(writeFound(arguments.apply, plan, *report.found));
    return problems;
}

std::vector<OutputTarget> targetsOf(const CommandArguments& arguments)
{
    return {{"--out", arguments.out}, {"--csv", arguments.csv}, {"--apply", arguments.apply}};
}

/// Problems of the study, of its case, and of the files that are to be written.
std::vector<InputProblem> problemsOf(const StudyPlan& plan, const CommandArguments& arguments)
{
    std::vector<InputProblem> problems = plan.problems;
    // A user who names a case file with --out may expect the found case in it.
    const auto kind = std::ranges::find(studyKinds(), arguments.kind, &StudyKind::name);
    if (kind != studyKinds().end() && kind->findsCase && arguments.out.ends_with(".toml"))
        problems.push_back({"", 0, "--out",
                            "writes findings, charts and tables as HDF5; write the case that was found with --apply " +
                                arguments.out});
    std::vector<std::filesystem::path> inputs = plan.inputs;
    for (const std::string& part : arguments.join) inputs.emplace_back(part);
    std::error_code error;
    if (arguments.resume) // it goes on in its file
        std::erase_if(inputs,
                      [&](const auto& input) { return std::filesystem::equivalent(input, arguments.out, error); });
    std::ranges::move(targetProblems(targetsOf(arguments), inputs), std::back_inserter(problems));
    return problems;
}

/// Prints the study that the arguments name, or one of their case with the defaults.
int printTemplate(const CommandArguments& arguments)
{
    const StudyPlan plan = openStudy(arguments.kind, arguments.name, arguments.settings, {}, arguments.outside());
    warnOf(plan);
    std::vector<InputProblem> problems = plan.problems;
    const bool isStudy = !plan.text.empty();
    const char* ignored = !arguments.options.empty()               ? "--option"
                          : isStudy && !arguments.settings.empty() ? "--set"
                                                                   : "";
    const std::string shortcut = arguments.kind == "advise"        ? "--tolerance"
                                 : arguments.kind == "convergence" ? "--levels"
                                                                   : "";
    if (*ignored != 0)
        problems.push_back({"", 0, ignored,
                            "has no effect" + (shortcut.empty() ? "" : ", nor has " + shortcut + ",") +
                                " on what --template prints; write it into the file"});
    if (!problems.empty()) return refuse(problems, arguments.json);
    if (isStudy) {
        printExactly(plan.text);
        return exitDone;
    }
    std::string head = "case = " + tomlString(arguments.name) + "\n";
    for (const std::string& setting : arguments.settings) {
        const auto equals = setting.find('=');
        head += "set." + tomlString(setting.substr(0, equals)) + " = " + tomlString(setting.substr(equals + 1)) + "\n";
    }
    printExactly(head + studyTemplate(arguments.kind, plan.start.value));
    return exitDone;
}

} // namespace

std::vector<std::string> studyKindNames()
{
    std::vector<std::string> names;
    for (const StudyKind& kind : studyKinds()) names.push_back(kind.name);
    return names;
}

void warnOf(const StudyPlan& plan)
{
    for (const auto* list : {&plan.start.warnings, &plan.start.unused}) complainOf(*list, "warning: ");
}

int studyCommand(const CommandArguments& given)
{
    if (given.asTemplate) return printTemplate(given);
    CommandArguments arguments = given;
    if (!arguments.engine.empty() && !arguments.out.empty()) {
        std::error_code error; // what cannot be written is told below
        std::filesystem::create_directories(arguments.out, error);
        arguments.out = std::filesystem::absolute(std::filesystem::path(arguments.out) / "result.h5").string();
    }
    const StudyPlan plan =
        openStudy(arguments.kind, arguments.name, arguments.settings, arguments.options, arguments.outside());
    warnOf(plan);
    ListStudy list;
    std::vector<InputProblem> wrong = problemsOf(plan, arguments);
    list.check(plan, arguments, wrong);
    if (!wrong.empty()) return refuse(wrong, arguments.json);
    TargetLocks locks({{"--csv", arguments.csv}, {"--apply", arguments.apply}});
    if (!locks.problems().empty()) return refuse(locks.problems(), arguments.json);
    StudyWriter out;
    if (!arguments.out.empty()) {
        const Case& c = plan.start.value;
        // The text holds the contents of the files that the case names: the report needs no other file.
        const std::string problem = out.open(
            arguments.out, {plan.kind, plan.title, c, updateCaseText(plan.start.text, c), plan.text, plan.options});
        if (!problem.empty()) return refuse({{"", 0, "--out", problem}}, arguments.json);
        if (const std::string taken = plan.performList ? list.open(arguments) : ""; !taken.empty())
            return refuse({{"", 0, "--out", taken}}, arguments.json);
    }

    ProgressLine line(arguments.progress);
    const StudyCallback follow = [&](const StudyProgress& progress) {
        // A state that cannot be written is no reason to stop: the problem is reported when the final report is
        // written.
        if (!arguments.out.empty()) out.update(progress.soFar);
        return line.show({progress.share, progress.doing});
    };
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    StudyReport report = plan.performList ? list.perform(plan, arguments, follow)
                                          : plan.perform(arguments.jobs > 0 ? arguments.jobs : cores, follow);
    if (report.status == StudyStatus::Completed) line.show({1.0}); // also of a study that reports no progress
    line.end();
    locks.release();
    const std::vector<std::string> problems = writeFiles(arguments, plan, report, out);
    if (!problems.empty()) {
        report.status = StudyStatus::Failed;
        report.message = problems.front();
    } else {
        list.close();
    }
    if (arguments.resume) complain(list.takenText(plan));
    print(arguments.json ? studyJson(report) : studyText(report, outputWidth()));
    if (report.status != StudyStatus::Completed) {
        complain(statusText(name(report.status), report.message));
        return exitNoAnswer;
    }
    if (arguments.apply.empty() || report.found) return exitDone;
    complain("--apply: nothing is written to " + arguments.apply +
             ": no case has this answer; the findings name the command that has it");
    return exitNoAnswer;
}

} // namespace touchdown
