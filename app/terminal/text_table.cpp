// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/text_table.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

namespace touchdown {

namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t gap = 2;          // between columns
constexpr std::size_t shortestCut = 24; // of a text; shorter ones are not understood

bool continuesCharacter(char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; } // of UTF-8

/// Characters, not bytes: "µ" is as wide as "u".
std::size_t textWidth(const std::string& text)
{
    return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continuesCharacter));
}

/// The heading in lines no longer than `most` or than its longest part.
Lines brokenHeading(const std::string& heading, std::size_t most)
{
    Lines lines;
    bool open = false;
    for (std::size_t at = 0; at < heading.size();) {
        const std::size_t end = std::min(heading.find_first_of("_ ", at), heading.size() - 1) + 1;
        const std::string part = heading.substr(at, end - at);
        const std::size_t bare = textWidth(part) - (part.ends_with(' ') ? 1 : 0);
        if (open && textWidth(lines.back()) + bare <= most)
            lines.back() += part;
        else
            lines.push_back(part);
        open = true;
        at = end;
    }
    for (std::string& line : lines) line.erase(line.find_last_not_of(' ') + 1);
    return lines;
}

std::size_t widest(const Lines& lines)
{
    std::size_t width = 0;
    for (const std::string& line : lines) width = std::max(width, textWidth(line));
    return width;
}

std::string cutTo(const std::string& text, std::size_t width)
{
    if (textWidth(text) <= width) return text;
    std::size_t bytes = 0;
    for (std::size_t taken = 0; taken + 1 < width; ++taken)
        for (++bytes; bytes < text.size() && continuesCharacter(text[bytes]);) ++bytes;
    const auto last = text.find_last_not_of(' ', bytes - 1);
    return text.substr(0, last + 1) + "…";
}

class Fitting {
public:
    Fitting(const std::vector<FittedColumn>& columns, const std::vector<Lines>& rows, std::size_t width)
        : columns_(columns), rows_(rows)
    {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            values_.push_back(0);
            for (const Lines& row : rows) values_[i] = std::max(values_[i], textWidth(row[i]));
        }
        kept_.resize(columns.size());
        std::iota(kept_.begin(), kept_.end(), std::size_t{0});
        if (widthWith(longest_) <= width) return;
        broken_ = true;
        for (std::size_t k = kept_.size(); k-- > 0 && widthWith(shortestCut) > width;)
            if (columns[kept_[k]].secondary) kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(k));
        while (kept_.size() > 1 && widthWith(shortestCut) > width) kept_.pop_back();
        longest_ = shortestCut;
        while (longest_ < width && widthWith(longest_ + 1) <= width) ++longest_;
    }

    FittedTable table() const
    {
        FittedTable result;
        std::vector<Lines> headings;
        std::size_t height = 0;
        for (const std::size_t i : kept_) {
            headings.push_back(broken_ ? brokenHeading(columns_[i].heading, room(i, longest_))
                                       : Lines{columns_[i].heading});
            height = std::max(height, headings.back().size());
        }
        std::vector<Lines> lines(height);
        std::vector<bool> left;
        for (std::size_t k = 0; k < kept_.size(); ++k) {
            headings[k].insert(headings[k].begin(), height - headings[k].size(), "");
            for (std::size_t line = 0; line < height; ++line) lines[line].push_back(headings[k][line]);
            left.push_back(columns_[kept_[k]].text);
        }
        for (const Lines& row : rows_) {
            Lines& line = lines.emplace_back();
            for (const std::size_t i : kept_) {
                line.push_back(columns_[i].text ? cutTo(row[i], longest_) : row[i]);
                result.cut = result.cut || line.back() != row[i];
            }
        }
        result.text = alignedTable(lines, left);
        for (std::size_t i = 0; i < columns_.size(); ++i)
            if (std::ranges::find(kept_, i) == kept_.end()) result.leftOut.push_back(columns_[i].heading);
        return result;
    }

private:
    /// Width of the values of a column when texts have at most `longest` characters.
    std::size_t room(std::size_t i, std::size_t longest) const
    {
        return columns_[i].text ? std::min(values_[i], longest) : values_[i];
    }

    std::size_t widthWith(std::size_t longest) const
    {
        std::size_t all = gap * (kept_.size() - 1);
        for (const std::size_t i : kept_) {
            const std::size_t its = room(i, longest);
            const std::string& heading = columns_[i].heading;
            all += std::max(its, broken_ ? widest(brokenHeading(heading, its)) : textWidth(heading));
        }
        return all;
    }

    const std::vector<FittedColumn>& columns_;
    const std::vector<Lines>& rows_;
    std::vector<std::size_t> values_; // the widest of each column
    std::vector<std::size_t> kept_;
    bool broken_ = false;                                           // headings
    std::size_t longest_ = std::numeric_limits<std::size_t>::max(); // text
};

} // namespace

std::string alignedTable(const std::vector<std::vector<std::string>>& rows, const std::vector<bool>& left)
{
    std::vector<std::size_t> widths;
    for (const Lines& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], textWidth(row[i]));
    }
    std::string text;
    for (const Lines& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string space(widths[i] - textWidth(row[i]), ' ');
            line += std::string(i == 0 ? 0 : gap, ' ');
            line += i < left.size() && left[i] ? row[i] + space : space + row[i];
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

FittedTable fittedTable(const std::vector<FittedColumn>& columns, const std::vector<std::vector<std::string>>& rows,
                        std::size_t width)
{
    return Fitting(columns, rows, width).table();
}

std::size_t outputWidth()
{
    constexpr std::size_t otherwise = 100, least = 20;
    if (const char* given = std::getenv("COLUMNS")) {
        std::size_t width = 0;
        const std::string_view text = given;
        if (std::from_chars(text.data(), text.data() + text.size(), width).ec == std::errc() && width > 0)
            return std::max(width, least);
    }
    winsize size{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        return std::max<std::size_t>(size.ws_col, least);
    return otherwise;
}

} // namespace touchdown
