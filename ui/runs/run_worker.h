// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run on the worker's thread: calls the solver, hands its batches out slice by slice at the pace that the window
// asks for, and records them to a results file.
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/results/results_writer.h"
#include "ui/runs/run_controller.h"

namespace touchdown {

class RunWorker {
public:
    RunWorker(const RunController::Solver& solver, RunRequest request, RunPace& pace, Mailbox<RunMail>& mailbox,
              std::stop_token stop);

    void work();

private:
    /// The part of an update that is handed out together.
    struct Slice {
        std::size_t begin = 0, end = 0; // of the samples
        std::span<const RunEvent> events;
        std::span<const FieldSnapshot> fields;
    };

    void open();
    bool handOut(const RunUpdate& update);
    void post(const RunUpdate& update, const Slice& slice);
    void record(const SampleBatch& samples, std::span<const FieldSnapshot> fields);
    void report(const std::string& recordingProblem);
    Summary shownSummary(Summary summary) const;

    const RunController::Solver& solver_;
    RunRequest request_;
    RunPace& pace_;
    Mailbox<RunMail>& mailbox_;
    std::stop_token stop_;

    bool heldBack_ = false; // stopped with samples that were not shown
    std::vector<double> lastSample_;
    std::optional<ResultsWriter> recorder_; // none after a problem
};

} // namespace touchdown
