// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml_case.h"

#include <exception>
#include <memory>
#include <system_error>

#include "core/formats/output_file.h"
#include "core/formats/text_file.h"

namespace touchdown {

namespace fs = std::filesystem;

namespace {

/// Every file is written before the first one appears.
std::string writeInto(const fs::path& folder, const std::vector<CmlMember>& members)
{
    std::vector<std::unique_ptr<PartFile>> parts;
    std::string name = folder.string();
    try {
        for (const CmlMember& member : members) {
            name = (folder / member.name).string();
            if (fs::is_directory(name)) return name + ": is a directory, not a file";
            parts.push_back(std::make_unique<PartFile>(name));
            if (const std::string problem = writePart(*parts.back(), member.text); !problem.empty())
                return name + ": " + problem;
        }
        for (const auto& part : parts) part->show();
    } catch (const std::exception& failure) {
        return name + ": cannot be written: " + failure.what();
    }
    return {};
}

} // namespace

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
