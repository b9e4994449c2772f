// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results whose every number can be foretold.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <QString>

#include "core/results/results_reader.h"
#include "core/results/results_writer.h"

namespace touchdown {

inline const std::vector<Quantity> sampleQuantities{{"minimum_spacing", "m", "nm", "Minimum spacing"},
                                                    {"pitch", "rad", "urad", "Pitch"}};

// Sample k of a column, so that every stored number can be foretold.
inline double sampleValue(std::size_t column, std::size_t k)
{
    const auto x = static_cast<double>(k);
    return column == 0 ? x * 1e-7 : std::sin(x * 0.01 * static_cast<double>(column)) * 1e-9 + x * 1e-17;
}

inline SampleBatch sampleBatch(std::size_t first, std::size_t count)
{
    SampleBatch b;
    b.columns.resize(sampleQuantities.size());
    for (std::size_t k = first; k < first + count; ++k) {
        b.time.push_back(sampleValue(0, k));
        for (std::size_t i = 0; i < b.columns.size(); ++i) b.columns[i].push_back(sampleValue(i + 1, k));
    }
    return b;
}

// "" if the samples are the first ones of the series, each number exact.
inline QString wrongSample(const SampleBatch& samples)
{
    if (samples.columns.size() != sampleQuantities.size()) return "number of columns";
    for (std::size_t k = 0; k < samples.size(); ++k)
        for (std::size_t i = 0; i <= sampleQuantities.size(); ++i)
            if ((i == 0 ? samples.time[k] : samples.columns[i - 1][k]) != sampleValue(i, k))
                return QString("column %1, sample %2").arg(i).arg(k);
    return {};
}

inline std::string bytes(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline void put(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
}

inline Case sampleCase()
{
    Case c;
    c.title = "Ein Läufer über der Platte";
    c.springs.cutoff = 0.4e-9;
    return c;
}

inline const std::string sampleCaseText = "# µ and θ are fine here\ntitle = \"Ein Läufer über der Platte\"\n\n";

inline Summary sampleSummary()
{
    Summary s;
    s.status = RunStatus::Failed;
    s.message = "the rear air spring is lost";
    s.endTime = 2e-3;
    s.steps = 123;
    s.final = {{"minimum_spacing", 7e-9}, {"pitch", 90e-6}};
    s.tail = {{"pitch", {90e-6, 1e-9, 89e-6, 91e-6}}};
    s.events = {{1e-6, "touch-down"}, {2e-6, "rear spring lost"}};
    s.peaks = {{8e5, 1e-10}};
    s.warnings = {"a warning"};
    return s;
}

} // namespace touchdown
