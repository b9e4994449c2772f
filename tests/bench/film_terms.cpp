// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/film_terms.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

#include "core/case_files/case_file.h"
#include "core/case_files/case_settings.h"
#include "core/physics/film/slip_model.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/convergence/node_film.h"

namespace touchdown {

namespace {

constexpr double gramForce = 9.80665e-3; // [N]
constexpr std::array columns{97, 193, 385, 769};
constexpr std::array finestColumns{1025, 1537, 2305}; // where walls a few micrometres wide are resolved

/// One case at its initial attitude, counted in any manner; loads in gf, NaN where no solution was found.
class FilmTerms {
public:
    explicit FilmTerms(const Case& c)
        : case_(c),
          recess_(c.surface, c.slider.length, c.slider.width),
          spacing_(c.surface, recess_),
          attitude_{c.initial.nominalTrailingEdgeHeight, c.initial.pitch, c.initial.roll}
    {
        case_.steady.fixedAttitude = true;
        case_.steady.stiffness = case_.steady.sensitivities = case_.steady.allEquilibria = false;
        case_.film.solver = FilmSolver::Newton;
        case_.film.scheme = ConvectionScheme::CompleteFlux;
    }

    double nodes(int lines, FaceGaps gaps, ConvectionScheme scheme, GridKind kind = GridKind::Uniform,
                 const std::function<void(FilmSetting&)>& change = {}) const
    {
        FilmSetting setting = filmSetting(case_);
        setting.scheme = scheme;
        if (change) change(setting);
        const CellGrid grid = kind == GridKind::Uniform
                                  ? uniform(lines)
                                  : gradedGrid(case_.surface, recess_.length(), recess_.width(), lines - 1, lines - 1);
        const NodeFilmResult result = NodeFilm(recess_, setting, grid, gaps).solve(attitude_);
        return result.converged ? result.load / gramForce : NAN;
    }

    /// Our flow through paths of pieces and our load, on the same nodes: the cells are their control volumes; those of
    /// the nodes on the outline, of half the width, have nodes of their own.
    double controlVolumes(int lines, ConvectionScheme scheme) const
    {
        Case c = case_;
        c.film.scheme = scheme;
        CellGrid cells = uniform(lines);
        for (auto* axis : {&cells.x, &cells.y}) {
            const double end = axis->back();
            for (std::size_t k = axis->size() - 1; k > 0; --k) (*axis)[k] = 0.5 * ((*axis)[k] + (*axis)[k - 1]);
            axis->push_back(end);
        }
        FilmLevel level(c, recess_, spacing_, std::move(cells));
        level.film.setAttitude(attitude_);
        const bool converged = level.flying.solveFilm(level.pressure, {.tolerance = 1e-8}).converged;
        return converged ? level.loads.load(level.pressure)[0] / gramForce : NAN;
    }

    double ours(int lines, GridKind grid) const
    {
        Case c = case_;
        c.film.nodes = {lines, lines};
        c.film.grid = grid;
        const SteadyResult result = steady(c);
        return result.status == SteadyStatus::Converged ? result.forces.net / gramForce : NAN;
    }

private:
    CellGrid uniform(int lines) const
    {
        return uniformGrid(case_.slider.length, case_.slider.width, lines - 1, lines - 1);
    }

