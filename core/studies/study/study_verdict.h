// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether what a study checks holds. A study that checks statements says so in the column "holds" of its first table,
// "yes" or "no" for each row; other studies have no verdict.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace touchdown {

struct StudyReport;

enum class StudyVerdict : std::uint8_t {
    None,        // nothing is checked, or it is a part of a study
    Holds,       // every row
    HoldsPartly, // some
    HoldsNot,    // no row, also where the study ended before its first row
};
inline std::string_view name(StudyVerdict verdict)
{
    constexpr std::array<std::string_view, 4> names{"none", "holds", "holds partly", "does not hold"};
    static_assert(names.size() == static_cast<std::size_t>(StudyVerdict::HoldsNot) + 1);
    return names[static_cast<std::size_t>(verdict)];
}

StudyVerdict verdictOf(const StudyReport& report);

} // namespace touchdown
