// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/film/solver_controller.h"

namespace touchdown {

/// Solves for the static state.
class SteadyController : public SolverController<SteadyResult> {
    Q_OBJECT

public:
    /// `solver` is `touchdown::steadyWithContact` or a stand-in of a test.
    explicit SteadyController(Solver solver, QObject* parent = nullptr) : SolverController(std::move(solver), parent) {}

signals:
    void finished(int number, const touchdown::SteadyResult& result);

protected:
    void tell(const SteadyResult& result) override { emit finished(current(), result); }
};

} // namespace touchdown
