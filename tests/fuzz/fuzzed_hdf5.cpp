// SPDX-License-Identifier: GPL-3.0-or-later
//
// HDF5 files that the library can read and that no program wrote: a good file whose objects are removed, renamed,
// linked to each other, and replaced by others of any type and shape. (What bytes the library cannot read does, is the
// matter of core/formats/reader_process.h.)
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

#include "core/formats/cml_text.h"
#include "core/formats/hdf5_file.h"
#include "core/formats/output_file.h"
#include "core/formats/surfaces/height_map_hdf5.h"
#include "core/results/results_reader.h"
#include "core/results/steady_reader.h"
#include "core/results/steady_writer.h"
#include "core/studies/study/study_file.h"
#include "core/studies/study/study_file_reader.h"
#include "tests/fuzz/fuzzed_readers.h"
#include "tests/support/sample_results.h"
#include "tests/support/sample_steady.h"

namespace touchdown::fuzz {

namespace {

namespace fs = std::filesystem;

fs::path scratchFile()
{
    static const fs::path path = "/dev/shm/touchdown-fuzz-" + std::to_string(::getpid()) + ".h5";
    return path;
}

/// Takes choices from the drawn bytes; zeros when they are used up.
class Choices {
public:
    explicit Choices(Bytes bytes) : bytes_(bytes) {}
    bool any() const { return !bytes_.empty(); }
    std::size_t below(std::size_t count)
    {
        if (bytes_.empty() || count == 0) return 0;
        const std::size_t value = bytes_.front() % count;
        bytes_ = bytes_.subspan(1);
        return value;
    }
    double number()
    {
        static constexpr std::array<double, 23> special{0.0,    1.0,  -1.0, NAN,   INFINITY, -INFINITY, 1e308, -1e308,
                                                        1e-320, 0.5,  2.0,  3.0,   -7.0,     255.0,     1e9,   2.0e9,
                                                        4.3e9,  1e19, 1e-9, 1e-30, 65536,    1e-15,     42.0};
        return special[below(special.size())];
    }
    std::string text()
    {
        static const std::array special{std::string(),
                                        std::string("completed"),
                                        std::string("m"),
                                        std::string("\xff\xfe"),
                                        std::string("\x1b[31m"),
                                        std::string(70000, 'x'),
                                        std::string("<img src='/dev/zero'>"),
                                        std::string("a\nb"),
                                        std::string("touchdown-study"),
                                        std::string("title = \"x\"\n")};
        return special[below(special.size())];
    }

private:
    Bytes bytes_;
};

/// Names of all objects of a file, "/samples/time".
std::vector<std::string> objectsOf(hid_t file)
{
    std::vector<std::string> names;
    H5Lvisit(
        file, H5_INDEX_NAME, H5_ITER_INC,
        [](hid_t, const char* name, const H5L_info_t*, void* list) {
            static_cast<std::vector<std::string>*>(list)->emplace_back(name);
            return herr_t(0);
        },
        &names);
    return names;
}

std::vector<std::string> attributesOf(hid_t file)
{
    std::vector<std::string> names;
    H5Aiterate2(
        file, H5_INDEX_NAME, H5_ITER_INC, nullptr,
        [](hid_t, const char* name, const H5A_info_t*, void* list) {
            static_cast<std::vector<std::string>*>(list)->emplace_back(name);
            return herr_t(0);
        },
        &names);
    return names;
}

Hdf5Handle drawnType(Choices& choices)
{
    const auto copy = [](hid_t type) { return Hdf5Handle(H5Tcopy(type), H5Tclose); };
    switch (choices.below(9)) {
    case 0: return copy(H5T_IEEE_F32BE);
    case 1: return copy(H5T_STD_I8LE);
    case 2: return copy(H5T_STD_U64BE);
    case 3: return hdf5TextType();
    case 4: {
        Hdf5Handle text = copy(H5T_C_S1);
        H5Tset_size(text, 1 + choices.below(20));
        return text;
    }
    case 5: {
        Hdf5Handle pair(H5Tcreate(H5T_COMPOUND, 16), H5Tclose);
        H5Tinsert(pair, "a", 0, H5T_NATIVE_DOUBLE);
        H5Tinsert(pair, "b", 8, H5T_NATIVE_DOUBLE);
        return pair;
    }
    case 6: {
        const hsize_t size = 2;
        return {H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &size), H5Tclose};
    }
    case 7: return {H5Tvlen_create(H5T_NATIVE_DOUBLE), H5Tclose};
    default: return copy(H5T_IEEE_F64LE);
    }
}

Hdf5Handle drawnSpace(Choices& choices)
{
    const std::size_t rank = choices.below(5);
    if (rank == 4) return {H5Screate(H5S_NULL), H5Sclose};
    if (rank == 0) return {H5Screate(H5S_SCALAR), H5Sclose};
    std::array<hsize_t, 3> shape{};
    for (hsize_t& length : shape) length = choices.below(9);
    return {H5Screate_simple(static_cast<int>(rank), shape.data(), nullptr), H5Sclose};
}

/// Numbers for the elements of `space`, of which there are few.
std::vector<double> drawnNumbers(Choices& choices, hid_t space)
{
    std::vector<double> numbers(static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0)));
    for (double& number : numbers) number = choices.number();
    return numbers;
}

