// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/simulation/static_state/steady.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "ui/calculation/calculation_controller.h"

namespace touchdown {

/// Solves one film case at a time, beside the window. Result: SteadyResult or ModesResult; a derived class has the
/// signal of it, as a template can have none.
template <class Result>
class SolverController : public CalculationController {
public:
    using Solver = std::function<Result(const Case&, const SteadyCallback&)>;

    ~SolverController() override { giveUp(); }

    /// See CalculationController::begin.
    int start(Case c)
    {
        return begin([this, c = std::move(c)](const std::stop_token& stop) {
            Result result;
            try {
                result = solver_(c, [&](const SteadyProgress& progress) {
                    mailbox_.post([&](Mail& mail) { mail.progress = progress; });
                    return !stop.stop_requested();
                });
            } catch (const std::exception& problem) {
                result = {};
                result.message = std::string("The calculation stopped with an error: ") + problem.what();
            }
            mailbox_.post([&](Mail& mail) { mail.result = std::move(result); });
        });
    }

protected:
    SolverController(Solver solver, QObject* parent) : CalculationController(parent), solver_(std::move(solver)) {}

    /// Emits the signal.
    virtual void tell(const Result& result) = 0;

    void deliver() override
    {
        const Mail mail = mailbox_.take();
        if (mail.progress) emit progressed(current(), progressOf(*mail.progress));
        if (!mail.result) return;
        end();
        tell(*mail.result);
    }

private:
    struct Mail {
        std::optional<SteadyProgress> progress;
        std::optional<Result> result;
    };

    Solver solver_;
    Mailbox<Mail> mailbox_{*this};
};

} // namespace touchdown
