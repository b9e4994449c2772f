// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/run_output.h"

#include <utility>

#include "core/case_files/case_text.h"
#include "core/simulation/run.h"

namespace touchdown {

RunOutput::RunOutput(const CaseDocument& document, const Files& files, const std::function<bool()>& goOn,
                     const ContinuedRun& continued, double heldUntil)
    : quantities_(recordedQuantities(document.value)), spectrum_(document.value.spectrum)
{
    // The time series takes its name only at the end of the run, the results at once: nothing may fail after them.
    if (!files.series.empty()) problem_ = csv_.emplace().open(files.series, quantities_, goOn);
    if (problem_.empty() && !files.results.empty()) {
        // The text holds the contents of the files that the case names: the results need no other file.
        const std::string text = updateCaseText(document.text, document.value);
        const std::vector<RecordedFields> fields = recordedFields(document.value);
        ResultsWriter& writer = files.whole ? results_.emplace(std::nullopt) : results_.emplace();
        // What the file holds stays until the run has come as far.
        problem_ = continued.from || !continued.startsAgain.empty()
                       ? writer.openAgain(files.results, document.value, text, quantities_, fields, heldUntil,
                                          continued.remark)
                       : writer.open(files.results, document.value, text, quantities_, fields);
        spectra_.emplace(document.value, quantities_);
    }
}

void RunOutput::addBefore(const SampleBatch& samples, const std::vector<FieldSnapshot>& fields,
                          const ContinuedRun& continued)
{
    add(samples, fields);
    for (const auto& state : continued.states)
        if (problem_.empty() && results_) problem_ = results_->keep(state);
}

void RunOutput::add(const SampleBatch& batch, const std::vector<FieldSnapshot>& fields)
{
    if (spectra_) spectra_->add(batch);
    if (problem_.empty() && results_) problem_ = results_->append(batch, fields);
    if (problem_.empty() && csv_) problem_ = csv_->append(batch);
}

void RunOutput::add(const RunUpdate& update)
{
    add(update.samples, update.fields);
    if (update.checkpoint && problem_.empty() && results_) problem_ = results_->keep(*update.checkpoint);
}

void RunOutput::finish(const Summary& summary)
{
    const auto keep = [this](std::string problem) {
        if (problem_.empty()) problem_ = std::move(problem);
    };
    if (csv_) keep(csv_->close());
    if (!results_) return;
    for (const auto& [quantity, spectrum] : spectra_->spectra())
        keep(results_->addSpectrum(quantity, spectrum, spectrum_));
    keep(results_->finish(summary));
}

} // namespace touchdown
