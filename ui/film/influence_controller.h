// SPDX-License-Identifier: GPL-3.0-or-later
//
// What each rail and each edge does to the flying height, beside the window: on the case's grid, or on 193 x 193 nodes
// where that is finer.
#pragma once

#include <optional>
#include <vector>

#include "core/simulation/static_state/sensitivity.h"
#include "ui/calculation/calculation_controller.h"

namespace touchdown {

class InfluenceController : public CalculationController {
    Q_OBJECT

public:
    explicit InfluenceController(QObject* parent = nullptr) : CalculationController(parent) {}
    ~InfluenceController() override { giveUp(); }

    /// Of these parts of a film case with a valid surface; ends the calculation before.
    void start(const Case& c, const PartSelection& parts);

signals:
    /// As far as it is found: rails first, then edge by edge. Empty where the slider does not fly.
    void found(const std::vector<touchdown::PartInfluence>& influence);

protected:
    void deliver() override;

private:
    struct Mail {
        std::optional<std::vector<PartInfluence>> influence;
        bool finished = false, stopped = false;
    };
    Mailbox<Mail> mailbox_{*this};
};

} // namespace touchdown
