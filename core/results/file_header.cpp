// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/file_header.h"

#include <ctime>

#include "core/case/parameters.h"

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

} // namespace touchdown
