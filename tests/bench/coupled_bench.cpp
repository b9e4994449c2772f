// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/coupled_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <optional>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_settings.h"
#include "core/simulation/run.h"

namespace touchdown {

namespace {

constexpr std::array stepErrors{1e-10, 1e-11, 1e-12,
                                1e-13}; // each is compared with the next, the last one has no row [m]

struct BenchCase {
    std::string name;
    std::vector<std::string> settings;
};

/// The free sliders begin 1 nm above their static state; all begin with their first 0.1 ms.
std::vector<BenchCase> defaultCases()
{
    const std::vector<std::string> kick{"initial.state=static", "initial.height_offset=1 nm", "run.duration=0.1 ms"};
    return {{"film_pico", kick},
            {"film_femto", kick},
            {"fig08_start_10nm", {"run.duration=0.1 ms"}},
            {"fig02_micro_pad_case_2_moving", {"run.duration=0.1 ms"}}};
}

double processorSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double wallSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The most memory that was resident since it was last forgotten; see proc(5) [MB].
double peakMemory()
{
    std::ifstream in("/proc/self/status");
    std::string line;
    while (std::getline(in, line))
        if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) * 1024e-6;
    return NAN;
}

void forgetPeakMemory() { std::ofstream("/proc/self/clear_refs") << "5"; }

struct Timed {
    Summary summary;
    double staticSeconds = 0.0, processor = 0.0, wall = 0.0; // the last two after the static state [s]
    double memory = 0.0;                                     // [MB]
    std::vector<double> spacing;                             // [m]
};

Timed timed(const Case& c)
{
    Timed result;
    const auto column = static_cast<std::size_t>(findQuantity(recordedQuantities(c), "minimum_spacing"));
    forgetPeakMemory();
    const double begin = wallSeconds();
    std::optional<std::array<double, 2>> moving; // processor and wall, when the slider began to move
    result.summary = run(c, [&](const RunUpdate& update) {
        const std::vector<double>& values = update.samples.columns[column];
        if (!moving && !values.empty()) moving = {processorSeconds(), wallSeconds()};
        result.spacing.insert(result.spacing.end(), values.begin(), values.end());
        return true;
    });
    const double end = wallSeconds();
    if (!moving) moving = {processorSeconds(), end};
    result.staticSeconds = (*moving)[1] - begin;
    result.processor = processorSeconds() - (*moving)[0];
    result.wall = end - (*moving)[1];
    result.memory = peakMemory();
    return result;
}

double figure(const Summary& summary, const char* name)
{
    for (const RunFigure& figure : summary.figures)
        if (figure.quantity.name == name) return figure.value;
    return NAN;
}

void tell(const std::string& name, double stepError, const Timed& run, const Timed& finer)
{
    const Summary& summary = run.summary;
    const double milliseconds = summary.endTime * 1e3;
    double largest = 0.0, squares = 0.0;
    const std::size_t count = std::min(run.spacing.size(), finer.spacing.size());
    for (std::size_t k = 0; k < count; ++k) {
        const double error = std::abs(run.spacing[k] - finer.spacing[k]);
        largest = std::max(largest, error);
        squares += error * error;
    }
    std::printf("%s,%g,%.2f,%.2f,%.2f", name.c_str(), stepError * 1e9, run.staticSeconds, run.processor / milliseconds,
                run.wall / milliseconds);
    const std::array<double, 7> counts{static_cast<double>(summary.steps), static_cast<double>(summary.rejectedSteps),
                                       figure(summary, "film_solves"),     static_cast<double>(summary.evaluations),
                                       figure(summary, "linearisations"),  figure(summary, "contact_solves"),
                                       figure(summary, "contact_skipped")};
    for (const double value : counts) std::printf(",%.0f", value / milliseconds);
    double rest = run.wall;
    for (const char* part : {"film_time", "response_time", "force_time", "contact_time", "disk_time"}) {
        const double seconds = figure(summary, part);
        rest -= seconds;
        std::printf(",%.1f", 100.0 * seconds / run.wall);
    }
    std::printf(",%.1f,%.0f,%.2g,%.2g,%.2g,%s\n", 100.0 * rest / run.wall, run.memory, largest * 1e9,
                std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count, 1))) * 1e9,
                figure(summary, "energy_balance"), std::string(touchdown::name(summary.status)).c_str());
    std::fflush(stdout);
    if (!summary.message.empty()) std::fprintf(stderr, "%s: %s\n", name.c_str(), summary.message.c_str());
}

void rows(const std::string& name, Case c)
{
    std::optional<Timed> last;
    double lastError = 0.0;
    c.run.steps = StepControl::Adaptive;
    for (const double stepError : stepErrors) {
        c.run.stepError = stepError;
        Timed next = timed(c);
        if (last) tell(name, lastError, *last, next);
        last = std::move(next);
        lastError = stepError;
    }
}

} // namespace

int benchmarkCoupled(const std::vector<std::string>& casesAndSettings)
{
    std::vector<BenchCase> cases;
    std::vector<std::string> settings;
    for (const std::string& argument : casesAndSettings)
        if (argument.find('=') == std::string::npos)
            cases.push_back({argument, {}});
        else
            settings.push_back(argument);
    if (cases.empty()) cases = defaultCases();

    std::vector<std::pair<std::string, Case>> runs;
    for (const BenchCase& bench : cases) {
        CaseDocument document = openCase(bench.name);
        applySettings(document, bench.settings);
        applySettings(document, settings);
        for (const InputProblem& problem : document.problems) std::fprintf(stderr, "%s\n", problem.text().c_str());
        if (!document.valid()) return 2;
        const std::string reason =
            document.value.model == ModelKind::Film ? reasonNotToRun(document.value) : "it has no film";
        if (!reason.empty()) {
            std::fprintf(stderr, "%s: %s\n", bench.name.c_str(), reason.c_str());
            return 2;
        }
        runs.emplace_back(bench.name, document.value);
    }

    std::printf("# one thread used; counts and times of a simulated ms; errors of the minimum spacing against a tenth "
                "of the step error\n");
    std::printf(
        "case,step error [nm],static state [s],processor time [s/ms],wall time [s/ms],steps,rejected,film solves,film "
        "iterations,linearisations,contact solves,contact skipped,film [%%],responses [%%],forces [%%],contact "
        "[%%],disk "
        "[%%],rest [%%],peak memory [MB],largest error [nm],rms error [nm],energy balance [-],status\n");
    for (const auto& [name, c] : runs) rows(name, c);
    return 0;
}

} // namespace touchdown
