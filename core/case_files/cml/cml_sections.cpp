// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_sections.h"

#include <algorithm>
#include <cctype>

#include "core/formats/quotation.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

// No file that people work with comes near; a hostile one takes no memory to speak of.
constexpr std::size_t mostSections = 1000;
constexpr std::size_t mostHeadings = 20000;
constexpr std::size_t mostNumbers = 200000;

bool isStarLine(std::string_view line) { return trimmed(line, blanks).starts_with('*'); }

bool isComments(std::string_view name)
{
    const std::string lower = lowerCase(name);
    return lower.starts_with("comment");
}

/// Fills the lists of a section.
class ListReader {
public:
    explicit ListReader(CmlSection& section) : section_(section), text_(section.body, section.line) {}

    /// Returns how many numbers there are.
    std::size_t read(std::size_t headings, std::size_t numbers)
    {
        while (!text_.peekWord().empty()) {
            if (text_.nextIsNumber()) {
                if (section_.lists.empty()) section_.lists.push_back({"", section_.line, {}, "", 0});
                if (++numbers > mostNumbers) throw CmlError(text_.line(), "holds more numbers than any such file");
                section_.lists.back().numbers.push_back(text_.number("a number"));
            } else {
                readWords();
                if (section_.lists.size() + headings > mostHeadings)
                    throw CmlError(text_.line(), "holds more headings than any such file");
            }
        }
        return numbers;
    }

private:
    /// A heading, or a remark behind numbers.
    void readWords()
    {
        text_.skipBlanks();
        const std::string_view word = text_.peekWord();
        const bool remark = !section_.lists.empty() && lastLine() == text_.line();
        if (!section_.lists.empty() && section_.lists.back().after.empty()) {
            section_.lists.back().after = word;
            section_.lists.back().afterLine = text_.line();
        }
        const int line = text_.line();
        const std::string_view words = text_.takeLine();
        if (!remark) section_.lists.push_back({trimmed(words, " \t\f\v"), line, {}, "", 0});
    }
    int lastLine() const
    {
        const CmlList& list = section_.lists.back();
        return list.numbers.empty() ? 0 : list.numbers.back().line;
    }

    CmlSection& section_;
    CmlText text_;
};

} // namespace

CmlSections splitCmlSections(std::string_view text)
{
    CmlSections result;
    CmlText lines(text);
    if (lines.peekWord().empty()) throw CmlError(0, "is empty");
    const char* bodyBegin = nullptr;
    const auto endBody = [&](const char* end) {
        if (bodyBegin != nullptr)
            result.sections.back().body = std::string_view(bodyBegin, static_cast<std::size_t>(end - bodyBegin));
    };
    bool comments = false;
    std::string_view line;
    while (!lines.atEnd()) {
        const int number = lines.line();
        line = lines.takeLine();
        if (!trimmed(line, blanks).empty()) result.lastLine = number;
        if (comments || !isStarLine(line)) continue;
        endBody(line.data());
        if (result.sections.size() == mostSections) throw CmlError(number, "holds more sections than any such file");
        result.sections.push_back({std::string(trimmed(line, " \t*")), number, {}, {}});
        bodyBegin = line.data() + line.size();
        comments = isComments(result.sections.back().name);
    }
    endBody(line.data() + line.size());

    std::size_t numbers = 0;
    std::size_t headings = 0;
    for (CmlSection& section : result.sections) {
        if (isComments(section.name)) continue;
        numbers = ListReader(section).read(headings, numbers);
        headings += section.lists.size();
    }
    return result;
}

} // namespace touchdown
