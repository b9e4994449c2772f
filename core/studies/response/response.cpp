// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/response.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/physics/disk/disk_surface_check.h"
#include "core/simulation/equilibria/spring_equilibria.h"
#include "core/simulation/run.h"
#include "core/studies/response/forced_film.h"
#include "core/studies/response/forced_springs.h"
#include "core/studies/response/response_report.h"
#include "core/studies/response/response_sweep.h"
#include "core/studies/study/growing_report.h"
#include "core/studies/study/study_reader.h"
#include "core/work/parallel.h"

namespace touchdown {

namespace {

constexpr int fewestSteps = 60, mostSteps = 400; // by default
constexpr double stepsOfBeat = 8.0;              // by default [-]
constexpr int standardStarts = 48;
constexpr double leastFrequency = 100.0, mostFrequency = 1e8;  // [Hz]
constexpr double leastAmplitude = 1e-15, mostAmplitude = 1e-3; // of the wave [m]
constexpr double aboveRoundOff = 1e5;                          // amplitude of the wave, in round-off of a height [-]
constexpr double standardAmplitude = 0.5e-9, smallAmplitude = 0.05e-9; // on springs, on a linear film [m]
constexpr ValueRange frequenciesOfFilm{20e3, 400e3};                   // by default [Hz]
constexpr double longestWave = 1.0;                                    // [m]
constexpr double belowModes = 0.5, aboveModes = 1.5;                   // default range, in frequencies of the modes [-]

bool isFilm(const Case& c) { return c.model == ModelKind::Film; }

/// What is recorded over a wave.
std::vector<Quantity> quantitiesOverWave(Case c)
{
    if (isFilm(c)) return quantitiesOfForcedFilm(c);
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    return SpringModel::quantities(c);
}

SpringModel modelOverFlatDisk(Case c)
{
    c.diskSurface.kind = DiskSurfaceKind::Flat;
    return SpringModel(c);
}

/// From half of the lowest frequency of the static state to 1.5 times the highest [Hz]; nothing without a mode. The
/// modes of a film take too long to be asked.
std::optional<ValueRange> defaultFrequencies(const Case& c)
{
    if (isFilm(c)) return frequenciesOfFilm;
    if (c.model != ModelKind::Springs) return {};
    const SpringModel model = modelOverFlatDisk(c);
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

/// Between two frequencies at which the waves under both air springs, or under both ends of the slider, are in phase,
/// if the speed is held [Hz].
double beatOf(const Case& c)
{
    return std::abs(speedAlong(c)) / (isFilm(c) ? c.slider.length : c.springs.frontDistance + c.springs.rearDistance);
}

/// Eight in each beat, if the speed is held.
int defaultSteps(const Case& c, const ValueRange& range, bool lengthHeld)
{
    if (lengthHeld) return fewestSteps;
    const double beats = (range.upper - range.lower) / beatOf(c);
    return int(std::clamp(std::ceil(stepsOfBeat * beats), double(fewestSteps), double(mostSteps)));
}

double defaultAmplitude(const Case& c)
{
    const std::vector<double>& given = c.diskSurface.waveAmplitudes;
    const bool hasWave = hasWaves(c.diskSurface) && !given.empty() && given.front() != 0.0;
    return hasWave ? std::abs(given.front()) : isFilm(c) ? smallAmplitude : standardAmplitude;
}

class ResponsePerformance {
public:
    ResponsePerformance(const ResponseTask& task, const StudyCallback& callback) : task_(task), callback_(callback) {}

    StudyReport perform(int jobs)
    {
        const std::size_t count = task_.frequencies.size(), starts = std::size_t(task_.starts);
        result_.linear.resize(count);
        result_.points.resize(2 * count);
        const auto poll = [this](std::size_t) { return tell(); };
        const auto one = [&](const std::function<void(const ResponseTask&)>& act) {
            return runParallel(
                1, 1, [&](std::size_t, const GoOn& goOn) { act(withGoOn(goOn)); }, poll);
        };
        std::vector<ForcedMotion> ofStarts(starts);
        const bool whole = one([this](const ResponseTask& task) { sweep(task); }) &&
                           runParallel(
                               starts, jobs,
                               [&](std::size_t start, const GoOn& goOn) {
                                   ofStarts[start] = motionOfStart(withGoOn(goOn), int(start));
                                   ++done_;
                               },
                               poll) &&
                           one([&](const ResponseTask& task) {
                               ResponseResult result = result_;
                               addOthers(task, ofStarts, result);
                               const std::lock_guard lock(mutex_);
                               result_ = std::move(result);
                           });
        StudyReport report = responseReport(task_, result_);
        if (!whole) return ended(report, StudyStatus::Cancelled, "stopped before all frequencies were done");
        if (result_.others.empty() &&
            std::ranges::none_of(result_.points, [](const ResponsePoint& at) { return at.motion.valid(); }))
            return ended(report, StudyStatus::Failed, "no motion is valid: " + result_.points.front().motion.problem);
        return report;
    }

private:
    ResponseTask withGoOn(const GoOn& goOn) const
    {
        ResponseTask task = task_;
        task.settle.goOn = goOn;
        return task;
    }

    void sweep(const ResponseTask& task)
    {
        const std::size_t count = task.frequencies.size();
        std::vector<ResponseJump> jumps = sweepBothWays(
            task, [&](std::size_t i, const ResponsePoint& point, const std::optional<std::complex<double>>& linear) {
                const std::lock_guard lock(mutex_);
                if (i < count) result_.linear[i] = linear;
                result_.points[i] = point;
                ++points_;
                ++done_;
            });
        const std::lock_guard lock(mutex_);
        result_.jumps = std::move(jumps);
    }

    bool tell()
    {
        const std::lock_guard lock(mutex_);
        const std::size_t points = result_.points.size(), all = points + std::size_t(task_.starts), done = done_;
        const std::string way = done >= points ? "other starts, " : 2 * done < points ? "up, " : "down, ";
        return tellProgress(
            callback_,
            {double(done) / double(all), way + std::to_string(done) + " of " + std::to_string(all) + " motions"},
            std::exchange(told_, points_) < points_,
            [this] { return withoutFindings(responseReport(task_, result_)); });
    }

    const ResponseTask& task_;
    const StudyCallback& callback_;
    std::mutex mutex_; // of all below
    ResponseResult result_;
    std::size_t points_ = 0, told_ = 0;
    std::atomic<std::size_t> done_ = 0; // motions
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

/// The film of the task's case, which takes seconds to find: false where it is stopped. Throws std::runtime_error.
bool takeFilm(ResponseTask& task, const StudyCallback& callback)
{
    const auto goOn = [&](double share) {
        return !callback || callback({0.0, "answer of the film, " + percent(share)});
    };
    auto film = FilmUnderWaves::make(task.start, task.quantity.name, task.amplitude, task.frequencies, task.beat, goOn);
    if (!film) return false;
    const auto law = characteristic(task.start);
    if (law && film->pieces().regions()[film->pieces().atRest()].name == ContactRegion::Apart)
        task.toContact = film->pieces().restSpacing() - law->touchDown;
    for (const double mode : film->pieces().frequencies())
        if (mode < task.frequencies.front() || mode > task.frequencies.back()) task.outside.push_back(mode);
    task.sliderAt = [film = std::move(film)](double frequency) {
        return std::make_unique<ForcedFilm>(film, frequency);
    };
    return true;
}

StudyReport performResponse(ResponseTask task, int jobs, const StudyCallback& callback)
{
    try {
        if (!isFilm(task.start))
            takeSprings(task);
        else if (!takeFilm(task, callback))
            return ended({}, StudyStatus::Cancelled, "stopped before the film's answer to waves was known");
    } catch (const std::runtime_error& error) {
        return ended({}, StudyStatus::Failed, error.what());
    }
    return ResponsePerformance(task, callback).perform(jobs);
}

} // namespace

void takeSprings(ResponseTask& task)
{
    if (const auto law = characteristic(task.start)) task.toContact = task.start.springs.flyingHeight - law->touchDown;
    task.sliderAt = [c = task.start, amplitude = task.amplitude, wavelength = task.wavelength,
                     name = task.quantity.name](double frequency) {
        return std::make_unique<ForcedSprings>(caseOverWave(c, amplitude, frequency, wavelength), name);
    };
}

StudyPerformance planResponse(StudyReader& reader)
{
    ResponseTask task;
    task.start = reader.start();
    const bool film = isFilm(task.start);
    if (!film && task.start.model != ModelKind::Springs) {
        reader.add("case", "is of model \"contact\": a study of forced motion takes springs or a linear film");
        return {};
    }
    if (const std::string reason = film ? reasonAgainstForcedFilm(task.start) : std::string(); !reason.empty()) {
        reader.add("case", reason);
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
    const std::optional<int> givenSteps = reader.integer("steps", 1, 2000);
    const std::string quantity = reader.choice("quantity");
    task.amplitude = reader.number("amplitude");
    const double least = film ? 0.0 : aboveRoundOff * ForcedSprings::roundOffOfHeight(modelOverFlatDisk(task.start));
    if (task.amplitude < least)
        reader.add("amplitude", "is lost in the round-off of the height of the slider: at least " +
                                    fewDigits(least, "nm") + " is needed");
    const std::optional<double> wavelength = reader.number("wavelength", "m", "um", 1e-9, longestWave);
    if (film && reader.has("wavelength"))
        reader.add("wavelength", "is held with springs alone: at another speed the film is another one");
    const bool wrongLength = reader.has("wavelength") && !wavelength;
    task.wavelength = wavelength.value_or(0.0);
    task.starts = reader.integer("starts");
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
    const int steps = givenSteps.value_or(defaultSteps(task.start, {*from, *to}, task.wavelength > 0.0));
    if (task.wavelength == 0.0) task.beat = beatOf(task.start);
    if (film) {
        task.under = task.start.surface.pointsOfInterest.empty() ? "the trailing edge" : "the first point of interest";
        task.ends = "both ends of the slider";
    }
    for (int i = 0; i <= steps; ++i) task.frequencies.push_back(std::lerp(*from, *to, double(i) / steps));
    return [task](int jobs, const StudyCallback& callback) { return performResponse(task, jobs, callback); };
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
        onlyOffered(integerKey("steps", range ? defaultSteps(c, *range, false) : fewestSteps, 1, 2000,
                               "from one end to the other; without it 60, and with the speed held up to 400, so that "
                               "8 are in each beat of the waves under the two air springs, or along a film")),
        choiceKey("quantity", "flying_height", std::move(quantities), "whose amplitude and phase are taken"),
        numberKey("amplitude", defaultAmplitude(c), "m", "nm", leastAmplitude, mostAmplitude,
                  "of the waves, which replace the surface of the case"),
        numberKey("wavelength", std::monostate{}, "m", "um", 1e-9, longestWave,
                  "of the waves, if it is held and the speed of the disk changes instead"),
        integerKey(
            "starts", standardStarts, 0, 10000,
            "spread over the frequencies, from which other motions are looked for: at rest, where contact begins, "
            "and drawn about the static state"),
        integerKey("periods", 1000, 10, 1000000, "of the forcing within which the motion must settle"),
        integerKey("longest_period", 8, 1, 64, "in periods of the forcing, after which a motion may repeat"),
    };
    form.remark =
        "The speed of the disk is held and the length of its waves changes. With wavelength = \"50 um\" that is "
        "the length of the waves, and the speed changes (springs only). A film is linear about its static state "
        "(film.motion = \"linear\"), under no contact or that of Ono and Yamane.";
    return form;
}

} // namespace touchdown
