// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/run_command.h"

#include <algorithm>
#include <optional>

#include "app/commands/case_commands.h"
#include "app/commands/run_report.h"
#include "app/terminal/console.h"
#include "app/terminal/output_target.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/report_text.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/results/csv_writer.h"
#include "core/results/results_writer.h"
#include "core/simulation/recording/run_spectra.h"
#include "core/simulation/run.h"

namespace touchdown {
namespace {

/// The output files of a run. The first problem is kept and ends the run.
class RunOutput {
public:
    RunOutput(const CommandArguments& arguments, const CaseDocument& document)
        : quantities_(recordedQuantities(document.value)), spectrum_(document.value.spectrum)
    {
        if (!arguments.out.empty()) {
            // The text holds the contents of the files that the case names: the results need no other file.
            const std::string text = updateCaseText(document.text, document.value);
            problem_ = results_.emplace().open(arguments.out, document.value, text, quantities_,
                                               recordedFields(document.value));
            spectra_.emplace(document.value, quantities_);
        }
        if (problem_.empty() && !arguments.csv.empty()) problem_ = csv_.emplace().open(arguments.csv, quantities_);
    }

    const std::vector<Quantity>& quantities() const { return quantities_; }
    const std::string& problem() const { return problem_; }

    void add(const SampleBatch& batch, const std::vector<FieldSnapshot>& fields)
    {
        if (spectra_) spectra_->add(batch);
        if (problem_.empty() && results_) problem_ = results_->append(batch, fields);
        if (problem_.empty() && csv_) problem_ = csv_->append(batch);
    }

    void finish(const Summary& summary)
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

private:
    std::vector<Quantity> quantities_;
    SpectrumCase spectrum_;
    std::optional<ResultsWriter> results_;
    std::optional<RunSpectra> spectra_;
    std::optional<CsvWriter> csv_;
    std::string problem_;
};

} // namespace

int runCommand(const CommandArguments& arguments)
{
    const CaseDocument document = openCaseOrComplain(arguments);
    const bool good = targetsAreGood({{"--out", arguments.out}, {"--csv", arguments.csv, true}}, arguments.name);
    if (!document.valid() || !good) return exitWrongInput;
    if (const std::string reason = reasonNotToRun(document.value); !reason.empty()) {
        complain(document.name + ": " + reason);
        return exitWrongInput;
    }

    ProgressLine line(arguments.progress);
    RunOutput output(arguments, document);
    if (!output.problem().empty()) {
        complain(output.problem());
        return exitWrongInput;
    }
    const int spacing = findQuantity(output.quantities(), "minimum_spacing");
    std::optional<double> least; // of all samples so far [m]
    Summary summary = run(document.value, [&](const RunUpdate& update) {
        output.add(update.samples, update.fields);
        if (spacing >= 0)
            for (const double each : update.samples.columns[static_cast<std::size_t>(spacing)])
                least = std::min(least.value_or(each), each);
        return line.show(runProgress(update.time, update.duration, least)) && output.problem().empty();
    });
    line.end();

    output.finish(summary);
    if (!output.problem().empty()) {
        summary.status = RunStatus::Failed;
        summary.message = output.problem();
    }
    print(arguments.json ? runJson(summary, output.quantities())
                         : runText(document.value, summary, output.quantities()));
    if (summary.status == RunStatus::Completed) return exitDone;
    complain(statusText(name(summary.status), summary.message));
    return exitNoAnswer;
}

} // namespace touchdown
