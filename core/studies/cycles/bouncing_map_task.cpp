// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/bouncing_map_task.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/formats/quotation.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/studies/cycles/cycle_keys.h"
#include "core/studies/cycles/cycles_report.h"
#include "core/studies/study/study_head.h"
#include "core/studies/study/study_reader.h"
#include "core/work/parallel.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

constexpr int fewestPoints = 2, mostPoints = 100, standardPoints = 20; // of an axis
constexpr int mostStarts = 8;
const std::vector<std::string> scales{"linear", "logarithmic"};
constexpr int halvingsOfPlace = 60;
constexpr double betweenMaps = 0.25; // that grow, while the map is made [s]
constexpr const char* markedByWork =
    " A case with another contact law, or with a film, is marked at the same W; the map shows what its own slider does "
    "there.";
constexpr std::array severities{0, 1, 2, 3, 1, 3}; // by MapClass

std::optional<double> readEnd(StudyReader& reader, const std::string& name, const Parameter& keys, bool logarithmic)
{
    if (!reader.has(name)) {
        reader.add(name, "is missing: a map has no range of its own");
        return {};
    }
    const std::optional<double> value = readValue(reader, name, keys);
    if (!value) return {};
    Case changed = reader.start();
    if (const auto problem = setFromNumber(changed, keys, *value)) {
        reader.add(name, *problem);
        return {};
    }
    if (logarithmic && !(*value > 0.0)) {
        reader.add(name, "must be greater than 0 on a logarithmic scale");
        return {};
    }
    return value;
}

std::optional<BouncingMapAxis> readAxis(StudyReader& reader, const std::string& name)
{
    BouncingMapAxis axis;
    const std::optional<std::string> text = reader.text(name, neededKeys);
    axis.logarithmic = reader.choice(name + "_scale") == "logarithmic";
    const int points = reader.integer(name + "_points");
    if (!text) {
        if (!reader.has(name)) reader.add(name, std::string("is missing; ") + neededKeys);
        reader.has(name + "_from"); // known, though nothing can be said about it
        reader.has(name + "_to");
        return {};
    }
    const std::optional<Parameter> keys = readKeys(reader, name, *text, axis.text);
    if (!keys) return {};
    axis.keys = *keys;
    const std::optional<double> from = readEnd(reader, name + "_from", *keys, axis.logarithmic),
                                to = readEnd(reader, name + "_to", *keys, axis.logarithmic);
    if (!from || !to) return {};
    if (*from == *to) {
        reader.add(name + "_to", "is the same as " + leafOf(name) + "_from: there is no range");
        return {};
    }
    axis.values = {std::min(*from, *to), std::max(*from, *to)};
    std::vector<double> values;
    for (int i = 0; i < points; ++i) values.push_back(axis.at(double(i) / (points - 1)));
    axis.values = std::move(values);
    return axis;
}

/// W of the map's law at a point [J].
std::optional<double> workOfLaw(const BouncingMapTask& task, double x, double y)
{
    Case c = task.start;
    if (setFromNumber(c, task.x.keys, x) || setFromNumber(c, task.y.keys, y)) return {};
    return cycleWork(c);
}

