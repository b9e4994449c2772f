// SPDX-License-Identifier: GPL-3.0-or-later
//
// The statements that a study checks, read and checked: see core/studies/statements/statements.h.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/case/case.h"
#include "core/simulation/recording/quantity.h"
#include "core/studies/runs/ensemble.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;

/// Where a quantity is taken.
enum class Taken : std::uint8_t {
    End,
    Swing,
    Rms,
    Mean,
    Least,
    Greatest,
    Difference,
    Distance,
    Peak,
    Peaks,
    Likeness,
    Case
};
inline constexpr std::size_t takenCount = 12;
inline std::string_view name(Taken taken)
{
    constexpr std::array<std::string_view, takenCount> names{"end",   "swing",    "rms",        "mean",
                                                             "least", "greatest", "difference", "distance",
                                                             "peak",  "peaks",    "likeness",   "case"};
    return names[static_cast<std::size_t>(taken)];
}

struct Statement {
    std::string figure; // "Fig. 12 a"
    std::string quote;
    std::string remark{};    // why it does not hold, or what to know
    std::string candidate{}; // empty: the cases as they are
    std::string command{};   // "touchdown run fig12a"
    Case c{};

    /// How the run ends: one of these ends, one of these motions, and as `like` or otherwise; each where it is given.
    std::vector<std::string> ends{}, motions{};
    std::optional<bool> sameAsLike{};
    bool aboutEnd() const { return !ends.empty() || !motions.empty() || sameAsLike.has_value(); }

    /// Else a quantity within bounds.
    Quantity quantity{};
    Taken taken = Taken::End;
    double atLeast = -std::numeric_limits<double>::infinity(); // [unit of the quantity]
    double atMost = std::numeric_limits<double>::infinity();
    double from = 0.0, to = std::numeric_limits<double>::infinity(); // band of Peaks [Hz]
    std::optional<Case> like{};                                      // that is compared with

    std::optional<EnsembleTask> ensemble{};
};

/// "1.55 nm to 1.65 nm", "flying or contact".
std::string expectedText(const Statement& statement);

struct StatementTask {
    std::vector<Statement> statements; // all of the first candidate, then all of the next
    std::vector<std::string> candidates;
};

StatementTask readStatements(StudyReader& reader);

} // namespace touchdown
