// SPDX-License-Identifier: GPL-3.0-or-later
//
// The steady film at a fixed attitude by alternating-direction line sweeps with full multigrid (Brandt 1977; for air
// bearings Lu 1997), the method of the established programs: Newton's discrete solution by another path.
//
// Every second line of a grid makes the next coarser one; each level samples the surface for itself and has its own
// film. The pressure starts on the coarsest level and is handed on from level to level, with one V cycle on each. A
// cycle seeks the correction v of the pressure,
//
//   J v = -R(p):  relax; sum the residual outflow over the coarse cells; correct there; interpolate; relax.
//
// Relaxation is zebra lines along x, then along y, with the derivatives of the flow that the convection scheme passes;
// a coarse level takes its own at the mean of the finer one's pressure. One linearisation serves a whole visit of a
// level, so that the full approximation of coarse levels comes down to their corrections; it is kept for further cycles
// until one gains too little. Linearising at each relaxation saves no cycle and costs twice the time.
//
// What the complete flux scheme adds couples nine cells and more, and is deferred: lines solve the five-point part for
// what the whole J leaves of the residual, several times at each relaxation. Deferred once per relaxation it takes up
// to twice as many cycles. Coarse levels do without, with exponential fitting.
//
// No pressure rises or falls by more than a factor of three in a cycle, so that none becomes negative. A cycle that
// makes things much worse is taken back, and repeated with a step in time in place of the steady state.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "core/numerics/line_relaxation.h"
#include "core/numerics/nested_grid.h"
#include "core/physics/film/film_newton.h"
#include "core/physics/film/gas_film.h"

namespace touchdown {

class FilmLineMultigrid {
public:
    FilmLineMultigrid(const Recess& recess, const CellGrid& grid, const FilmSetting& setting)
        : FilmLineMultigrid(recess, FilmGaps(recess, grid), setting)
    {}
    /// `finest`: the recess as the finest grid sees it.
    FilmLineMultigrid(const Recess& recess, FilmGaps finest, const FilmSetting& setting);
    FilmLineMultigrid(FilmLineMultigrid&&) = default; // moved, the levels stay where they are
    FilmLineMultigrid& operator=(FilmLineMultigrid&&) = default;

    /// On the finest grid. A solution leaves its linearisation undetermined.
    GasFilm& film() { return levels_.front().film; }
    void setAttitude(const Attitude& attitude);

    /// Solves R(p) = 0 from the guess p (padded). `iterations` are V cycles on the finest grid, `solves` those on all.
    /// A guess that is nearly right is kept; with another one the levels are climbed. Without convergence, p is the
    /// best seen.
    FilmSolution solve(std::span<double> p, const FilmOptions& options, const FilmMonitor& monitor = {});

private:
    struct Level {
        Level(FilmGaps levelGaps, const FilmSetting& setting);

        /// At the pressure, with a step in time of 1/shift.
        void linearise(double shift);
        /// Sweeps over the lines; as often again for each deferral of a complete flux scheme. `fromZero`: the
        /// correction is.
        void relax(int sweeps, bool fromZero);
        /// residual = right - J correction.
        void leave();

        FilmGaps gaps;
        GasFilm film;
        LineRelaxation lines;
        GridTransfer toCoarser;
        bool complete;                  // the scheme, complete flux
        FaceFlows<double> flows;        // its work space
        double shift = 0.0;             // zero for the steady state [1/s]
        std::vector<double> pressure;   // [Pa]
        std::vector<double> residual;   // R(p), or what the correction leaves of `right` [Pa m^3/s]
        std::vector<double> right;      // -R(p), or what a finer level leaves, summed [Pa m^3/s]
        std::vector<double> correction; // [Pa]
        std::vector<double> change;     // of the correction or of the pressure [Pa]
    };

    /// From the guess, when it is nearly right, or by way of all levels, when that does not make things much worse.
    void start(std::span<const double> guess, FilmSolution& result);
    void climb(FilmSolution& result);
    /// All levels, about the finest one's pressure.
    void linearise(double shift);
    /// One V cycle: the level's correction, from zero, for its right-hand side.
    void cycle(std::size_t index);
    double residualOf(Level& level);
    double shorterShift(double shift, double gain) const;

    std::deque<Level> levels_; // the finest first; films refer to their level's gaps, which stay where they are
    std::vector<double> best_; // pressure on the finest level [Pa]
};

} // namespace touchdown
