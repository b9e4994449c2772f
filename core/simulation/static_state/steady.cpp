// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/steady.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "core/case/ridge_check.h"
#include "core/physics/film/film_line_multigrid.h"
#include "core/simulation/static_state/film_balance.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/grid_error.h"
#include "core/simulation/static_state/high_disk.h"
#include "core/simulation/static_state/ridge_error.h"
#include "core/simulation/static_state/sensitivity.h"
#include "core/simulation/static_state/static_check.h"
#include "core/work/team.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

/// Walks from the coarsest grid to the finest, each adapted to what the one before found.
class SteadySolver {
public:
    SteadySolver(const Case& c, const SteadyCallback& callback)
        : case_(c),
          callback_(callback),
          recess_(c.surface, c.slider.length, c.slider.width),
          spacing_(c.surface, recess_),
          attitude_{c.initial.nominalTrailingEdgeHeight, c.initial.pitch, c.initial.roll}
    {}

    SteadyResult solve()
    {
        if (const std::string why = whyNoStaticState(case_, spacing_); !why.empty()) return refused(why);
        const std::vector<std::array<int, 2>> levels = filmLevels(case_.film);
        for (const std::array<int, 2>& cells : levels) {
            previous_ = std::move(level_);
            CellGrid cellGrid = grid(cells);
            const auto goOn = [&] { return tell(cellGrid, 0, result_.residual, result_.loadError, attitude_); };
            auto gaps = std::make_shared<const FilmGaps>(recess_, cellGrid, goOn);
            if (!goOn()) return result_;
            level_ = std::make_unique<FilmLevel>(case_, std::move(gaps), spacing_);
            if (!tell(0, result_.residual, result_.loadError, attitude_)) return result_;
            if (previous_) level_->take(previous_->known(case_));
            if (case_.film.solver == FilmSolver::LineMultigrid) takeLineMultigrid();
            const bool finest = &cells == &levels.back();
            const bool converged = case_.steady.fixedAttitude ? solveFilm(finest) : solveAttitude(finest);
            if (result_.status == SteadyStatus::Cancelled) return result_;
            if (!converged && case_.film.accuracy > 0.0 && coarse_.size() > 1) {
                goBack();
                break;
            }
            if (!converged && (finest || hopeless())) return unconverged();
            first_ = false;
            if (converged && isAccurate()) break;
            if (!finest) {
                if (converged) {
                    coarse_.insert(coarse_.begin(), summary());
                    converged_ = result_;
                } else {
                    coarse_.clear();
                    level_.reset(); // what a coarse grid did not find is no start for the next, but for how far it came
                }
            }
        }
        report(true);
        if (!case_.steady.sensitivities || case_.steady.fixedAttitude || result_.status == SteadyStatus::Cancelled)
            return result_;
        lineMultigrid_.reset();
        previous_.reset();
        level_.reset(); // two films of the finest grid take much memory
        result_.sensitivities = sensitivities(case_, *FilmBalance::at(case_, result_), result_.contact);
        return result_;
    }

private:
    void takeLineMultigrid()
    {
        lineMultigrid_ = std::make_unique<FilmLineMultigrid>(recess_, level_->film.sharedGaps(), filmSetting(case_));
        level_->flying.setFilmSolve(
            [this](std::span<double> p, const FilmOptions& options, const FilmMonitor& monitor) {
                lineMultigrid_->setAttitude(level_->film.attitude());
                return lineMultigrid_->solve(p, options, monitor);
            });
    }

    CellGrid grid(const std::array<int, 2>& cells) const
    {
        const double length = case_.slider.length, width = case_.slider.width;
        if (case_.film.grid == GridKind::Adapted && previous_)
            return adaptedGrid(case_.surface, length, width, cells[0], cells[1], previous_->known(case_));
        return unadaptedGrid(case_, cells);
    }

