// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_parameters.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>

#include "core/case/parameters.h"
#include "core/formats/decimal.h"
#include "core/formats/quotation.h"
#include "core/formats/units.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

const Parameter& parameterOf(std::string_view key)
{
    const Parameter* parameter = findParameter(key);
    assert(parameter != nullptr && "the readers of CML files name parameters that exist");
    return *parameter;
}

/// In SI. The file's unit is one of the program's own, so that only the number can be wrong.
double inSi(const CmlNumber& number, const Parameter& parameter, std::string_view unit)
{
    if (unit.empty()) return number.value;
    // Loads are shown in grams of force: 0.8e-3 kg has to be 0.8 gf to the last digit.
    const std::string quantity =
        unit == "kgf" ? decimalText(number.value, 3) + " gf" : *plainDecimal(number.text) + ' ' + std::string(unit);
    const auto value = parseQuantity(quantity, parameter.unit);
    if (const auto* problem = std::get_if<UnitProblem>(&value)) throw CmlError(number.line, problem->message);
    return std::get<double>(value);
}

std::string titleOf(const CmlSection& section)
{
    return section.name.empty() ? "a section without a name" : section.name;
}

void readSection(const CmlSection& section, const CmlSectionReader& reader, CmlParameters& parameters)
{
    CmlPart part(section, parameters);
    try {
        reader.read(part);
    } catch (const CmlError& error) {
        parameters.addProblem(error.line(), titleOf(section) + ": " + error.what());
    }
    part.finish();
}

} // namespace

void CmlParameters::setSurface(const CmlRails& rails)
{
    value_.slider.length = rails.length;
    value_.slider.width = rails.width;
    value_.slider.thickness = rails.thickness;
    value_.surface = rails.surface;
    for (const auto& [key, line] : rails.lines) remember(key, line);
    const auto rememberAll = [&](const std::string& key, const std::vector<int>& lines) {
        for (std::size_t i = 0; i < lines.size(); ++i) remember(key + '[' + std::to_string(i + 1) + ']', lines[i]);
    };
    rememberAll("abs.rail", rails.railLines);
    rememberAll("abs.wall", rails.wallLines);
}

void CmlParameters::set(std::string_view key, const CmlNumber& number, std::string_view unit)
{
    setNumber(key, inSi(number, parameterOf(key), unit), number.line);
}

void CmlParameters::setNumber(std::string_view key, double value, int line)
{
    remember(key, line);
    if (auto problem = setFromNumber(value_, parameterOf(key), value))
        problems.push_back({file_, line, std::string(key), std::move(*problem)});
}

void CmlParameters::setList(std::string_view key, std::span<const CmlNumber> numbers, std::string_view unit)
{
    const Parameter& parameter = parameterOf(key);
    std::vector<double> values;
    for (const CmlNumber& number : numbers) values.push_back(inSi(number, parameter, unit));
    setNumbers(key, values, numbers.empty() ? 0 : numbers.front().line);
}

void CmlParameters::setNumbers(std::string_view key, const std::vector<double>& values, int line)
{
    remember(key, line);
    if (auto problem = setFromNumbers(value_, parameterOf(key), values))
        problems.push_back({file_, line, std::string(key), std::move(*problem)});
}

void CmlParameters::choose(std::string_view key, std::string_view name, int line)
{
    remember(key, line);
    if (auto problem = setFromText(value_, parameterOf(key), name))
        problems.push_back({file_, line, std::string(key), std::move(*problem)});
}

int CmlParameters::lineOf(std::string_view key) const
{
    const auto place = places_.find(std::string(key));
    return place == places_.end() ? 0 : place->second.line;
}

void CmlParameters::checkCombinations()
{
    for (const CaseProblem& problem : touchdown::checkCombinations(value_)) {
        const auto place = places_.find(problem.key);
        const InputProblem at = place != places_.end() ? place->second : InputProblem{file_, 0, "", ""};
        problems.push_back(problem.in(at.file, at.line));
    }
}

std::string CmlPart::name() const { return lowerCase(section_.name); }

std::span<const CmlNumber> CmlPart::list(std::size_t list) const
{
    if (list >= section_.lists.size()) return {};
    return section_.lists[list].numbers;
}

const CmlNumber& CmlPart::number(std::size_t list, std::size_t index, std::string_view what) const
{
    if (list >= section_.lists.size())
        throw CmlError(section_.line, "the section ends where " + std::string(what) + " is needed");
    const CmlList& numbers = section_.lists[list];
    if (index < numbers.numbers.size()) return numbers.numbers[index];
    if (numbers.after.empty())
        throw CmlError(numbers.numbers.empty() ? numbers.line : numbers.numbers.back().line,
                       "the section ends where " + std::string(what) + " is needed");
    throw CmlError(numbers.afterLine, std::string(what) + " must be a number, not " + inQuotes(numbers.after));
}

