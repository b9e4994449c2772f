// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/stability.h"

#include <algorithm>
#include <memory>

#include "core/formats/toml_document.h"
#include "core/numerics/wall_clock.h"
#include "core/studies/stability/stability_picture.h"
#include "core/studies/stability/stability_report.h"

namespace touchdown {

namespace {

constexpr double pictureShare = 0.1;    // of the time
constexpr double longestSilence = 0.03; // between calls [s]

StudyReport cancelled(StudyReport report, double begin)
{
    report.status = StudyStatus::Cancelled;
    report.message = "stopped before all runs were made";
    report.wallSeconds = wallClock() - begin;
    return report;
}

StudyReport perform(const StabilityTask& task, int jobs, const StudyCallback& callback)
{
    const double begin = wallClock();
    StudyReport report;
    double lastCall = 0.0;
    const auto tell = [&](double share, const std::string& doing, const StudyReport* soFar) {
        lastCall = wallClock();
        return !callback || callback({share, doing, soFar});
    };
    if (task.picture) {
        LinearPicture picture;
        const auto goOn = [&] {
            return wallClock() - lastCall < longestSilence || tell(0.0, "linear picture", nullptr);
        };
        if (!makeLinearPicture(task.start, picture, goOn)) return cancelled(std::move(report), begin);
        report.charts = std::move(picture.charts);
        report.tables = std::move(picture.tables);
        report.findings = std::move(picture.findings);
        report.warnings = std::move(picture.warnings);
        if (!picture.problem.empty())
            report.warnings.insert(report.warnings.begin(), "There is no linear picture: " + picture.problem + ".");
        if (!picture.problem.empty() && !task.map) {
            report.status = StudyStatus::Failed;
            report.message = "there is no linear picture: " + picture.problem;
        }
        if (!tell(task.map ? pictureShare : 1.0, "runs", &report)) return cancelled(std::move(report), begin);
    }
    if (task.map) {
        const double from = task.picture ? pictureShare : 0.0;
        StabilityMap map;
        if (!performMap(task, jobs, map, [&](double share, const std::string& doing) {
                return tell(from + (1.0 - from) * share, doing, nullptr);
            }))
            return cancelled(std::move(report), begin);
        StudyReport whole;
        tellMap(task, map, whole);
        // What became of the runs comes first; the linear picture explains it.
        report.findings.insert(report.findings.begin(), whole.findings.begin(), whole.findings.end());
        report.warnings.insert(report.warnings.begin(), whole.warnings.begin(), whole.warnings.end());
        report.charts.push_back(mapChart(task, map));
        std::vector<StudyTable> tables = mapTables(task, map);
        report.tables.insert(report.tables.begin(), tables.begin(), tables.end());
    }
    report.wallSeconds = wallClock() - begin;
    return report;
}

} // namespace

StudyPerformance planStability(StudyReader& reader)
{
    const auto task = std::make_shared<const StabilityTask>(readStabilityTask(reader));
    return [task](int jobs, const StudyCallback& callback) { return perform(*task, jobs, callback); };
}

} // namespace touchdown
