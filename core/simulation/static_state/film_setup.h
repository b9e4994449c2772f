// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a case to its film: air, slip, disk and scheme; the parts of one grid.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/case/case.h"
#include "core/physics/film/film_grid.h"
#include "core/physics/film/gas_film.h"
#include "core/physics/slider/minimum_spacing.h"
#include "core/simulation/static_state/flying_attitude.h"

namespace touchdown {

struct SteadyResult;

/// The air of a case's film: given, of the atmosphere, or that of the established program.
Air airOf(const AirCase& air);
FilmSetting filmSetting(const Case& c);

/// Numbers of cells from coarse to fine, each twice the last; the finest is that of the case, or where the case asks
/// for an accuracy, the finest that is tried.
std::vector<std::array<int, 2>> filmLevels(const FilmCase& film);

/// Threads for the film of a case that the calling thread is about to compute: run.threads, or as many as the size of
/// its grid is worth; not more than the thread may use (core/work/team.h).
int filmThreads(const Case& c);
/// The same for a static state, whose start is serial in part.
int staticThreads(const Case& c);

/// About what the film of a case takes on its finest grid, with its solvers [B]; 0 without a film.
std::size_t filmBytes(const Case& c);

/// The grid that is known before any solution: uniform, or graded towards the rails' edges.
CellGrid unadaptedGrid(const Case& c, const std::array<int, 2>& cells);

/// The disk carries the pressure waves of a motion at half its speed U, with a length U/(2 f). Waves of a few cells
/// decay or travel too fast, which changes the damping ratio: by up to 7 % at six cells, its sign at three (measured on
/// the fastest modes of five sliders, tests/bench/README.md).
inline constexpr double cellsForDamping = 6.0, cellsForItsSign = 3.0;
/// Frequency up to which the grid resolves the damping of a motion [Hz].
double resolvedFrequency(const Case& c, const CellGrid& grid);

/// One grid of a slider's film. Neither copied nor moved: its parts point at each other.
struct FilmLevel {
    FilmLevel(const Case& c, const Recess& recess, const MinimumSpacing& spacing, CellGrid grid)
        : FilmLevel(c, std::make_shared<const FilmGaps>(recess, std::move(grid)), spacing)
    {}
    /// For a caller that has the gaps of the case's slider, or may stop in between: they take half of the time.
    FilmLevel(const Case& c, std::shared_ptr<const FilmGaps> gaps, const MinimumSpacing& spacing);
    FilmLevel(const FilmLevel&) = delete;

    GasFilm film;
    const FilmGaps& gaps; // of the film
    FilmLoads loads;
    FlyingAttitude flying;
    std::vector<double> pressure; // padded, ambient at first [Pa]

    /// Pressure and gap row by row, for the next grid.
    KnownFilm known(const Case& c) const;
    void take(const KnownFilm& known);
};

/// What a static state says of its attitude and of the level's film there: spacing, forces, fields.
void setState(SteadyResult& state, const Case& c, FilmLevel& level, const MinimumSpacing& spacing,
              const Attitude& attitude);

} // namespace touchdown
