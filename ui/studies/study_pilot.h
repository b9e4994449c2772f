// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long a study will take: its first seconds are performed in the background, and the share of the study that they
// did gives the whole. Nothing of it is kept.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <QString>

#include "core/studies/study/study.h"
#include "core/work/wall_clock.h"
#include "ui/calculation/calculation_controller.h"

namespace touchdown {

class StudyPilot : public CalculationController {
    Q_OBJECT

public:
    explicit StudyPilot(QObject* parent = nullptr) : CalculationController(parent) {}
    ~StudyPilot() override { giveUp(); }

    /// On as many threads as the study itself will have.
    void start(StudyPerformance perform, int jobs);
    /// Of the next starts [s]; read on the thread of the pilot.
    void setClock(std::function<double()> clock) { clock_ = std::move(clock); }

signals:
    /// The time of the whole study [s]; none where nothing was done in the first seconds. A pilot that is stopped says
    /// nothing.
    void estimated(std::optional<double> seconds);
    /// The study cannot be performed; it says itself what is wrong.
    void failed();

protected:
    void deliver() override;

private:
    struct Estimate {
        std::optional<double> seconds;
        bool failed = false;
    };
    struct Mail {
        std::optional<Estimate> estimate;
    };

    static Estimate performPilot(const StudyPerformance& perform, int jobs, const std::function<double()>& clock,
                                 const std::stop_token& stop);

    std::function<double()> clock_ = wallClock;
    Mailbox<Mail> mailbox_{*this};
};

/// "less than 1 s", "about 20 s", "about 3 min", "about 1.5 h": an estimate has no more digits.
QString roughTime(double seconds);

} // namespace touchdown
