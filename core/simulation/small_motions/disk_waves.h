// SPDX-License-Identifier: GPL-3.0-or-later
//
// The waves of a moving disk over the cells of a film.
#pragma once

#include <vector>

namespace touchdown {

struct Case;
struct FilmGaps;

/// a sin(phi - omega t) = Re W e^(i omega t), W = w(t = 0) + i w(a quarter of a period before). With omega < 0 that
/// quarter lies as far ahead.
struct DiskWave {
    double omega = 0.0;                // [1/s]
    std::vector<double> real, quarter; // [m]; padded
};

/// Of a surface of waves that moves; those that pass along their crests are left out.
std::vector<DiskWave> diskWaves(const Case& c, const FilmGaps& gaps);

} // namespace touchdown
