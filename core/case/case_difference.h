// SPDX-License-Identifier: GPL-3.0-or-later
//
// In which values two cases differ, for a list of runs or a report. Case::operator== tells whether they differ at all.
#pragma once

#include "core/case/case.h"

#include <string>
#include <vector>

namespace touchdown {

/// Kind: a step that became a ramp, or the reverse, with its recess. Order: of the items of a list.
enum class CaseChangeKind : std::uint8_t { Value, Kind, Added, Removed, Order };

/// One value, or one rail, wall or point that was added, removed or moved in its list. Numbers count from 1; those of
/// a removed item count in the first case, all others in the second. The key of a value is a key of
/// core/case/case_key.h in the second case: after changes of the other kinds, `key=after` of each value makes the
/// second case out of the first one.
struct CaseChange {
    CaseChangeKind kind = CaseChangeKind::Value;
    std::string key;    // "ono_yamane.take_off", "abs.rail[3].recess", "abs.rail[2].point[4].x", "abs.rail[3]"
    std::string label;  // "take-off height", "rail 3: recess", "rail 2, point 4: x", "rail 3", "order of rails 2 to 3"
    std::string before; // Value: "0.1 um", as toText() writes it; Kind: "step"
    std::string after;  // Value: "0.2 um"; Kind: "ramp"
};

/// Values that neither case uses, the title and the texts about a case are left out.
std::vector<CaseChange> caseChanges(const Case& before, const Case& after);

/// Points of a rail that were moved together. All count from 0.
struct MovedPoints {
    enum class How : std::uint8_t {
        Points,
        Edge,    // from the first to the second of its two points, parallel to itself: its ends by different shifts
        Rail,    // all points of the rail
        Mirrored // the rail about a line along x; `x` and `y` are not used
    };
    std::size_t rail = 0;
    std::vector<std::size_t> points;
    How how = How::Points;
    double x = 0.0; // [m]; of an edge: normal to it
    double y = 0.0; // [m]
};
/// Only rails that have as many points before as after, in surfaces with as many rails; a shift of less than 1 pm is
/// none, and shifts that differ by less are the same.
std::vector<MovedPoints> movedPoints(const AirBearingSurface& before, const AirBearingSurface& after);

} // namespace touchdown
