// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text of a CML file, the established slider program's format: numbers as Fortran reads and writes them, in lists
// that blanks, commas or new lines separate, between lines that count by their number alone. Windows line ends, Latin-1
// bytes, trailing blanks and a missing last line end are all read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace touchdown {

/// Largest CML file, or member of an archive, that is read [byte].
inline constexpr std::uintmax_t maximumCmlFileSize = 16u << 20;

/// Why a CML file cannot be read any further; its readers turn it into an InputProblem.
class CmlError : public std::runtime_error {
public:
    CmlError(int line, const std::string& sentence) : std::runtime_error(sentence), line_(line) {}
    int line() const { return line_; }

private:
    int line_;
};

/// A number with its place. `text` is a part of the file's text and lives as long.
struct CmlNumber {
    double value = 0.0;
    std::string_view text{};
    int line = 0;
};

/// "1.5", ".5", "+1.0E-007", "1.0D-7", "1.0-7" as other programs write them, "1.0e-7"; nothing for words, "NaN" and
/// "inf".
std::optional<std::string> plainDecimal(std::string_view text);
/// Its value; empty also for a number beyond the range of doubles.
std::optional<double> readCmlNumber(std::string_view text);

/// The number as an integer. Throws CmlError, which calls it `what`, unless it is whole and in the range.
int wholeCmlNumber(const CmlNumber& number, std::string_view what, int lowest, int highest);

/// Reads a text once, from front to back. Throws CmlError if the text does not hold the requested item.
class CmlText {
public:
    /// Refuses bytes that no text holds. Begins at `line` of the file.
    explicit CmlText(std::string_view text, int line = 1);

    /// The rest of this line, without its end; goes to the next one. At the end of the text it is empty.
    std::string_view takeLine();
    bool atEnd() const { return at_ == text_.size(); }
    /// Goes to the next word, on this line or a later one.
    void skipBlanks() { moveTo(wordBegin()); }
    int line() const { return line_; }

    /// The next word on this line or a later one; empty at the end of the text.
    std::string_view peekWord();
    std::string_view takeWord();
    /// True when the next word is on this line.
    bool onThisLine();
    /// True when the next word, on this line or a later one, is a number.
    bool nextIsNumber();

    /// The next number, on this line or a later one. `what` names it in the error.
    CmlNumber number(std::string_view what);
    /// The next number, which must be whole and in the range.
    int whole(std::string_view what, int lowest, int highest);

    /// Skips a remark, from a word that is no number to the end of the line.
    void skipRemark();
    /// Ends a list: skips the rest of this line. True if the rest began with a number, which the list did not read.
    bool endList();

private:
    int lastLine() const;          // that holds a word
    std::size_t wordBegin() const; // of the next word
    std::size_t wordEnd(std::size_t begin) const;
    void moveTo(std::size_t at);

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

} // namespace touchdown
