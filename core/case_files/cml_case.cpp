// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml_case.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <system_error>
#include <utility>

#include "core/case/disk_setup.h"
#include "core/case/parameters.h"
#include "core/case_files/case_text.h"
#include "core/case_files/cml/cml_dynamics_file.h"
#include "core/case_files/cml/cml_kept_values.h"
#include "core/case_files/cml/cml_rail_file.h"
#include "core/case_files/cml/cml_run_file.h"
#include "core/case_files/surface_text.h"
#include "core/formats/quotation.h"
#include "core/formats/text_file.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/physics/slider/surface_check.h"

namespace touchdown {

namespace fs = std::filesystem;

namespace {

bool isArchive(const fs::path& path) { return lowerCase(path.extension().string()) == ".cml"; }

/// In which the files of the case lie, or its archive.
fs::path folderOf(const fs::path& path)
{
    std::error_code error;
    return fs::is_directory(path, error) ? path : path.parent_path().empty() ? fs::path(".") : path.parent_path();
}

/// A sentence as it follows file and line.
std::string asMessage(std::string sentence)
{
    if (!sentence.empty()) sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
    if (sentence.ends_with('.')) sentence.pop_back();
    return sentence;
}

void readRails(const CmlFiles::File& file, CmlParameters& parameters)
{
    parameters.beginFile(file.name);
    const CmlRails rails = readCmlRails(file.text, file.name);
    parameters.problems.insert(parameters.problems.end(), rails.problems.begin(), rails.problems.end());
    parameters.warnings.insert(parameters.warnings.end(), rails.warnings.begin(), rails.warnings.end());
    if (!rails.valid()) return;
    parameters.setSurface(rails);
    for (const auto& [key, sentence, places] : surfaceProblems(rails.surface))
        parameters.addProblem(parameters.lineOf(key), asMessage(sentence));
    if (!parameters.problems.empty()) return;
    for (const auto& [key, sentence, places] : surfaceWarnings(rails.surface, rails.length, rails.width))
        parameters.addWarning(parameters.lineOf(key), asMessage(sentence));
}

/// Mass and inertias that no file gives, of a homogeneous block of the slider's material.
class SliderBlock {
public:
    /// Sets them.
    explicit SliderBlock(CmlParameters& parameters) : parameters_(parameters)
    {
        const SliderCase slider = parameters.value().slider;
        const double block = density * slider.length * slider.width * slider.thickness;
        const double mass = parameters.wasSet("slider.mass") ? slider.mass : block;
        const auto inertia = [&](double a) { return mass * (a * a + slider.thickness * slider.thickness) / 12.0; };
        set("slider.mass", mass);
        set("slider.pitch_inertia", inertia(slider.length));
        set("slider.roll_inertia", inertia(slider.width));
    }

    /// Reports the notes that still hold.
    void tell(const std::string& file) const
    {
        std::vector<std::string> told;
        for (const auto& [key, text] : values_)
            if (toText(parameters_.value(), *findParameter(key)) == text) told.push_back(key + " = " + text);
        if (told.empty()) return;
        parameters_.beginFile(file);
        parameters_.addWarning(
            0, "no file gives the slider's " + std::string(told.size() == 3 ? "mass and inertias" : "inertias") +
                   ": those of a block of AlTiC with 4000 kg/m^3 (4000 to 4250 are reported), " + joined(told));
    }

private:
    static constexpr double density = 4000.0; // [kg/m^3]
    static constexpr int digits = 4;

    void set(const std::string& key, double value)
    {
        if (parameters_.wasSet(key)) return;
        const Parameter& parameter = *findParameter(key);
        parameters_.setNumber(key, std::clamp(roundedTo(value, digits), parameter.minimum, parameter.maximum), 0);
        values_.emplace_back(key, toText(parameters_.value(), parameter));
    }

    CmlParameters& parameters_;
    std::vector<std::pair<std::string, std::string>> values_; // key and value
};

/// Latin-1, which the program writes, as UTF-8; control characters become '?'.
std::string commentLine(std::string_view line)
{
    constexpr std::size_t longest = 500;
    const bool utf8 = findInvalidUtf8(line) == std::string_view::npos;
    std::string text;
    for (const char c : utf8 ? line : line.substr(0, longest)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) {
            text += c == '\t' ? ' ' : '?';
        } else if (byte < 0x80 || utf8) {
            text += c;
        } else {
            text += static_cast<char>(0xc0 | (byte >> 6));
            text += static_cast<char>(0x80 | (byte & 0x3f));
        }
    }
    return "# " + text + "\n";
}

/// The case as TOML, below the comments of the files.
std::string asToml(const CaseDocument& document, const std::string& comments)
{
    constexpr int mostLines = 200;
    std::string text = commentLine("From the files " + document.name);
    CmlText lines(comments);
    lines.skipBlanks();
    for (int i = 0; i < mostLines && !lines.atEnd(); ++i) text += commentLine(lines.takeLine());
    return text + "\n" + formatCase(document.value);
}

/// The files that a path leads to, or why there are none.
class CmlFinder {
public:
    CmlFinder(CaseDocument& document, OutsidePaths outside) : document_(document), outside_(outside) {}

