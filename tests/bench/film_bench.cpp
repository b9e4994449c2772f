// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/film_bench.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/case_files/case_file.h"
#include "core/physics/film/film_energy.h"
#include "core/physics/film/film_step.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady.h"

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
                c.steady.fixedAttitude ? "fixed" : "flying", solver == FilmSolver::Newton ? "newton" : "line-multigrid",
                nodes, seconds.front() * 1e3, seconds[seconds.size() / 2] * 1e3, result.iterations, result.solves,
                result.forces.net / 9.80665e-3, result.discretisationError.load / 9.80665e-3,
                result.minimumSpacing * 1e9, result.attitude.pitch * 1e6, result.attitude.roll * 1e6, result.residual,
                std::string(touchdown::name(result.status)).c_str());
    std::fflush(stdout);
}

void rows(const std::string& name, const Case& c, int repeats)
{
    for (const FilmSolver solver : {FilmSolver::Newton, FilmSolver::LineMultigrid}) {
        if (solver == FilmSolver::LineMultigrid && !c.steady.fixedAttitude)
            continue; // it solves films at a given attitude
        for (const int nodes : {97, 193, 385}) row(name, c, solver, nodes, repeats);
    }
}

/// At the fixed attitude of the figures that others publish.
Case fixedCase(Case c)
{
    c.film.scheme = ConvectionScheme::CompleteFlux;
    c.steady.fixedAttitude = true;
    c.steady.stiffness = false;
    c.initial = {
        .flyingHeight = c.initial.flyingHeight, .pitch = 118e-6, .nominalTrailingEdgeHeight = 7.2e-9, .roll = -2e-6};
    c.air.source = AirSource::Given;
    return c;
}

void caseRows(const std::string& name, const Case& c, int repeats)
{
    rows(name, fixedCase(c), repeats);
    Case flying = c;
    flying.film.scheme = ConvectionScheme::CompleteFlux;
    flying.steady.fixedAttitude = false;
    rows(name, flying, repeats);
}

/// The film under a slider whose height moves by a hundredth and its pitch by three thousandths, at 100 and 50 kHz.
struct MovingFilm {
    GasFilm film;
    const FilmGaps& gaps; // of the film
    FilmLoads loads;
    Attitude rest;
    std::vector<double> pressure; // padded [Pa]

    MovingFilm(const Case& c, const SteadyResult& steady)
        : film(steady.gaps, filmSetting(c)),
          gaps(film.gaps()),
          loads(film),
          rest(steady.attitude),
          pressure(gaps.pad.size(), film.ambient())
    {
        film.setAttitude(rest);
        gaps.pad.pad<double>(steady.pressure, pressure);
        FilmNewton(film).solve(pressure, {.tolerance = 1e-10});
    }

    struct Result {
        std::vector<double> seconds, load, end; // of each step [s], [N], last pressures [Pa]
        int iterations = 0, solves = 0, linearisations = 0, failures = 0;
    };
    /// Loads at every `stride`-th step.
    Result run(double dt, int count, int stride, const FilmStepOptions& options)
    {
        Result result;
        film.setStorage(0.0, {});
        film.setAttitude(rest);
        FilmStepper stepper(film, options);
        stepper.start(pressure);
        for (int k = 1; k <= count; ++k) {
            const double phase = 2.0 * std::numbers::pi * 100e3 * k * dt;
            const Attitude attitude{rest.height * (1.0 + 0.005 * (1.0 - std::cos(phase))),
                                    rest.pitch * (1.0 + 0.0015 * (1.0 - std::cos(0.5 * phase))), rest.roll};
            const auto begin = std::chrono::steady_clock::now();
            const FilmStepResult step = stepper.step(dt, attitude);
            result.failures += !stepper.accept();
            result.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
            result.iterations += step.iterations;
            result.solves += step.solves;
            result.linearisations += step.linearisations;
            if (k % stride == 0) result.load.push_back(loads.load(stepper.pressure())[0]);
        }
        result.end.assign(stepper.pressure().begin(), stepper.pressure().end());
        return result;
    }
};

double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
    return largest;
}

