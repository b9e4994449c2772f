// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of CML files put into a case by the keys of its parameters, so that ranges and units are checked as in a
// case file and every problem names its line.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/case/case_document.h"
#include "core/case_files/cml/cml_rail_file.h"
#include "core/case_files/cml/cml_sections.h"

namespace touchdown {

/// A case that CML files fill, with the problems and the warnings about values that are not modelled.
class CmlParameters {
public:
    /// `value` outlives this.
    explicit CmlParameters(Case& value) : value_(value) {}

    const Case& value() const { return value_; }
    /// The file of the following values.
    void beginFile(std::string file) { file_ = std::move(file); }
    const std::string& file() const { return file_; }

    /// The slider's size and its surface.
    void setSurface(const CmlRails& rails);
    /// Sets a parameter; `unit` is that of the file where it is not SI.
    void set(std::string_view key, const CmlNumber& number, std::string_view unit = {});
    void setNumber(std::string_view key, double value, int line);
    void setList(std::string_view key, std::span<const CmlNumber> numbers, std::string_view unit = {});
    void setNumbers(std::string_view key, const std::vector<double>& values, int line);
    /// By the name of a choice, or "true" and "false".
    void choose(std::string_view key, std::string_view name, int line);

    void addProblem(int line, std::string message) { problems.push_back({file_, line, "", std::move(message)}); }
    void addWarning(int line, std::string message) { warnings.push_back({file_, line, "", std::move(message)}); }
    bool wasSet(std::string_view key) const { return places_.contains(std::string(key)); }
    /// 0 for a key that no file set.
    int lineOf(std::string_view key) const;
    /// Adds values that contradict each other, at the line of the first of them.
    void checkCombinations();

    std::vector<InputProblem> problems;
    std::vector<InputProblem> warnings;
    std::string comments; // of the file, as they stand

private:
    void remember(std::string_view key, int line) { places_[std::string(key)] = {file_, line, "", ""}; }

    Case& value_;
    std::string file_;
    std::map<std::string, InputProblem> places_; // where each key was set
};

/// A number with the word above it, in lower case.
struct CmlNamedNumber {
    std::string name;
    CmlNumber number;
};

/// One section while it is read. Throws CmlError where a number is missing or wrong.
class CmlPart {
public:
    CmlPart(const CmlSection& section, CmlParameters& parameters) : section_(section), parameters_(parameters) {}

    CmlParameters& parameters() { return parameters_; }
    int line() const { return section_.line; }
    std::string name() const; // in lower case
    /// The numbers of a list, counted from 0; none if there is no such list.
    std::span<const CmlNumber> list(std::size_t list) const;
    bool has(std::size_t list, std::size_t index) const { return index < this->list(list).size(); }
    /// A number; `what` names it in the error.
    const CmlNumber& number(std::size_t list, std::size_t index, std::string_view what) const;
    int whole(std::size_t list, std::size_t index, std::string_view what, int lowest, int highest) const;
    /// All numbers of the section, `count` or more, across lines and headings.
    std::vector<CmlNumber> sequence(std::size_t count) const;
    /// The first `count` numbers of a list.
    std::span<const CmlNumber> numbers(std::size_t list, std::size_t count, std::string_view what) const;
    void set(std::string_view key, std::size_t list, std::size_t index, std::string_view what,
             std::string_view unit = {});
    /// All numbers, each with its word of the heading above.
    std::vector<CmlNamedNumber> namedNumbers() const;

    /// Notes a feature that is switched on but not modelled.
    void leaveOut(const std::string& what) { leftOut_ += (leftOut_.empty() ? "" : ", ") + what; }
    /// The one warning of the section.
    void finish();

private:
    const CmlSection& section_;
    CmlParameters& parameters_;
    std::string leftOut_;
};

/// The reader of one kind of section. `name` is a part of its title, in lower case; an empty one fits all.
struct CmlSectionReader {
    std::string_view name;
    std::string_view title; // as the established program writes it
    bool needed = false;
    void (*read)(CmlPart&) = nullptr;
};

/// Reads all sections of a text, each by the first reader whose name fits; unknown ones get a warning. Problems of a
/// section do not keep the others from being read.
void readCmlSections(std::string_view text, std::span<const CmlSectionReader> readers, CmlParameters& parameters);

/// Sets film.nodes to the nearest possible number of grid lines, with a warning if it differs; the established program
/// has `extra` additional lines.
void setCmlNodes(CmlPart& part, const CmlNumber& nx, const CmlNumber& ny, int extra);

} // namespace touchdown
