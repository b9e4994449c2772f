// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lesson, one step at a time: text, question, a button for each run, what to change, and the answer when it is
// asked for.
#pragma once

#include <vector>

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QWidget>

#include "core/studies/lesson/lesson.h"

namespace touchdown {

class LessonPane : public QWidget {
    Q_OBJECT

public:
    explicit LessonPane(std::vector<LessonStep> steps, QWidget* parent = nullptr);

    std::size_t step() const { return step_; }
    const LessonStep& shown() const { return steps_[step_]; }
    /// The first step is 0.
    void go(std::size_t step);

signals:
    void stepShown(std::size_t step);
    void runRequested(const touchdown::LessonRun& run);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void write();
    void buildRuns();
    void showAnswer(bool shown);

    std::vector<LessonStep> steps_;
    std::size_t step_ = 0;
    QScrollArea* scroll_;
    QLabel *place_, *title_, *text_, *question_, *change_, *answer_;
    QWidget* runs_; // a row for each run
    std::vector<QLabel*> purposes_;
    QPushButton *show_, *back_, *next_;
};

} // namespace touchdown
