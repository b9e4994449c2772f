// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/file_header.h"

#include <charconv>
#include <ctime>
#include <fstream>
#include <system_error>

#include "core/case/parameters.h"
#include "core/formats/hdf5_file.h"
#include "core/formats/reader_process.h"
#include "core/formats/text_file.h"

namespace touchdown {
namespace {

Hdf5Dataset putParameter(const Hdf5Group& group, const Case& c, const Parameter& parameter)
{
    const ParameterValue value = parameter.get(c);
    if (const auto* number = std::get_if<double>(&value)) return group.put(parameter.key, *number);
    if (const auto* whole = std::get_if<int>(&value)) return group.put(parameter.key, static_cast<double>(*whole));
    if (const auto* list = std::get_if<std::vector<double>>(&value)) return group.put(parameter.key, *list);
    return group.put(parameter.key, toText(c, parameter));
}

/// Of "1.0"; -1 if it is none.
int majorVersion(const std::string& text)
{
    int major = -1;
    std::from_chars(text.data(), text.data() + text.size(), major);
    return major;
}

} // namespace

std::string dateNow()
{
    const std::time_t seconds = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    char text[32];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

void writeFileHeader(const Hdf5Group& file, const std::string& format, int major, int minor, const std::string& date,
                     const std::string& title)
{
    file.set("format", format);
    file.set("format_version", std::to_string(major) + "." + std::to_string(minor));
    file.set("software_version", TOUCHDOWN_VERSION);
    file.set("date", date);
    file.set("title", title);
}

void writeCaseGroup(const Hdf5Group& file, const Case& c, const std::string& text)
{
    const Hdf5Group group = file.create("case");
    group.put("text", text, "1", "The case as it was given");
    const Hdf5Group values = group.create("parameters");
    for (const Parameter& parameter : parameters()) {
        if (parameter.used && !parameter.used(c)) continue;
        const Hdf5Dataset dataset = putParameter(values, c, parameter);
        dataset.describe(parameter.unit, parameter.label);
        if (!parameter.symbol.empty()) dataset.set("symbol", parameter.symbol);
    }
}

std::string notHdf5(const std::filesystem::path& path)
{
    const std::string name = path.string();
    std::error_code none;
    const std::filesystem::file_status status = std::filesystem::status(path, none);
    if (!std::filesystem::exists(status)) return name + ": there is no such file";
    if (std::filesystem::is_directory(status)) return name + " is a directory, not a results file";
    if (!notRegularFile(path).empty()) return name + " is no regular file";
    if (!std::ifstream(path, std::ios::binary)) return name + " cannot be read: no permission";
    if (H5Fis_hdf5(path.c_str()) <= 0) return name + " is not an HDF5 file";
    return {};
}

std::string foreignFile(const std::filesystem::path& path, const Hdf5Group& file, const std::string& format, int major,
                        const std::string& what)
{
    if (file.attribute("format") != format)
        return path.string() + " is an HDF5 file, but not " + what + " of Touchdown";
    const std::string version = file.attribute("format_version");
    const int found = majorVersion(version);
    if (found < 0) return path.string() + " does not say the version of its format";
    if (found > major)
        return path.string() + " has format version " + version + ", written by Touchdown " +
               file.attribute("software_version") + "; this program, version " + TOUCHDOWN_VERSION +
               ", reads versions up to " + std::to_string(major) + ".x: use a newer one";
    return {};
}

std::string formatOf(const std::filesystem::path& path)
{
    std::string format;
    try {
        readAnswer({"format", path, ""}, format);
    } catch (const ReaderFailure&) {
        return {};
    }
    return format;
}

std::string formatDirectly(const std::filesystem::path& path)
{
    const Hdf5Access access;
    if (!notHdf5(path).empty()) return {};
    try {
        return openHdf5File(path).attribute("format");
    } catch (const Hdf5Error&) {
        return {};
    }
}

} // namespace touchdown