    bool tell(int iteration, double residual, double loadError, const Attitude& attitude)
    {
        return tell(level_->gaps.grid, iteration, residual, loadError, attitude);
    }
    bool tell(const CellGrid& grid, int iteration, double residual, double loadError, const Attitude& attitude)
    {
        if (result_.status == SteadyStatus::Cancelled) return false;
        const std::string size = std::to_string(grid.x.size()) + " x " + std::to_string(grid.y.size());
        const bool goOn = !callback_ || callback_({"grid " + size, iteration, residual, loadError, attitude});
        if (!goOn) {
            result_.status = SteadyStatus::Cancelled;
            result_.message = "cancelled on the " + size + " grid";
        }
        return goOn;
    }

    /// Coarse grids are only as exact as what they are good for.
    static constexpr double coarseTolerance = 1e-4;
    double tolerance(bool finest, double own) const
    {
        // With an accuracy asked for, any grid after the second may be the last.
        return finest || (case_.film.accuracy > 0.0 && coarse_.size() > 1) ? own : std::max(coarseTolerance, own);
    }

    /// Whether an accuracy was asked for and is reached: of the net force at a fixed attitude, else of the minimum
    /// spacing. Two coarser grids must have agreed before.
    bool isAccurate()
    {
        if (!(case_.film.accuracy > 0.0) || coarse_.size() < 2) return false;
        std::optional<Matrix3> stiffness;
        if (!case_.steady.fixedAttitude) stiffness = level_->flying.roughStiffness(level_->pressure);
        const GridState state = summary();
        const DiscretisationError error = gridError(case_, *level_, stiffness, state, coarse_, ridgeErrors());
        // Where the parts above and below ambient pressure nearly cancel, their size is what counts.
        const double force = std::max({std::abs(state.load), 1e-2 * (2.0 * state.positive - state.load), 1e-9});
        accuracy_ =
            case_.steady.fixedAttitude ? error.load / force : error.minimumSpacing / std::abs(state.minimumSpacing);
        return accuracy_ <= case_.film.accuracy;
    }

    std::vector<Vector3> ridgeErrors()
    {
        return touchdown::ridgeErrors(case_, *level_, unresolvedRidges(case_.surface, recess_, level_->gaps.grid));
    }

    AttitudeMonitor monitor()
    {
        return [this](int iteration, double residual, double loadError, const Attitude& attitude) {
            return tell(iteration, residual, loadError, attitude);
        };
    }

    bool solveFilm(bool finest)
    {
        level_->film.setAttitude(attitude_);
        const FilmSolution s = level_->flying.solveFilm(
            level_->pressure,
            {.tolerance = tolerance(finest, case_.film.tolerance), .maximumIterations = case_.film.maximumIterations},
            [this](int iteration, double residual) { return tell(iteration, residual, 0.0, attitude_); });
        std::vector<double> residual(level_->pressure.size());
        level_->film.residual(level_->pressure, residual); // the flow through the outline is reported from it
        result_.iterations = s.iterations;
        result_.solves += s.solves;
        result_.residual = s.residual;
        return s.converged;
    }

    bool solveAttitude(bool finest)
    {
        // From far, and where contact may carry what the film does not: see search_watch.h.
        const bool throughDisk = first_ || case_.contact != noContact;
        const AttitudeOptions options{.filmTolerance = tolerance(finest, case_.film.tolerance),
                                      .loadTolerance = tolerance(finest, case_.steady.loadTolerance),
                                      .maximumIterations = case_.film.maximumIterations,
                                      .patience = throughDisk ? 100 : 30,
                                      .throughDisk = throughDisk};
        FlyingAttitude& flying = level_->flying;
        const bool together = previous_ && case_.film.solver == FilmSolver::Newton;
        const AttitudeSolution s = together ? flying.solve(level_->pressure, attitude_, options, monitor())
                                            : flying.approach(level_->pressure, attitude_, options, monitor());
        level_->film.setAttitude(attitude_);
        result_.iterations = s.iterations;
        result_.solves += s.solves;
        result_.residual = s.residual;
        result_.loadError = s.loadError;
        search_ = s;
        return s.converged;
    }