/// Time of implicit steps, and what they leave: against the same steps solved to round-off, beside the error of these
/// in time.
void stepRow(const std::string& name, Case c, int repeats)
{
    constexpr double dt = 1e-7;             // [s]
    constexpr int nodes = 195, count = 100; // 194 x 194 cells
    c.film.nodes = {nodes, nodes};
    c.steady.stiffness = c.steady.sensitivities = c.steady.allEquilibria = false;
    MovingFilm moving(c, steady(c));
    const FilmStepOptions tight{.tolerance = 1e-12, .share = 0.0, .maximumIterations = 40};
    const MovingFilm::Result exact = moving.run(dt / 4, 4 * count, 4, tight), inTime = moving.run(dt, count, 1, tight);
    MovingFilm::Result result;
    std::vector<double> mean, median;
    for (int k = 0; k < repeats; ++k) {
        result = moving.run(dt, count, 1, {});
        std::sort(result.seconds.begin(), result.seconds.end());
        median.push_back(result.seconds[count / 2]);
        mean.push_back(std::accumulate(result.seconds.begin(), result.seconds.end(), 0.0) / count);
    }
    const double gramForce = 9.80665e-3;
    std::printf(
        "%s,%g,%.3f,%.3f,%.2f,%.2f,%.2f,%.2e,%.2e,%.2e,%.2e,%d\n", name.c_str(), dt * 1e6,
        *std::min_element(mean.begin(), mean.end()) * 1e3, *std::min_element(median.begin(), median.end()) * 1e3,
        double(result.iterations) / count, double(result.solves) / count, double(result.linearisations) / count,
        largestDifference(result.load, inTime.load) / gramForce, largestDifference(inTime.load, exact.load) / gramForce,
        largestDifference(result.end, inTime.end) / moving.film.ambient(),
        largestDifference(inTime.end, exact.end) / moving.film.ambient(), result.failures);
    std::fflush(stdout);
}

/// Time of the parts of a step that moves the slider too, each the least of many.
void partRow(const std::string& name, Case c, int repeats)
{
    c.film.nodes = {195, 195}; // 194 x 194 cells
    c.steady.stiffness = c.steady.sensitivities = c.steady.allEquilibria = false;
    MovingFilm moving(c, steady(c));
    GasFilm& film = moving.film;
    FilmLoads& loads = moving.loads;
    AttitudeWork work(film.gaps());
    const std::vector<double>& p = moving.pressure;
    std::vector<double> residual(p.size());
    std::array<std::vector<double>, 3> columns;
    FilmLoads::Derivatives slopes;
    FilmEnergy energy(film);
    const auto tell = [repeats](const auto& part) {
        double least = 1e9;
        for (int k = 0; k < 20 * repeats; ++k) {
            const auto begin = std::chrono::steady_clock::now();
            part();
            least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        }
        std::printf(",%.3f", least * 1e3);
    };
    std::printf("%s", name.c_str());
    tell([&] { film.setAttitude(moving.rest); });
    tell([&] { film.residual(p, residual); });
    tell([&] { loads.loadAndShear(p); });
    tell([&] { energy.at(p); });
    tell([&] { film.linearise(p, residual); });
    tell([&] { loads.derivatives(p, slopes); });
    tell([&] { film.attitudeColumns(p, columns, work); });
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace

int benchmarkFilm(const std::string& fileOrFolder, int repeats)
{
    std::printf("# one thread used; minimum and median of %d runs after a warm-up\n", repeats);
    std::printf("case,attitude,solver,nodes,minimum [ms],median [ms],iterations,linear iterations,net force [gf],its "
                "estimated error [gf],"
                "minimum spacing [nm],pitch [urad],roll [urad],residual,status\n");
    rows("film_plane", openCase("film_plane").value, repeats);
    CaseDocument document;
    if (!fileOrFolder.empty()) {
        document = openCase(fileOrFolder);
        for (const InputProblem& problem : document.problems) std::fprintf(stderr, "%s\n", problem.text().c_str());
        if (!document.valid() || document.value.model != ModelKind::Film) return 2;
        caseRows(fileOrFolder, document.value, repeats);
    }
    std::printf("# implicit steps of the film of a moving slider, 194 x 194 cells; minimum over %d runs of 100 steps\n",
                repeats);
    std::printf("case,step [us],mean [ms],median [ms],residuals a step,factor solves or cycles,linearisations,largest "
                "load error of the "
                "solver [gf],of the step [gf],largest pressure error of the solver [-],of the step [-],failures\n");
    for (const char* name : {"film_plane", "film_pico", "film_femto"}) stepRow(name, openCase(name).value, repeats);
    if (!fileOrFolder.empty()) stepRow(fileOrFolder, fixedCase(document.value), repeats);
    std::printf("# parts of the step of a slider on its film, 194 x 194 cells; the first four at each step, the others "
                "at some [ms]\n");
    std::printf("case,gaps,residual,forces,energy,linearisation,derivatives of forces,of the residual by attitude\n");
    for (const char* name : {"film_plane", "film_pico", "film_femto"}) partRow(name, openCase(name).value, repeats);
    if (!fileOrFolder.empty()) partRow(fileOrFolder, fixedCase(document.value), repeats);
    return 0;
}

} // namespace touchdown
