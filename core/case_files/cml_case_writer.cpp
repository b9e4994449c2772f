// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of a case are formatted and written.
#include "core/case_files/cml_case.h"

#include <exception>
#include <memory>
#include <system_error>
#include <utility>

#include "core/case/parameters.h"
#include "core/case_files/cml/cml_kept_values.h"
#include "core/case_files/cml/cml_rail_file.h"
#include "core/case_files/cml/cml_run_file.h"
#include "core/formats/output_file.h"
#include "core/formats/text_file.h"

namespace touchdown {

namespace fs = std::filesystem;

namespace {

/// Every file is written before the first one appears, in the place of one whose name differs in case.
std::string writeInto(const fs::path& folder, const std::vector<CmlMember>& members)
{
    std::vector<std::unique_ptr<PartFile>> parts;
    std::string name = folder.string();
    try {
        for (const CmlMember& member : members) {
            name = findCmlMember(folder, member.name).value_or(folder / member.name).string();
            if (fs::is_directory(name)) return name + ": is a directory, not a file";
            parts.push_back(std::make_unique<PartFile>(name));
            if (const std::string reason = writePart(*parts.back(), member.text); !reason.empty())
                return name + ": cannot be written: " + reason;
        }
        for (const auto& part : parts) part->show();
    } catch (const std::exception& failure) {
        return name + ": cannot be written: " + failure.what();
    }
    return {};
}

} // namespace

CmlOutput formatCmlCase(const Case& c)
{
    CmlOutput output;
    if (c.model != ModelKind::Film) {
        output.problem = "model is " + toText(c, *findParameter("model")) +
                         "; the established program's files describe an air film (model = \"film\")";
        return output;
    }
    CmlFiles files;
    files.rail = {"rail.dat", formatCmlRails(c.slider.length, c.slider.width, c.slider.thickness, c.surface)};
    files.run = {"run.dat", formatCmlRun(c, "")};
    Case read = defaultsOf(ModelKind::Film);
    CmlParameters parameters(read);
    readCmlFiles(files, parameters);
    if (!parameters.problems.empty()) {
        output.problem = "does not fit into the established program's files: " + parameters.problems.front().text();
        return output;
    }
    const CmlKeptValues kept = keepValues(c, read);
    output.members = {{"rail.dat", std::move(files.rail.text)}, {"run.dat", formatCmlRun(c, kept.comments)}};
    output.keptKeys = kept.keys;
    if (!c.surface.distances.empty() || !c.surface.symmetries.empty())
        output.lost = "these files have no kept distances and symmetries";
    return output;
}

std::vector<fs::path> replacedCmlFiles(const fs::path& path)
{
    std::error_code error;
    if (!fs::is_directory(path, error)) return fs::exists(path, error) ? std::vector{path} : std::vector<fs::path>{};
    std::vector<fs::path> files;
    for (const char* name : {"rail.dat", "run.dat"})
        if (const auto found = findCmlMember(path, name)) files.push_back(*found);
    return files;
}

std::string writeCmlCase(const fs::path& path, const std::vector<CmlMember>& members)
{
    if (isCmlPath(path) && !fs::is_directory(path)) {
        if (isCmlMember(path.filename().string())) return path.string() + ": name the folder in which it is to stand";
        const auto bytes = formatCmlArchive(members);
        if (const auto* problem = std::get_if<FileProblem>(&bytes)) return path.string() + ": " + problem->message;
        const std::string problem = writeTextFile(path, std::get<std::string>(bytes));
        return problem.empty() ? problem : path.string() + ": " + problem;
    }
    std::error_code error;
    if (fs::exists(path, error) && !fs::is_directory(path, error))
        return path.string() + ": is a file; a folder, a .cml archive or a .toml case file is needed";
    const bool made = fs::create_directories(path, error);
    if (error) return path.string() + ": cannot be made: " + error.message();
    std::string problem = writeInto(path, members);
    if (!problem.empty() && made) fs::remove(path, error);
    return problem;
}

} // namespace touchdown