    std::optional<CmlFiles> find(const fs::path& path)
    {
        if (isArchive(path)) return fromArchive(path);
        std::error_code error;
        const fs::path folder = folderOf(path);
        const std::string named = fs::is_directory(path, error) ? "" : lowerCase(path.filename().string());
        std::vector<std::pair<std::string, fs::path>> found;
        for (const std::string member : {"rail.dat", "run.dat", "dynamics.def"}) {
            if (member == named)
                found.emplace_back(member, path);
            else if (auto file = findCmlMember(folder, member)) {
                if (outside_ == OutsidePaths::Refused && leadsOutside(folder, file->filename())) {
                    document_.outsideFiles.push_back(file->string());
                    refuse(file->string(), outsideProblem(file->filename().string(), "the other files"));
                    continue;
                }
                found.emplace_back(member, *file);
            }
        }
        if (!document_.outsideFiles.empty()) return {};
        return choose(found, named);
    }

private:
    template <typename Text>
    static const Text* textOf(const std::vector<std::pair<std::string, Text>>& found, std::string_view name)
    {
        for (const auto& [member, text] : found)
            if (member == name) return &text;
        return nullptr;
    }

    std::optional<CmlFiles> fromArchive(const fs::path& path)
    {
        document_.files.push_back(path);
        auto bytes = readTextFile(path, maximumCmlFileSize);
        if (const auto* problem = std::get_if<FileProblem>(&bytes)) return refuse(path.string(), problem->message);
        auto archive = readCmlArchive(std::get<std::string>(bytes));
        if (const auto* problem = std::get_if<FileProblem>(&archive)) return refuse(path.string(), problem->message);
        CmlArchive& content = std::get<CmlArchive>(archive);
        for (std::string& warning : content.warnings)
            document_.warnings.push_back({path.string(), 0, "", std::move(warning)});
        std::vector<std::pair<std::string, CmlFiles::File>> found;
        for (CmlMember& member : content.members)
            found.emplace_back(member.name, CmlFiles::File{path.string() + "/" + member.name, std::move(member.text)});
        return pick(found, "", [](const CmlFiles::File& file) { return std::optional(file); });
    }

    std::optional<CmlFiles> choose(const std::vector<std::pair<std::string, fs::path>>& found, const std::string& named)
    {
        return pick(found, named, [&](const fs::path& file) -> std::optional<CmlFiles::File> {
            document_.files.push_back(file);
            auto text = readTextFile(file, maximumCmlFileSize);
            if (auto* content = std::get_if<std::string>(&text))
                return CmlFiles::File{file.string(), std::move(*content)};
            refuse(file.string(), std::get<FileProblem>(text).message);
            return {};
        });
    }

    /// rail.dat, and run.dat or dynamics.def: the file that is named, else run.dat.
    template <typename Found, typename Read>
    std::optional<CmlFiles> pick(const Found& found, const std::string& named, Read read)
    {
        const auto* const rail = textOf(found, "rail.dat");
        const auto* run = textOf(found, "run.dat");
        const auto* dynamics = textOf(found, "dynamics.def");
        if (rail == nullptr) return refuse(document_.name, "has no rail.dat beside it");
        if (run == nullptr && dynamics == nullptr)
            warn("has no run.dat or dynamics.def beside it; everything but the slider's surface has its default");
        if (run != nullptr && dynamics != nullptr) {
            const bool wantsDynamics = named == "dynamics.def";
            warn(wantsDynamics ? "there is also a run.dat, which is not read"
                               : "there is also a dynamics.def, which is not read");
            (wantsDynamics ? run : dynamics) = nullptr;
        }
        CmlFiles files;
        for (const auto& [from, to] :
             {std::pair{rail, &files.rail}, std::pair{run, &files.run}, std::pair{dynamics, &files.dynamics}}) {
            if (from == nullptr) continue;
            auto file = read(*from);
            if (!file) return {};
            *to = std::move(*file);
        }
        return files;
    }

    std::optional<CmlFiles> refuse(const std::string& file, std::string message)
    {
        document_.problems.push_back({file, 0, "", std::move(message)});
        return {};
    }
    void warn(std::string message) { document_.warnings.push_back({document_.name, 0, "", std::move(message)}); }

