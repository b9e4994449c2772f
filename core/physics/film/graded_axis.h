// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines of a grid along one axis: as dense as a given density asks, with neighbouring spacings that differ little, and
// with lines exactly on given positions.
#pragma once

#include <vector>

namespace touchdown {

/// A position that should have a line; where two want the same, the heavier holds.
struct AxisMark {
    double position = 0.0; // inside the axis
    double weight = 0.0;
};

struct AxisWish {
    double start = 0.0, end = 1.0;
    std::vector<double> density; // lines per length, up to a factor, at equal bins from start to end; not negative
    std::vector<AxisMark> marks;
    double growth = 0.2; // largest change of the spacing per spacing [-]
    int multiple = 2;    // marks sit on lines whose number is a multiple of this, so that coarser grids keep them
};

/// cells + 1 ascending lines from start to end; marks that find no line of their own are left out.
std::vector<double> gradedAxis(const AxisWish& wish, int cells);

} // namespace touchdown
