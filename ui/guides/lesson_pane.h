// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lesson or the demonstrations, one step at a time: text, a button for each run, values to move, what to change.
// The lesson asks a question and answers it when it is asked to; a demonstration says what to watch, and how sure it
// is. The first use of a term in a step leads to its explanation.
#pragma once

#include <utility>
#include <vector>

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QWidget>

#include "core/studies/lesson/lesson.h"
#include "ui/guides/term_marks.h"

namespace touchdown {

class LiveValues;

class LessonPane : public QWidget {
    Q_OBJECT

public:
    enum class Kind { Lesson, Demonstrations };

    explicit LessonPane(Kind kind, std::vector<LessonStep> steps, QWidget* parent = nullptr);

    Kind kind() const { return kind_; }
    std::size_t step() const { return step_; }
    std::size_t count() const { return steps_.size(); }
    const LessonStep& shown() const { return steps_[step_]; }
    /// The first step is 0.
    void go(std::size_t step);
    LiveValues& live() { return *live_; }
    /// What a run of the shown step gave, in a few words, in the colour of failure if it did not complete; "" takes it
    /// back.
    void showResult(std::size_t run, const QString& result, bool completed = true);
    /// As the button of a run of the shown step.
    void perform(std::size_t run) { emit runRequested(shown().runs.at(run)); }
    /// Of the shown step, as HTML.
    QString questionText() const { return question_->text(); }
    QString answerText() const { return answer_->text(); }
    QString runText(std::size_t run) const { return purposes_.at(run)->text(); }

signals:
    void stepShown(std::size_t step);
    /// The texts have changed.
    void written();
    void runRequested(const touchdown::LessonRun& run);
    /// A key of a parameter in the text was chosen.
    void keyChosen(const QString& key);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void write();
    void buildRuns();
    void showAnswer(bool shown);

    Kind kind_;
    std::vector<LessonStep> steps_;
    std::size_t step_ = 0;
    QScrollArea* scroll_;
    QLabel *place_, *title_, *text_, *question_, *change_, *answer_;
    QWidget* runs_; // a row for each run
    LiveValues* live_;
    TermMarks terms_;
    std::vector<QLabel*> purposes_;
    std::vector<std::pair<QString, bool>> results_; // of the runs of the shown step, and whether they completed
    QPushButton *show_, *back_, *next_;
};

} // namespace touchdown
