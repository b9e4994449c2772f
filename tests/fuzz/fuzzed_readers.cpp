// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/fuzzed_readers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <variant>

#include <unistd.h>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/case_files/cml/cml_parameters.h"
#include "core/case_files/cml_case.h"
#include "core/formats/dxf_surface.h"
#include "core/formats/quotation.h"
#include "core/formats/surfaces/height_map_file.h"
#include "core/formats/toml_document.h"
#include "core/formats/toml_editor.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study_plan.h"
#include "tests/support/cml_sample.h"
#include "tests/support/dxf_sample.h"
#include "tests/support/random_case.h"

namespace touchdown::fuzz {

void mustHold(bool rule, std::string_view sentence)
{
    if (rule) return;
    std::fprintf(stderr, "Broken rule: %.*s\n", static_cast<int>(sentence.size()), sentence.data());
    std::abort();
}

namespace {

std::string textOf(Bytes bytes) { return {bytes.begin(), bytes.end()}; }

/// One line that a terminal shows and does not obey, of a length that a person reads.
void isSentence(const InputProblem& problem)
{
    const std::string text = problem.text();
    mustHold(!text.empty() && text.size() < 4000, "a problem is a sentence: " + text.substr(0, 200));
    mustHold(findInvalidUtf8(text) == std::string::npos, "a problem is UTF-8");
    mustHold(std::ranges::none_of(text, [](unsigned char c) { return (c < 0x20 && c != 0x09) || c == 0x7f; }),
             "a problem is one line: " + text);
    mustHold(problem.line >= 0, "a line is counted from 1");
}

void areSentences(const std::vector<InputProblem>& problems) { std::ranges::for_each(problems, isSentence); }

// ---- TOML
// ------------------------------------------------------------------------------------------------------------

void readTomlText(Bytes bytes)
{
    const std::string text = textOf(bytes);
    const TomlDocument toml = readToml(text);
    if (!toml.problem.empty()) {
        isSentence({"file.toml", toml.problemLine, "", toml.problem});
        return;
    }
    for (const TomlEntry& entry : toml.entries)
        mustHold(entry.begin < entry.end && entry.end <= text.size(), "a value lies in the text: " + entry.key);
    if (toml.entries.empty()) return;
    // One value of a kind that a case may hold is replaced: the others stay, and the text stays TOML.
    const TomlEntry& chosen = toml.entries[bytes.back() % toml.entries.size()];
    if (std::holds_alternative<std::monostate>(chosen.value)) return;
    TomlEditor editor(text, toml);
    editor.put(chosen.key, "123456");
    const std::string changed = editor.result();
    const TomlDocument again = readToml(changed);
    mustHold(again.problem.empty(), "an edited text is TOML: " + again.problem);
    mustHold(again.entries.size() == toml.entries.size(), "an edit adds and removes no key");
    for (std::size_t i = 0; i < again.entries.size(); ++i) {
        mustHold(again.entries[i].key == toml.entries[i].key, "an edit keeps the keys");
        if (&toml.entries[i] == &chosen)
            mustHold(std::get_if<std::int64_t>(&again.entries[i].value) != nullptr, "an edit sets it: " + chosen.key);
    }
}

std::vector<std::string> tomlSeeds()
{
    std::vector<std::string> seeds{"a = 1\n[b]\nc.d = [1, 2.5, 'x']\n[[e]]\nf = { g = true, \"h i\" = -1e9 }\n"};
    for (const SampleCase& sample : sampleCases()) seeds.push_back(sample.text);
    return seeds;
}

// ---- Cases
// -----------------------------------------------------------------------------------------------------------

void readCaseText(Bytes bytes)
{
    const CaseDocument document = parseCase(textOf(bytes), "file.toml");
    areSentences(document.problems);
    areSentences(document.warnings);
    areSentences(document.unused);
    if (!document.valid()) return;
    for (const std::string& written : {formatCase(document.value), updateCaseText(document.text, document.value)}) {
        const CaseDocument again = parseCase(written, "again.toml");
        mustHold(again.valid(), "a case that was written is read: " + (again.valid() ? "" : again.problems[0].text()));
        mustHold(test::firstDifference(again.value, document.value).empty(),
                 "a case that was written is the same: " + test::firstDifference(again.value, document.value));
    }
}

std::vector<std::string> caseSeeds()
{
    std::vector<std::string> seeds;
    for (const SampleCase& sample : sampleCases()) seeds.push_back(sample.text);
    test::RandomCase random(1);
    for (const double probability : {0.05, 0.3, 1.0}) {
        Case c;
        random.change(c, probability);
        seeds.push_back(formatCase(c));
    }
    Case c = defaultsOf(ModelKind::Film);
    c.surface = test::cmlSurface();
    c.surface.distances = {{{0, 1, true}, {1, 3, true}, true, 100e-6}, {{0, 0, false}, {2, 4, false}, false, 0.0}};
    c.surface.symmetries = {{0, 1}, {2, 2}};
    seeds.push_back(formatCase(c));
    return seeds;
}

// ---- Studies
// ---------------------------------------------------------------------------------------------------------

void readStudyText(Bytes bytes)
{
    if (bytes.empty()) return;
    const std::span<const StudyKind> kinds = studyKinds();
    const StudyPlan plan =
        parseStudy(kinds[bytes[0] % kinds.size()].name, textOf(bytes.subspan(1)), "study.toml", "/nonexistent");
    areSentences(plan.problems);
    mustHold(!plan.valid() || plan.perform, "a valid study can be performed");
}

std::vector<std::string> studySeeds()
{
    std::vector<std::string> seeds;
    const std::span<const StudyKind> kinds = studyKinds();
    for (const SampleStudy& sample : sampleStudies()) {
        const auto kind = std::ranges::find(kinds, sample.kind, &StudyKind::name);
        seeds.push_back(std::string(1, static_cast<char>(kind - kinds.begin())) + sample.text);
    }
    return seeds;
}

// ---- Files of the established program
// --------------------------------------------------------------------------------

/// What is read is a case, or there is a reason.
void readCml(const CmlFiles& files)
{
    Case c = defaultsOf(ModelKind::Film);
    CmlParameters parameters(c);
    readCmlFiles(files, parameters);
    areSentences(parameters.problems);
    areSentences(parameters.warnings);
    if (!parameters.problems.empty()) return;
    const CaseDocument document =
        parseCase(formatCase(c), "case.toml", {}, OutsidePaths::Allowed, MeasuredSurface::Unread);
    mustHold(document.valid() || !c.diskSurface.file.empty(),
             "an imported case is one: " + (document.valid() ? "" : document.problems[0].text()));
    if (!document.valid()) return;
    mustHold(test::firstDifference(document.value, c).empty(),
             "an imported case is written and read: " + test::firstDifference(document.value, c));
}

void readRails(Bytes bytes) { readCml({{"rail.dat", textOf(bytes)}, {}, {}}); }
void readRun(Bytes bytes) { readCml({{"rail.dat", test::cmlRailText()}, {"run.dat", textOf(bytes)}, {}}); }
void readDynamics(Bytes bytes) { readCml({{"rail.dat", test::cmlRailText()}, {}, {"dynamics.def", textOf(bytes)}}); }

std::vector<std::string> railSeeds() { return {test::cmlRailText()}; }
std::vector<std::string> runSeeds()
{
    std::vector<std::string> seeds{test::cmlRunText()};
    Case c = defaultsOf(ModelKind::Film);
    c.surface = test::cmlSurface();
    for (const CmlMember& member : formatCmlCase(c).members)
        if (member.name == "run.dat") seeds.push_back(member.text);
    return seeds;
}
std::vector<std::string> dynamicsSeeds() { return {test::cmlDynamicsText()}; }

/// A file in memory, of this process.
std::filesystem::path scratch(const char* name, Bytes bytes)
{
    const std::filesystem::path path =
        std::filesystem::path("/dev/shm") / ("touchdown-fuzz-" + std::to_string(::getpid()) + name);
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path;
}

void readArchive(Bytes bytes)
{
    const std::filesystem::path path = scratch(".cml", bytes);
    const CaseDocument document = readCmlCase(path);
    std::filesystem::remove(path);
    areSentences(document.problems);
    areSentences(document.warnings);
}

std::vector<std::string> archiveSeeds()
{
    const std::filesystem::path path = scratch("seed.cml", {});
    Case c = defaultsOf(ModelKind::Film);
    c.surface = test::cmlSurface();
    std::filesystem::remove(path);
    writeCmlCase(path, formatCmlCase(c).members);
    std::ifstream file(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    std::filesystem::remove(path);
    return {bytes};
}

// ---- Drawings
// ---------------------------------------------------------------------------------------------------------

/// In a second process, as the program does: its library trusts a file.
void readDrawing(Bytes bytes)
{
    const std::filesystem::path path = scratch(".dxf", bytes);
    const Drawing drawing = readDxf(path);
    std::filesystem::remove(path);
    if (!drawing.problem.empty()) return isSentence({"a.dxf", 0, "", drawing.problem});
    mustHold(drawing.remark.empty() || findInvalidUtf8(drawing.remark) == std::string::npos, "a remark is UTF-8");
    mustHold(std::isfinite(drawing.unit) && drawing.unit >= 0.0, "a unit is a length");
    for (const DrawnPath& drawn : drawing.paths) {
        mustHold(drawn.points.size() > 1 && findInvalidUtf8(drawn.layer) == std::string::npos, "a line has two points");
        mustHold(std::ranges::all_of(drawn.points,
                                     [](const SurfacePoint& p) { return std::isfinite(p.x) && std::isfinite(p.y); }),
                 "places are finite");
    }
}

std::vector<std::string> drawingSeeds() { return {dxfText(test::cmlSurface(), 1.25e-3, 1e-3), test::dxfSample()}; }

// ---- Measured surfaces as text
// ---------------------------------------------------------------------------------------

constexpr std::array surfaceNames{"a.txt", "a.csv", "wave.def", "a.gsf", "a.sdf", "a.asc"};
constexpr std::array surfaceUnits{"", "um, nm", "mm"};

void readSurfaceText(Bytes bytes)
{
    if (bytes.empty()) return;
    const std::size_t choice = bytes[0];
    const HeightMapDocument document =
        readHeightMapText(textOf(bytes.subspan(1)), surfaceNames[choice % surfaceNames.size()],
                          surfaceUnits[choice / surfaceNames.size() % surfaceUnits.size()]);
    areSentences(document.problems);
    areSentences(document.warnings);
    if (!document.valid()) return;
    const HeightMap& map = document.map;
    mustHold(map.nx > 1 && map.ny > 0, "a map has points");
    mustHold(map.heights.size() == static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny),
             "a map has a height for each point");
    mustHold(std::ranges::all_of(map.heights, [](double h) { return std::isfinite(h); }), "heights are finite");
    mustHold(std::isfinite(map.dx) && map.dx > 0 && (map.ny == 1 || (std::isfinite(map.dy) && map.dy > 0)),
             "points have distances");
}

std::vector<std::string> surfaceSeeds()
{
    const auto of = [](int choice, const char* text) { return std::string(1, static_cast<char>(choice)) + text; };
    return {
        of(0, "# x [um]  h [nm]\n0 1.0\n1 2.0\n2 1.5\n3 0.5\n"),
        of(0, "# Width: 3 um\n# Height: 2 um\n# Value units: nm\n1 2 3\n4 5 6\n"),
        of(0, "# Channel: Height\n# Spacing: 0.5 um\n# unit: nm\n1\n2\n3\n2\n"),
        of(1, "x_um,h_nm\n0,1\n1,2\n2,1.5\n"),
        of(1, "x;y;height\num;um;nm\n0,0;0,0;1,5\n0,5;0,0;2,5\n0,0;0,5;1,0\n0,5;0,5;2,0\n"),
        of(2, "0 1 2 3\n1e-6 1 2 3\n2e-6 1 2 3\n0 1e-6 2e-6\n"),
        of(3, "Gwyddion Simple Field 1.0\nXRes = 2\nYRes = 2\nXReal = 1e-6\nYReal = 1e-6\nXYUnits = m\nZUnits = m\n"),
        of(4,
           "aBCR-1.0\nManufacID   = Test\nNumPoints   = 3\nNumProfiles = 2\nXscale      = 1.0e-6\nYscale      = "
           "1.0e-6\nZscale      = 1.0e-9\nZresolution = -1\nCompression = 0\nDataType    = 7\nCheckType   = 0\n*\n1 2 "
           "3\n4 5 6\n*\n"),
        of(5, "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n1 2 3\n4 5 6\n"),
        of(6, "0 1.0\n1 2.0\n2 1.5\n3 0.5\n"),
        of(12, "0 0 1.0\n1 0 2.0\n0 1 1.5\n1 1 0.5\n"),
    };
}

std::vector<std::string> changeSeeds() { return {std::string(1, '\0'), "\x01\x02\x03\x04\x05\x06\x07\x08", "change"}; }

} // namespace

std::span<const FuzzedReader> readers()
{
    static constexpr std::array all{
        FuzzedReader{"toml", readTomlText, tomlSeeds},
        FuzzedReader{"case", readCaseText, caseSeeds},
        FuzzedReader{"study", readStudyText, studySeeds},
        FuzzedReader{"rail", readRails, railSeeds},
        FuzzedReader{"run", readRun, runSeeds},
        FuzzedReader{"dynamics", readDynamics, dynamicsSeeds},
        FuzzedReader{"archive", readArchive, archiveSeeds},
        FuzzedReader{"drawing", readDrawing, drawingSeeds},
        FuzzedReader{"surface", readSurfaceText, surfaceSeeds},
        FuzzedReader{"surface-hdf5", readSurfaceFile, changeSeeds},
        FuzzedReader{"run-hdf5", readRunFile, changeSeeds},
        FuzzedReader{"state-hdf5", readStateFile, changeSeeds},
        FuzzedReader{"study-hdf5", readStudyFile, changeSeeds},
    };
    return all;
}

} // namespace touchdown::fuzz
