// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/statements/statements.h"

#include <algorithm>

#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/studies/statements/statement_runs.h"
#include "core/studies/statements/statement_task.h"

namespace touchdown {

namespace {

/// The candidate before the figure, where there are any.
std::string placeOf(const Statement& statement)
{
    return (statement.candidate.empty() ? "" : statement.candidate + ", ") + statement.figure;
}

std::string shareText(const Share& share, int starts)
{
    return std::to_string(share.count) + " of " + counted(std::size_t(starts), "start") + " (" + percent(share.lower) +
           " to " + percent(share.upper) + ")";
}

StudyTable tableOf(const StatementTask& task, const CheckedStatements& checked)
{
    const bool several = !task.candidates.empty();
    StudyTable table{.name = "statements"};
    if (several) table.columns.push_back({"candidate", "", "", "Candidate"});
    for (const StudyColumn& column :
         std::initializer_list<StudyColumn>{{"figure", "", "", "Figure"},
                                            {"holds", "", "", "Holds"},
                                            {"found", "", "", "Found"},
                                            {"expected", "", "", "Expected"},
                                            {"starts", "", "", "Starts that do so; in brackets the 95 % interval"},
                                            {"statement", "", "", "What the text says"},
                                            {.name = "command", .longName = "Command", .secondary = true},
                                            {.name = "remark", .longName = "Remark", .secondary = true}})
        table.columns.push_back(column);
    for (std::size_t i = 0; i < task.statements.size(); ++i) {
        if (!checked[i].done) continue;
        const Statement& statement = task.statements[i];
        const CheckedStatement& each = checked[i];
        std::vector<StudyValue> row;
        if (several) row.emplace_back(statement.candidate);
        const std::string shares = each.share ? shareText(*each.share, statement.ensemble->starts) : "";
        for (const std::string& text :
             {statement.figure, std::string(each.holds() ? "yes" : "no"), each.finding.text, expectedText(statement),
              shares, statement.quote, statement.command, statement.remark})
            row.emplace_back(text);
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// Of each candidate.
StudyTable candidatesOf(const StatementTask& task, const CheckedStatements& checked)
{
    StudyTable table{.name = "candidates"};
    table.columns = {{"candidate", "", "", "Candidate"},
                     {"holding", "", "", "Statements that hold"},
                     {"statements", "", "", "Statements"},
                     {"least_share", "", "", "Least share of an ensemble"}};
    for (const std::string& candidate : task.candidates) {
        double holding = 0.0, all = 0.0, least = 1.0;
        for (std::size_t i = 0; i < task.statements.size(); ++i) {
            if (task.statements[i].candidate != candidate || !checked[i].done) continue;
            all += 1.0;
            holding += checked[i].holds() ? 1.0 : 0.0;
            if (checked[i].share) least = std::min(least, checked[i].share->share);
        }
        if (all > 0.0) table.rows.push_back({candidate, holding, all, least});
    }
    return table;
}

/// The shares of the ensembles, of each candidate.
std::vector<StudyChart> chartsOf(const StatementTask& task, const CheckedStatements& checked)
{
    ChartPanel panel{.x = {"Statement"}, .y = {"Share of the starts"}};
    std::vector<std::string> candidates = task.candidates;
    if (candidates.empty()) candidates.emplace_back();
    for (const std::string& candidate : candidates) {
        ChartSeries series{.name = candidate.empty() ? "share" : candidate, .line = ChartLine::None};
        double x = 0.0;
        for (std::size_t i = 0; i < task.statements.size(); ++i) {
            const Statement& statement = task.statements[i];
            if (statement.candidate != candidate || !statement.ensemble) continue;
            x += 1.0;
            if (!checked[i].share) continue;
            const Share& share = *checked[i].share;
            series.points.push_back({.x = x,
                                     .y = 0.5 * (share.lower + share.upper),
                                     .label = statement.figure,
                                     .kind = checked[i].holds() ? PointKind::Good : PointKind::WrongState,
                                     .yError = 0.5 * (share.upper - share.lower)});
        }
        if (!series.points.empty()) panel.series.push_back(std::move(series));
    }
    if (panel.series.empty()) return {};
    panel.bands.push_back({.alongX = false, .lower = 0.5, .upper = 0.5, .label = "one half"});
    return {{"Which share of the starts does what the text says?",
             "Wilson's interval at 95 %, and its middle; hollow: no more than half of the starts.",
             {panel}}};
}

StudyReport reportOf(const StatementTask& task, const CheckedStatements& checked)
{
    StudyReport report;
    report.tables.push_back(tableOf(task, checked));
    if (!task.candidates.empty()) report.tables.push_back(candidatesOf(task, checked));
    report.charts = chartsOf(task, checked);
    std::size_t done = 0, holding = 0;
    for (const CheckedStatement& each : checked) {
        done += each.done ? 1 : 0;
        holding += each.done && each.holds() ? 1 : 0;
    }
    report.findings.push_back(std::to_string(holding) + " of " + counted(done, "statement") +
                              (done == 1 ? " holds." : " hold."));
    for (const std::vector<StudyValue>& row : report.tables.back().rows) {
        if (task.candidates.empty()) break;
        report.findings.push_back(std::get<std::string>(row[0]) + ": " + formatNumber(std::get<double>(row[1])) +
                                  " of " + formatNumber(std::get<double>(row[2])) +
                                  " hold; the least share of an ensemble is " + percent(std::get<double>(row[3])) +
                                  ".");
    }
    for (std::size_t i = 0; i < checked.size(); ++i) {
        const CheckedStatement& each = checked[i];
        if (!each.done || each.holds()) continue;
        const Statement& statement = task.statements[i];
        report.findings.push_back(
            placeOf(statement) + " does not hold: \"" + statement.quote + "\" Expected: " + expectedText(statement) +
            "; found: " + each.finding.text +
            (each.share ? "; " + shareText(*each.share, statement.ensemble->starts) + " do what is expected" : "") +
            ".");
    }
    return report;
}

} // namespace

StudyWork planStatements(StudyReader& reader)
{
    const StatementTask task = readStatements(reader);
    return statementItems(task, [task](const CheckedStatements& checked) { return reportOf(task, checked); });
}

} // namespace touchdown
