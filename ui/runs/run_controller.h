// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs one case at a time beside the window; a run can pause, advance by single steps and run in slow motion.
//
// No sample is lost: the worker appends the solver's batches to the mail. The mail is bounded, so that a delivery is
// short and the window keeps responding; a solver that is faster than the window waits for room.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "core/case/case.h"
#include "core/results/results_checkpoint.h"
#include "core/simulation/recording/field_snapshot.h"
#include "core/simulation/recording/run_summary.h"
#include "ui/calculation/calculation_controller.h"
#include "ui/runs/run_pace.h"

namespace touchdown {

/// What came before in a run that continues.
struct EarlierRun {
    std::vector<SampleBatch> samples;
    std::vector<RunEvent> events;
    std::vector<FieldSnapshot> fields;
    std::vector<std::shared_ptr<const StoredCheckpoint>> states; // see ContinuedRun; it continues from the last one
    std::string remark;
};

struct RunRequest {
    Case value;
    std::string caseText;           // the exact input, for the results file
    std::filesystem::path recordTo; // a results file written during the run; empty for none
    RunOptions options = {};
    std::shared_ptr<const EarlierRun> earlier = nullptr; // null: the run begins
};

/// Samples, events and fields since the last delivery.
struct RunDelivery {
    int run = 0; // number of the run
    SampleBatch samples;
    std::vector<RunEvent> events;
    std::optional<std::vector<RecordedFields>> sets; // of which there will be snapshots: once, before the first one
    std::vector<FieldSnapshot> fields;               // of these sets
    ResultsCheckpoints checkpoints;                  // of all that was delivered
    double time = 0.0;                               // reached [s]
    double duration = 0.0; // of the whole run [s]; 0 without an update since the last delivery
};

struct RunMail {
    RunDelivery delivery;
    std::optional<Summary> summary;
    std::string recordingProblem;
    bool wasFull = false; // the worker had to wait for room
};

class RunController : public CalculationController {
    Q_OBJECT

public:
    using Solver = std::function<Summary(const Case&, const RunCallback&, const RunOptions&)>;
    static constexpr double fullSpeed = RunPace::fullSpeed;

    explicit RunController(QObject* parent = nullptr);
    /// With another solver than `touchdown::run`.
    explicit RunController(Solver solver, QObject* parent = nullptr);
    ~RunController() override { giveUp(); }

    /// See CalculationController::begin.
    int start(RunRequest request);

    double pace() const { return pace_.value(); }

public slots:
    void pause();
    void resume();
    /// Advances a paused run by one picture: 1/60 s of its pace, or 1/200 of its duration at full speed.
    void step();
    /// Simulated seconds per second of wall time; takes effect at once.
    void setPace(double simulatedPerWallSecond) { pace_.set(simulatedPerWallSecond); }

signals:
    void delivered(const touchdown::RunDelivery& delivery);
    void finished(int run, const touchdown::Summary& summary);
    /// The results file could not be written; the run continues without it.
    void recordingFailed(int run, const QString& problem);

protected:
    void deliver() override;

private:
    Solver solver_;
    RunPace pace_;
    Mailbox<RunMail> mailbox_{*this};
};

} // namespace touchdown
