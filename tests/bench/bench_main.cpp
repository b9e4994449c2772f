// SPDX-License-Identifier: GPL-3.0-or-later
//
// Benchmark: runs the sample cases and prints time, steps and error as CSV.
//
//   touchdown-bench [--case NAME] [--sweep] [--repeats N] [--write-references]
//
//   touchdown-bench [--repeats N] --film [CASE OR FOLDER OF CML FILES]      (tests/bench/film_bench.h)
//
//   touchdown-bench --film-terms CASE-OR-FOLDER [KEY=VALUE]...              (tests/bench/film_terms.h)
//
//   touchdown-bench [--repeats N] --contact                                 (tests/bench/contact_bench.h)
//
//   touchdown-bench --coupled [CASE OR KEY=VALUE]...                        (tests/bench/coupled_bench.h)
//
//   touchdown-bench --damping [CASE OR KEY=VALUE]...                        (tests/bench/damping_bench.h)
//
//   touchdown-bench --family [KEY=VALUE]...                                 (tests/bench/family_bench.h)
//
// The error is that of the flying height every 2 us against a stored reference (tests/bench/reference_<case>.csv), up
// to the time to which the reference is determined. References are made by --write-references: dopri5 at 1e-13, as far
// as rk4-events at a quarter of a nanosecond agrees with it to 1e-5 nm; a bouncing slider loses all memory of its
// start, and beyond that time no method knows the trajectory.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "app/terminal/freed_memory.h"
#include "core/case/integrator_kind.h"
#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/formats/units.h"
#include "core/numerics/cvode.h"
#include "core/simulation/run.h"
#include "core/studies/reader_program.h"
#include "tests/bench/contact_bench.h"
#include "tests/bench/coupled_bench.h"
#include "tests/bench/damping_bench.h"
#include "tests/bench/family_bench.h"
#include "tests/bench/film_bench.h"
#include "tests/bench/film_terms.h"

using namespace touchdown;

