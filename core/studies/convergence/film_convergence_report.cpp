// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/film_convergence_report.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/numerics/moments.h"

namespace touchdown {

namespace {

/// The quantity of which errors are.
struct Compared {
    const char *name, *unit, *displayUnit;
};
Compared comparedOf(const FilmConvergenceTask& task)
{
    return task.fixedAttitude ? Compared{"net force", "N", "mN"} : Compared{"minimum spacing", "m", "nm"};
}

std::string errorText(const FilmConvergenceTask& task, double error)
{
    return fewDigits(error, comparedOf(task).displayUnit);
}

bool several(const FilmConvergenceTask& task) { return task.sliders.size() > 1; }

StudyTable runsOf(const FilmConvergenceTask& task, const FilmConvergence& study)
{
    const Compared of = comparedOf(task);
    StudyTable table{.name = "runs",
                     .columns = {{.name = "slider", .longName = "Slider", .secondary = !several(task)},
                                 {.name = "method", .longName = "Method"},
                                 {"nodes", "", "", "Grid lines in each direction"},
                                 {"net_force", "N", "mN", "Net force"},
                                 {"minimum_spacing", "m", "nm", "Minimum spacing"},
                                 {"pitch", "rad", "urad", "Pitch"},
                                 {"roll", "rad", "urad", "Roll"},
                                 {"error", of.unit, of.displayUnit, "Error of the " + std::string(of.name)},
                                 {"stated_error", of.unit, of.displayUnit, "Error that the run states"},
                                 {"ratio", "", "", "Stated error divided by the error found"},
                                 {"seconds", "s", "s", "Wall time"},
                                 {.name = "problem", .longName = "Why it was not solved", .secondary = true}}};
    for (const FilmRun& run : study.runs) {
        const FilmState& state = run.state;
        const bool solved = state.problem.empty();
        table.rows.push_back({task.sliders[run.slider].title, task.methods[run.method].name, double(run.nodes),
                              known(solved, state.netForce), known(solved, state.minimumSpacing),
                              known(solved, state.pitch), known(solved, state.roll), known(run.error),
                              known(state.statedError), known(run.ratio()), state.seconds, state.problem});
    }
    return table;
}

StudyTable summaryOf(const FilmConvergenceTask& task, const std::vector<FilmGridSummary>& summaries)
{
    const Compared of = comparedOf(task);
    StudyTable table{.name = "summary",
                     .columns = {{.name = "method", .longName = "Method"},
                                 {"nodes", "", "", "Grid lines in each direction"},
                                 {"sliders", "", "", "Sliders with an error"},
                                 {"median_error", of.unit, of.displayUnit, "Median error"},
                                 {"worst_error", of.unit, of.displayUnit, "Largest error"},
                                 {"median_ratio", "", "", "Median of stated error divided by error found"},
                                 {"least_ratio", "", "", "Least stated error divided by error found"},
                                 {"held", "", "", "Share of stated errors of two thirds of the error found or more"},
                                 {"seconds", "s", "s", "Median wall time"}}};
    for (const FilmGridSummary& each : summaries)
        table.rows.push_back({task.methods[each.method].name, double(each.nodes), double(each.solved), each.median,
                              each.worst, known(each.medianRatio), known(each.leastRatio),
                              known(each.stated > 0, double(each.held) / double(std::max<std::size_t>(each.stated, 1))),
                              each.seconds});
    return table;
}

StudyTable referencesOf(const FilmConvergenceTask& task, const FilmConvergence& study)
{
    const Compared of = comparedOf(task);
    StudyTable table{.name = "references",
                     .columns = {{.name = "slider", .longName = "Slider"},
                                 {"nodes", "", "", "Grid lines in each direction"},
                                 {"net_force", "N", "mN", "Net force"},
                                 {"minimum_spacing", "m", "nm", "Minimum spacing"},
                                 {"pitch", "rad", "urad", "Pitch"},
                                 {"roll", "rad", "urad", "Roll"},
                                 {"uncertainty", of.unit, of.displayUnit, "Difference from the finest other grid"},
                                 {"stated_error", of.unit, of.displayUnit, "Error that the run states"},
                                 {"seconds", "s", "s", "Wall time, several at a time"},
                                 {.name = "problem", .longName = "Why it was not solved", .secondary = true}}};
    for (std::size_t s = 0; s < study.references.size(); ++s) {
        const FilmState& state = study.references[s];
        const bool solved = state.problem.empty();
        table.rows.push_back({task.sliders[s].title, double(task.reference), known(solved, state.netForce),
                              known(solved, state.minimumSpacing), known(solved, state.pitch),
                              known(solved, state.roll), known(study.uncertainty[s]), known(state.statedError),
                              state.seconds, state.problem});
    }
    return table;
}

/// Known uncertainties of the references.
std::vector<double> uncertaintiesOf(const FilmConvergence& study)
{
    std::vector<double> values;
    for (const auto& each : study.uncertainty)
        if (each) values.push_back(*each);
    return values;
}

const FilmGridSummary* findGrid(const std::vector<FilmGridSummary>& summaries, std::size_t method, int nodes)
{
    const auto found = std::ranges::find_if(
        summaries, [&](const FilmGridSummary& each) { return each.method == method && each.nodes == nodes; });
    return found == summaries.end() ? nullptr : &*found;
}

/// The grid of the first case where it is among those compared, else the finest.
int toldNodes(const FilmConvergenceTask& task)
{
    const int own = task.sliders.front().film.nodes[0];
    return std::ranges::find(task.grids, own) != task.grids.end() ? own : task.grids.back();
}

void tellMethods(const FilmConvergenceTask& task, const std::vector<FilmGridSummary>& summaries, StudyReport& report)
{
    const int nodes = toldNodes(task);
    for (std::size_t m = 0; m < task.methods.size(); ++m) {
        std::string text = capitalized(task.methods[m].name) + ": ";
        const auto order = observedFilmOrder(task, summaries, m);
        text += order ? "observed order " + fewDigits(*order, "") : std::string("no observed order");
        if (const FilmGridSummary* grid = findGrid(summaries, m, nodes)) {
            text += "; with " + std::to_string(nodes) + " lines the error of the " + comparedOf(task).name + " is ";
            text += several(task)
                        ? errorText(task, grid->median) + " in the median and " + errorText(task, grid->worst) +
                              " at most over " + counted(grid->solved, "slider")
                        : errorText(task, grid->median);
            text += ", in " + fewDigitsOfTime(grid->seconds);
        }
        report.findings.push_back(text + ".");
    }
}

void tellStated(const FilmConvergenceTask& task, const FilmConvergence& study, StudyReport& report)
{
    for (std::size_t m = 0; m < task.methods.size(); ++m) {
        std::size_t stated = 0, held = 0;
        const FilmRun* least = nullptr;
        for (const FilmRun& run : study.runs) {
            const auto ratio = run.ratio();
            if (run.method != m || !ratio) continue;
            ++stated;
            held += *ratio >= heldShare ? 1 : 0;
            if (least == nullptr || *ratio < *least->ratio()) least = &run;
        }
        if (least == nullptr) continue;
        report.findings.push_back(
            "Stated errors, " + task.methods[m].name + ": " + std::to_string(held) + " of " + std::to_string(stated) +
            " are at least two thirds of the error found; the least is " + fewDigits(*least->ratio(), "") +
            " times the error found (" + (several(task) ? task.sliders[least->slider].title + ", " : "") +
            std::to_string(least->nodes) + " lines).");
    }
}

void tellReference(const FilmConvergenceTask& task, const FilmConvergence& study, StudyReport& report)
{
    const std::string lines = std::to_string(task.reference);
    std::string text = "Errors are distances from " + task.methods.front().name + " with " + lines + " lines";
    if (const std::vector<double> values = uncertaintiesOf(study); !values.empty())
        text += ". The reference differs from the result with " + std::to_string(task.grids.back()) + " lines by " +
                errorText(task, medianOf(values)) +
                (several(task) ? " in the median and " + errorText(task, std::ranges::max(values)) + " at most" : "") +
                "; smaller errors are not resolved";
    report.findings.push_back(text + ".");
    for (std::size_t s = 0; s < study.references.size(); ++s)
        if (!study.references[s].problem.empty())
            report.warnings.push_back(task.sliders[s].title +
                                      ": the reference has no solution: " + study.references[s].problem + ".");
    const auto failed =
        std::ranges::count_if(study.runs, [](const FilmRun& run) { return !run.state.problem.empty(); });
    if (failed > 0)
        report.warnings.push_back(counted(static_cast<std::size_t>(failed), "run") + (failed == 1 ? " has" : " have") +
                                  " no solution; the table of runs says why.");
}

using NumberOf = std::function<double(const FilmGridSummary&)>;

ChartPanel errorPanel(const FilmConvergenceTask& task, const std::vector<FilmGridSummary>& summaries,
                      double uncertainty, ChartAxis x, const NumberOf& at, const NumberOf& error)
{
    const Compared of = comparedOf(task);
    ChartPanel panel{std::move(x), {"Error of the " + std::string(of.name), of.unit, of.displayUnit, true}};
    const int own = task.sliders.front().film.nodes[0];
    for (std::size_t m = 0; m < task.methods.size(); ++m) {
        ChartSeries line{.name = task.methods[m].name};
        for (const FilmGridSummary& each : summaries)
            if (each.method == m && at(each) > 0.0 && error(each) > 0.0)
                line.points.push_back({.x = at(each),
                                       .y = error(each),
                                       .label = std::to_string(each.nodes),
                                       .chosen = m == 0 && each.nodes == own});
        if (!line.points.empty()) panel.series.push_back(std::move(line));
    }
    if (uncertainty > 0.0) panel.bands.push_back({false, -INFINITY, uncertainty, "unknown to the reference"});
    return panel;
}

StudyChart errorChart(const FilmConvergenceTask& task, const std::vector<FilmGridSummary>& summaries,
                      double uncertainty, const std::string& title, const NumberOf& error)
{
    StudyChart chart{.title = title,
                     .caption = "Lower is more accurate, left is faster. Numbers: lines of the grid in each direction; "
                                "ringed: the grid of the case. Time: one run alone, from a cold start, with the "
                                "coarser grids that it needs" +
                                std::string(several(task) ? "; median over the sliders" : "") +
                                ". Shaded: the reference, with " + std::to_string(task.reference) +
                                " lines, differs as much from the finest grid of its method.",
                     .panels = {}};
    chart.panels.push_back(errorPanel(
        task, summaries, uncertainty, {"Wall time", "s", "s", true},
        [](const FilmGridSummary& each) { return each.seconds; }, error));
    chart.panels.push_back(errorPanel(
        task, summaries, uncertainty, {"Lines in each direction", "", "", true},
        [](const FilmGridSummary& each) { return double(each.nodes); }, error));
    return chart;
}

/// Of one slider one chart; of several one of the median and one of the largest error.
std::vector<StudyChart> errorCharts(const FilmConvergenceTask& task, const FilmConvergence& study,
                                    const std::vector<FilmGridSummary>& summaries)
{
    const std::vector<double> uncertainties = uncertaintiesOf(study);
    const double largest = uncertainties.empty() ? 0.0 : std::ranges::max(uncertainties);
    const std::string over = " over " + counted(task.sliders.size(), "slider");
    std::vector<StudyChart> charts{
        errorChart(task, summaries, medianOf(uncertainties),
                   several(task) ? "Median error" + over + ", against time and grid" : "Error against time and grid",
                   [](const FilmGridSummary& each) { return each.median; })};
    if (several(task))
        charts.push_back(errorChart(task, summaries, largest, "Largest error" + over + ", against time and grid",
                                    [](const FilmGridSummary& each) { return each.worst; }));
    return charts;
}

/// Points on or above the line have a stated error that is true.
StudyChart statedChart(const FilmConvergenceTask& task, const FilmConvergence& study)
{
    const Compared of = comparedOf(task);
    ChartPanel panel{{"Error found", of.unit, of.displayUnit, true}, {"Error stated", of.unit, of.displayUnit, true}};
    double least = INFINITY, most = 0.0;
    for (std::size_t m = 0; m < task.methods.size(); ++m) {
        ChartSeries series{.name = task.methods[m].name, .line = ChartLine::None};
        for (const FilmRun& run : study.runs) {
            if (run.method != m || !run.ratio() || !(*run.ratio() > 0.0)) continue;
            series.points.push_back({.x = *run.error, .y = *run.state.statedError});
            least = std::min(least, *run.error);
            most = std::max(most, *run.error);
        }
        if (!series.points.empty()) panel.series.push_back(std::move(series));
    }
    if (panel.series.empty()) return {};
    panel.series.push_back({.name = "stated = found",
                            .points = {{.x = least, .y = least}, {.x = most, .y = most}},
                            .markers = false,
                            .quiet = true});
    return {.title = "Stated and found errors",
            .caption = "Each point is one run. Above the line the run states a larger error than it has.",
            .panels = {panel}};
}

} // namespace

StudyReport filmConvergenceReport(const FilmConvergenceTask& task, const FilmConvergence& study)
{
    StudyReport report;
    report.status = study.status;
    report.message = study.message;
    if (several(task)) report.title = "Static films of " + counted(task.sliders.size(), "slider") + " over their grids";
    const std::vector<FilmGridSummary> summaries = summarize(task, study);
    report.tables = {runsOf(task, study), summaryOf(task, summaries), referencesOf(task, study)};
    if (summaries.empty()) return report;
    tellMethods(task, summaries, report);
    tellStated(task, study, report);
    tellReference(task, study, report);
    report.charts = errorCharts(task, study, summaries);
    if (StudyChart stated = statedChart(task, study); !stated.panels.empty()) report.charts.push_back(stated);
    return report;
}

} // namespace touchdown
