// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/run_spectra.h"

#include "core/simulation/recording/last_sample.h"
#include "core/simulation/recording/run_statistics.h"

namespace touchdown {
namespace {

constexpr std::size_t mostSamples = std::size_t{1} << 21; // 16 MiB a signal

} // namespace

RunSpectra::RunSpectra(const Case& c, const std::vector<Quantity>& quantities)
    : options_(c.spectrum), interval_(c.run.sampleInterval)
{
    if (c.model == ModelKind::Contact) return; // it is moved, and does not oscillate
    for (const char* name : {"flying_height", "minimum_spacing", "pitch", "roll"})
        if (const int i = findQuantity(quantities, name); i >= 0) {
            const auto column = static_cast<std::size_t>(i);
            signals_.push_back({quantities[column], column, {}});
        }
}

void RunSpectra::add(const SampleBatch& batch)
{
    for (Signal& signal : signals_) {
        const std::vector<double>& column = batch.columns[signal.column];
        for (std::size_t k = 0; k < batch.size(); ++k)
            if (batch.time[k] >= options_.start && !isBetweenSamples(batch.time[k], interval_))
                signal.values.push_back(column[k]);
        if (signal.values.size() > 2 * mostSamples)
            signal.values.erase(signal.values.begin(), signal.values.end() - mostSamples);
    }
}

std::vector<std::pair<Quantity, Spectrum>> RunSpectra::spectra() const
{
    std::vector<std::pair<Quantity, Spectrum>> result;
    WelchEstimator estimate(welchOptions(options_, interval_));
    for (const Signal& signal : signals_)
        if (Spectrum spectrum = estimate(signal.values, interval_); !spectrum.empty())
            result.emplace_back(signal.quantity, std::move(spectrum));
    return result;
}

} // namespace touchdown
