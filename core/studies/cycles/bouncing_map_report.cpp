// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/bouncing_map_report.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "core/case/contact_law.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/studies/cycles/cycles_report.h"

namespace touchdown {

namespace {

constexpr const char* markedByWork =
    " A case with another contact law, or with a film, is marked at the same W; the map shows what its own slider does "
    "there.";
constexpr std::array severities{0, 1, 2, 3, 1, 3}; // by MapClass

/// W at a mark [J].
double workOf(const BouncingMapTask& task, const MapMark& mark)
{
    return workOfLaw(task, mark.x, mark.y).value_or(0.0);
}

std::string cellText(const BouncingMapTask& task, const MapCell& cell)
{
    std::string text = task.x.text.of(cell.x) + ", " + task.y.text.of(cell.y) + ": " + std::string(name(cell.kind())) +
                       "; W = " + fewDigits(cell.cycleWork, "pJ", 3) + "; " +
                       counted(std::size_t(task.starts), "start") + ": ";
    std::vector<std::string> ends;
    for (std::size_t k = 0; k < cell.ends.size(); ++k)
        if (cell.ends[k] > 0)
            ends.push_back(std::to_string(cell.ends[k]) + " " + std::string(name(static_cast<BouncingEnd>(k))));
    text += joined(ends);
    return text + (cell.problem.empty() ? "" : " (" + cell.problem + ")");
}

ChartAxis chartAxis(const BouncingMapAxis& axis)
{
    return {axis.text.label, axis.text.unit, axis.text.displayUnit, axis.logarithmic};
}

StudyChart chartOf(const MarkedMapTask& task, const std::vector<MapCell>& cells)
{
    ChartPanel panel{chartAxis(task.x), chartAxis(task.y)};
    ChartMap& map = panel.map.emplace();
    map.x = task.x.values;
    map.y = task.y.values;
    for (std::size_t k = 0; k < mapClasses; ++k)
        map.classes.push_back({std::string(name(static_cast<MapClass>(k))), severities[k]});
    for (const MapCell& cell : cells) {
        map.cells.push_back(cell.done ? static_cast<int>(cell.kind()) : -1);
        map.details.push_back(cell.done ? cellText(task, cell) : "");
    }
    ChartSeries line{.name = "W = 0", .markers = false};
    for (const auto& [x, y] : zeroWork(task)) line.points.push_back({.x = x, .y = y});
    if (line.points.size() > 1) panel.series.push_back(std::move(line));
    if (!task.marks.empty()) {
        ChartSeries& marks = panel.series.emplace_back(ChartSeries{.name = "marked", .line = ChartLine::None});
        for (const MapMark& mark : task.marks) marks.points.push_back({.x = mark.x, .y = mark.y, .label = mark.name});
    }
    return {
        "Does the slider fly, is it caught, or does it bounce for ever?",
        "Each cell: " + counted(std::size_t(task.starts), "run") + " of " + fewDigitsOfTime(task.search.duration, 3) +
            " from different heights, each with the verdict of a run; one that bounces is enough. Line: W = 0, where "
            "one loop of the contact law neither takes nor creates energy." +
            (task.marksByWork ? markedByWork : ""),
        {panel}};
}

StudyTable tableOf(const BouncingMapTask& task, const std::vector<MapCell>& cells)
{
    StudyTable table{.name = "map"};
    table.columns = {{"x", task.x.text.unit, task.x.text.displayUnit, task.x.text.label},
                     {"y", task.y.text.unit, task.y.text.displayUnit, task.y.text.label},
                     {"work", "J", "pJ", "W, which one loop of the contact law takes"},
                     {"class", "", "", "How the slider ends"},
                     {"flies", "", "", "Share of the runs that fly at the end"},
                     {"caught", "", "", "Share of the runs that end in contact"},
                     {"bounces", "", "", "Share of the runs that bounce at the end"},
                     {"unknown", "", "", "Share of the runs that are too short to tell"},
                     {"failed", "", "", "Share of the runs that fail"},
                     {.name = "remark", .secondary = true}};
    for (const MapCell& cell : cells) {
        if (!cell.done) continue;
        std::vector<StudyValue> row{cell.x, cell.y, cell.cycleWork, std::string(name(cell.kind()))};
        for (const int runs : cell.ends) row.emplace_back(double(runs) / task.starts);
        row.emplace_back(cell.problem);
        assert(row.size() == table.columns.size());
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string findingOf(const std::vector<MapCell>& cells)
{
    const MapCount count = countOf(cells);
    const std::size_t quiet = count.quietFlying + count.quietOther;
    std::string text = "The slider bounces for ever in " + std::to_string(count.creating + count.taking) + " of " +
                       counted(count.cells, "cell") + " of the map: in " + std::to_string(count.creating) +
                       " with W < 0 and in " + std::to_string(count.taking) + " with W >= 0";
    if (quiet == 0) return text + "; in no cell with W < 0 the bouncing ends.";
    text += "; in " + counted(quiet, "cell") + " with W < 0 the bouncing ends, as the dashpots take the energy: ";
    text += "the slider flies in " + std::to_string(count.quietFlying);
    text += " of them and is caught, from one start or more, in " + std::to_string(count.quietOther);
    return text + ".";
}

StudyTable marksTable(const BouncingMapTask& task)
{
    StudyTable table{.name = "marks"};
    table.columns = {{"name", "", "", "Mark"},
                     {"x", task.x.text.unit, task.x.text.displayUnit, task.x.text.label},
                     {"y", task.y.text.unit, task.y.text.displayUnit, task.y.text.label},
                     {"work", "J", "pJ", "W, which one loop of the contact law takes"}};
    for (const MapMark& mark : task.marks) table.rows.push_back({mark.name, mark.x, mark.y, workOf(task, mark)});
    return table;
}

/// How many marks have a law that creates energy.
std::string findingOfMarks(const BouncingMapTask& task)
{
    SwingOf works;
    std::size_t creating = 0;
    for (const MapMark& mark : task.marks) {
        works.add(workOf(task, mark));
        creating += workOf(task, mark) < 0.0 ? 1 : 0;
    }
    return "W < 0 at " + std::to_string(creating) + " of " + counted(task.marks.size(), "mark") + "; W is from " +
           fewDigits(works.least, "pJ", 3) + " to " + fewDigits(works.most, "pJ", 3) + " there.";
}

/// Where the law creates energy; empty where no cell does.
std::string creationWarning(const std::vector<MapCell>& cells)
{
    const auto creates = [](const MapCell& cell) { return cell.done && cell.cycleWork < 0.0; };
    const auto creating = std::ranges::count_if(cells, creates);
    if (creating == 0) return {};
    return "W is negative in " + std::to_string(creating) + " of " + counted(cells.size(), "cell") + " of the map" +
           creatingLaw;
}

} // namespace

std::optional<double> workOfLaw(const BouncingMapTask& task, double x, double y)
{
    Case c = task.start;
    if (setFromNumber(c, task.x.keys, x) || setFromNumber(c, task.y.keys, y)) return {};
    return cycleWork(c);
}

StudyReport mapReport(const MarkedMapTask& task, const std::vector<MapCell>& cells)
{
    StudyReport report;
    report.charts.push_back(chartOf(task, cells));
    report.tables.push_back(tableOf(task, cells));
    if (!task.marks.empty()) report.tables.push_back(marksTable(task));
    if (std::string warning = creationWarning(cells); !warning.empty()) report.warnings.push_back(std::move(warning));
    const auto failed = std::ranges::find(
        cells, true, [](const MapCell& cell) { return cell.done && cell.runs(BouncingEnd::Failed) > 0; });
    if (!std::ranges::all_of(cells, &MapCell::done)) return report;
    if (std::ranges::all_of(cells, [](const MapCell& cell) { return cell.kind() == MapClass::Fails; })) {
        report.status = StudyStatus::Failed;
        report.message = "no cell of the map has a valid end: " + failed->problem;
        return report;
    }
    report.findings.push_back(findingOf(cells));
    if (!task.marks.empty()) report.findings.push_back(findingOfMarks(task));
    if (const std::size_t taking = countOf(cells).taking; taking > 0)
        report.warnings.push_back("In " + counted(taking, "cell") +
                                  " of the map the slider bounces at the end though W >= 0; a longer duration "
                                  "shows whether that bouncing decays.");
    if (task.start.model == ModelKind::Film)
        report.warnings.push_back("The film is linear about the static state of the case, in all cells and from all "
                                  "starts: a motion that is large against the spacing may end otherwise on the film "
                                  "itself.");
    if (failed != cells.end()) report.warnings.push_back("One run of the map or more failed: " + failed->problem + ".");
    return report;
}

} // namespace touchdown
