// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spectra of a run's motion, from the samples as they come, in bounded memory.
#pragma once

#include <utility>
#include <vector>

#include "core/case/case.h"
#include "core/simulation/recording/quantity.h"

namespace touchdown {

class RunSpectra {
public:
    /// Spectra of flying height, minimum spacing, pitch and roll, as far as they are recorded.
    RunSpectra(const Case& c, const std::vector<Quantity>& quantities);

    void add(const SampleBatch& batch);
    /// As the case asks for them; without those for which there are too few samples.
    std::vector<std::pair<Quantity, Spectrum>> spectra() const;

private:
    struct Signal {
        Quantity quantity;
        std::size_t column = 0;
        std::vector<double> values; // the newest
    };
    SpectrumCase options_;
    double interval_; // [s]
    std::vector<Signal> signals_;
};

} // namespace touchdown