namespace {

constexpr double referenceSpacing = 2e-6; // [s]
constexpr double agreement = 1e-5 * 1e-9; // [m]

struct Trajectory {
    std::vector<double> height; // flying height every referenceSpacing [m]
    Summary summary;
};

Trajectory integrate(Case c)
{
    Trajectory trajectory;
    c.run.stepCheck = false;
    const auto column = std::size_t(findQuantity(recordedQuantities(c), "flying_height"));
    const auto stride = static_cast<long long>(std::llround(referenceSpacing / c.run.sampleInterval));
    long long index = 0;
    trajectory.summary = run(c, [&](const RunUpdate& update) {
        for (const double height : update.samples.columns[column])
            if (index++ % stride == 0) trajectory.height.push_back(height);
        return true;
    });
    return trajectory;
}

std::string referenceFile(const std::string& name)
{
    return std::string(TOUCHDOWN_SOURCE_DIR "/tests/bench/reference_") + name + ".csv";
}

std::vector<double> readReference(const std::string& name)
{
    std::ifstream in(referenceFile(name));
    std::vector<double> heights;
    std::string line;
    while (std::getline(in, line)) {
        const std::size_t comma = line.find(',');
        if (line.starts_with('#') || line.starts_with("time") || comma == std::string::npos) continue;
        heights.push_back(std::strtod(line.c_str() + comma + 1, nullptr) * 1e-9);
    }
    return heights;
}

bool writeReference(const std::string& name, Case c)
{
    c.run.integrator = IntegratorKind::Dopri5;
    c.run.tolerance = 1e-13;
    const Trajectory tight = integrate(c);
    c.run.integrator = IntegratorKind::Rk4Events;
    c.run.step = 0.25e-9;
    const Trajectory other = integrate(c);
    std::size_t determined = 0;
    while (determined < std::min(tight.height.size(), other.height.size()) &&
           std::abs(tight.height[determined] - other.height[determined]) <= agreement)
        ++determined;
    std::ofstream out(referenceFile(name));
    out << "# " << name << ": dopri5 at 1e-13, agreeing with rk4-events at 0.25 ns to 1e-5 nm up to its last row\n";
    out << "time [us],flying_height [nm]\n";
    for (std::size_t i = 0; i < determined; ++i) {
        char row[64];
        std::snprintf(row, sizeof row, "%zu,%.9f\n", 2 * i, tight.height[i] * 1e9);
        out << row;
    }
    std::fprintf(stderr, "%s: determined to %zu us of %g us\n", name.c_str(),
                 determined == 0 ? 0 : 2 * (determined - 1), c.run.duration * 1e6);
    return bool(out.flush());
}

std::string processor()
{
    std::ifstream in("/proc/cpuinfo");
    std::string line;
    while (std::getline(in, line))
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

void benchmark(const std::string& name, const Case& c, int repeats)
{
    const std::vector<double> reference = readReference(name);
    const Trajectory trajectory = integrate(c); // also the warm-up
    double sum = 0.0;
    double worst = 0.0;
    const std::size_t count = std::min(reference.size(), trajectory.height.size());
    for (std::size_t i = 0; i < count; ++i) {
        const double error = std::abs(trajectory.height[i] - reference[i]);
        sum += error * error;
        worst = std::max(worst, error);
    }
    std::vector<double> seconds;
    for (int i = 0; i < repeats; ++i) {
        seconds.push_back(integrate(c).summary.solverSeconds);
        if (seconds.front() > 2.0) break;
    }
    std::sort(seconds.begin(), seconds.end());
    const Summary& summary = trajectory.summary;
    const bool adaptive = !hasFixedStep(c.run.integrator);
    const std::string setting =
        adaptive ? toText(c, *findParameter("run.tolerance")) : toText(c, *findParameter("run.step"));
    double end = NAN;
    for (const auto& [quantity, value] : summary.final)
        if (quantity == "flying_height") end = value;
    std::printf("%s,%s,%s,%.4f,%.4f,%lld,%lld,%lld,%zu,%.3g,%.3g,%zu,%.5f,%s\n", name.c_str(),
                toText(c, *findParameter("run.integrator")).c_str(), setting.c_str(), seconds.front() * 1e3,
                seconds[seconds.size() / 2] * 1e3, summary.steps, summary.rejectedSteps, summary.evaluations,
                summary.events.size(), count > 0 ? std::sqrt(sum / double(count)) * 1e9 : NAN, worst * 1e9,
                count > 0 ? 2 * (count - 1) : 0, end * 1e9, std::string(touchdown::name(summary.status)).c_str());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    if (const auto code = touchdown::runReader(argc, argv)) return *code;
    touchdown::keepFreedMemory();
    std::string only;
    bool sweep = false;
    bool write = false;
    int repeats = 7;
    for (int i = 1; i < argc; ++i) {
        const bool more = i + 1 < argc;
        if (std::strcmp(argv[i], "--case") == 0 && more)
            only = argv[++i];
        else if (std::strcmp(argv[i], "--repeats") == 0 && more)
            repeats = std::max(1, std::atoi(argv[++i]));
        else if (std::strcmp(argv[i], "--sweep") == 0)
            sweep = true;
        else if (std::strcmp(argv[i], "--write-references") == 0)
            write = true;
        else if (std::strcmp(argv[i], "--contact") == 0)
            return benchmarkContact(repeats);
        else if (std::strcmp(argv[i], "--coupled") == 0)
            return benchmarkCoupled({argv + i + 1, argv + argc});
        else if (std::strcmp(argv[i], "--damping") == 0)
            return benchmarkDamping({argv + i + 1, argv + argc});
        else if (std::strcmp(argv[i], "--family") == 0)
            return benchmarkFamily({argv + i + 1, argv + argc});
        else if (std::strcmp(argv[i], "--film") == 0)
            return benchmarkFilm(more ? argv[i + 1] : "", repeats);
        else if (std::strcmp(argv[i], "--film-terms") == 0 && more)
            return tellFilmTerms(argv[i + 1], {argv + i + 2, argv + argc});
        else {
            std::fprintf(stderr, "usage: touchdown-bench [--case NAME] [--sweep] [--repeats N] [--write-references]\n"
                                 "       touchdown-bench [--repeats N] --film [CASE OR FOLDER OF CML FILES]\n"
                                 "       touchdown-bench --film-terms CASE-OR-FOLDER [KEY=VALUE]...\n"
                                 "       touchdown-bench [--repeats N] --contact\n"
                                 "       touchdown-bench --coupled [CASE OR KEY=VALUE]...\n"
                                 "       touchdown-bench --damping [CASE OR KEY=VALUE]...\n"
                                 "       touchdown-bench --family [KEY=VALUE]...\n");
            return std::strcmp(argv[i], "--help") == 0 ? 0 : 2;
        }
    }

    if (!write) {
        std::printf(
            "# touchdown %s, %s, %u threads (one used), GCC %s, minimum and median of %d runs after a warm-up\n",
            TOUCHDOWN_VERSION, processor().c_str(), std::thread::hardware_concurrency(), __VERSION__, repeats);
        std::printf("case,integrator,setting,minimum [ms],median [ms],steps,rejected,evaluations,switches,L2 error "
                    "[nm],largest error [nm],"
                    "reference to [us],end [nm],status\n");
    }
    bool found = false;
    for (const SampleCase& sample : sampleCases()) {
        if (!only.empty() && sample.name != only) continue;
        const CaseDocument document = parseCase(sample.text, sample.name);
        if (document.value.model != ModelKind::Springs) continue; // this benchmark is of integrators
        found = true;
        if (write) {
            if (!writeReference(sample.name, document.value)) {
                std::fprintf(stderr, "%s cannot be written\n", referenceFile(sample.name).c_str());
                return 1;
            }
            continue;
        }
        const std::vector<double> tolerances = sweep ? std::vector{1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11}
                                                     : std::vector{document.value.run.tolerance};
        const std::vector<double> steps =
            sweep ? std::vector{100e-9, 50e-9, 20e-9, 10e-9, 5e-9, 2e-9, 1e-9} : std::vector{document.value.run.step};
        for (const IntegratorKind kind : {IntegratorKind::Dopri5, IntegratorKind::Rk4, IntegratorKind::Rk4Events,
                                          IntegratorKind::Newmark, IntegratorKind::Cvode}) {
            Case c = document.value;
            c.run.integrator = kind;
            if (kind == IntegratorKind::Cvode && !haveCvode) continue;
            const bool adaptive = !hasFixedStep(kind);
            for (const double value : adaptive ? tolerances : steps) {
                (adaptive ? c.run.tolerance : c.run.step) = value;
                benchmark(sample.name, c, repeats);
            }
        }
    }
    if (!found) {
        std::fprintf(stderr, "there is no sample case %s\n", only.c_str());
        return 2;
    }
    return 0;
}
