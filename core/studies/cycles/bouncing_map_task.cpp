// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/bouncing_map_task.h"

#include <algorithm>
#include <cmath>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/formats/decimal.h"
#include "core/formats/quotation.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/studies/cycles/bouncing_map_report.h"
#include "core/studies/cycles/cycle_keys.h"
#include "core/studies/study/study_head.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

constexpr int fewestPoints = 2, mostPoints = 100, standardPoints = 20; // of an axis
constexpr int mostStarts = 8;
const std::vector<std::string> scales{"linear", "logarithmic"};
constexpr int halvingsOfPlace = 60;

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
    for (const double value : axis.values)
        if (!keepsFilm(reader, name, *keys, value)) return {};
    return axis;
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

ItemRow rowOf(const MapCell& cell)
{
    ItemRow row{cell.cycleWork};
    for (const int runs : cell.ends) row.emplace_back(double(runs));
    row.emplace_back(cell.problem);
    return row;
}

/// Not done without a row.
MapCell cellOf(double x, double y, const std::optional<ItemRow>& row)
{
    MapCell cell{.x = x, .y = y};
    if (!row) return cell;
    const auto number = [&](std::size_t i) {
        const double* value = std::get_if<double>(&(*row)[i]);
        return value == nullptr ? 0.0 : *value;
    };
    cell.done = true;
    cell.cycleWork = number(0);
    for (std::size_t k = 0; k < bouncingEnds; ++k)
        cell.ends[k] = static_cast<int>(std::clamp(number(k + 1), 0.0, double(mostStarts)));
    if (const auto* problem = std::get_if<std::string>(&row->back())) cell.problem = *problem;
    return cell;
}

} // namespace

std::optional<MarkedMapTask> readBouncingMap(StudyReader& reader, int starts, double duration)
{
    MarkedMapTask task;
    task.start = reader.start();
    task.search.duration = duration;
    task.sliderOf = slidersLike(task.start);
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

ItemStudy bouncingMapItems(const MarkedMapTask& task)
{
    const std::size_t columns = task.x.values.size();
    const auto placeOf = [task, columns](std::size_t i) {
        return std::pair(task.x.values[i % columns], task.y.values[i / columns]);
    };
    const std::string common = "map " + std::to_string(task.starts) + " " + decimalText(task.search.duration) + " " +
                               task.x.keys.key + " " + task.y.keys.key + "\n" + formatCase(task.start);
    return {
        .count = columns * task.y.values.size(),
        .width = bouncingEnds + 2,
        .content =
            [placeOf, common](std::size_t i) {
                const auto [x, y] = placeOf(i);
                return decimalText(x) + " " + decimalText(y) + " " + common;
            },
        .solve = [task, placeOf](std::size_t i, ItemCall& call) -> std::optional<ItemRow> {
            const auto [x, y] = placeOf(i);
            const MapCell cell = judgeCell(task, x, y, call.goOn);
            return cell.done ? std::optional(rowOf(cell)) : std::nullopt;
        },
        .report =
            [task, placeOf](const ItemRows& rows) {
                std::vector<MapCell> cells;
                for (std::size_t i = 0; i < rows.size(); ++i) {
                    const auto [x, y] = placeOf(i);
                    cells.push_back(cellOf(x, y, rows[i]));
                }
                return mapReport(task, cells);
            },
    };
}

} // namespace touchdown
