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

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

/// The length in metres of one "um"; empty for other words.
std::optional<double> spelledLength(std::string_view unit);
/// "10 um", "10,5 [um]": its number and its unit, which may be empty; nothing if it does not begin with a number.
struct NumberAndUnit {
    double number = 0.0;
    std::string unit;
};
std::optional<NumberAndUnit> numberAndUnit(std::string_view quantity);

/// A word that stands in the place of a unit.
struct UnitMention {
    std::string text;
    std::optional<double> metres; // empty: no length, or not clearly one
};

/// The units of a heading: "x [um]  h (nm)", "x in um, h in nm", "x_um h_nm", "x/um", "um;nm". A number before the unit
/// makes it a value, which is no mention.
std::vector<UnitMention> unitMentions(std::string_view line);

} // namespace touchdown
