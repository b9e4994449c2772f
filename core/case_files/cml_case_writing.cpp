// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of a case are formatted and written.
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "core/case/parameters.h"
#include "core/case_files/cml/cml_kept_values.h"
#include "core/case_files/cml/cml_rail_file.h"
#include "core/case_files/cml/cml_run_file.h"
#include "core/case_files/cml_case.h"
#include "core/formats/text_file.h"

namespace touchdown {

namespace fs = std::filesystem;

namespace {

/// A new folder, which the destructor removes with its content.
class StagingFolder {
public:
    explicit StagingFolder(const fs::path& inside) : name_((inside / ".touchdown.XXXXXX").string())
    {
        made_ = ::mkdtemp(name_.data()) != nullptr;
        if (!made_) problem_ = "cannot be written: " + std::generic_category().message(errno);
    }
    ~StagingFolder()
    {
        std::error_code ignored;
        if (made_) fs::remove_all(name_, ignored);
    }
    StagingFolder(const StagingFolder&) = delete;
    StagingFolder& operator=(const StagingFolder&) = delete;
    fs::path path() const { return name_; }
    const std::string& problem() const { return problem_; }

private:
    std::string name_;
    std::string problem_;
    bool made_ = false;
};

std::string writeInto(const fs::path& folder, const std::vector<CmlMember>& members)
{
    for (const CmlMember& member : members)
        if (fs::is_directory(folder / member.name))
            return (folder / member.name).string() + ": is a directory, not a file";
    const StagingFolder staging(folder);
    if (!staging.problem().empty()) return folder.string() + ": " + staging.problem();
    for (const CmlMember& member : members)
        if (const std::string problem = writeTextFile(staging.path() / member.name, member.text); !problem.empty())
            return (folder / member.name).string() + ": " + problem;
    for (const CmlMember& member : members) {
        std::error_code error;
        fs::rename(staging.path() / member.name, folder / member.name, error);
        if (error) return (folder / member.name).string() + ": cannot be written: " + error.message();
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
    return output;
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
