// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <variant>

#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/numerics/moments.h"

namespace touchdown {

SweepPoints::SweepPoints(const SweepTask& task, const ItemRows& rows) : task_(task), rows_(rows)
{
    for (std::size_t d = 0; d < task.axes.size(); ++d)
        if (!task.axes[d].average) axes_.push_back(d);
    std::map<std::vector<double>, std::size_t> places;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::vector<SweepValue> at;
        std::vector<double> numbers;
        const std::vector<SweepValue> values = task.valuesOf(i);
        for (const std::size_t d : axes_) {
            at.push_back(values[d]);
            numbers.push_back(values[d].number);
        }
        std::size_t place = points_.size();
        if (averages()) place = places.emplace(std::move(numbers), place).first->second;
        if (place == points_.size()) points_.push_back({std::move(at)});
        ++points_[place].items;
        if (rows[i]) points_[place].rows.push_back(&*rows[i]);
    }
}

std::vector<std::size_t> SweepPoints::drawn() const
{
    std::vector<std::size_t> list;
    for (std::size_t r = 0; r < readings(); ++r)
        if (!reading(r).isText && !reading(r).isError) list.push_back(r);
    return list;
}

std::vector<double> SweepPoints::numbers(const SweepPoint& point, std::size_t reading) const
{
    std::vector<double> list;
    for (const ItemRow* row : point.rows)
        if (const double* value = std::get_if<double>(&(*row)[reading])) list.push_back(*value);
    return list;
}

StudyValue SweepPoints::valueOf(const SweepPoint& point, std::size_t reading) const
{
    if (task_.readings[reading].isText) {
        std::map<std::string, std::size_t> counts;
        for (const ItemRow* row : point.rows)
            if (const auto* text = std::get_if<std::string>(&(*row)[reading])) ++counts[*text];
        if (counts.empty()) return {};
        return std::ranges::max_element(counts, {}, [](const auto& each) { return each.second; })->first;
    }
    const std::vector<double> list = numbers(point, reading);
    if (list.empty()) return {};
    return list.size() == 1 ? list.front() : momentsOf(list).mean;
}

double SweepPoints::numberOf(const SweepPoint& point, std::size_t reading) const
{
    const StudyValue value = valueOf(point, reading);
    const double* number = std::get_if<double>(&value);
    return number == nullptr ? std::numeric_limits<double>::quiet_NaN() : *number;
}

std::string SweepPoints::textOf(const SweepPoint& point, std::size_t reading) const
{
    const StudyValue value = valueOf(point, reading);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    const double* number = std::get_if<double>(&value);
    return number == nullptr ? "no value" : fewDigits(*number, task_.readings[reading].column().displayUnit, 4);
}

std::string SweepPoints::nameOf(const SweepPoint& point) const
{
    std::vector<std::string> words;
    for (std::size_t k = 0; k < axes(); ++k) words.push_back(axis(k).text.label + " " + axis(k).nameOf(point.at[k]));
    return joined(words);
}

const std::string& SweepPoints::problemOf(const ItemRow& row) const
{
    static const std::string none;
    const auto* text = std::get_if<std::string>(&row.back());
    return text == nullptr ? none : *text;
}

std::string SweepPoints::firstProblem(const SweepPoint& point) const
{
    for (const ItemRow* row : point.rows)
        if (!problemOf(*row).empty()) return problemOf(*row);
    return {};
}

ChartAxis SweepPoints::chartAxis(const SweepAxis& axis) const
{
    return {axis.text.label, axis.isNumber ? axis.text.unit : "", axis.isNumber ? axis.text.displayUnit : "",
            axis.logarithmic};
}

ChartAxis SweepPoints::chartAxis(const Reading& reading) const
{
    const StudyColumn column = reading.column();
    return {column.longName + (averages() ? ", mean" : ""), column.unit, column.displayUnit};
}

} // namespace touchdown
