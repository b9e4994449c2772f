// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/family_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <sstream>

#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/numerics/moments.h"
#include "core/physics/film/film_grid.h"
#include "core/physics/slider/edge_ridges.h"
#include "core/physics/slider/recess.h"
#include "core/studies/convergence/convergence.h"
#include "core/studies/convergence/established_film.h"
#include "tests/support/random_slider.h"

namespace touchdown {

namespace {

using Settings = std::map<std::string, std::string>;

/// Whether an edge has a ridge that the default grid does not resolve.
bool hasRidges(const Case& c)
{
    const double length = c.slider.length, width = c.slider.width;
    const CellGrid grid = gradedGrid(c.surface, length, width, c.film.nodes[0] - 1, c.film.nodes[1] - 1);
    return !unresolvedRidges(c.surface, Recess(c.surface, length, width), grid).empty();
}

std::vector<Case> drawFamily(const Settings& settings)
{
    std::vector<Case> sliders;
    const std::string& ridges = settings.at("ridges");
    const auto count = static_cast<std::size_t>(std::max(0, std::atoi(settings.at("sliders").c_str())));
    for (auto seed = std::strtoull(settings.at("seed").c_str(), nullptr, 10); sliders.size() < count; ++seed) {
        Case c = test::RandomSlider(seed).draw();
        if (ridges == "any" || (ridges == "with") == hasRidges(c)) sliders.push_back(std::move(c));
    }
    return sliders;
}

std::vector<int> gridsOf(const Settings& settings)
{
    std::vector<int> grids;
    std::istringstream list(settings.at("grids"));
    for (std::string each; std::getline(list, each, ',');) grids.push_back(std::atoi(each.c_str()));
    std::ranges::sort(grids);
    return grids;
}

/// slider_1.toml, ..., and the studies force.toml and spacing.toml of all of them.
int writeFamily(const std::vector<Case>& sliders, const Settings& settings)
{
    const std::filesystem::path folder = settings.at("write");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::string further;
    std::vector<std::string> problems;
    for (std::size_t i = 0; i < sliders.size(); ++i) {
        const std::string name = "slider_" + std::to_string(i + 1) + ".toml";
        problems.push_back(writeCaseFile(folder / name, formatCase(sliders[i])));
        if (i > 0) further += (i > 1 ? ", \"" : "\"") + name + '"';
    }
    const std::string count = std::to_string(sliders.size());
    for (const bool fixed : {true, false}) {
        const std::string title = fixed ? "Net force of " + count + " sliders at a fixed attitude"
                                        : "Minimum spacing of " + count + " sliders";
        std::string text = "kind = \"convergence\"\ntitle = \"" + title + "\"\ncase = \"slider_1.toml\"\n";
        if (!further.empty()) text += "cases = [" + further + "]\n";
        text += std::string("fixed_attitude = ") + (fixed ? "true" : "false") + "\ngrids = [" + settings.at("grids") +
                "]\nreference = " + settings.at("reference") + "\n";
        problems.push_back(writeCaseFile(folder / (fixed ? "force.toml" : "spacing.toml"), text));
    }
    for (const std::string& problem : problems)
        if (!problem.empty()) {
            std::fprintf(stderr, "%s\n", problem.c_str());
            return 1;
        }
    std::printf("%s: %s sliders, force.toml and spacing.toml\n", folder.c_str(), count.c_str());
    return 0;
}

/// The limit of infinitely many cells, from grids whose cells are each half as large as those of the one before: with
/// the observed order, kept from 1/2 to 3; with first order, as at slanted walls, where the differences do not shrink
/// with one sign.
double limitOf(double coarse, double middle, double fine)
{
    const double last = fine - middle, ratio = (middle - coarse) / last;
    const double order = ratio > 1.0 ? std::clamp(std::log2(ratio), 0.5, 3.0) : 1.0;
    return fine + last / (std::exp2(order) - 1.0);
}

/// On as many lines as the reference has: the limit of this grid and two coarser ones.
FilmMethod extrapolatedAt(int reference, FilmMethod method)
{
    const auto solve = [reference, solveOn = method.solve](const Case& slider, int nodes, const GoOn& goOn) {
        FilmState state = solveOn(slider, nodes, goOn);
        if (nodes != reference || !state.problem.empty()) return state;
        const FilmState coarse = solveOn(slider, (nodes - 1) / 4 + 1, goOn),
                        middle = solveOn(slider, (nodes - 1) / 2 + 1, goOn);
        state.problem = coarse.problem + middle.problem;
        state.netForce = limitOf(coarse.netForce, middle.netForce, state.netForce);
        state.minimumSpacing = limitOf(coarse.minimumSpacing, middle.minimumSpacing, state.minimumSpacing);
        return state;
    };
    return {std::move(method.name), solve};
}

/// The runs of the sliders with ridges, or those without.
FilmConvergence partOf(const FilmConvergenceTask& task, const FilmConvergence& study, bool ridges)
{
    const auto isIn = [&](std::size_t slider) { return hasRidges(task.sliders[slider]) == ridges; };
    FilmConvergence part;
    std::ranges::copy_if(study.runs, std::back_inserter(part.runs),
                         [&](const FilmRun& run) { return isIn(run.slider); });
    for (std::size_t s = 0; s < study.uncertainty.size(); ++s)
        if (isIn(s)) part.uncertainty.push_back(study.uncertainty[s]);
    return part;
}

/// Errors in mN with percent of the preload, or in nm.
void tellRows(const FilmConvergenceTask& task, const FilmConvergence& study, const char* sliders)
{
    const double unit = task.fixedAttitude ? 1e-3 : 1e-9;
    const char* symbol = task.fixedAttitude ? "mN" : "nm";
    const auto share = [&](const FilmRun& run) {
        const Case& slider = task.sliders[run.slider];
        return *run.error / (task.fixedAttitude ? slider.suspension.preload : test::RandomSlider::spacing);
    };
    std::printf("# %s, %s; share: of the preload, or of 14 nm\n",
                task.fixedAttitude ? "net force at a fixed attitude" : "minimum spacing in flight", sliders);
    std::printf("%-24s %5s %4s  %12s %12s  %9s %9s  %9s %9s %6s  %8s\n", "method", "nodes", "runs",
                (std::string("median [") + symbol + "]").c_str(), (std::string("worst [") + symbol + "]").c_str(),
                "median[%]", "worst[%]", "held", "ratio", "least", "time [s]");
    for (const FilmGridSummary& each : summarize(task, study)) {
        std::vector<double> shares;
        for (const FilmRun& run : study.runs)
            if (run.method == each.method && run.nodes == each.nodes && run.error) shares.push_back(share(run));
        const std::string held = std::to_string(each.held) + " of " + std::to_string(each.stated);
        std::printf("%-24s %5d %4zu  %12.4g %12.4g  %9.3f %9.3f  %9s %9.2f %6.2f  %8.3f\n",
                    task.methods[each.method].name.c_str(), each.nodes, each.solved, each.median / unit,
                    each.worst / unit, 1e2 * medianOf(shares), 1e2 * std::ranges::max(shares),
                    each.stated > 0 ? held.c_str() : "-", each.medianRatio.value_or(NAN), each.leastRatio.value_or(NAN),
                    each.seconds);
    }
    std::vector<double> uncertainties;
    for (const auto& uncertainty : study.uncertainty)
        if (uncertainty) uncertainties.push_back(*uncertainty / unit);
    if (!uncertainties.empty())
        std::printf("# the references, %s extrapolated from %d lines, differ from %d lines by %.3g %s in the median, "
                    "%.3g %s at most\n",
                    task.methods.front().name.c_str(), task.reference, task.grids.back(), medianOf(uncertainties),
                    symbol, std::ranges::max(uncertainties), symbol);
    for (const FilmRun& run : study.runs)
        if (!run.state.problem.empty())
            std::printf("# not solved: %s, %s, %d lines: %s\n", task.sliders[run.slider].title.c_str(),
                        task.methods[run.method].name.c_str(), run.nodes, run.state.problem.c_str());
    std::fflush(stdout);
}

/// One line for each run: the reference and the distance from it.
void tellEach(const FilmConvergenceTask& task, const FilmConvergence& study)
{
    const double unit = task.fixedAttitude ? 1e-3 : 1e-9;
    for (const FilmRun& run : study.runs)
        if (run.error)
            std::printf("# %s, %s, %s, %d lines: reference %.5g %s, error %.3g, stated %.3g\n",
                        task.sliders[run.slider].title.c_str(),
                        hasRidges(task.sliders[run.slider]) ? "with ridges" : "without ridges",
                        task.methods[run.method].name.c_str(), run.nodes,
                        resultOf(task, study.references[run.slider]) / unit, task.fixedAttitude ? "mN" : "nm",
                        *run.error / unit, run.state.statedError.value_or(NAN) / unit);
}

} // namespace

int benchmarkFamily(const std::vector<std::string>& arguments)
{
    Settings settings{{"sliders", "10"},    {"seed", "1"}, {"grids", "97,193,385"}, {"reference", "1537"},
                      {"attitude", "both"}, {"jobs", "1"}, {"ridges", "any"},       {"methods", "all"},
                      {"each", "no"},       {"write", ""}};
    for (const std::string& argument : arguments) {
        const std::size_t equals = argument.find('=');
        const auto known = settings.find(argument.substr(0, equals));
        if (equals == std::string::npos || known == settings.end()) {
            std::fprintf(stderr, "%s: is none of the settings of --family\n", argument.c_str());
            return 2;
        }
        known->second = argument.substr(equals + 1);
    }
    const std::vector<Case> sliders = drawFamily(settings);
    if (!settings.at("write").empty()) return writeFamily(sliders, settings);
    const std::string& attitude = settings.at("attitude");
    const int reference = std::atoi(settings.at("reference").c_str());
    for (const bool fixed : {true, false}) {
        if (attitude == (fixed ? "flying" : "fixed")) continue;
        FilmConvergenceTask task{.sliders = sliders,
                                 .fixedAttitude = fixed,
                                 .methods = {extrapolatedAt(reference, steadyMethod("ours", {}))},
                                 .grids = gridsOf(settings),
                                 .reference = reference};
        if (settings.at("methods") == "all") {
            task.methods.push_back(
                steadyMethod("power-law, uniform", {{"film.scheme", "power-law"}, {"film.grid", "uniform"}}));
            task.methods.push_back(establishedMethod());
        }
        const FilmConvergence study = performFilmConvergence(task, std::atoi(settings.at("jobs").c_str()), {});
        if (settings.at("each") == "yes") tellEach(task, study);
        const bool isMixed = settings.at("ridges") == "any";
        tellRows(task, study,
                 isMixed                           ? "all sliders"
                 : settings.at("ridges") == "with" ? "with ridges"
                                                   : "without ridges");
        if (!isMixed) continue;
        tellRows(task, partOf(task, study, true), "with ridges");
        tellRows(task, partOf(task, study, false), "without ridges");
    }
    return 0;
}

} // namespace touchdown
