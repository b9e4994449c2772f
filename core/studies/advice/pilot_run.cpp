// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/pilot_run.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/simulation/recording/last_sample.h"
#include "core/simulation/recording/run_statistics.h"
#include "core/simulation/run.h"
#include "core/studies/runs/measured_run.h"

namespace touchdown {

namespace {

constexpr double fewestPilotSamples = 1000.0; // of a run, so that its last tenth and a first part of it have statistics

constexpr double mostGrowth = 0.3; // e-folds of a mode over the run, beyond which a part does not predict its end

bool hasNoOrder(const DiskSurface& surface)
{
    return surface.kind != DiskSurfaceKind::Flat && surface.kind != DiskSurfaceKind::Waves &&
           surface.motion == SurfaceMotion::Moving;
}

} // namespace

double pilotInterval(const Case& c) { return std::min(c.run.sampleInterval, c.run.duration / fewestPilotSamples); }

double threadSeconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double PilotRun::secondsTo(double time) const
{
    if (course.empty()) return 0.0;
    const auto at = [this](double t) {
        const auto after = std::ranges::lower_bound(course, t, {}, &std::pair<double, double>::first);
        if (after == course.begin()) return course.front().second;
        if (after == course.end()) return course.back().second;
        const auto before = after - 1;
        return before->second + (after->second - before->second) * (t - before->first) / (after->first - before->first);
    };
    const double reached = course.back().first;
    if (time <= reached || !(reached > 0.0)) return at(time);
    return at(reached) + (at(reached) - at(0.5 * reached)) / (0.5 * reached) * (time - reached);
}

PilotRun pilotRun(const Case& c, const PilotEnough& enough, const GoOn& goOn)
{
    Case quiet = c;
    quiet.run.fieldSnapshots = 0;
    quiet.run.sampleInterval = pilotInterval(c);
    const std::vector<Quantity> quantities = recordedQuantities(quiet);
    const auto spacing = static_cast<std::size_t>(findQuantity(quantities, spacingOf(quiet)));
    // Springs measure from the disk under them; a film, from its mean plane.
    const int disk = c.model == ModelKind::Springs ? findQuantity(quantities, "disk_height") : -1;
    const TouchColumns touch(quiet, quantities);

    PilotRun pilot;
    pilot.samples.interval = quiet.run.sampleInterval;
    pilot.lowest = std::numeric_limits<double>::infinity();
    bool known = false;
    double begin = threadSeconds();
    const auto look = [&](const RunUpdate& update) {
        const SampleBatch& batch = update.samples;
        for (std::size_t k = 0; k < batch.size(); ++k) {
            const double under = disk >= 0 ? batch.columns[static_cast<std::size_t>(disk)][k] : 0.0;
            const double value = batch.columns[spacing][k] + under;
            const auto valueOf = [&](std::size_t column) { return batch.columns[column][k]; };
            pilot.lowest = std::min(pilot.lowest, value);
            pilot.contactActs = pilot.contactActs || touch.acts(valueOf);
            if (isBetweenSamples(batch.time[k], pilot.samples.interval)) continue;
            pilot.samples.spacing.push_back(value);
            pilot.samples.touching.push_back(touch.touches(valueOf));
        }
        if (batch.size() > 0) pilot.course.emplace_back(update.time, threadSeconds() - begin);
        if (goOn && !goOn()) {
            pilot.stopped = true;
            return false;
        }
        // What looking at it takes is not the run's.
        const double looked = threadSeconds();
        known = known || (enough && batch.size() > 0 && enough(pilot.samples));
        begin += threadSeconds() - looked;
        return !known;
    };
    // Its time is that of a run that finds its static state.
    const Summary summary = run(quiet, look, {.kept = KeptStates::None});
    if (!known && !pilot.stopped && summary.status != RunStatus::Completed) pilot.problem = summary.message;
    if (!known && !pilot.course.empty()) pilot.course.back().second = threadSeconds() - begin;
    return pilot;
}

bool SceneMotion::predicts() const { return growth <= mostGrowth && growthProblem.empty() && !roughPasses; }

SceneMotion sceneMotion(const Case& c, const GoOn& goOn)
{
    const double begin = threadSeconds();
    SceneMotion scene;
    scene.roughPasses = hasNoOrder(c.diskSurface);
    scene.motion = linearMotion(c, [&](const SteadyProgress&) { return !goOn || goOn(); });
    const LinearMotion& motion = scene.motion;
    if (motion.modes.empty())
        scene.growthProblem = motion.message.empty() ? "no static state was found" : motion.message;
    for (const MotionTerm& mode : motion.modes) {
        scene.rates.push_back({mode.rate, false});
        scene.growth = std::max(scene.growth, mode.rate.real() * c.run.duration);
    }
    // Air that creeps out of the cavity takes about as long as the disk drags it along under the slider.
    const double speed = std::abs(c.disk.speed) * c.disk.radius;
    if (!scene.rates.empty() && speed > 0.0) scene.rates.push_back({-speed / c.slider.length, false});
    for (const MotionTerm& wave : motion.waves) scene.rates.push_back({wave.rate, true});
    scene.seconds = threadSeconds() - begin;
    return scene;
}

} // namespace touchdown
