// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_reader.h"

#include <algorithm>
#include <new>

#include "core/formats/hdf5_file.h"
#include "core/formats/hdf5_inspection.h"
#include "core/formats/reader_process.h"
#include "core/results/file_header.h"
#include "core/results/results_layout.h"
#include "core/results/results_samples.h"
#include "core/results/stored_values.h"

namespace touchdown {
namespace fs = std::filesystem;

namespace {

/// The lengths are those that the reader found.
bool fits(const StoredRun& run)
{
    const auto isColumn = [&](const std::vector<double>& column) { return column.size() == run.samples.size(); };
    const auto isSnapshot = [&](const FieldSnapshot& snapshot) {
        if (snapshot.set >= run.recorded.size()) return false;
        const RecordedFields& set = run.recorded[snapshot.set];
        const auto isField = [&](const std::vector<double>& field) { return field.size() == set.grid.cells(); };
        return snapshot.values.size() == set.quantities.size() && std::ranges::all_of(snapshot.values, isField);
    };
    const auto hasCells = [](const RecordedFields& set) { return set.grid.nx() > 0 && set.grid.ny() > 0; };
    const auto isCovered = [&](const StoredCheckpoint& checkpoint) {
        if (checkpoint.samples > run.samples.size() || checkpoint.snapshots.size() != run.recorded.size()) return false;
        for (std::size_t set = 0; set < run.recorded.size(); ++set)
            if (checkpoint.snapshots[set] > std::size_t(std::ranges::count(run.fields, set, &FieldSnapshot::set)))
                return false;
        return true;
    };
    return run.samples.columns.size() == run.quantities.size() && std::ranges::all_of(run.samples.columns, isColumn) &&
           std::ranges::all_of(run.checkpoints, isCovered) && std::ranges::all_of(run.recorded, hasCells) &&
           std::ranges::all_of(run.fields, isSnapshot);
}

/// How the motion ends. Files of runs that were interrupted do not say.
void readMotion(const Hdf5Group& file, StoredRun& run)
{
    const std::string motion = "summary/motion", tail = "summary/tail/minimum_spacing";
    if (!file.has("summary") || !file.has(motion)) return;
    run.motion = file.get(motion).text();
    if (!file.has("summary/tail") || !file.has(tail) || !file.has(tail + "/min") || !file.has(tail + "/max")) return;
    const std::vector<double> least = file.get(tail + "/min").numbers(), most = file.get(tail + "/max").numbers();
    if (least.size() == 1 && most.size() == 1) run.swing = most.front() - least.front();
}

} // namespace

StoredRun readResults(const fs::path& path) { return readByProcess<StoredRun>("run", path, fits); }

StoredRun readResultsDirectly(const fs::path& path)
{
    const Hdf5Access access;
    StoredRun run;
    const auto refused = [](std::string problem) {
        StoredRun nothing;
        nothing.problem = std::move(problem);
        return nothing;
    };
    if (std::string problem = notHdf5(path); !problem.empty()) return refused(std::move(problem));
    try {
        const Hdf5Group file = openHdf5File(path);
        if (std::string problem = foreignFile(path, file, resultsFormat, resultsFormatMajor, "the results of a run");
            !problem.empty())
            return refused(std::move(problem));
        inspectHdf5File(file, readerLimits(path).data);
        run.title = file.attribute("title");
        run.status = file.attribute("status");
        run.message = file.attribute("message");
        run.softwareVersion = file.attribute("software_version");
        run.date = file.attribute("date");
        run.continued = file.attribute("continued");
        run.caseText = file.get("case/text").text();
        StoredSamples stored = readSamples(file);
        run.quantities = std::move(stored.quantities);
        run.samples = std::move(stored.samples);
        run.recorded = std::move(stored.sets);
        run.fields = std::move(stored.snapshots);
        run.checkpoints = readCheckpoints(file, run.recorded);
        readMotion(file, run);
    } catch (const Hdf5Error& error) {
        return refused(path.string() + " is damaged or cut short: " + error.what());
    } catch (const std::bad_alloc&) {
        return refused(path.string() + " does not fit into memory");
    }
    return run;
}

} // namespace touchdown
