// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/damping_bench.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>

#include "core/case_files/case_file.h"
#include "core/case_files/case_settings.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/steady.h"
#include "tests/support/exponential_fit.h"
#include "tests/support/free_oscillation.h"
#include "tests/support/random_slider.h"

namespace touchdown {

namespace {

using Complex = std::complex<double>;

constexpr double highest = 1e6;        // of the modes that are looked at [Hz]
constexpr double skippedPeriods = 2.0; // for what a start has besides the mode
constexpr double samplesPerPeriod = 24.0;

struct NamedCase {
    std::string name;
    Case value;
};

double processorSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Ringing {
    Summary summary;
    double processor = 0.0; // after the static state [s]
    Eigen::VectorXd time;
    Eigen::MatrixXd samples;
};

Ringing ring(const Case& c, double skipped)
{
    Ringing result;
    std::array<std::size_t, 3> columns{};
    const std::array names{"flying_height", "pitch", "roll"};
    for (std::size_t k = 0; k < 3; ++k)
        columns[k] = static_cast<std::size_t>(findQuantity(recordedQuantities(c), names[k]));
    const std::array lengths{1.0, 0.5 * c.slider.length, 0.5 * c.slider.width};
    std::vector<std::array<double, 3>> samples;
    std::optional<double> moving;
    result.summary = run(c, [&](const RunUpdate& update) {
        const auto& values = update.samples.columns;
        for (std::size_t n = 0; n < values[columns[0]].size(); ++n)
            samples.push_back({values[columns[0]][n], values[columns[1]][n], values[columns[2]][n]});
        if (!moving && !samples.empty()) moving = processorSeconds();
        return true;
    });
    result.processor = processorSeconds() - moving.value_or(processorSeconds());
    const auto first = static_cast<std::size_t>(std::ceil(skipped / c.run.sampleInterval));
    const std::size_t count = samples.size() > first ? samples.size() - first : 0;
    result.time.resize(static_cast<Eigen::Index>(count));
    result.samples.resize(static_cast<Eigen::Index>(count), 3);
    for (std::size_t n = 0; n < count; ++n) {
        const auto row = static_cast<Eigen::Index>(n);
        result.time[row] = static_cast<double>(n) * c.run.sampleInterval;
        for (int k = 0; k < 3; ++k)
            result.samples(row, k) =
                lengths[static_cast<std::size_t>(k)] * samples[first + n][static_cast<std::size_t>(k)];
    }
    return result;
}

/// The run of a mode: as long as its motion keeps between a tenth and four times its size, 8 to 60 periods in all.
Case runOf(const Case& c, const AirBearingMode& mode, double amplitude)
{
    Case moved = test::released(c, mode, amplitude);
    const double perPeriod = 2.0 * std::numbers::pi * std::abs(mode.dampingRatio);
    const double periods = std::clamp((mode.dampingRatio > 0.0 ? 2.3 : 1.4) / std::max(perPeriod, 1e-9), 6.0, 58.0);
    const double period = 1.0 / mode.frequency;
    moved.run.sampleInterval = period / samplesPerPeriod;
    moved.run.duration = std::ceil((periods + skippedPeriods) * samplesPerPeriod) * moved.run.sampleInterval;
    return moved;
}

void tell(const NamedCase& named, const std::vector<double>& shares, double amplitude)
{
    const ModesResult found = modes(named.value);
    if (found.status != SteadyStatus::Converged) {
        std::fprintf(stderr, "%s: %s\n", named.name.c_str(), found.message.c_str());
        return;
    }
    std::vector<Complex> rates;
    for (const AirBearingMode& mode : found.modes) rates.push_back(test::rateOf(mode));
    for (std::size_t m = 0; m < found.modes.size(); ++m) {
        const AirBearingMode& mode = found.modes[m];
        if (mode.frequency > highest) continue;
        for (const double share : shares) {
            Case c = runOf(named.value, mode, amplitude);
            c.run.stepError *= share;
            const Ringing run = ring(c, skippedPeriods / mode.frequency);
            if (run.summary.status != RunStatus::Completed || run.time.size() < 8) {
                std::fprintf(stderr, "%s, mode %zu: %s\n", named.name.c_str(), m + 1, run.summary.message.c_str());
                continue;
            }
            const test::ExponentialFit fit(run.time, run.samples);
            const std::vector<Complex> fitted = fit.rates(rates);
            const Complex s = fitted[m];
            const double damping = -s.real() / std::abs(s), difference = damping - mode.dampingRatio;
            const double milliseconds = run.summary.endTime * 1e3;
            std::printf("%s,%zu,%s,%.3f,%.3f,%.5f,%.5f,%.5f,%.2f,%.3f,%.1f,%.2f,%.2g\n", named.name.c_str(), m + 1,
                        mode.kind.c_str(), mode.frequency * 1e-3, s.imag() / (2e3 * std::numbers::pi),
                        100.0 * mode.dampingRatio, 100.0 * damping, 100.0 * difference,
                        100.0 * difference / std::abs(mode.dampingRatio), c.run.stepError * 1e9,
                        static_cast<double>(run.summary.steps) / (run.summary.endTime * mode.frequency),
                        run.processor / milliseconds, fit.left(fitted));
            std::fflush(stdout);
        }
    }
}

} // namespace

int benchmarkDamping(const std::vector<std::string>& casesAndSettings)
{
    std::map<std::string, std::string> own{{"drawn", "0"}, {"seed", "1"}, {"amplitude", "0.2"}, {"step_errors", "1"}};
    std::vector<std::string> names, settings;
    for (const std::string& argument : casesAndSettings) {
        const std::size_t equals = argument.find('=');
        if (equals == std::string::npos)
            names.push_back(argument);
        else if (const auto place = own.find(argument.substr(0, equals)); place != own.end())
            place->second = argument.substr(equals + 1);
        else
            settings.push_back(argument);
    }
    const int drawn = std::atoi(own["drawn"].c_str());
    if (names.empty() && drawn == 0) names = {"film_pico", "film_femto", "film_fig4_pico"};
    std::vector<double> shares;
    std::istringstream list(own["step_errors"]);
    for (std::string each; std::getline(list, each, ',');) shares.push_back(std::strtod(each.c_str(), nullptr));

    std::vector<NamedCase> cases;
    for (const std::string& name : names) {
        CaseDocument document = openCase(name);
        applySettings(document, settings);
        for (const InputProblem& problem : document.problems) std::fprintf(stderr, "%s\n", problem.text().c_str());
        if (!document.valid()) return 2;
        cases.push_back({name.substr(name.rfind('/') + 1), document.value});
    }
    const auto seed = std::strtoull(own["seed"].c_str(), nullptr, 10);
    for (int k = 0; k < drawn; ++k) {
        CaseDocument document;
        document.value = test::RandomSlider(seed + static_cast<unsigned>(k)).draw();
        applySettings(document, settings);
        cases.push_back({"drawn " + std::to_string(seed + static_cast<unsigned>(k)), document.value});
    }
    std::printf("# one thread used; starts with %s nm of the corner that moves most\n", own["amplitude"].c_str());
    std::printf("case,mode,kind,modes [kHz],run [kHz],modes [%%],run [%%],difference [%%],difference of the ratio "
                "[%%],step error [nm],steps per period,processor time [s/ms],left by the fit [-]\n");
    const double amplitude = std::strtod(own["amplitude"].c_str(), nullptr) * 1e-9;
    for (const NamedCase& each : cases) tell(each, shares, amplitude);
    return 0;
}

} // namespace touchdown
