// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/response.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/physics/disk/disk_surface_check.h"
#include "core/simulation/equilibria/spring_equilibria.h"
#include "core/simulation/run.h"
#include "core/studies/response/response_report.h"
#include "core/studies/runs/parallel.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

constexpr int jumpHalvings = 6;                                // of the interval in which a jump lies
constexpr double leastFrequency = 100.0, mostFrequency = 1e8;  // [Hz]
constexpr double leastAmplitude = 1e-15, mostAmplitude = 1e-3; // of the wave [m]
constexpr double standardAmplitude = 0.5e-9;                   // [m]
constexpr double longestWave = 1.0;                            // [m]
constexpr double belowModes = 0.5, aboveModes = 1.5;           // default range, in frequencies of the modes [-]

/// What is recorded over a wave.
std::vector<Quantity> quantitiesOverWave(Case c)
{
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    return SpringModel::quantities(c);
}

/// From half of the lowest frequency of the static state to 1.5 times the highest [Hz]; nothing without a mode.
std::optional<ValueRange> defaultFrequencies(const Case& c)
{
    if (c.model != ModelKind::Springs) return {};
    Case flat = c;
    flat.diskSurface.kind = DiskSurfaceKind::Flat;
    const SpringModel model(flat);
    double lowest = mostFrequency, highest = 0.0;
    for (const std::complex<double> value : eigenvaluesAt(model, model.staticState().head<2>(), {})) {
        const double frequency = value.imag() / (2.0 * std::numbers::pi);
        if (!(frequency > 2.0 * leastFrequency)) continue;
        lowest = std::min(lowest, frequency);
        highest = std::max(highest, frequency);
    }
    if (!(highest > 0.0)) return {};
    return ValueRange{roundedTo(belowModes * lowest, 2), roundedTo(std::min(aboveModes * highest, mostFrequency), 2)};
}

double defaultAmplitude(const Case& c)
{
    const std::vector<double>& given = c.diskSurface.waveAmplitudes;
    const bool hasWave = hasWaves(c.diskSurface) && !given.empty() && given.front() != 0.0;
    return hasWave ? std::abs(given.front()) : standardAmplitude;
}

class ResponsePerformance {
public:
    ResponsePerformance(const ResponseTask& task, const StudyCallback& callback) : task_(task), callback_(callback) {}

    StudyReport perform()
    {
        const std::size_t count = task_.frequencies.size();
        result_.linear.resize(count);
        result_.points.resize(2 * count);
        bool whole = runParallel(
            1, 1, [this](std::size_t, const GoOn& goOn) { sweep(goOn); }, [this](std::size_t) { return tell(); });
        StudyReport report = responseReport(task_, result_);
        if (!whole) {
            report.status = StudyStatus::Cancelled;
            report.message = "stopped before all frequencies were done";
            report.findings.clear();
        } else if (std::ranges::none_of(result_.points, [](const ResponsePoint& at) { return at.motion.valid(); })) {
            report.status = StudyStatus::Failed;
            report.message = "no motion is valid: " + result_.points.front().motion.problem;
            report.findings.clear();
        }
        return report;
    }

private:
    void sweep(const GoOn& goOn)
    {
        ResponseTask task = task_;
        task.settle.goOn = goOn;
        const std::size_t count = task_.frequencies.size();
        std::optional<ForcedState> last;
        for (std::size_t i = 0; i < 2 * count && goOn(); ++i) {
            ResponsePoint point;
            point.down = i >= count;
            const std::size_t place = point.down ? 2 * count - 1 - i : i;
            const ForcedSprings springs = task.springsAt(task.frequencies[place]);
            const std::optional<std::complex<double>> linear = point.down ? result_.linear[place] : springs.linear();
            point.anew = i > 0 && !last;
            point.motion = settledMotion(springs, last.value_or(springs.start()), task.settle);
            point.motion.frequency = task.frequencies[place]; // without the round-off of its period
            if (!goOn()) return;
            last = point.motion.valid() ? std::optional(point.motion.end) : std::nullopt;
            point.done = true;
            const std::lock_guard lock(mutex_);
            result_.linear[place] = linear;
            result_.points[i] = std::move(point);
            ++done_;
        }
        std::vector<ResponseJump> jumps = jumpsOf(task, result_, jumpHalvings);
        const std::lock_guard lock(mutex_);
        result_.jumps = std::move(jumps);
    }

    bool tell()
    {
        if (!callback_) return true;
        const std::lock_guard lock(mutex_);
        const std::size_t all = result_.points.size();
        StudyProgress progress{.share = double(done_) / double(all),
                               .doing = std::string(2 * done_ < all ? "up, " : "down, ") + std::to_string(done_) +
                                        " of " + std::to_string(all) + " points",
                               .soFar = nullptr};
        std::optional<StudyReport> soFar;
        if (done_ > told_) {
            soFar = responseReport(task_, result_);
            soFar->findings.clear();
            progress.soFar = &*soFar;
            told_ = done_;
        }
        return callback_(progress);
    }