void setAttribute(Choices& choices, hid_t object)
{
    static constexpr std::array own{"unit",    "display_unit",  "long_name",    "format",     "format_version",
                                    "status",  "lower",         "scale_factor", "add_offset", "_FillValue",
                                    "x_label", "missing_value", "motion",       "swing"};
    const std::vector<std::string> there = attributesOf(object);
    const std::size_t which = choices.below(there.size() + own.size());
    const std::string name = which < there.size() ? there[which] : own[which - there.size()];
    H5Adelete(object, name.c_str());
    const std::size_t what = choices.below(4);
    if (what == 0) return;
    const Hdf5Handle type = what == 1 ? hdf5TextType() : drawnType(choices);
    const Hdf5Handle space = what == 1 ? Hdf5Handle(H5Screate(H5S_SCALAR), H5Sclose) : drawnSpace(choices);
    const Hdf5Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (what == 1) {
        const std::string text = choices.text();
        const char* const pointer = text.c_str();
        H5Awrite(attribute, type, &pointer);
    } else if (const std::vector<double> numbers = drawnNumbers(choices, space); !numbers.empty()) {
        H5Awrite(attribute, H5T_NATIVE_DOUBLE, numbers.data());
    }
}

void putDataset(Choices& choices, hid_t file, const std::string& name)
{
    const Hdf5Handle type = drawnType(choices), space = drawnSpace(choices);
    const Hdf5Handle dataset(H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Dclose);
    if (H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) > 0) {
        const auto count = static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0));
        std::vector<std::string> texts(count);
        std::vector<const char*> pointers;
        for (std::string& text : texts) pointers.push_back((text = choices.text()).c_str());
        if (count > 0)
            H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, static_cast<const void*>(pointers.data()));
        return;
    }
    const std::vector<double> numbers = drawnNumbers(choices, space);
    if (!numbers.empty()) H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
}

/// New numbers or another length for a dataset that stays what it is.
void changeNumbers(Choices& choices, hid_t file, const std::string& name)
{
    const Hdf5Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (choices.below(3) == 0) {
        const hsize_t length = choices.below(12);
        const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
        std::array<hsize_t, H5S_MAX_RANK> shape{};
        if (H5Sget_simple_extent_ndims(space) < 1) return;
        H5Sget_simple_extent_dims(space, shape.data(), nullptr);
        shape[0] = length;
        H5Dset_extent(dataset, shape.data());
        return;
    }
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    if (count < 1 || count > 4096) return;
    std::vector<double> numbers(static_cast<std::size_t>(count));
    if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0) return;
    numbers[choices.below(numbers.size())] = choices.number();
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
}