int CmlPart::whole(std::size_t list, std::size_t index, std::string_view what, int lowest, int highest) const
{
    return wholeCmlNumber(number(list, index, what), what, lowest, highest);
}

std::vector<CmlNumber> CmlPart::sequence(std::size_t count) const
{
    std::vector<CmlNumber> all;
    int line = section_.line;
    std::string stop;
    for (const CmlList& each : section_.lists) {
        all.insert(all.end(), each.numbers.begin(), each.numbers.end());
        if (each.numbers.empty()) continue;
        if (stop.empty()) line = each.numbers.back().line;
        // A word behind a number on the same line may name the next number.
        if (stop.empty() && each.afterLine == line) stop = "; " + inQuotes(each.after) + " is none";
    }
    if (all.size() >= count) return all;
    throw CmlError(line, "needs " + std::to_string(count) + " numbers, but has " + std::to_string(all.size()) + stop);
}

std::span<const CmlNumber> CmlPart::numbers(std::size_t list, std::size_t count, std::string_view what) const
{
    if (count > 0) number(list, count - 1, what);
    return this->list(list).first(count);
}

void CmlPart::set(std::string_view key, std::size_t list, std::size_t index, std::string_view what,
                  std::string_view unit)
{
    parameters_.set(key, number(list, index, what), unit);
}

std::vector<CmlNamedNumber> CmlPart::namedNumbers() const
{
    std::vector<CmlNamedNumber> result;
    for (const CmlList& each : section_.lists) {
        CmlText words(each.heading, each.line);
        for (const CmlNumber& number : each.numbers) {
            words.skipBlanks();
            result.push_back({lowerCase(words.takeWord()), number});
        }
    }
    return result;
}

void CmlPart::finish()
{
    if (!leftOut_.empty()) parameters_.addWarning(section_.line, titleOf(section_) + ": not modelled: " + leftOut_);
}

void readCmlSections(std::string_view text, std::span<const CmlSectionReader> readers, CmlParameters& parameters)
{
    CmlSections all;
    try {
        all = splitCmlSections(text);
    } catch (const CmlError& error) {
        parameters.addProblem(error.line(), error.what());
        return;
    }
    std::vector<bool> found(readers.size());
    for (const CmlSection& section : all.sections) {
        const std::string name = lowerCase(section.name);
        const auto reader = std::ranges::find_if(
            readers, [&](const CmlSectionReader& each) { return name.find(each.name) != std::string::npos; });
        if (name.starts_with("comment")) {
            parameters.comments.append(section.body);
        } else if (reader != readers.end()) {
            const auto index = static_cast<std::size_t>(reader - readers.begin());
            if (found[index] && !reader->name.empty())
                parameters.addWarning(section.line, titleOf(section) + ": is there twice; the last one counts");
            found[index] = true;
            readSection(section, *reader, parameters);
        } else if (!section.lists.empty()) {
            parameters.addWarning(section.line, titleOf(section) + ": an unknown section, which is not used");
        }
    }
    for (std::size_t i = 0; i < readers.size(); ++i)
        if (readers[i].needed && !found[i])
            parameters.addProblem(all.lastLine, "the file ends without the section " + inQuotes(readers[i].title));
}

void setCmlNodes(CmlPart& part, const CmlNumber& nx, const CmlNumber& ny, int extra)
{
    constexpr double most = 1e6;
    const Parameter& parameter = parameterOf("film.nodes");
    std::vector<double> nodes;
    for (const CmlNumber& n : {nx, ny}) {
        if (!(n.value >= 2.0 && n.value <= most) || n.value != std::trunc(n.value))
            throw CmlError(n.line, "the number of grid lines must be a whole number from 2 to 1000000, not " +
                                       inQuotes(n.text));
        const double fitting =
            parameter.minimum + parameter.stride * std::round((n.value - extra - parameter.minimum) / parameter.stride);
        nodes.push_back(std::clamp(fitting, parameter.minimum, parameter.maximum));
    }
    if (nodes[0] != nx.value - extra || nodes[1] != ny.value - extra)
        part.leaveOut(std::string(nx.text) + " x " + std::string(ny.text) + " grid lines; " + formatNumber(nodes[0]) +
                      " x " + formatNumber(nodes[1]) + " are taken");
    part.parameters().setNumbers("film.nodes", nodes, nx.line);
}

} // namespace touchdown