    Case case_;
    Recess recess_;
    MinimumSpacing spacing_;
    Attitude attitude_;
};

using Loads = std::array<double, columns.size()>;

Loads onEach(const std::function<double(int)>& load)
{
    Loads loads;
    for (std::size_t k = 0; k < columns.size(); ++k) loads[k] = load(columns[k]);
    return loads;
}

Loads tell(const char* name, const Loads& before, const Loads& loads)
{
    std::printf("%s", name);
    for (std::size_t k = 0; k < columns.size(); ++k) std::printf(",%.4f,%+.4f", loads[k], loads[k] - before[k]);
    std::printf("\n");
    std::fflush(stdout);
    return loads;
}

void tellFinest(const char* name, const std::function<double(int)>& load)
{
    std::printf("%s", name);
    for (const int lines : finestColumns) {
        std::printf(",%.4f", load(lines));
        std::fflush(stdout);
    }
    std::printf("\n");
}

} // namespace

int tellFilmTerms(const std::string& fileOrFolder, const std::vector<std::string>& settings)
{
    CaseDocument document = openCase(fileOrFolder);
    applySettings(document, settings);
    for (const InputProblem& problem : document.problems) std::fprintf(stderr, "%s\n", problem.text().c_str());
    if (!document.valid()) return 2;
    if (document.value.model != ModelKind::Film) {
        std::fprintf(stderr, "%s has no film\n", fileOrFolder.c_str());
        return 2;
    }
    const FilmTerms terms(document.value);
    using enum ConvectionScheme;

    std::printf(
        "# net force at the initial attitude [gf] and what each step changes, by lines along x and along y\nstep");
    for (const int lines : columns) std::printf(",%d,change", lines);
    std::printf("\n");
    const auto nodes = [&](FaceGaps gaps, ConvectionScheme scheme) {
        return [&terms, gaps, scheme](int lines) { return terms.nodes(lines, gaps, scheme); };
    };
    const auto volumes = [&](ConvectionScheme scheme) {
        return [&terms, scheme](int lines) { return terms.controlVolumes(lines, scheme); };
    };
    const auto ours = [&](GridKind grid) { return [&terms, grid](int lines) { return terms.ours(lines, grid); }; };

    const Loads manner = onEach(nodes(FaceGaps::TwoOfSamples, PowerLaw));
    tell("established manner", manner, manner);
    Loads last = manner;
    const auto step = [&last](const char* name, const std::function<double(int)>& load) {
        last = tell(name, last, onEach(load));
    };
    step("whole faces, not samples", nodes(FaceGaps::Two, PowerLaw));
    step("all gaps along a face, not two", nodes(FaceGaps::All, PowerLaw));
    step("exponential, not power law", nodes(FaceGaps::All, Exponential));
    step("gaps along paths, not on faces", volumes(Exponential));
    step("complete flux, not exponential", volumes(CompleteFlux));
    step("cells between lines, not nodes", ours(GridKind::Uniform));
    step("lines on long edges", ours(GridKind::Graded));
    step("adapted grid: ours", ours(GridKind::Adapted));
    tell("sum of all changes", manner, last);

    std::printf("# apart, no part of the difference: what the established manner would change by\n");
    const auto changed = [&](const char* name, const std::function<void(FilmSetting&)>& change) {
        tell(name, manner, onEach([&](int lines) {
                 return terms.nodes(lines, FaceGaps::TwoOfSamples, PowerLaw, GridKind::Uniform, change);
             }));
    };
    changed("uniform disk velocity", [](FilmSetting& setting) { setting.disk.field = VelocityField::Uniform; });
    if (document.value.air.slip.model == SlipModel::FukuiKaneko)
        changed("fit of Fukui and Kaneko",
                [](FilmSetting& setting) { setting.slip.model = SlipModel::FukuiKanekoFit; });

    std::printf("# towards the limit [gf]\nmanner");
    for (const int lines : finestColumns) std::printf(",%d", lines);
    std::printf("\n");
    const auto onEdges = [&](FaceGaps gaps, ConvectionScheme scheme) {
        return [&terms, gaps, scheme](int lines) { return terms.nodes(lines, gaps, scheme, GridKind::Graded); };
    };
    tellFinest("established manner", nodes(FaceGaps::TwoOfSamples, PowerLaw));
    tellFinest("the same with lines on long edges", onEdges(FaceGaps::TwoOfSamples, PowerLaw));
    tellFinest("besides with all gaps along a face and exponential", onEdges(FaceGaps::All, Exponential));
    tellFinest("ours on uniform grids", ours(GridKind::Uniform));
    tellFinest("ours with lines on long edges", ours(GridKind::Graded));
    tellFinest("ours adapted", ours(GridKind::Adapted));
    return 0;
}

} // namespace touchdown
