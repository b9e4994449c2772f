// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/run_command.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include <unistd.h>

#include "app/commands/case_commands.h"
#include "app/commands/run_report.h"
#include "app/terminal/output_target.h"
#include "app/terminal/progress_line.h"
#include "app/terminal/stop_signal.h"
#include "core/case_files/case_text.h"
#include "core/formats/output_file.h"
#include "core/results/csv_writer.h"
#include "core/results/results_writer.h"
#include "core/simulation/recording/run_spectra.h"
#include "core/simulation/run.h"

namespace touchdown {
namespace {

namespace fs = std::filesystem;

// Unlike HDF5, CSV may go into a device or a pipe.
std::string checkCsvTarget(const std::string& file)
{
    std::error_code none;
    const fs::file_status status = fs::status(file, none);
    const bool stream = fs::is_character_file(status) || fs::is_fifo(status);
    return stream && ::access(file.c_str(), W_OK) == 0 ? std::string() : checkOutputFile(file);
}

// Everything that can be known to go wrong with the output before anything is written.
bool targetsAreGood(const RunArguments& arguments)
{
    const std::string& name = arguments.caseArguments.name;
    bool good = targetIsGood("--out", arguments.out, checkOutputFile(arguments.out), name);
    good = targetIsGood("--csv", arguments.csv, checkCsvTarget(arguments.csv), name) && good;
    if (!arguments.out.empty() && !arguments.csv.empty() && sameFile(arguments.out, arguments.csv)) {
        complain("--out and --csv: both name " + arguments.out);
        good = false;
    }
    return good;
}

// The minimum spacing of all samples so far [m].
struct LeastSpacing {
    explicit LeastSpacing(const std::vector<Quantity>& quantities) : column(findQuantity(quantities, "minimum_spacing"))
    {}
    void add(const SampleBatch& batch)
    {
        if (column < 0) return;
        for (const double each : batch.columns[static_cast<std::size_t>(column)])
            least = least ? std::min(*least, each) : each;
    }
    int column;
    std::optional<double> least{};
};

// The files that a run fills. The first problem is kept, and ends the run.
class RunOutput {
public:
    RunOutput(const RunArguments& arguments, const CaseDocument& document)
        : quantities_(recordedQuantities(document.value)), spectrum_(document.value.spectrum)
    {
        if (!arguments.out.empty()) {
            // Without the files that the text may name, so that the results stand alone.
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

int runCommand(const RunArguments& arguments)
{
    const CaseDocument document = openCaseOrComplain(arguments.caseArguments);
    const bool good = targetsAreGood(arguments);
    if (!document.valid() || !good) return exitWrongInput;
    if (const std::string reason = reasonNotToRun(document.value); !reason.empty()) {
        complain(document.name + ": " + reason);
        return exitWrongInput;
    }

    const StopSignal stop;
    RunOutput output(arguments, document);
    if (!output.problem().empty()) {
        complain(output.problem());
        return exitWrongInput;
    }
    ProgressLine line(arguments.progress);
    LeastSpacing spacing(output.quantities());
    Summary summary = run(document.value, [&](const RunUpdate& update) {
        output.add(update.samples, update.fields);
        spacing.add(update.samples);
        line.show(runProgress(update.time, update.duration, spacing.least));
        return !stop.requested() && output.problem().empty();
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
    complain(std::string(name(summary.status)) + (summary.message.empty() ? "" : ": " + summary.message));
    return exitNoAnswer;
}

} // namespace touchdown