    /// Whether finer grids need not be tried. A coarse grid may miss the film's force by its half, and two grids do not
    /// miss the same state.
    bool hopeless()
    {
        constexpr double farFromBalance = 0.5; // load error of all sane states
        if (case_.steady.fixedAttitude || search_.why == NoBalance::None) return false;
        return search_.why == NoBalance::BelowDisk || search_.why == NoBalance::FarAway ||
               search_.leastSaneError > farFromBalance || ++abandoned_ > 1;
    }

    SteadyResult refused(const std::string& why)
    {
        const MinimumSpacing::Place nearest = spacing_.at(attitude_);
        result_.status = SteadyStatus::Failed;
        result_.message = why;
        result_.attitude = attitude_;
        result_.minimumSpacing = nearest.spacing;
        result_.minimumAt = nearest.at;
        return result_;
    }

    /// To the last grid that was solved.
    void goBack()
    {
        level_ = std::move(previous_);
        lineMultigrid_.reset(); // it knows the other grid
        attitude_ = coarse_.front().attitude;
        coarse_.erase(coarse_.begin());
        result_ = converged_;
    }

    GridState summary() const
    {
        const FilmForces forces = level_->loads.forces(level_->pressure);
        const MinimumSpacing::Place nearest = spacing_.at(attitude_);
        return {attitude_, nearest.at, nearest.spacing, forces.net, forces.positive};
    }

    SteadyResult unconverged()
    {
        report(false);
        result_.status = SteadyStatus::NotConverged;
        if (!case_.steady.fixedAttitude && search_.why != NoBalance::None) {
            result_.message = "no flying attitude was found: " + std::string(reason(search_.why)) +
                              (search_.sane ? "; " + lastStateWords(case_, result_) : std::string());
            return result_;
        }
        char text[240];
        std::snprintf(text, sizeof text,
                      "film residual %.1e and load error %.1e remain after %d iterations on the finest grid",
                      result_.residual, result_.loadError, result_.iterations);
        result_.message = text;
        result_.note(noteOnClosedGap(case_, spacing_));
        if (!case_.steady.fixedAttitude && result_.minimumSpacing <= 0.0)
            result_.message += "; the rails went below the mean plane of the disk: it seems that the film alone does "
                               "not carry the load";
        return result_;
    }

    void report(bool converged)
    {
        FilmLevel& level = *level_;
        result_.status = SteadyStatus::Converged;
        result_.message = noteOnClosedGap(case_, spacing_);
        if (converged && case_.film.accuracy > 0.0 && !(accuracy_ <= case_.film.accuracy)) {
            char text[200];
            std::snprintf(
                text, sizeof text,
                "film.accuracy = %.2g %% is not reached: on the finest grid that has a solution the error is about "
                "%.2g %%",
                100.0 * case_.film.accuracy, 100.0 * accuracy_);
            result_.note(text);
        }
        setState(result_, case_, level, spacing_, attitude_);
        if (converged) result_.note(noteOnHeldRoll(case_, result_));
        std::optional<Matrix3> stiffness; // the error follows from it, too
        if (converged && (case_.steady.stiffness || (!coarse_.empty() && !case_.steady.fixedAttitude)))
            stiffness = case_.steady.stiffness ? level.flying.stiffness(level.pressure)
                                               : level.flying.roughStiffness(level.pressure);
        if (case_.steady.stiffness) result_.stiffness = stiffness;
        std::vector<Vector3> ridges;
        if (converged) {
            ridges = ridgeErrors();
            result_.unresolvedRidges = ridges.size();
            result_.note(ridgeWords(ridges.size()));
        }
        if (!coarse_.empty())
            result_.discretisationError = gridError(case_, level, stiffness, summary(), coarse_, ridges);
        if (converged && case_.steady.allEquilibria && !case_.steady.fixedAttitude) findOthers();
        if (converged && !case_.steady.fixedAttitude && result_.minimumSpacing <= 0.0) {
            result_.status = SteadyStatus::Failed;
            char text[260];
            std::snprintf(
                text, sizeof text,
                "the film alone would carry the load only with the rails %.3g nm below the mean plane of the disk: "
                "the slider touches the disk",
                -result_.minimumSpacing * 1e9);
            result_.message = text;
        }
    }

