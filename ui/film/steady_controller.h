// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "core/simulation/static_state/steady.h"
#include "ui/calculation/calculation_controller.h"

namespace touchdown {

/// Solves one case at a time for its static state, beside the window.
class SteadyController : public CalculationController {
    Q_OBJECT

public:
    using Solver = std::function<SteadyResult(const Case&, const SteadyCallback&)>;

    /// `solver` is `touchdown::steady` or a stand-in of a test.
    explicit SteadyController(Solver solver, QObject* parent = nullptr);
    ~SteadyController() override { giveUp(); }

    /// See CalculationController::begin.
    int start(Case c);

signals:
    void finished(int number, const touchdown::SteadyResult& result);

protected:
    void deliver() override;

private:
    struct Mail {
        std::optional<SteadyProgress> progress;
        std::optional<SteadyResult> result;
    };

    Solver solver_;
    Mailbox<Mail> mailbox_{*this};
};

} // namespace touchdown
