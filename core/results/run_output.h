// SPDX-License-Identifier: GPL-3.0-or-later
//
// The output files of a run: results and time series.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/case/case_document.h"
#include "core/results/continued_run.h"
#include "core/results/csv_writer.h"
#include "core/results/results_writer.h"
#include "core/simulation/recording/run_spectra.h"

namespace touchdown {

/// The first problem is kept and ends the run.
class RunOutput {
public:
    struct Files {
        std::string results{}, series{}; // "" for none
        bool whole = false;              // the results appear when the run has ended, else from its beginning on
    };
    /// `goOn` is asked while it waits. `continued`: a run that was begun before, whose file had samples until
    /// `heldUntil` [s]. Then what came before follows, see addBefore().
    RunOutput(const CaseDocument& document, const Files& files, const std::function<bool()>& goOn,
              const ContinuedRun& continued = {}, double heldUntil = 0.0);

    const std::vector<Quantity>& quantities() const { return quantities_; }
    const std::string& problem() const { return problem_; }

    /// All that came before a state from which the run continues.
    void addBefore(const SampleBatch& samples, const std::vector<FieldSnapshot>& fields, const ContinuedRun& continued);
    void add(const RunUpdate& update);
    void finish(const Summary& summary);

private:
    void add(const SampleBatch& batch, const std::vector<FieldSnapshot>& fields);

    std::vector<Quantity> quantities_;
    SpectrumCase spectrum_;
    std::optional<ResultsWriter> results_;
    std::optional<RunSpectra> spectra_;
    std::optional<CsvWriter> csv_;
    std::string problem_;
};

} // namespace touchdown
