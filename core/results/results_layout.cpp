// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_layout.h"

#include <cstdint>
#include <ctime>

#include <hdf5_hl.h>

#include "core/case/fields.h"
#include "core/results/results_fields.h"
#include "core/results/results_file.h"
#include "core/results/results_series.h"

namespace touchdown {
namespace {

constexpr const char* series = "timeseries";

std::string unitText(const std::string& unit) { return unit.empty() ? "1" : unit; }

void writeParameters(hid_t group, const Case& c)
{
    for (const Field& field : fields()) {
        if (field.used && !field.used(c)) continue;
        const FieldValue value = field.get(c);
        Hdf5Handle dataset;
        if (const auto* number = std::get_if<double>(&value))
            dataset = writeHdf5Scalar(group, field.key, *number);
        else if (const auto* whole = std::get_if<int>(&value))
            dataset = writeHdf5Scalar(group, field.key, static_cast<double>(*whole));
        else if (const auto* list = std::get_if<std::vector<double>>(&value))
            dataset = writeHdf5Array(group, field.key, *list);
        else
            dataset = writeHdf5Scalar(group, field.key, toText(c, field));
        describeHdf5(dataset, unitText(field.unit), field.label);
        if (!field.symbol.empty()) writeHdf5Attribute(dataset, "symbol", field.symbol);
    }
}

/// Of what is random in a case; 0 where nothing is.
int seedOf(const Case& c) { return findField("disk.surface.seed")->used(c) ? c.diskSurface.seed : 0; }

void createTimeSeries(hid_t file, const std::vector<Quantity>& quantities)
{
    const Hdf5Handle group = createHdf5Group(file, series);
    const Hdf5Handle time = createHdf5Series(group, "time");
    describeHdf5(time, "s", "Time");
    checkHdf5(H5DSset_scale(time, "time"));
    for (const Quantity& quantity : quantities) {
        const Hdf5Handle dataset = createHdf5Series(group, quantity.name);
        describeHdf5(dataset, unitText(quantity.unit), quantity.longName);
        writeHdf5Attribute(dataset, "display_unit", quantity.displayUnit);
        checkHdf5(H5DSattach_scale(dataset, time, 0));
    }
}

// "time" and the quantities.
std::vector<std::string> seriesNames(const std::vector<Quantity>& quantities)
{
    std::vector<std::string> names{"time"};
    for (const Quantity& quantity : quantities) names.push_back(quantity.name);
    return names;
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

void writeFileHeader(hid_t file, const std::string& format, int major, int minor, const std::string& date,
                     const std::string& title)
{
    writeHdf5Attribute(file, "format", format);
    writeHdf5Attribute(file, "format_version", std::to_string(major) + "." + std::to_string(minor));
    writeHdf5Attribute(file, "software_version", std::string(TOUCHDOWN_VERSION));
    writeHdf5Attribute(file, "date", date);
    writeHdf5Attribute(file, "title", title);
}

void writeCaseGroup(hid_t file, const Case& c, const std::string& text)
{
    const Hdf5Handle group = createHdf5Group(file, "case");
    describeHdf5(writeHdf5Scalar(group, "text", text), "1", "The case as it was given");
    writeParameters(createHdf5Group(group, "parameters"), c);
}

Hdf5Handle createResultsFile(const std::filesystem::path& path, const ResultsHeader& header)
{
    // The sets of fields are told apart by the order of their groups.
    const Hdf5Handle list(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    checkHdf5(H5Pset_link_creation_order(list, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, list, hdf5FileAccess()), H5Fclose);
    writeFileHeader(file, resultsFormat, resultsFormatMajor, resultsFormatMinor, header.date, header.value.title);
    writeHdf5Attribute(file, "seed", std::int64_t{seedOf(header.value)});
    writeHdf5Attribute(file, "status", std::string(interruptedStatus));
    writeHdf5Attribute(file, "message", std::string("The run was interrupted; what follows the last sample is lost."));
    writeCaseGroup(file, header.value, header.caseText);
    createTimeSeries(file, header.quantities);
    createFields(file, header.fields);
    return file;
}

hsize_t storedSamples(hid_t file) { return seriesLength(openHdf5Dataset(file, std::string(series) + "/time")); }

void copyMissingSamples(hid_t from, hid_t to, const std::vector<Quantity>& quantities)
{
    const Hdf5Handle source = openHdf5Group(from, series);
    const Hdf5Handle target = openHdf5Group(to, series);
    for (const std::string& name : seriesNames(quantities))
        copyMissingChunks(openHdf5Dataset(source, name), openHdf5Dataset(target, name));
}

void appendSamples(hid_t file, const std::vector<Quantity>& quantities, const SampleBatch& batch)
{
    if (batch.size() == 0) return;
    const Hdf5Handle group = openHdf5Group(file, series);
    appendToSeries(openHdf5Dataset(group, "time"), batch.time);
    for (std::size_t i = 0; i < quantities.size(); ++i)
        appendToSeries(openHdf5Dataset(group, quantities[i].name), batch.columns[i]);
}

hsize_t storedBytes(hid_t file, const std::vector<Quantity>& quantities)
{
    const Hdf5Handle group = openHdf5Group(file, series);
    hsize_t bytes = 0;
    for (const std::string& name : seriesNames(quantities)) bytes += H5Dget_storage_size(openHdf5Dataset(group, name));
    return bytes;
}

void writeSpectrum(hid_t file, const ResultsSpectrum& entry)
{
    if (entry.spectrum.empty()) return;
    const Hdf5Handle all =
        H5Lexists(file, "spectra", H5P_DEFAULT) > 0 ? openHdf5Group(file, "spectra") : createHdf5Group(file, "spectra");
    const std::string& name = entry.quantity.name;
    if (H5Lexists(all, name.c_str(), H5P_DEFAULT) > 0) checkHdf5(H5Ldelete(all, name.c_str(), H5P_DEFAULT));
    const Hdf5Handle group = createHdf5Group(all, name);

    const Spectrum& spectrum = entry.spectrum;
    const bool density = entry.options.scaling == SpectrumScaling::Density;
    // The names and texts of the options are those of the case file.
    Case options;
    options.spectrum = entry.options;
    const auto option = [&](const char* key) {
        const Field* field = findField(key);
        return field ? toText(options, *field) : std::string();
    };
    writeHdf5Attribute(group, "window", option("spectrum.window"));
    writeHdf5Attribute(group, "scaling", option("spectrum.scaling"));
    writeHdf5Attribute(group, "segment_length", 1.0 / spectrum.frequency[1]);
    writeHdf5Attribute(group, "segment_length_unit", std::string("s"));
    writeHdf5Attribute(group, "segment_samples", static_cast<std::int64_t>(spectrum.segment));
    writeHdf5Attribute(group, "segments", static_cast<std::int64_t>(spectrum.segments));
    writeHdf5Attribute(group, "overlap", entry.options.overlap);
    writeHdf5Attribute(group, "equivalent_noise_bandwidth", spectrum.equivalentNoiseBandwidth);
    writeHdf5Attribute(group, "equivalent_noise_bandwidth_unit", std::string("Hz"));

    const Hdf5Handle frequency = writeHdf5Array(group, "frequency", spectrum.frequency);
    describeHdf5(frequency, "Hz", "Frequency");
    checkHdf5(H5DSset_scale(frequency, "frequency"));
    const Hdf5Handle power = writeHdf5Array(group, density ? "density" : "power", spectrum.power);
    const std::string square = entry.quantity.unit.empty() ? "1" : "(" + entry.quantity.unit + ")^2";
    describeHdf5(power, density ? square + "/Hz" : square,
                 (density ? "Power spectral density: " : "Power spectrum: ") + entry.quantity.longName);
    checkHdf5(H5DSattach_scale(power, frequency, 0));
}

} // namespace touchdown
