// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_file.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <system_error>

#include "core/results/results_fields.h"
#include "core/results/results_layout.h"
#include "core/results/results_series.h"

namespace touchdown {
namespace {

namespace fs = std::filesystem;

// Why a file cannot be opened at all, told before the library is asked: its own words would not say it so plainly.
std::string unreadable(const fs::path& path)
{
    const std::string name = path.string();
    std::error_code none;
    const fs::file_status status = fs::status(path, none);
    if (!fs::exists(status)) return name + ": there is no such file";
    if (fs::is_directory(status)) return name + " is a directory, not a results file";
    if (!fs::is_regular_file(status)) return name + " is no regular file";
    if (!std::ifstream(path, std::ios::binary)) return name + " cannot be read: no permission";
    if (H5Fis_hdf5(path.c_str()) <= 0) return name + " is not an HDF5 file";
    return {};
}

// Major version of "1.0"; -1 if it is none.
int majorVersion(const std::string& text)
{
    int major = -1;
    std::from_chars(text.data(), text.data() + text.size(), major);
    return major;
}

std::string foreign(const fs::path& path, hid_t file)
{
    if (readHdf5Attribute(file, "format") != resultsFormat)
        return path.string() + " is an HDF5 file, but not the results of a run of Touchdown";
    const std::string version = readHdf5Attribute(file, "format_version");
    const int major = majorVersion(version);
    if (major < 0) return path.string() + " does not say the version of its format";
    if (major > resultsFormatMajor)
        return path.string() + " has format version " + version + ", written by Touchdown " +
               readHdf5Attribute(file, "software_version") + "; this program, version " + TOUCHDOWN_VERSION +
               ", reads versions up to " + std::to_string(resultsFormatMajor) + ".x: use a newer one";
    return {};
}

void readTimeSeries(hid_t file, StoredRun& run)
{
    const Hdf5Handle group = openHdf5Group(file, "timeseries");
    run.samples.time = readSeries(openHdf5Dataset(group, "time"));
    for (const std::string& name : namesInHdf5Group(group)) {
        if (name == "time") continue;
        const Hdf5Handle dataset = openHdf5Dataset(group, name);
        std::vector<double> column = readSeries(dataset);
        if (column.size() != run.samples.size()) throw Hdf5Error(name + " and time differ in length");
        Quantity quantity{name, readHdf5Attribute(dataset, "unit"), readHdf5Attribute(dataset, "display_unit"),
                          readHdf5Attribute(dataset, "long_name")};
        if (quantity.unit == "1") quantity.unit.clear();
        run.quantities.push_back(std::move(quantity));
        run.samples.columns.push_back(std::move(column));
    }
}

} // namespace

StoredRun readResults(const fs::path& path)
{
    const Hdf5Access access;
    StoredRun run;
    const auto refused = [](std::string problem) {
        StoredRun nothing;
        nothing.problem = std::move(problem);
        return nothing;
    };
    if (std::string problem = unreadable(path); !problem.empty()) return refused(std::move(problem));
    try {
        const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, hdf5FileAccess()), H5Fclose);
        if (std::string problem = foreign(path, file); !problem.empty()) return refused(std::move(problem));
        run.title = readHdf5Attribute(file, "title");
        run.status = readHdf5Attribute(file, "status");
        run.message = readHdf5Attribute(file, "message");
        run.softwareVersion = readHdf5Attribute(file, "software_version");
        run.date = readHdf5Attribute(file, "date");
        run.caseText = readHdf5Text(file, "case/text");
        readTimeSeries(file, run);
        StoredFields fields = readFields(file);
        run.recorded = std::move(fields.sets);
        run.fields = std::move(fields.snapshots);
    } catch (const Hdf5Error& error) {
        return refused(path.string() + " is damaged or cut short: " + error.what());
    } catch (const std::bad_alloc&) {
        return refused(path.string() + " does not fit into memory");
    }
    return run;
}

} // namespace touchdown
