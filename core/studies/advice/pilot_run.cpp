// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/advice/pilot_run.h"
#include "core/simulation/run.h"

#include <time.h>

#include <algorithm>
#include <limits>

namespace touchdown {

namespace {

constexpr double fewestSamples = 1000.0; // of a run, so that its last tenth and a first part of it have statistics

} // namespace

double pilotInterval(const Case& c) { return std::min(c.run.sampleInterval, c.run.duration / fewestSamples); }

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
    const TouchColumns touch(quiet);

    PilotRun pilot;
    pilot.samples.interval = quiet.run.sampleInterval;
    pilot.lowest = std::numeric_limits<double>::infinity();
    bool known = false;
    double begin = threadSeconds();
    const Summary summary = run(quiet, [&](const RunUpdate& update) {
        const SampleBatch& batch = update.samples;
        for (std::size_t k = 0; k < batch.size(); ++k) {
            const double value = batch.columns[spacing][k];
            pilot.samples.spacing.push_back(value);
            pilot.samples.touching.push_back(touch.touches(batch, k));
            pilot.lowest = std::min(pilot.lowest, value);
            pilot.contactActs = pilot.contactActs || touch.acts(batch, k);
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
    });
    if (!known && !pilot.stopped && summary.status != RunStatus::Completed) pilot.problem = summary.message;
    if (!known && !pilot.course.empty()) pilot.course.back().second = threadSeconds() - begin;
    return pilot;
}

} // namespace touchdown
