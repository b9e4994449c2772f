// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines with equal counts of numbers, and the text around them.
//
// Numbers are separated by semicolons, commas or blanks and tabs, each perhaps in quotation marks. A comma is a decimal
// comma where blanks, tabs or semicolons separate the numbers and no number has a point: "2,7000<tab>3,2740",
// "0,25;2,5". The minus sign of typography, U+2212, is a minus. What can be read in two ways is refused: "1,5,2,5",
// "1,234;2,500".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

/// A comment or a heading, as it stands in the file.
struct HeadingLine {
    std::string text;
    int line = 0;
    bool comment = false;
};

/// A comment or an empty line after the first line of numbers.
struct TableBreak {
    std::size_t row = 0; // of the table, which follows
    HeadingLine line;    // without text: empty lines
};

struct MapTable {
    std::size_t columns = 0;
    bool indexed = false; // a column before them was taken out
    char separator = ' '; // of the numbers; a blank: blanks and tabs
    std::vector<double> numbers;
    std::vector<int> lines;       // of the file, one for each row
    std::vector<double> shortRow; // a last line with other than `columns` numbers
    int shortLine = 0;
    std::vector<HeadingLine> headings; // before the first line of numbers
    std::vector<TableBreak> breaks;

    std::size_t rows() const { return lines.size(); }
    double at(std::size_t row, std::size_t column) const { return numbers[row * columns + column]; }
};

/// Throws CmlError, a sentence with its line, where the text is no table.
MapTable readMapTable(std::string_view text);
void refuseShortRow(const MapTable& table);

/// "1,234", which may be a decimal or a thousand and more; not "0,234" and "1,23".
bool mayCountThousands(std::string_view number);

} // namespace touchdown
