// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a column or a channel of a surface file holds, by the words of its name in English, German, French or Spanish.
//
//   x       "x", "distance", "track position"
//   y       "y", "across"
//   height  "z", "h", "surface height", "elevation"; counted downwards: "depth", "-z", "(-) z", "inverted z"
//   none    "gap", "log10 z", "z^2", "std of z", "slope", "PSD", "counts" and other quantities that are no height, also
//           where another word stands beside: "height error"
//
// Words of no meaning of their own, as "raw" or "sample", and single letters may stand for any column.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

inline constexpr std::string_view decimalDigits = "0123456789";

enum class WordMeaning : std::uint8_t {
    X,
    Y,
    Height,
    Depth,    // counts downwards, as Below, once
    Below,    //
    Turns,    // changes the sign each time
    Function, // of heights: none of Function to Quantity is a height
    Scaling,  // "multiplied"
    Factor,   //
    Quantity, //
    Data,     // "value", "axis": may be anything, as Neutral
    Neutral,  //
    Unknown
};

struct NameWord {
    std::string text; // as it is written
    WordMeaning meaning = WordMeaning::Unknown;
    std::size_t at = 0; // in the whole text [byte]
};
/// The runs of letters of a text; those that are written as one, "logz", "Profilhoehe", are divided where both
/// parts are known.
std::vector<NameWord> wordsWithMeaning(std::string_view text);

enum class ColumnRole : std::uint8_t { Unknown, Any, X, Y, Height, None };

struct ColumnName {
    ColumnRole role = ColumnRole::Unknown;
    bool known = true;   // each of its words
    bool turned = false; // counts downwards
    std::string word;    // that says what the column holds, where it is no place and no height
};

ColumnName columnName(std::string_view name);

} // namespace touchdown