void change(Choices& choices, hid_t file)
{
    std::vector<std::string> names = objectsOf(file);
    names.emplace_back(".");
    const std::string name = names[choices.below(names.size())];
    const std::string other = names[choices.below(names.size())];
    const std::size_t what = choices.below(9);
    if (what == 0) {
        const Hdf5Handle object(H5Oopen(file, name.c_str(), H5P_DEFAULT), H5Oclose);
        setAttribute(choices, object);
    } else if (what == 1) {
        changeNumbers(choices, file, name);
    } else if (name == ".") {
        return;
    } else if (what == 2) {
        H5Ldelete(file, name.c_str(), H5P_DEFAULT);
    } else if (what == 3) {
        H5Ldelete(file, name.c_str(), H5P_DEFAULT);
        putDataset(choices, file, name);
    } else if (what == 4) {
        H5Lmove(file, name.c_str(), file, (other + "/" + std::to_string(choices.below(5))).c_str(), H5P_DEFAULT,
                H5P_DEFAULT);
    } else if (what == 5) {
        H5Ldelete(file, name.c_str(), H5P_DEFAULT);
        H5Lcreate_hard(file, other.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    } else if (what == 6) {
        H5Ldelete(file, name.c_str(), H5P_DEFAULT);
        H5Lcreate_soft(("/" + other).c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    } else if (what == 7) {
        H5Ldelete(file, name.c_str(), H5P_DEFAULT);
        H5Lcreate_external("/etc/passwd", "/", file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    } else {
        const Hdf5Handle group(H5Gcreate2(file, (name + "/" + std::to_string(choices.below(5))).c_str(), H5P_DEFAULT,
                                          H5P_DEFAULT, H5P_DEFAULT),
                               H5Gclose);
    }
}

using Write = std::string (*)(const fs::path&);

/// The file that `write` makes, with the drawn changes.
fs::path changedFile(Bytes bytes, Write write, std::string& good)
{
    const fs::path path = scratchFile();
    if (good.empty()) {
        fs::remove(path);
        mustHold(write(path).empty(), "a good file is written");
        std::ifstream file(path, std::ios::binary);
        good.assign(std::istreambuf_iterator<char>(file), {});
    }
    std::ofstream(path, std::ios::binary | std::ios::trunc) << good;
    const Hdf5Access access;
    const Hdf5Group file = openHdf5File(path, H5F_ACC_RDWR);
    Choices choices(bytes);
    for (int changes = 0; choices.any() && changes < 40; ++changes) try {
            change(choices, file);
        } catch (const Hdf5Error&) { // a change that HDF5 refuses
        }
    return path;
}

void isOneSentence(const std::string& problem)
{
    mustHold(problem.size() < 4000 &&
                 std::ranges::none_of(problem, [](unsigned char c) { return c < 0x20 && c != 0x09; }),
             "a problem is one line: " + problem.substr(0, 300));
}

bool finite(const std::vector<double>& numbers)
{
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

// ---- Good files
// ------------------------------------------------------------------------------------------------------

std::string writeSurface(const fs::path& path)
{
    return writeHdf5File(OutputLock(path), "a surface", [](const Hdf5Group& file) {
        file.put("x", std::vector<double>{0.0, 1.0, 2.0, 3.0}).set("unit", "um");
        file.put("y", std::vector<double>{0.0, 1.0, 2.0}).set("unit", "um");
        const std::array<double, 12> heights{1, 2, 3, 4, 2, 3, 4, 5, 3, 4, 5, 6};
        file.table("height", 3, 4, heights.data(), "nm", "Height");
    });
}

std::string writeRun(const fs::path& path)
{
    ResultsWriter writer(std::nullopt);
    const RecordedFields set{"fields", {{0.0, 1e-3, 2e-3}, {0.0, 1e-3}}, {sampleQuantities[0]}};
    std::string problem = writer.open(path, sampleCase(), sampleCaseText, sampleQuantities, {set});
    if (problem.empty()) problem = writer.append(sampleBatch(0, 6), {{0.0, 0, {{1.0, 2.0}}}, {1e-6, 0, {{3.0, 4.0}}}});
    return problem.empty() ? writer.finish(sampleSummary()) : problem;
}

std::string writeState(const fs::path& path)
{
    SteadyWriter writer;
    std::string problem = writer.open(path, test::sampleFilmCase(), "title = \"x\"\n");
    if (problem.empty()) problem = writer.add({}, test::sampleSteady());
    return problem.empty() ? writer.finish(SteadyStatus::Converged, "") : problem;
}

std::string writeReport(const fs::path& path)
{
    StudyReport report;
    report.kind = "hysteresis";
    report.title = "x";
    report.findings = {"One."};
    report.warnings = {"Two."};
    ChartPanel panel;
    panel.x = {"Time", "s", "ms", true};
    panel.series = {{"up", {{1.0, 2.0, "a"}, {2.0, 3.0}}}};
    panel.bands = {{true, 1.0, 2.0, "band"}};
    panel.map = ChartMap{{1.0, 2.0}, {1.0}, {{"good", 0}}, {0, -1}, {"first", "second"}};
    report.charts = {{"Chart", "Caption.", {panel}}};
    report.tables = {{"runs", {{"a", "m", "nm", "A"}, {"b"}}, {{1.0, "x"}, {{}, "y"}}}};
    report.found = Case{};
    return writeStudy(path, report, Case{}, "title = \"x\"\n", "kind = \"hysteresis\"\n");
}

} // namespace

void readSurfaceFile(Bytes changes)
{
    static std::string good;
    try {
        const HeightMap map = readHeightMapHdf5(changedFile(changes, writeSurface, good));
        mustHold(map.heights.size() == static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny) &&
                     finite(map.heights) && map.dx > 0 && (map.ny == 1 || map.dy > 0),
                 "a map has a finite height for each point");
    } catch (const CmlError& error) {
        isOneSentence(error.what());
    }
}

void readRunFile(Bytes changes)
{
    static std::string good;
    const StoredRun run = readResultsDirectly(changedFile(changes, writeRun, good));
    isOneSentence(run.problem);
    if (!run.problem.empty()) return;
    mustHold(run.samples.columns.size() == run.quantities.size(), "each quantity has a column");
    for (const std::vector<double>& column : run.samples.columns)
        mustHold(column.size() == run.samples.time.size(), "a column has a number for each time");
    mustHold(finite(run.samples.time) && std::ranges::is_sorted(run.samples.time), "times rise");
    for (const FieldSnapshot& snapshot : run.fields) {
        mustHold(snapshot.set < run.recorded.size(), "a snapshot has its set");
        const RecordedFields& set = run.recorded[snapshot.set];
        mustHold(snapshot.values.size() == set.quantities.size(), "a snapshot has each field");
        for (const std::vector<double>& field : snapshot.values)
            mustHold(finite(field) && field.size() == (set.grid.x.size() - 1) * (set.grid.y.size() - 1),
                     "a field has a finite number for each cell");
    }
}

void readStateFile(Bytes changes)
{
    static std::string good;
    const StoredSteady stored = readSteadyDirectly(changedFile(changes, writeState, good));
    isOneSentence(stored.problem);
    for (const SteadyResult& state : stored.states) {
        if (state.pressure.empty()) continue;
        const std::size_t cells = (state.grid.x.size() - 1) * (state.grid.y.size() - 1);
        mustHold(state.pressure.size() == cells && state.gap.size() == cells && finite(state.pressure),
                 "a field has a finite number for each cell");
    }
}

void readStudyFile(Bytes changes)
{
    static std::string good;
    const StoredStudy stored = readStudyDirectly(changedFile(changes, writeReport, good));
    isOneSentence(stored.problem);
    if (!stored.problem.empty()) return;
    for (const StudyTable& table : stored.report.tables)
        for (const std::vector<StudyValue>& row : table.rows) {
            mustHold(row.size() == table.columns.size(), "a row has a value for each column");
            for (const StudyValue& value : row)
                mustHold(!std::get_if<double>(&value) || std::isfinite(std::get<double>(value)), "numbers are finite");
        }
    for (const StudyChart& chart : stored.report.charts)
        for (const ChartPanel& panel : chart.panels) {
            for (const ChartSeries& series : panel.series)
                for (const ChartPoint& point : series.points)
                    mustHold(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.xError) &&
                                 std::isfinite(point.yError),
                             "points are finite");
            if (!panel.map) continue;
            mustHold(panel.map->cells.size() == panel.map->x.size() * panel.map->y.size(), "a map has all cells");
            mustHold(finite(panel.map->x) && finite(panel.map->y) && std::ranges::is_sorted(panel.map->x) &&
                         std::ranges::is_sorted(panel.map->y),
                     "the places of a map rise");
        }
}

} // namespace touchdown::fuzz
