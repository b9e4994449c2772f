// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much the grid decides the static state of a film: one slider or several, solved by several methods on finer and
// finer grids. The error of a run is the distance of its result from a reference, the first method on a grid that is
// finer than all others; beside it stand the error that the run itself states, and its time.
//
// The result is the net force at the initial attitude, or the minimum spacing of the flying slider. The reference is
// itself uncertain by about its difference from the first method's finest run; smaller errors are not resolved.
//
// References run several at a time; the other runs run alone, so that their times can be compared.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/case_files/case_settings.h"
#include "core/studies/study/study.h"
#include "core/work/parallel.h"

namespace touchdown {

/// A static state on one grid.
struct FilmState {
    std::string problem{};       // a sentence where there is none; "" where it was solved
    double netForce = 0.0;       // [N]
    double minimumSpacing = 0.0; // [m]
    double pitch = 0.0;          // [rad]
    double roll = 0.0;           // [rad]
    /// Of the net force [N] or the minimum spacing [m], as the run itself estimates it; none where it does not.
    std::optional<double> statedError{};
    double seconds = 0.0; // of wall time
};

struct FilmMethod {
    std::string name; // "complete-flux, adapted"
    /// `slider` asks for its attitude to be fixed or not; the grid has `nodes` lines in each direction.
    std::function<FilmState(const Case& slider, int nodes, const GoOn& goOn)> solve;
};
/// The static state of the case with these changes, which the case must allow.
FilmMethod steadyMethod(std::string name, std::vector<CaseSetting> changes);
struct FilmConvergenceTask {
    std::vector<Case> sliders; // one or more film cases, told apart by their titles
    bool fixedAttitude = false;
    std::vector<FilmMethod> methods; // one or more; the first one gives the references
    std::vector<int> grids;          // lines in each direction, 16 k + 1, ascending
    int reference = 769;             // lines of the references, more than those of any grid
};

struct FilmRun {
    std::size_t slider = 0, method = 0;
    int nodes = 0;
    FilmState state;
    std::optional<double> error; // distance from the reference [N] or [m]; none where either has no solution

    /// Stated error divided by the error found [-].
    std::optional<double> ratio() const
    {
        if (!error || !state.statedError || !(*error > 0.0)) return {};
        return *state.statedError / *error;
    }
};

struct FilmConvergence {
    StudyStatus status = StudyStatus::Completed;
    std::string message;
    std::vector<FilmState> references; // one for each slider
    std::vector<FilmRun> runs;         // slider by slider, method by method, from coarse to fine
    /// One for each slider: the distance of the reference from the first method's finest run [N] or [m].
    std::vector<std::optional<double>> uncertainty;
};

/// What is compared: the net force [N] or the minimum spacing [m].
double resultOf(const FilmConvergenceTask& task, const FilmState& state);

/// `jobs`: references at a time. `reportOf`: of the grids so far, for the callback, whenever one is solved.
FilmConvergence performFilmConvergence(const FilmConvergenceTask& task, int jobs, const StudyCallback& callback,
                                       const std::function<StudyReport(const FilmConvergence&)>& reportOf = {});

/// The runs of one method on one grid, of all sliders.
struct FilmGridSummary {
    std::size_t method = 0;
    int nodes = 0;
    std::size_t solved = 0;                            // runs with an error
    double median = 0.0, worst = 0.0;                  // error [N] or [m]
    std::size_t stated = 0, held = 0;                  // runs with a ratio; of these with one of `heldShare` or more
    std::optional<double> leastRatio{}, medianRatio{}; // [-]
    double seconds = 0.0;                              // median wall time
};
/// A stated error is taken as true from this share of the error found on.
inline constexpr double heldShare = 2.0 / 3.0;
/// Method by method, from coarse to fine; grids without an error are left out.
std::vector<FilmGridSummary> summarize(const FilmConvergenceTask& task, const FilmConvergence& study);

/// Least-squares slope of log(error) against log(1/(nodes - 1)) over the grids with at most a third of the lines of the
/// reference, as the reference's own error distorts finer ones; none with fewer than three of them, or below 0.
std::optional<double> observedFilmOrder(const FilmConvergenceTask& task, const std::vector<FilmGridSummary>& summaries,
                                        std::size_t method);

} // namespace touchdown