    /// Other attitudes at which the forces balance, from starts all over the range where sliders fly.
    void findOthers()
    {
        const CellGrid coarsest = gradedGrid(case_.surface, case_.slider.length, case_.slider.width,
                                             filmLevels(case_.film).front()[0], filmLevels(case_.film).front()[1]);
        const auto gaps = std::make_shared<const FilmGaps>(recess_, coarsest);
        for (const double height : {0.5e-9, 5e-9, 30e-9, 200e-9})
            for (const double pitch : {20e-6, 150e-6, 500e-6}) {
                FilmLevel coarse(case_, gaps, spacing_);
                Attitude attitude{height, pitch, 0.0};
                const AttitudeOptions options{
                    .filmTolerance = coarseTolerance, .loadTolerance = coarseTolerance, .maximumIterations = 25};
                AttitudeSolution found = coarse.flying.approach(coarse.pressure, attitude, options, monitor());
                if (found.cancelled) return;
                if (!found.converged || isKnown(attitude, 0.1)) continue;
                FilmLevel fine(case_, level_->film.sharedGaps(), spacing_);
                fine.take(coarse.known(case_));
                found = fine.flying.solve(
                    fine.pressure, attitude,
                    {.filmTolerance = case_.film.tolerance, .loadTolerance = case_.steady.loadTolerance}, monitor());
                if (found.cancelled) return;
                if (found.converged && spacing_.at(attitude).spacing > 0.0 && !isKnown(attitude, 1e-3))
                    result_.otherEquilibria.push_back(attitude);
            }
    }

    bool isKnown(const Attitude& attitude, double share) const
    {
        const auto near = [&](const Attitude& known) {
            const double length = case_.slider.length;
            const double apart = std::abs(known.height - attitude.height) +
                                 length * std::abs(known.pitch - attitude.pitch) +
                                 case_.slider.width * std::abs(known.roll - attitude.roll);
            return apart <= share * (std::abs(known.height) + length * std::abs(known.pitch));
        };
        return near(attitude_) || std::any_of(result_.otherEquilibria.begin(), result_.otherEquilibria.end(), near);
    }

    const Case& case_;
    const SteadyCallback& callback_;
    Recess recess_;
    MinimumSpacing spacing_;
    Attitude attitude_;
    std::unique_ptr<FilmLevel> level_, previous_;
    std::unique_ptr<FilmLineMultigrid> lineMultigrid_; // of the level, when it is chosen
    std::vector<GridState> coarse_;                    // the finest of them first, as far as all converged
    double accuracy_ = 0.0;                            // of the last grid, where one is asked for [-]
    bool first_ = true;                                // grid
    AttitudeSolution search_;                          // the last one
    int abandoned_ = 0;                                // searches that were given up
    SteadyResult result_, converged_; // the second: with the last solved grid's iterations and residuals
};

std::atomic<long long> solutionsAskedFor = 0; // on any thread

} // namespace

long long staticSolutions() { return solutionsAskedFor; }

SteadyResult steady(const Case& c, const SteadyCallback& callback)
{
    const double start = wallClock();
    const TeamScope team(staticThreads(c));
    ++solutionsAskedFor;
    Case held = c;
    if (const std::optional<Attitude> rest = unloadedRest(c); rest && !c.steady.fixedAttitude) {
        held.steady.fixedAttitude = true;
        held.initial.nominalTrailingEdgeHeight = rest->height;
        held.initial.pitch = rest->pitch;
        held.initial.roll = rest->roll;
    }
    SteadyResult result = SteadySolver(held, callback).solve();
    // Not of the states that runs and searches ask for.
    if (result.status == SteadyStatus::Converged && c.steady.stiffness)
        result.note(noteOnHighDisk(c, result.minimumSpacing));
    result.wallSeconds = wallClock() - start;
    return result;
}

Case attitudeCase(const Case& c)
{
    Case result = c;
    result.steady.fixedAttitude = result.steady.stiffness = result.steady.sensitivities = result.steady.allEquilibria =
        false;
    return result;
}

} // namespace touchdown
