// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_layout.h"

#include "core/case/parameters.h"
#include "core/formats/hdf5_file.h"
#include "core/results/file_header.h"
#include "core/results/results_samples.h"

namespace touchdown {
namespace {

/// Seed of the random disk; 0 where nothing is random.
int seedOf(const Case& c) { return findParameter("disk.surface.seed")->used(c) ? c.diskSurface.seed : 0; }

} // namespace

Hdf5Group createResultsFile(const std::filesystem::path& path, const ResultsHeader& header)
{
    Hdf5Group file = createHdf5File(path);
    writeFileHeader(file, resultsFormat, resultsFormatMajor, resultsFormatMinor, header.date, header.value.title);
    file.set("seed", std::int64_t{seedOf(header.value)});
    file.set("status", "interrupted");
    file.set("message", "The run was interrupted; what follows the last sample is lost.");
    if (!header.continued.empty()) file.set("continued", header.continued);
    writeCaseGroup(file, header.value, header.caseText);
    createSamples(file, header.quantities, header.fields);
    return file;
}

void writeSpectrum(const Hdf5Group& file, const ResultsSpectrum& entry)
{
    if (entry.spectrum.empty()) return;
    const Hdf5Group all = file.has("spectra") ? file.group("spectra") : file.create("spectra");
    const std::string& name = entry.quantity.name;
    if (all.has(name)) all.remove(name);
    const Hdf5Group group = all.create(name);

    const Spectrum& spectrum = entry.spectrum;
    const bool density = entry.options.scaling == SpectrumScaling::Density;
    // The names and texts of the options are those of the case file.
    Case options;
    options.spectrum = entry.options;
    const auto option = [&](const char* key) {
        const Parameter* parameter = findParameter(key);
        return parameter ? toText(options, *parameter) : std::string();
    };
    group.set("window", option("spectrum.window"));
    group.set("scaling", option("spectrum.scaling"));
    group.set("segment_length", 1.0 / spectrum.frequency[1]);
    group.set("segment_length_unit", "s");
    group.set("segment_samples", static_cast<std::int64_t>(spectrum.segment));
    group.set("segments", static_cast<std::int64_t>(spectrum.segments));
    group.set("overlap", entry.options.overlap);
    group.set("equivalent_noise_bandwidth", spectrum.equivalentNoiseBandwidth);
    group.set("equivalent_noise_bandwidth_unit", "Hz");

    const Hdf5Dataset frequency = group.put("frequency", spectrum.frequency, "Hz", "Frequency");
    frequency.makeScale("frequency");
    const std::string square = entry.quantity.unit.empty() ? "1" : "(" + entry.quantity.unit + ")^2";
    group
        .put(density ? "density" : "power", spectrum.power, density ? square + "/Hz" : square,
             (density ? "Power spectral density: " : "Power spectrum: ") + entry.quantity.longName)
        .attachScale(frequency, 0);
}

} // namespace touchdown
