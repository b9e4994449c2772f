// SPDX-License-Identifier: GPL-3.0-or-later
//
// Units of length as instruments and people spell them.
//
//   m cm mm um nm pm       and UM, NM; the micro sign in Latin-1, in both forms of Unicode, as \mu or &micro;
//   A                      and the letter with its ring, angstrom, Angstroem
//   in, uin                inch, microinch
//   micrometres, microns   whole words in any case, singular or plural, also "meter" and "mikrometer"
//
// M, MM, Mm, mM, nM, Nm and other spellings that may be another unit are not read.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

/// The length in metres of one "um"; empty for other words.
std::optional<double> spelledLength(std::string_view unit);
/// "V", "px", "counts": a unit that is no length.
bool spellsOtherUnit(std::string_view word);
/// "um" for 1e-6; every length that is read has a symbol.
std::string lengthSymbol(double metres);

/// "10 um", "10,5 [um]": its number and its unit, which may be empty; nothing if it does not begin with a number.
struct NumberAndUnit {
    double number = 0.0;
    std::string unit;
};
std::optional<NumberAndUnit> numberAndUnit(std::string_view quantity);

/// Units of length of the columns [m]; empty where none are given.
using ColumnUnits = std::vector<double>;

/// The value of disk.surface.unit: "um, nm". Nothing if it holds another word.
std::optional<ColumnUnits> unitsOfKey(std::string_view text);
/// One unit for each of `columns`: one for all, one for each, or one for x and y and one for heights. Throws CmlError
/// where the counts do not fit.
ColumnUnits unitsOfKey(const ColumnUnits& key, std::size_t columns);

/// Micro signs to u, letters with rings to plain ones.
std::string withPlainLetters(std::string_view line);

} // namespace touchdown
