// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/disk_setup.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>

#include <time.h>

#include "core/case/parameters.h"
#include "core/formats/file_identity.h"
#include "core/formats/quotation.h"
#include "core/formats/surfaces/height_map_file.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

bool readsFile(const Case& c) { return findParameter("disk.surface.file")->used(c) && hasFile(c.diskSurface); }

/// Whether a later change of the file gets another time. File times advance with this clock, in steps of some
/// milliseconds; two changes within one step have the same time.
bool isPast(std::int64_t time)
{
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME_COARSE, &now);
    return time < std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

using ReadMap = std::shared_ptr<const HeightMapDocument>;

/// The map of the case's file. The last file that was read is kept: a command asks for it up to six times, a study once
/// for each run. It is read again when it has changed.
ReadMap readMap(const Case& c)
{
    struct Kept {
        std::filesystem::path file;
        std::string name, unit;
        FileIdentity mark; // without the hash
        ReadMap map;
    };
    static std::mutex busy; // who waits needs the same file as a rule
    static std::optional<Kept> kept;
    const std::lock_guard lock(busy);

    const std::filesystem::path file = c.folder / c.diskSurface.file;
    const std::optional<FileIdentity> mark = marksOf(file);
    if (kept && mark && kept->file == file && kept->name == c.diskSurface.file && kept->unit == c.diskSurface.unit &&
        kept->mark == *mark)
        return kept->map;
    kept.reset();
    const bool settled = mark && isPast(mark->changed);
    auto map = std::make_shared<const HeightMapDocument>(readHeightMap(file, c.diskSurface.file, c.diskSurface.unit));
    if (settled && marksOf(file) == mark) kept = Kept{file, c.diskSurface.file, c.diskSurface.unit, *mark, map};
    return map;
}

} // namespace

void DiskFileCheck::nameIn(const std::string& place, int line)
{
    for (std::vector<InputProblem>* list : {&problems, &warnings})
        for (InputProblem& each : *list) {
            if (each.line > 0) {
                each.message += "; " + place + (line > 0 ? ':' + std::to_string(line) : "") + " names this file";
                continue;
            }
            each.message = inQuotes(each.file) + ' ' + each.message;
            each.file = place;
            each.line = line;
        }
}

DiskFileCheck checkDiskFile(const Case& c)
{
    if (!readsFile(c) || c.diskSurface.file.empty()) return {};
    const ReadMap document = readMap(c);
    DiskFileCheck check{document->problems, document->warnings};
    for (std::vector<InputProblem>* list : {&check.problems, &check.warnings})
        for (InputProblem& problem : *list) {
            problem.kind = ProblemKind::MeasuredDisk;
            if (problem.key.empty()) problem.key = "disk.surface.file";
        }
    if (document->valid())
        for (const DiskSurfaceProblem& each : heightMapWarnings(document->map))
            check.warnings.push_back(
                {c.diskSurface.file, 0, "disk.surface." + each.key, each.sentence, ProblemKind::MeasuredDisk});
    return check;
}

DiskTopography diskTopography(const Case& c, const std::function<bool()>& goOn)
{
    if (!readsFile(c)) return DiskTopography(c.diskSurface, {}, goOn);
    const ReadMap document = readMap(c);
    if (!document->valid()) throw std::runtime_error(document->problems.front().text());
    return DiskTopography(c.diskSurface, document->map, goOn);
}

} // namespace touchdown
