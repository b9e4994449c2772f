// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/disk_setup.h"

#include <stdexcept>
#include <utility>

#include "core/case/parameters.h"
#include "core/formats/surfaces/height_map_file.h"
#include "core/physics/disk/disk_surface_check.h"

namespace touchdown {

namespace {

bool readsFile(const Case& c) { return findParameter("disk.surface.file")->used(c) && hasFile(c.diskSurface); }

HeightMapDocument readMap(const Case& c)
{
    return readHeightMap(c.folder / c.diskSurface.file, c.diskSurface.file, c.diskSurface.unit);
}

} // namespace

DiskFileCheck checkDiskFile(const Case& c)
{
    if (!readsFile(c) || c.diskSurface.file.empty()) return {};
    const HeightMapDocument document = readMap(c);
    DiskFileCheck check{document.problems, document.warnings};
    for (std::vector<InputProblem>* list : {&check.problems, &check.warnings})
        for (InputProblem& problem : *list) {
            problem.kind = ProblemKind::MeasuredDisk;
            if (problem.key.empty()) problem.key = "disk.surface.file";
        }
    if (document.valid())
        for (const DiskSurfaceProblem& each : heightMapWarnings(document.map))
            check.warnings.push_back(
                {c.diskSurface.file, 0, "disk.surface." + each.key, each.sentence, ProblemKind::MeasuredDisk});
    return check;
}

DiskTopography diskTopography(const Case& c, const std::function<bool()>& goOn)
{
    if (!readsFile(c)) return DiskTopography(c.diskSurface, {}, goOn);
    HeightMapDocument document = readMap(c);
    if (!document.valid()) throw std::runtime_error(document.problems.front().text());
    return DiskTopography(c.diskSurface, std::move(document.map), goOn);
}

} // namespace touchdown
