// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step of the lesson or of the demonstrations for a lecture, without its pane: the question or what to watch, a
// button with a number for each run and what the last one gave, the values to move beside one another.
#pragma once

#include <vector>

#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QWidget>

namespace touchdown {

class LessonPane;
class LiveValues;

class GuideStrip : public QWidget {
    Q_OBJECT

public:
    explicit GuideStrip(QWidget* parent = nullptr);

    /// Shows what the pane shows, from now on; nullptr: hidden.
    void follow(LessonPane* pane);
    LiveValues& live() { return *live_; }
    const std::vector<QToolButton*>& runs() const { return runs_; }
    QPushButton* answer() const { return answer_; }

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showStep();
    void write();
    void fitText();
    void perform(std::size_t run);

    QPointer<LessonPane> pane_;
    QScrollArea* scroll_; // about the text
    QLabel *text_, *run_;
    QWidget* row_;                   // the buttons and run_
    std::vector<QToolButton*> runs_; // of the step
    std::size_t chosen_ = 0;         // whose text run_ has
    LiveValues* live_;
    QPushButton* answer_;
};

} // namespace touchdown
