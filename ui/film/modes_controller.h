// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/film/solver_controller.h"

namespace touchdown {

/// Finds the air bearing modes about the static state.
class ModesController : public SolverController<ModesResult> {
    Q_OBJECT

public:
    /// `solver` is `touchdown::modes` or a stand-in of a test.
    explicit ModesController(Solver solver, QObject* parent = nullptr) : SolverController(std::move(solver), parent) {}

signals:
    void finished(int number, const touchdown::ModesResult& result);

protected:
    void tell(const ModesResult& result) override { emit finished(current(), result); }
};

} // namespace touchdown
