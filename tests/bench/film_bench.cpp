// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/film_bench.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "core/simulation/case_file.h"
#include "core/simulation/steady.h"

namespace touchdown {

namespace {

/// From a cold start each time: geometry, all grids, solution to the case's tolerance. No stiffness matrix.
void row(const std::string& name, Case c, FilmSolver solver, int nodes, int repeats)
{
    c.film.nodes = {nodes, nodes};
    c.film.solver = solver;
    c.steady.stiffness = c.steady.sensitivities = c.steady.allEquilibria = false;
    SteadyResult result = steady(c); // warm-up
    std::vector<double> seconds;
    for (int k = 0; k < repeats; ++k) seconds.push_back((result = steady(c)).wallSeconds);
    std::sort(seconds.begin(), seconds.end());
    std::printf("%s,%s,%s,%d,%.2f,%.2f,%d,%d,%.6f,%.3g,%.5f,%.5f,%.5f,%.3g,%s\n", name.c_str(),
                c.steady.fixedAttitude ? "fixed" : "flying", solver == FilmSolver::Newton ? "newton" : "line-multigrid", nodes,
                seconds.front() * 1e3, seconds[seconds.size() / 2] * 1e3, result.iterations, result.solves,
                result.forces.net / 9.80665e-3, result.discretisationError.load / 9.80665e-3, result.minimumSpacing * 1e9,
                result.attitude.pitch * 1e6, result.attitude.roll * 1e6, result.residual,
                std::string(touchdown::name(result.status)).c_str());
    std::fflush(stdout);
}

void rows(const std::string& name, const Case& c, int repeats)
{
    for (const FilmSolver solver : {FilmSolver::Newton, FilmSolver::LineMultigrid}) {
        if (solver == FilmSolver::LineMultigrid && !c.steady.fixedAttitude) continue; // it solves films at a given attitude
        for (const int nodes : {97, 193, 385}) row(name, c, solver, nodes, repeats);
    }
}

} // namespace

int benchmarkFilm(const std::string& fileOrFolder, int repeats)
{
    std::printf("# one thread used; minimum and median of %d runs after a warm-up\n", repeats);
    std::printf("case,attitude,solver,nodes,minimum [ms],median [ms],iterations,linear iterations,net force [gf],its estimated error [gf],"
                "minimum spacing [nm],pitch [urad],roll [urad],residual,status\n");
    rows("film_plane", openCase("film_plane").value, repeats);
    if (fileOrFolder.empty()) return 0;
    const CaseDocument document = openCase(fileOrFolder);
    for (const InputProblem& problem : document.problems) std::fprintf(stderr, "%s\n", problem.text().c_str());
    if (!document.valid() || document.value.model != ModelKind::Film) return 2;
    Case c = document.value;
    c.film.scheme = ConvectionScheme::CompleteFlux;
    c.steady.fixedAttitude = true;
    c.initial = {.flyingHeight = c.initial.flyingHeight, .pitch = 118e-6, .nominalTrailingEdgeHeight = 7.2e-9, .roll = -2e-6};
    Case fixed = c;
    fixed.air.source = AirSource::Given;
    rows(fileOrFolder, fixed, repeats);
    Case flying = document.value;
    flying.film.scheme = ConvectionScheme::CompleteFlux;
    flying.steady.fixedAttitude = false;
    rows(fileOrFolder, flying, repeats);
    return 0;
}

} // namespace touchdown
