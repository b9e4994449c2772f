// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_reader.h"

#include <charconv>
#include <fstream>
#include <new>
#include <system_error>

#include "core/formats/hdf5_file.h"
#include "core/results/results_layout.h"
#include "core/results/results_samples.h"

namespace touchdown {
namespace {

namespace fs = std::filesystem;

// Why a file cannot be opened at all, in plainer words than those of the library.
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

std::string foreign(const fs::path& path, const Hdf5Group& file)
{
    if (file.attribute("format") != resultsFormat)
        return path.string() + " is an HDF5 file, but not the results of a run of Touchdown";
    const std::string version = file.attribute("format_version");
    const int major = majorVersion(version);
    if (major < 0) return path.string() + " does not say the version of its format";
    if (major > resultsFormatMajor)
        return path.string() + " has format version " + version + ", written by Touchdown " +
               file.attribute("software_version") + "; this program, version " + TOUCHDOWN_VERSION +
               ", reads versions up to " + std::to_string(resultsFormatMajor) + ".x: use a newer one";
    return {};
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
        const Hdf5Group file = openHdf5File(path);
        if (std::string problem = foreign(path, file); !problem.empty()) return refused(std::move(problem));
        run.title = file.attribute("title");
        run.status = file.attribute("status");
        run.message = file.attribute("message");
        run.softwareVersion = file.attribute("software_version");
        run.date = file.attribute("date");
        run.caseText = file.get("case/text").text();
        StoredSamples stored = readSamples(file);
        run.quantities = std::move(stored.quantities);
        run.samples = std::move(stored.samples);
        run.recorded = std::move(stored.sets);
        run.fields = std::move(stored.snapshots);
    } catch (const Hdf5Error& error) {
        return refused(path.string() + " is damaged or cut short: " + error.what());
    } catch (const std::bad_alloc&) {
        return refused(path.string() + " does not fit into memory");
    }
    return run;
}

} // namespace touchdown
