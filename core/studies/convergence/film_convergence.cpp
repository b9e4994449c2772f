// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/film_convergence.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/moments.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/study/growing_report.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

FilmState stateOf(Case c, int nodes, const GoOn& goOn)
{
    c.film.nodes = {nodes, nodes};
    c.film.accuracy = 0.0;
    const double begin = wallClock();
    const SteadyResult result = steady(c, [&](const SteadyProgress&) { return !goOn || goOn(); });
    FilmState state;
    state.seconds = wallClock() - begin;
    if (result.status != SteadyStatus::Converged) {
        state.problem = result.message.empty() ? std::string(name(result.status)) : result.message;
        return state;
    }
    state.netForce = result.forces.net;
    state.minimumSpacing = result.minimumSpacing;
    state.pitch = result.attitude.pitch;
    state.roll = result.attitude.roll;
    const DiscretisationError& error = result.discretisationError;
    // Zero where the coarser grids have no solution, from which it is estimated.
    if (const double stated = c.steady.fixedAttitude ? error.load : error.minimumSpacing; stated > 0.0)
        state.statedError = stated;
    return state;
}

Case prepared(Case c, bool fixedAttitude)
{
    c.steady.fixedAttitude = fixedAttitude;
    c.steady.stiffness = c.steady.sensitivities = c.steady.allEquilibria = false;
    return c;
}

/// Runs one after the other or several at a time, with their shares of the progress.
class FilmRuns {
public:
    FilmRuns(const FilmConvergenceTask& task, int jobs, const StudyCallback& callback,
             const std::function<StudyReport(const FilmConvergence&)>& reportOf)
        : task_(task), jobs_(jobs), callback_(callback), reportOf_(reportOf)
    {
        for (const Case& slider : task.sliders) sliders_.push_back(prepared(slider, task.fixedAttitude));
        for (std::size_t s = 0; s < sliders_.size(); ++s) {
            all_ += costOf(task.reference);
            for (std::size_t m = 0; m < task.methods.size(); ++m)
                for (const int nodes : task.grids) {
                    study_.runs.push_back({.slider = s, .method = m, .nodes = nodes, .state = {}, .error = {}});
                    study_.runs.back().state.problem = notSolved;
                    all_ += costOf(nodes);
                }
        }
        study_.references.resize(sliders_.size());
        for (FilmState& each : study_.references) each.problem = notSolved;
    }

    FilmConvergence perform()
    {
        if (!solveReferences() || !solveRuns()) {
            study_.status = StudyStatus::Cancelled;
            study_.message = "stopped before all grids were solved";
        }
        findErrors();
        const auto hasError = [](const FilmRun& run) { return run.error.has_value(); };
        if (study_.status == StudyStatus::Completed && std::ranges::none_of(study_.runs, hasError)) {
            study_.status = StudyStatus::Failed;
            const std::string& problem = study_.references.front().problem;
            study_.message = problem.empty() ? "no grid has a solution: " + study_.runs.front().state.problem
                                             : "the reference has no solution: " + problem;
        }
        return std::move(study_);
    }

private:
    static constexpr const char* notSolved = "not solved";
    static constexpr double mostOfOne = 0.95; // counted before it is solved

    /// Time is about proportional to the number of cells.
    static double costOf(int nodes) { return double(nodes) * nodes; }

    /// Solutions of `cost` are under way since `begin` [wall clock], beyond what is done: a part of them counts by the
    /// time that they are expected to take at the pace so far. Nothing counts before the first solution tells the pace.
    bool tell(double cost, double begin, const std::string& doing)
    {
        const double passed = wallClock() - begin_, now = wallClock() - begin;
        const double part = done_ > 0.0 ? std::min(now / (cost * passed / done_), mostOfOne) : 0.0;
        told_ = std::max(told_, std::min((done_ + part * cost) / all_, 1.0)); // it never falls
        return !callback_ || callback_({.share = told_, .doing = doing});
    }

    /// Between solutions, so that none is being written.
    bool tellSoFar(const std::string& doing)
    {
        findErrors();
        return tellProgress(callback_, {told_, doing}, bool(reportOf_), [this] { return reportOf_(study_); });
    }

    bool solveReferences()
    {
        const auto solve = [&](std::size_t s, const GoOn& goOn) {
            study_.references[s] = task_.methods.front().solve(sliders_[s], task_.reference, goOn);
        };
        double begin = wallClock();
        return runParallel(sliders_.size(), jobs_, solve, [&](std::size_t done) {
            if (const double now = double(done) * costOf(task_.reference); now > done_) {
                done_ = now;
                begin = wallClock();
            }
            const std::size_t atATime = std::min<std::size_t>(std::size_t(std::max(jobs_, 1)), sliders_.size() - done);
            return tell(double(std::max<std::size_t>(atATime, 1)) * costOf(task_.reference), begin,
                        std::to_string(done) + " of " + std::to_string(sliders_.size()) + " references");
        });
    }