    CaseDocument& document_;
    OutsidePaths outside_;
};

/// A surface that the comments of run.dat name, which may lie anywhere.
void checkKeptSurface(CaseDocument& document, const CmlFiles::File& run)
{
    std::string& file = document.value.diskSurface.file;
    if (file.empty() || !leadsOutside(document.value.folder, file)) return;
    document.outsideFiles.push_back(file);
    document.problems.push_back({run.name, 0, surfaceFileKey, outsideProblem(file, "the case")});
    file.clear();
}

/// The wave.def beside the other files, by its absolute path, so that the case may be moved.
void findTrackProfile(const fs::path& path, OutsidePaths outside, CmlParameters& parameters, CaseDocument& document)
{
    const Case& c = parameters.value();
    if (c.diskSurface.file.empty()) return;
    const int line = parameters.lineOf("disk.surface.file");
    std::error_code error;
    const fs::path folder = folderOf(path);
    const auto file = isArchive(path) ? std::nullopt : findCmlMember(folder, c.diskSurface.file);
    if (file && outside == OutsidePaths::Refused && leadsOutside(folder, file->filename())) {
        document.outsideFiles.push_back(file->string());
        parameters.addProblem(line, outsideProblem(file->filename().string(), "the other files"));
        return;
    }
    if (file) {
        parameters.choose("disk.surface.file", fs::weakly_canonical(*file, error).string(), line);
        DiskFileCheck disk = checkDiskFile(c);
        disk.nameIn(parameters.file(), line);
        parameters.problems.insert(parameters.problems.end(), disk.problems.begin(), disk.problems.end());
        parameters.warnings.insert(parameters.warnings.end(), disk.warnings.begin(), disk.warnings.end());
        return;
    }
    if (c.diskSurface.kind == DiskSurfaceKind::File) parameters.choose("disk.surface.kind", "flat", line);
    parameters.choose("disk.surface.file", "", line);
    parameters.addWarning(line, isArchive(path)
                                    ? "Disk Track Profile: not modelled: a wave.def in an archive; unpack it"
                                    : "Disk Track Profile: not modelled: there is no wave.def beside this file");
}

/// "tfc3" for tfc3, tfc3/ , tfc3/rail.dat and tfc3.cml.
std::string titleOf(const fs::path& path)
{
    std::error_code error;
    fs::path absolute = fs::weakly_canonical(fs::absolute(path, error), error);
    if (isArchive(path)) return absolute.stem().string();
    if (isCmlMember(lowerCase(absolute.filename().string()))) absolute = absolute.parent_path();
    return absolute.filename().string();
}

} // namespace

std::optional<fs::path> findCmlMember(const fs::path& folder, const std::string& name)
{
    std::error_code error;
    std::optional<fs::path> found;
    for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error)) {
        const std::string entry = each->path().filename().string();
        if (lowerCase(entry) == name && (!found || entry == name)) found = each->path();
    }
    return found;
}

bool isCmlPath(const fs::path& path)
{
    std::error_code error;
    if (fs::is_directory(path, error)) return findCmlMember(path, "rail.dat").has_value();
    return isArchive(path) || isCmlMember(lowerCase(path.filename().string()));
}

void readCmlFiles(const CmlFiles& files, CmlParameters& parameters)
{
    readRails(files.rail, parameters);
    const bool dynamic = files.run.name.empty() && !files.dynamics.name.empty();
    const CmlFiles::File& other = dynamic ? files.dynamics : files.run;
    if (!other.name.empty()) {
        parameters.beginFile(other.name);
        (dynamic ? readCmlDynamics : readCmlRun)(other.text, parameters);
    }
    if (!parameters.problems.empty()) return;
    const SliderBlock block(parameters);
    if (!other.name.empty() && !dynamic) applyKeptValues(parameters);
    block.tell(files.rail.name);
    if (parameters.problems.empty()) parameters.checkCombinations();
}

CaseDocument readCmlCase(const fs::path& path, OutsidePaths outside)
{
    CaseDocument document;
    document.name = path.string();
    document.value = defaultsOf(ModelKind::Film);
    document.value.folder = document.folder = folderOf(path);
    const auto files = CmlFinder(document, outside).find(path);
    if (!files) return document;
    CmlParameters parameters(document.value);
    readCmlFiles(*files, parameters);
    if (!files->dynamics.name.empty()) findTrackProfile(path, outside, parameters, document);
    if (document.value.title == Case{}.title) parameters.choose("title", titleOf(path), 0);
    document.problems = std::move(parameters.problems);
    if (outside == OutsidePaths::Refused && files->dynamics.name.empty()) checkKeptSurface(document, files->run);
    document.warnings.insert(document.warnings.end(), parameters.warnings.begin(), parameters.warnings.end());
    document.text = asToml(document, parameters.comments);
    return document;
}

} // namespace touchdown
