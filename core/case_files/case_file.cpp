// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/case_file.h"

#include "core/case_files/case_reader.h"
#include "core/case_files/cml_case.h"
#include "core/formats/nearest_name.h"
#include "core/formats/text_file.h"

#include <algorithm>

namespace touchdown {

namespace {

constexpr std::uintmax_t largestCaseFile = 1 << 20; // [byte]

} // namespace

std::string titleOf(const SampleCase& sample)
{
    const std::string before = "\ntitle = \"";
    const std::size_t begin = sample.text.find(before) + before.size();
    return sample.text.substr(begin, sample.text.find('"', begin) - begin);
}

CaseDocument readCaseFile(const std::filesystem::path& file, OutsidePaths outside)
{
    const auto refuse = [&](std::string message) {
        CaseDocument document;
        document.name = file.string();
        document.problems.push_back({document.name, 0, "", std::move(message)});
        return document;
    };
    if (file.empty()) return refuse("a file name is needed");
    auto content = readTextFile(file, largestCaseFile);
    if (const auto* problem = std::get_if<FileProblem>(&content)) return refuse(problem->message);
    std::string& text = std::get<std::string>(content);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) return refuse("is empty");
    const std::filesystem::path folder = file.parent_path();
    CaseDocument document = parseCase(std::move(text), file.string(), folder.empty() ? "." : folder, outside);
    document.files.push_back(file);
    return document;
}

CaseDocument openCase(const std::string& fileOrName, OutsidePaths outside)
{
    std::error_code error;
    const auto sample = std::ranges::find(sampleCases(), fileOrName, &SampleCase::name);
    const bool isSample = sample != sampleCases().end();
    // A folder of results may bear the name of its case.
    const bool isFile =
        std::filesystem::exists(fileOrName, error) && !(isSample && std::filesystem::is_directory(fileOrName, error));
    if (isSample && !isFile) return parseCase(sample->text, sample->name);
    if (isFile && isCmlPath(fileOrName)) return readCmlCase(fileOrName, outside);
    CaseDocument document = readCaseFile(fileOrName, outside);
    if (!isFile && !error && !fileOrName.empty() && fileOrName.find('/') == std::string::npos) {
        std::vector<std::string> names;
        for (const SampleCase& each : sampleCases()) names.push_back(each.name);
        document.problems.front().kind = ProblemKind::NotFound;
        document.problems.front().message =
            "is neither a file nor a sample case" + didYouMean(nearestName(fileOrName, names));
    }
    return document;
}

std::string writeCaseFile(const std::filesystem::path& file, const std::string& text)
{
    const std::string problem = writeTextFile(file, text);
    return problem.empty() ? problem : file.string() + ": " + problem;
}

} // namespace touchdown