    bool solveRuns()
    {
        if (!tellSoFar("references")) return false;
        for (FilmRun& run : study_.runs) {
            const FilmMethod& method = task_.methods[run.method];
            const auto solve = [&](std::size_t, const GoOn& goOn) {
                run.state = method.solve(sliders_[run.slider], run.nodes, goOn);
            };
            const std::string doing = method.name + ", " + std::to_string(run.nodes) + " lines";
            const double begin = wallClock();
            if (!runParallel(1, 1, solve, [&](std::size_t) { return tell(costOf(run.nodes), begin, doing); }))
                return false;
            done_ += costOf(run.nodes);
            if (!tellSoFar(doing)) return false;
        }
        return true;
    }

    void findErrors()
    {
        study_.uncertainty.resize(sliders_.size());
        for (FilmRun& run : study_.runs) {
            const FilmState& reference = study_.references[run.slider];
            if (!run.state.problem.empty() || !reference.problem.empty()) continue;
            run.error = std::abs(resultOf(task_, run.state) - resultOf(task_, reference));
            if (run.method == 0 && run.nodes == task_.grids.back()) study_.uncertainty[run.slider] = run.error;
        }
    }

    const FilmConvergenceTask& task_;
    int jobs_;
    const StudyCallback& callback_;
    const std::function<StudyReport(const FilmConvergence&)>& reportOf_;
    std::vector<Case> sliders_;
    FilmConvergence study_;
    double all_ = 0.0, done_ = 0.0; // cost
    double begin_ = wallClock(), told_ = 0.0;
};

} // namespace

FilmMethod steadyMethod(std::string name, std::vector<CaseSetting> changes)
{
    return {std::move(name),
            [changes = std::move(changes)](const Case& slider, int nodes, const GoOn& goOn) -> FilmState {
                Case c = slider;
                if (const auto problem = changeCase(c, changes, OutsidePaths::Allowed)) {
                    FilmState state;
                    state.problem = problem->text();
                    return state;
                }
                return stateOf(std::move(c), nodes, goOn);
            }};
}

double resultOf(const FilmConvergenceTask& task, const FilmState& state)
{
    return task.fixedAttitude ? state.netForce : state.minimumSpacing;
}

FilmConvergence performFilmConvergence(const FilmConvergenceTask& task, int jobs, const StudyCallback& callback,
                                       const std::function<StudyReport(const FilmConvergence&)>& reportOf)
{
    return FilmRuns(task, jobs, callback, reportOf).perform();
}

std::vector<FilmGridSummary> summarize(const FilmConvergenceTask& task, const FilmConvergence& study)
{
    std::vector<FilmGridSummary> summaries;
    for (std::size_t m = 0; m < task.methods.size(); ++m)
        for (const int nodes : task.grids) {
            FilmGridSummary summary{.method = m, .nodes = nodes};
            std::vector<double> errors, ratios, seconds;
            for (const FilmRun& run : study.runs) {
                if (run.method != m || run.nodes != nodes || !run.error) continue;
                errors.push_back(*run.error);
                seconds.push_back(run.state.seconds);
                if (run.ratio()) ratios.push_back(*run.ratio());
            }
            if (errors.empty()) continue;
            summary.solved = errors.size();
            summary.worst = std::ranges::max(errors);
            summary.median = medianOf(std::move(errors));
            summary.seconds = medianOf(std::move(seconds));
            summary.stated = ratios.size();
            summary.held = static_cast<std::size_t>(
                std::ranges::count_if(ratios, [](double ratio) { return ratio >= heldShare; }));
            if (!ratios.empty()) {
                summary.leastRatio = std::ranges::min(ratios);
                summary.medianRatio = medianOf(std::move(ratios));
            }
            summaries.push_back(summary);
        }
    return summaries;
}

std::optional<double> observedFilmOrder(const FilmConvergenceTask& task, const std::vector<FilmGridSummary>& summaries,
                                        std::size_t method)
{
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const FilmGridSummary& each : summaries) {
        if (each.method != method || !(each.median > 0.0) || 3 * (each.nodes - 1) > task.reference - 1) continue;
        const double u = -std::log(each.nodes - 1.0), v = std::log(each.median);
        n += 1.0, x += u, y += v, xx += u * u, xy += u * v;
    }
    if (n < 3.0) return {};
    const double order = (n * xy - x * y) / (n * xx - x * x);
    return order > 0.0 ? std::optional(order) : std::nullopt;
}

} // namespace touchdown
