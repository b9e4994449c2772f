// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static states on disk (HDF5):
//
//   /                         attributes format ("touchdown-steady"), format_version, software_version, date, title,
//                             status, message
//   /case/text, parameters    the input, as in a results file of a run
//   /states/<n>/              one for each state, from 1: attributes status, message, iterations, wall_seconds, ...
//       <quantity>            numbers with unit and long_name: nominal_trailing_edge_height, pitch, roll, ...;
//                             minimum_spacing_error, ..., load_error: of the grid; unresolved_ridges (since 1.1): the
//                             number of edges with a ridge narrower than a cell, which these errors count;
//                             contact_force, ..., peak_contact_pressure (since 1.2) where the attribute contact_state
//                             names the state of the contact; contact_region, contact_branch: how it is found again
//       suspension_rest       trailing edge height, pitch, roll (since 1.2) where they are not those of the state
//       minimum_spacing_at    x, y [m]; also maximum_pressure_at, ..., centre_of_positive_pressure, ...
//       stiffness             3 x 3, if it was asked for
//       contact_stiffness     3 x 3 (since 1.2, as the following), of a state in contact
//       other_states/<n>/     the other states of a contact law: attributes contact_state, unstable; numbers
//       points_of_interest    x, y, spacing [m], row by row
//       fields/x, y           centres of the cells: the dimension scales of the fields
//       fields/x_lines, y_lines   borders of the cells
//       fields/pressure, gap, recess   on (y, x); pressures are absolute
//   /series/<quantity>        of several states: radius, skew, speed and the numbers above, one element for each state
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

inline constexpr const char* steadyFormat = "touchdown-steady";
inline constexpr int steadyFormatMajor = 1;
inline constexpr int steadyFormatMinor = 2;

/// Writes a file that appears whole or not at all (core/formats/output_file.h). Every call returns "" or the problem in
/// one sentence.
class SteadyWriter {
public:
    SteadyWriter();
    ~SteadyWriter(); // removes a file that was not finished
    SteadyWriter(SteadyWriter&&) noexcept;
    SteadyWriter& operator=(SteadyWriter&&) noexcept;

    std::string open(const std::filesystem::path& file, const Case& c, const std::string& caseText);
    std::string add(const SteadySeriesPoint& point, const SteadyResult& result);
    /// `status` of the whole series: that of its worst state.
    std::string finish(SteadyStatus status, const std::string& message);

private:
    struct File;
    std::unique_ptr<File> file_;
};

} // namespace touchdown
