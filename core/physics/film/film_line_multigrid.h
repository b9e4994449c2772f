// SPDX-License-Identifier: GPL-3.0-or-later
//
// The steady film at a fixed attitude by alternating-direction line sweeps with full multigrid (Brandt 1977; for air
// bearings Lu 1997), the method of the established programs: another way to Newton's discrete solution.
//
// Every second line of a grid makes the next coarser one; each level samples the surface itself and has its own film.
// The pressure starts on the coarsest level and is passed from level to level, with one V cycle on each. A cycle finds
// the correction v of the pressure,
//
//   J v = -R(p):  relax; sum the residual outflow over the coarse cells; correct there; interpolate; relax.
//
// Relaxation is zebra lines along x, then along y, with the derivatives of the flow of the convection scheme; a coarse
// level linearises at the mean of the finer one's pressure. A linearisation is kept for further cycles until one gains
// too little; linearising at each relaxation saves no cycle and costs twice the time.
//
// The correction of the complete flux scheme couples nine cells and more and is deferred: lines solve the five-point
// part for the residual of the whole J, several times at each relaxation (once takes up to twice as many cycles).
// Coarse levels use exponential fitting without it.
//
// Where a cycle gains too little, as with narrow deep channels that coarse levels do not see, cycles become the
// preconditioner of Newton's linear systems.
//
// No pressure changes by more than a factor of three in a cycle, so none becomes negative. A cycle that raises the
// residual much is undone and repeated with a step in time instead of the steady state.
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "core/numerics/gmres.h"
#include "core/numerics/line_relaxation.h"
#include "core/numerics/nested_grid.h"
#include "core/physics/film/film_newton.h"
#include "core/physics/film/gas_film.h"

namespace touchdown {

class FilmLineMultigrid {
public:
    FilmLineMultigrid(const Recess& recess, const CellGrid& grid, const FilmSetting& setting)
        : FilmLineMultigrid(recess, std::make_shared<const FilmGaps>(recess, grid), setting)
    {}
    /// `finest`: the recess as the finest grid sees it.
    FilmLineMultigrid(const Recess& recess, std::shared_ptr<const FilmGaps> finest, const FilmSetting& setting);
    FilmLineMultigrid(FilmLineMultigrid&&) = default; // the levels keep their addresses
    FilmLineMultigrid& operator=(FilmLineMultigrid&&) = default;

    /// On the finest grid. A solution leaves its linearisation undetermined.
    GasFilm& film() { return levels_.front().film; }
    void setAttitude(const Attitude& attitude);

    /// Solves R(p) = 0 from the guess p (padded). `iterations` are V cycles on the finest grid, `solves` those on all.
    /// Starts from the coarsest level unless the guess is good. Without convergence, p is the best one found.
    FilmSolution solve(std::span<double> p, const FilmOptions& options, const FilmMonitor& monitor = {});

private:
    struct Level {
        Level(std::shared_ptr<const FilmGaps> gaps, const FilmSetting& setting);

        /// At the pressure, with a step in time of 1/shift.
        void linearise(double shift);
        /// Sweeps over the lines, repeated for each deferral of a complete flux scheme; `fromZero`: no correction yet.
        void relax(int sweeps, bool fromZero);
        /// residual = right - J correction.
        void leave();
        /// out = J v.
        void apply(std::span<const double> v, std::span<double> out);

        GasFilm film;
        LineRelaxation lines;
        GridTransfer toCoarser;
        bool complete;                  // the scheme, complete flux
        FaceFlows<double> flows;        // work space of J
        double shift = 0.0;             // zero for the steady state [1/s]
        std::vector<double> pressure;   // [Pa]
        std::vector<double> residual;   // R(p), or what the correction leaves of `right` [Pa m^3/s]
        std::vector<double> right;      // -R(p), or what a finer level leaves, summed [Pa m^3/s]
        std::vector<double> correction; // [Pa]
        std::vector<double> change;     // of the correction or of the pressure [Pa]
    };

    /// Starts from a guess that is nearly right; else climbs all levels, unless that makes the residual four times
    /// larger.
    void start(std::span<const double> guess, FilmSolution& result);
    void climb(FilmSolution& result);
    /// All levels, about the finest one's pressure.
    void linearise(double shift);
    /// One V cycle: the level's correction, from zero, for its right-hand side.
    void cycle(std::size_t index);
    /// A step of Newton's method, in place of a cycle's correction: generalised minimal residuals with at most so many
    /// cycles as preconditioner. Returns their number.
    int accelerate(int most);
    double residualOf(Level& level);
    double shorterShift(double shift, double gain) const;

    std::deque<Level> levels_; // the finest first
    Gmres<double> gmres_;
    std::vector<double> newton_, step_; // its right-hand side [Pa m^3/s], its solution [Pa]
    std::vector<double> best_;          // pressure on the finest level [Pa]
};

} // namespace touchdown