    const ResponseTask& task_;
    const StudyCallback& callback_;
    std::mutex mutex_; // of all below
    ResponseResult result_;
    std::size_t done_ = 0, told_ = 0;
};

/// Why one end of the range cannot be had, reported at its key.
void checkEnd(StudyReader& reader, const ResponseTask& task, const char* name, double frequency)
{
    const Case over = caseOverWave(task.start, task.amplitude, frequency, task.wavelength);
    if (over.diskSurface.waveLengths.front() > longestWave)
        reader.add(name, "makes the waves longer than 1 m at the speed of the disk: a higher frequency is needed");
    const Parameter& speed = *findParameter("disk.speed");
    if (over.disk.speed > speed.maximum)
        reader.add(name, "makes disk.speed " + fewDigits(over.disk.speed, "rpm", 3) +
                             " with this wavelength; at most " + fewDigits(speed.maximum, "rpm", 3) + " is allowed");
    for (const CaseProblem& problem : checkCombinations(over)) reader.add(name, problem.key + ": " + problem.message);
}

} // namespace

StudyPerformance planResponse(StudyReader& reader)
{
    ResponseTask task;
    task.start = reader.start();
    if (task.start.model != ModelKind::Springs) {
        reader.add("case", "is not of model \"springs\": a study of forced motion takes the slider with two degrees of "
                           "freedom");
        return {};
    }
    if (!(std::abs(speedAlong(task.start)) > 0.0)) {
        reader.add("case", "has a disk that does not move along the slider, so that no waves pass (disk.speed, "
                           "disk.radius)");
        return {};
    }
    if (const std::string reason = reasonNotToRun(task.start); !reason.empty()) reader.add("case", reason);
    const std::optional<ValueRange> standard = defaultFrequencies(task.start);
    const auto end = [&](const char* name, double ValueRange::*which) -> std::optional<double> {
        if (reader.has(name) || standard) {
            const auto given = reader.number(name, "Hz", "kHz", leastFrequency, mostFrequency);
            return given || reader.has(name) ? given : std::optional((*standard).*which);
        }
        reader.add(name, "is missing: the case has no mode that vibrates, from which it would follow");
        return {};
    };
    const std::optional<double> from = end("from", &ValueRange::lower), to = end("to", &ValueRange::upper);
    const int steps = reader.integer("steps");
    const std::string quantity = reader.choice("quantity");
    task.amplitude = reader.number("amplitude");
    const std::optional<double> wavelength = reader.number("wavelength", "m", "um", 1e-9, longestWave);
    const bool wrongLength = reader.has("wavelength") && !wavelength;
    task.wavelength = wavelength.value_or(0.0);
    task.settle.mostPeriods = reader.integer("periods");
    task.settle.longestPeriod = reader.integer("longest_period");
    if (!from || !to || wrongLength) return {};
    if (!(*from < *to)) {
        reader.add("to", "must be greater than from: the way leads up first");
        return {};
    }
    const std::vector<Quantity> all = quantitiesOverWave(task.start);
    task.quantity = all[static_cast<std::size_t>(std::max(0, findQuantity(all, quantity)))];
    checkEnd(reader, task, "from", *from);
    checkEnd(reader, task, "to", *to);
    for (int i = 0; i <= steps; ++i) task.frequencies.push_back(std::lerp(*from, *to, double(i) / steps));
    return [task](int, const StudyCallback& callback) { return ResponsePerformance(task, callback).perform(); };
}

StudyForm responseForm(const Case& c)
{
    const std::optional<ValueRange> range = defaultFrequencies(c);
    const auto end = [&](double ValueRange::*which) {
        return range ? StudyDefault((*range).*which) : StudyDefault(std::monostate{});
    };
    std::vector<std::string> quantities;
    for (const Quantity& each : quantitiesOverWave(c)) quantities.push_back(each.name);
    StudyForm form;
    form.keys = {
        numberKey("from", end(&ValueRange::lower), "Hz", "kHz", leastFrequency, mostFrequency,
                  "the lowest frequency, with which the study begins and ends"),
        numberKey("to", end(&ValueRange::upper), "Hz", "kHz", leastFrequency, mostFrequency, "the highest frequency"),
        integerKey("steps", 60, 1, 2000, "from one end to the other"),
        choiceKey("quantity", "flying_height", std::move(quantities), "whose amplitude and phase are taken"),
        numberKey("amplitude", defaultAmplitude(c), "m", "nm", leastAmplitude, mostAmplitude,
                  "of the waves, which replace the surface of the case"),
        numberKey("wavelength", std::monostate{}, "m", "um", 1e-9, longestWave,
                  "of the waves, if it is held and the speed of the disk changes instead"),
        integerKey("periods", 1000, 10, 1000000, "of the forcing within which the motion must settle"),
        integerKey("longest_period", 8, 1, 64, "in periods of the forcing, after which a motion may repeat"),
    };
    form.remark =
        "The speed of the disk is held and the length of its waves changes. With wavelength = \"50 um\" that is "
        "the length of the waves, and the speed changes.";
    return form;
}

} // namespace touchdown
