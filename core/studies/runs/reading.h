// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers that can be read off a calculation of a case, by name: of a run in time, a static state or its modes. A
// quantity that changes over a run needs to be told where it is taken.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/simulation/recording/quantity.h"
#include "core/studies/study/item_study.h"

namespace touchdown {

struct Case;
struct MeasuredRun;

enum class Calculation : std::uint8_t { Run, Steady, Modes };
inline std::string_view name(Calculation calculation)
{
    constexpr std::array<std::string_view, 3> names{"run", "steady", "modes"};
    return names[static_cast<std::size_t>(calculation)];
}

/// Where a quantity of a run is taken; the last tenth is that of the duration.
enum class ReadAt : std::uint8_t {
    Single, // it is one number
    End,    // the last sample
    Tail,   // mean over the last tenth
    Swing,  // peak to peak there, between samples, too, where the run states that
    Rms,    // standard deviation there
    Mean,   // over the whole run
    Least,  // in the whole run, between samples, too
    Most
};
/// "end"; "" of Single.
std::string_view name(ReadAt taken);
/// What it means, in a few words.
std::string_view meaning(ReadAt taken);
inline constexpr std::size_t readAtCount = 8;

/// One row of the table of all readings.
struct ReadableQuantity {
    Quantity quantity;
    bool overTime = false; // a value at each time of a run
    bool isText = false;
};

/// All that can be read off this calculation of this case, in the order of its report.
std::vector<ReadableQuantity> readableQuantities(Calculation calculation, const Case& c);

/// Every name that some calculation of some case has, for the reference.
struct ReadingRow {
    ReadableQuantity what;
    std::vector<std::string> where{}; // "run of springs", "run of a film", "run of a pad", "steady", "modes"
};
std::vector<ReadingRow> allReadings();

struct Reading {
    Quantity quantity;
    ReadAt at = ReadAt::Single;
    bool isText = false;
    bool isError = false; // the stated error of the reading before it

    /// "flying_height_end", with the unit; texts have none.
    StudyColumn column() const;
};

/// The reading, or why there is none, in a sentence without the key. `at`: "" for the end, or for a single number.
std::variant<Reading, std::string> findReading(Calculation calculation, const Case& c, const std::string& quantity,
                                               const std::string& at);

/// The readings with the stated error of each behind it, where there is one.
std::vector<Reading> withErrors(Calculation calculation, const Case& c, const std::vector<Reading>& readings);

/// A quantity over a run, taken there [its unit]; NaN where it is not known. `samples`: of the quantity, all of the
/// run.
double valueAt(ReadAt at, const Case& c, const MeasuredRun& run, const std::string& quantity,
               std::span<const double> samples);

/// A value for each reading, nothing where it is not known; then why the calculation has no valid end, "" where it has.
struct CaseReadings {
    std::vector<StudyValue> values;
    std::string problem{};
};
/// Calculates the case, also one whose values contradict each other, which is a problem of it. A run writes its results
/// to the file that the call names. Nothing where it was told to end, or where these cannot be written.
std::optional<CaseReadings> readCase(const Case& c, Calculation calculation, const std::vector<Reading>& readings,
                                     ItemCall& call);

} // namespace touchdown
