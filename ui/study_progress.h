// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a study is: its share, what it does, the time left.
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QWidget>

#include "ui/study_controller.h"

namespace touchdown {

class StudyProgressLine : public QWidget {
    Q_OBJECT

public:
    explicit StudyProgressLine(QWidget* parent = nullptr);

    void setState(StudyController::State state);
    void advance(double share, const QString& doing);
    void end(const StudyReport& report);
    QString text() const { return text_->text(); }

private:
    QLabel* state_;
    QProgressBar* bar_;
    QLabel* text_;
    QElapsedTimer clock_;
    double share_ = 0.0;
};

/// "40 s left", "3 min left"; empty while too little is done to tell.
QString timeLeftText(double share, double seconds);

} // namespace touchdown
