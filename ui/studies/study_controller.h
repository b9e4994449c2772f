// SPDX-License-Identifier: GPL-3.0-or-later
//
// Performs one study at a time, beside the window. A study that is stopped ends within 50 ms.
#pragma once

#include <optional>

#include "core/studies/study/study.h"
#include "ui/calculation/calculation_controller.h"

namespace touchdown {

class StudyController : public CalculationController {
    Q_OBJECT

public:
    explicit StudyController(QObject* parent = nullptr) : CalculationController(parent) {}
    ~StudyController() override { giveUp(); }

    /// On up to `jobs` threads; see CalculationController::begin.
    int start(StudyPerformance perform, int jobs);

signals:
    /// The report so far; it has more to show than before.
    void partial(int number, const touchdown::StudyReport& report);
    void finished(int number, const touchdown::StudyReport& report);

protected:
    void deliver() override;

private:
    struct Mail {
        std::optional<Progress> progress;
        std::optional<StudyReport> partial;
        std::optional<StudyReport> report;
    };

    void work(const StudyPerformance& perform, int jobs, const std::stop_token& stop);

    Mailbox<Mail> mailbox_{*this};
};

} // namespace touchdown
