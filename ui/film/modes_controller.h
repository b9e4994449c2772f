// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "core/simulation/static_state/steady.h"
#include "ui/calculation/calculation_controller.h"

namespace touchdown {

/// Finds the air bearing modes of one case at a time, beside the window.
class ModesController : public CalculationController {
    Q_OBJECT

public:
    using Solver = std::function<ModesResult(const Case&, const SteadyCallback&)>;

    /// `solver` is `touchdown::modes` or a stand-in of a test.
    explicit ModesController(Solver solver, QObject* parent = nullptr);
    ~ModesController() override { giveUp(); }

    /// See CalculationController::begin.
    int start(Case c);

signals:
    void finished(int number, const touchdown::ModesResult& result);

protected:
    void deliver() override;

private:
    struct Mail {
        std::optional<SteadyProgress> progress;
        std::optional<ModesResult> result;
    };

    Solver solver_;
    Mailbox<Mail> mailbox_{*this};
};

} // namespace touchdown
