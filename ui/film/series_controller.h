// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solves a series of static states, one after the other, beside the window. Each is the case at that point, solved from
// the case's own start on the case's own grid, as `touchdown steady` does. A start from the state before would save no
// time that can be measured: nearly all of it is spent on the finest grid.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/simulation/static_state/steady.h"
#include "ui/calculation/calculation_controller.h"
#include "ui/film/steady_controller.h"

namespace touchdown {

class SeriesController : public CalculationController {
    Q_OBJECT

public:
    explicit SeriesController(SteadyController::Solver solver, QObject* parent = nullptr);
    ~SeriesController() override { giveUp(); }

    /// See CalculationController::begin. A point at which the case contradicts itself has a failed state with the
    /// reason.
    int start(const Case& c, std::vector<SteadySeriesPoint> points);

signals:
    /// In the order of the points; none for a state that was stopped.
    void solved(std::size_t index, const touchdown::SteadyResult& result);
    void finished(int number, bool stopped);

protected:
    void deliver() override;

private:
    struct Mail {
        std::optional<Progress> progress;
        std::vector<std::pair<std::size_t, SteadyResult>> states;
        bool finished = false, stopped = false;
    };
    SteadyResult solveOne(const Case& c, std::size_t index, std::size_t count, const std::stop_token& stop);

    SteadyController::Solver solver_;
    Mailbox<Mail> mailbox_{*this};
};

} // namespace touchdown
