// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs of a study of statements, and what each of them says.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/studies/runs/ensemble.h"
#include "core/studies/statements/statement_task.h"
#include "core/studies/study/item_study.h"

namespace touchdown {

/// A run, and the column of the statement's quantity among its samples.
struct SampledRun {
    const MeasuredRun* run = nullptr; // null: there is none
    std::size_t column = 0;
    std::span<const double> samples() const { return run->columns[column]; }
};

/// What one run says of a statement.
struct StatementFinding {
    bool agrees = false;
    std::string text{}; // "ends in contact at 1.6 nm", "94.17 urad"
};
/// `like`: the run that the statement compares with, where it does.
StatementFinding judge(const Statement& statement, SampledRun run, SampledRun like);
/// The quantity whose samples `judge` needs, or none.
std::optional<std::string> sampledBy(const Statement& statement);

struct CheckedStatement {
    bool done = false;
    StatementFinding finding{};   // of the run itself
    std::optional<Share> share{}; // of the ensemble's starts that agree
    /// More than half of the ensemble, where there is one, else the run.
    bool holds() const { return share ? share->share > 0.5 : finding.agrees; }
};

/// As task.statements; only whole ones are done.
using CheckedStatements = std::vector<CheckedStatement>;

/// An item for each statement and one for each start of its ensemble. Its row: whether it agrees, 1 or 0, and what was
/// found. Runs that several statements share are made once, where no part is asked for.
ItemStudy statementItems(const StatementTask& task, std::function<StudyReport(const CheckedStatements&)> reportOf);

} // namespace touchdown
