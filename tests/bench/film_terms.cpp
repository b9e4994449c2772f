// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/film_terms.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

#include <Eigen/LU>
#include <Eigen/QR>

#include "core/simulation/case_file.h"
#include "core/simulation/film_setup.h"
#include "core/simulation/steady.h"
#include "tests/bench/node_film.h"

namespace touchdown {

namespace {

constexpr double gramForce = 9.80665e-3; // [N]
constexpr std::array columns{97, 193, 385, 769};
constexpr std::array limitCells{512, 576, 640, 768, 896, 1024, 1280, 1536};

/// One case at its initial attitude, counted in any manner; loads in gf, NaN where no solution was found.
class FilmTerms {
public:
    explicit FilmTerms(const Case& c)
        : case_(c), recess_(c.surface, c.slider.length, c.slider.width), spacing_(c.surface, recess_),
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
        const NodeFilmResult result = solveNodeFilm(recess_, setting, attitude_, grid, gaps);
        return result.converged ? result.load / gramForce : NAN;
    }

    /// Our flow through paths of pieces, on the same nodes: the cells are their control volumes, those of the nodes on
    /// the outline (of half the width) have nodes of their own.
    double controlVolumes(int lines, ConvectionScheme scheme, bool profiles) const
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
        if (!level.flying.solveFilm(level.pressure, {.tolerance = 1e-8}).converged) return NAN;
        if (profiles) return level.film.load(level.pressure)[0] / gramForce;
        double load = 0.0;
        for (std::size_t at = 0; at < level.pressure.size(); ++at)
            load += (level.pressure[at] - level.film.ambient()) * level.film.areas()[at];
        return load / gramForce;
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
    CellGrid uniform(int lines) const { return uniformGrid(case_.slider.length, case_.slider.width, lines - 1, lines - 1); }

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

/// a of a + b/n + c/n^2 by least squares with weights n^2 (edges scatter loads by some share of 1/n), and its standard error.
void limit(const char* name, const std::function<double(int)>& load)
{
    constexpr Eigen::Index grids = limitCells.size();
    Eigen::Matrix<double, grids, 3> powers;
    Eigen::Matrix<double, grids, 1> loads;
    for (Eigen::Index k = 0; k < grids; ++k) {
        const double n = limitCells[static_cast<std::size_t>(k)];
        powers.row(k) << n, 1.0, 1.0 / n;
        loads(k) = n * load(limitCells[static_cast<std::size_t>(k)] + 1);
    }
    const Eigen::Vector3d fit = powers.colPivHouseholderQr().solve(loads);
    const double variance = (loads - powers * fit).squaredNorm() / static_cast<double>(grids - 3);
    const double error = std::sqrt(variance * (powers.transpose() * powers).inverse()(0, 0));
    std::printf("%s,%.4f,%.4f\n", name, fit(0), error);
    std::fflush(stdout);
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

    std::printf("# net force at the initial attitude [gf] and what each step changes, by lines along x and along y\nstep");
    for (const int lines : columns) std::printf(",%d,change", lines);
    std::printf("\n");
    const auto nodes = [&](FaceGaps gaps, ConvectionScheme scheme) {
        return [&terms, gaps, scheme](int lines) { return terms.nodes(lines, gaps, scheme); };
    };
    const auto volumes = [&](ConvectionScheme scheme, bool profiles) {
        return [&terms, scheme, profiles](int lines) { return terms.controlVolumes(lines, scheme, profiles); };
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
    step("gaps along paths, not on faces", volumes(Exponential, false));
    step("load of profiles across edges", volumes(Exponential, true));
    step("complete flux, not exponential", volumes(CompleteFlux, true));
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
        changed("fit of Fukui and Kaneko", [](FilmSetting& setting) { setting.slip.model = SlipModel::FukuiKanekoFit; });

    std::printf("# limits of nodes with lines on the long edges, by a + b/n + c/n^2 through %zu grids of n = %d to %d; ours at "
                "the last\nmanner,limit [gf],standard error [gf]\n",
                limitCells.size(), limitCells.front(), limitCells.back());
    const auto onEdges = [&](FaceGaps gaps, ConvectionScheme scheme) {
        return [&terms, gaps, scheme](int lines) { return terms.nodes(lines, gaps, scheme, GridKind::Graded); };
    };
    limit("established manner", onEdges(FaceGaps::TwoOfSamples, PowerLaw));
    limit("all gaps along a face; exponential", onEdges(FaceGaps::All, Exponential));
    const int finest = limitCells.back() + 1;
    std::printf("ours with lines on long edges,%.4f,\n", terms.ours(finest, GridKind::Graded));
    std::printf("ours adapted,%.4f,\n", terms.ours(finest, GridKind::Adapted));
    return 0;
}

} // namespace touchdown