/// The x at which the law of the map has this W, by bisection; W changes with x in one direction.
std::optional<double> placeOfWork(const BouncingMapTask& task, double y, double work)
{
    double low = task.x.values.front(), high = task.x.values.back();
    const std::optional<double> first = workOfLaw(task, low, y), last = workOfLaw(task, high, y);
    if (!first || !last || work < std::min(*first, *last) || work > std::max(*first, *last) || *first == *last)
        return {};
    for (int k = 0; k < halvingsOfPlace; ++k) {
        const double middle = 0.5 * (low + high);
        const std::optional<double> there = workOfLaw(task, middle, y);
        if (!there) return {};
        ((*there < work) == (*first < *last) ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

std::optional<double> readPlace(StudyReader& reader, const std::string& table, const char* leaf,
                                const BouncingMapAxis& axis)
{
    if (!reader.has(table + leaf)) reader.add(table, std::string("has no ") + (leaf + 1));
    return reader.number(table + leaf, axis.text.unit, axis.text.displayUnit, axis.values.front(), axis.values.back());
}

/// The place along x that the W of a case gives.
std::optional<double> readPlaceOfCase(StudyReader& reader, const std::string& key, const BouncingMapTask& task,
                                      double y)
{
    const std::string name = reader.text(key).value_or("");
    const CaseDocument document = openCaseBeside(reader, name);
    const std::optional<double> work = document.valid() ? cycleWork(document.value) : std::nullopt;
    if (!work) {
        reader.add(key, inQuotes(name) + " is no valid case with contact = \"ono-yamane\"");
        return {};
    }
    const std::optional<double> x = placeOfWork(task, y, *work);
    if (!x)
        reader.add(key, inQuotes(name) + " has W = " + fewDigits(*work, "pJ", 3) +
                            ", which the law of the map has nowhere between x_from and x_to");
    return x;
}

/// [[mark]]; within the map.
std::vector<MapMark> readMarks(StudyReader& reader, MarkedMapTask& task)
{
    std::vector<MapMark> marks;
    for (const std::string& table : reader.tables("mark")) {
        MapMark mark{reader.text(table + ".name").value_or("")};
        if (mark.name.empty()) reader.add(table, "has no name");
        const std::string byCase = table + ".work_of";
        mark.y = readPlace(reader, table, ".y", task.y).value_or(task.y.values.front());
        if (reader.has(byCase) && reader.has(table + ".x")) {
            reader.add(byCase, "stands beside x: one of them gives the place");
        } else if (reader.has(byCase)) {
            mark.x = readPlaceOfCase(reader, byCase, task, mark.y).value_or(0.0);
            task.marksByWork = true;
        } else {
            mark.x = readPlace(reader, table, ".x", task.x).value_or(0.0);
        }
        marks.push_back(std::move(mark));
    }
    return marks;
}

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

std::optional<MarkedMapTask> readBouncingMap(StudyReader& reader, int starts, double duration)
{
    MarkedMapTask task;
    task.start = reader.start();
    task.search.duration = duration;
    task.starts = reader.integer("map.starts", 1, mostStarts).value_or(starts);
    const std::optional<BouncingMapAxis> x = readAxis(reader, "map.x"), y = readAxis(reader, "map.y");
    if (!x || !y) return {};
    if (x->keys.key == y->keys.key) {
        reader.add("map.y", inQuotes(y->keys.key) + " is the key of x, too");
        return {};
    }
    task.x = *x;
    task.y = *y;
    task.marks = readMarks(reader, task);
    return task;
}

std::vector<StudyKey> bouncingMapKeys(const Case& c, double largestMeniscusForce)
{
    const Parameter &force = *findParameter("ono_yamane.meniscus_force"),
                    &height = *findParameter("ono_yamane.take_off");
    std::vector<StudyKey> keys{tableKey(
        "map", "A map over two values: does the slider fly, is it caught, or does it bounce for ever? With this "
               "table and without parameter, from, to, values and crossings only the map is made.")};
    const auto addAxis = [&](const std::string& name, const Parameter& parameter, double from, double to) {
        const auto endKey = [&](const char* end, double value, const char* help) {
            return numberKey(name + end, value, parameter.unit, parameter.displayUnit, parameter.minimum,
                             parameter.maximum, help);
        };
        keys.push_back(textKey(name, parameter.key, neededKeys, "what changes along the axis"));
        keys.push_back(endKey("_from", from, "one end of the axis"));
        keys.push_back(endKey("_to", to, "the other end"));
        keys.push_back(integerKey(name + "_points", standardPoints, fewestPoints, mostPoints, "both ends included"));
        keys.push_back(choiceKey(name + "_scale", scales.front(), scales, "distances of the points"));
    };
    addAxis("map.x", force, 0.0, largestMeniscusForce);
    const double takeOff = characteristic(c).value_or(OnoYamane()).takeOff;
    addAxis("map.y", height, takeOff, 2.0 * takeOff);
    keys.push_back(integerKey("map.starts", 3, 1, mostStarts, "of each cell: as the case says, then lower ones"));
    for (StudyKey& key : keys) key = onlyOffered(std::move(key));
    for (const char* leaf : {"x", "y"})
        keys.push_back(inList(textKey(std::string("mark.") + leaf, {}, "", "its place on the map, within both axes")));
    keys.push_back(inList(textKey("mark.work_of", {}, "a case in quotation marks",
                                  "instead of x: a case; the mark stands where the law of the map has the W of its "
                                  "law")));
    keys.push_back(inList(textKey("mark.name", {}, "", "of a point that is marked on the map; needs the table [map]")));
    return keys;
}

void addBouncingMap(const MarkedMapTask& task, int jobs, const StudyCallback& callback, StudyReport& report)
{
    const std::size_t columns = task.x.values.size(), count = columns * task.y.values.size();
    std::vector<MapCell> cells(count);
    std::vector<std::atomic<bool>> written(count); // a cell may be read from then on
    const std::vector<std::size_t> order = scatteredOrder(count);
    const auto judge = [&](std::size_t k, const GoOn& goOn) {
        const std::size_t i = order[k];
        cells[i] = judgeCell(task, task.x.values[i % columns], task.y.values[i / columns], goOn);
        written[i].store(true, std::memory_order_release);
    };
    std::size_t shown = 0;
    double shownAt = wallClock();
    const bool whole = runParallel(count, jobs, judge, [&](std::size_t done) {
        if (!callback) return true;
        const std::string doing = "cell " + std::to_string(std::min(done + 1, count)) + " of " + std::to_string(count);
        const double share = double(done) / double(count);
        if (done == shown || wallClock() - shownAt < betweenMaps) return callback({share, doing, nullptr});
        shown = done;
        shownAt = wallClock();
        std::vector<MapCell> seen(count);
        for (std::size_t i = 0; i < count; ++i)
            if (written[i].load(std::memory_order_acquire)) seen[i] = cells[i];
        StudyReport soFar = report;
        soFar.charts.push_back(chartOf(task, seen));
        return callback({share, doing, &soFar});
    });
    report.charts.push_back(chartOf(task, cells));
    report.tables.push_back(tableOf(task, cells));
    if (!task.marks.empty()) report.tables.push_back(marksTable(task));
    if (std::string warning = creationWarning(cells); !warning.empty()) report.warnings.push_back(std::move(warning));
    const auto failed = std::ranges::find(
        cells, true, [](const MapCell& cell) { return cell.done && cell.runs(BouncingEnd::Failed) > 0; });
    if (!whole) {
        report.status = StudyStatus::Cancelled;
        report.message = "stopped before all cells of the map were run";
    } else if (std::ranges::all_of(cells, [](const MapCell& cell) { return cell.kind() == MapClass::Fails; })) {
        report.status = StudyStatus::Failed;
        report.message = "no cell of the map has a valid end: " + failed->problem;
    } else {
        report.findings.insert(report.findings.begin(), findingOf(cells));
        if (!task.marks.empty()) report.findings.insert(report.findings.begin() + 1, findingOfMarks(task));
        if (const std::size_t taking = countOf(cells).taking; taking > 0)
            report.warnings.push_back("In " + counted(taking, "cell") +
                                      " of the map the slider bounces at the end though W >= 0; a longer duration "
                                      "shows whether that bouncing decays.");
        if (failed != cells.end())
            report.warnings.push_back("One run of the map or more failed: " + failed->problem + ".");
    }
}

} // namespace touchdown
