// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the results that a session left, one after the other, beside the window.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/studies/study/study_file_reader.h"
#include "ui/calculation/calculation_controller.h"
#include "ui/film/series_file.h"
#include "ui/film/solution_files.h"
#include "ui/runs/run_record.h"
#include "ui/sessions/session_state.h"

namespace touchdown {

/// One result, or the solutions that one file of the user has.
struct LeftResult {
    enum class Kind { Run, Solutions, Study, Series };
    Kind kind = Kind::Run;
    std::vector<ListedState> entries; // as the session lists them; none of a study, a series
    std::vector<int> numbers;         // that they get; as many
    QString study;                    // its kind
    QString file;                     // to be read
    bool inFolder = true;             // the file is in the folder of the session
    // After it was read:
    std::unique_ptr<RunRecord> run;
    StoredSolutions solutions;
    StoredStudy report;
    StoredSeries series;
    std::optional<FileIdentity> identity; // of the user's file of a result in the folder, where that has it still
    QString problem;                      // why it could not be read; empty: it was
};

class SessionReader : public CalculationController {
    Q_OBJECT

public:
    explicit SessionReader(QObject* parent) : CalculationController(parent) {}
    ~SessionReader() override { giveUp(); }

    /// See CalculationController::begin.
    int start(std::vector<std::shared_ptr<LeftResult>> results);

signals:
    /// In their order; none after a stop.
    void read(const std::shared_ptr<touchdown::LeftResult>& result);
    void finished(bool stopped);

protected:
    void deliver() override;

private:
    struct Mail {
        std::optional<Progress> progress;
        std::shared_ptr<LeftResult> result; // the next one is read when this is taken
        bool finished = false, stopped = false;
    };

    Mailbox<Mail> mailbox_{*this};
};

} // namespace touchdown
