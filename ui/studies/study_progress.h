// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a study is: its share, what it does, the time left.
#pragma once

#include <QElapsedTimer>

#include "ui/calculation/progress_strip.h"
#include "ui/studies/study_controller.h"

namespace touchdown {

class StudyProgressLine : public ProgressStrip {
    Q_OBJECT

public:
    explicit StudyProgressLine(QWidget* parent = nullptr);

    void setState(StudyController::State state);
    void advance(double share, const QString& doing);
    void end(const StudyReport& report);

private:
    QElapsedTimer clock_;
};

/// "40 s left", "3 min left"; empty while too little is done to tell.
QString timeLeftText(double share, double seconds);

} // namespace touchdown
