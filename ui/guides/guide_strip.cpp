// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/guide_strip.h"

#include <algorithm>

#include <QAbstractButton>
#include <QEvent>
#include <QHBoxLayout>
#include <QShortcut>
#include <QVBoxLayout>

#include "ui/guides/lesson_pane.h"
#include "ui/guides/live_values.h"
#include "ui/guides/term_marks.h"
#include "ui/style/foreign_text.h"

namespace touchdown {

namespace {

constexpr double mostOfWindow = 0.18; // of its height, for the text
constexpr std::size_t keys = 9;       // 1 to 9, for the first runs

/// Once for each press, however long the key is held.
void pressedBy(Qt::Key key, QAbstractButton* button)
{
    auto* shortcut = new QShortcut(QKeySequence(key), button);
    shortcut->setAutoRepeat(false);
    QObject::connect(shortcut, &QShortcut::activated, button, &QAbstractButton::click);
}

} // namespace

GuideStrip::GuideStrip(QWidget* parent)
    : QWidget(parent),
      scroll_(new QScrollArea(this)),
      text_(new QLabel(this)),
      run_(new QLabel(this)),
      row_(new QWidget(this)),
      live_(new LiveValues(this, Qt::Horizontal)),
      answer_(new QPushButton(tr("Answer"), this))
{
    for (QLabel* label : {text_, run_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::RichText);
        explainTerms(label);
    }
    text_->setAccessibleName(tr("Question or answer"));
    run_->setAccessibleName(tr("What the run shows"));
    answer_->setCheckable(true);
    answer_->setToolTip(tr("Shows the answer to the question (A)"));
    pressedBy(Qt::Key_A, answer_);
    connect(answer_, &QPushButton::toggled, this, &GuideStrip::write);
    auto* row = new QHBoxLayout(row_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(run_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 8);
    // A long text scrolls, so that the plots above keep their height.
    scroll_->setWidget(text_);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setFocusPolicy(Qt::NoFocus);
    column->addWidget(scroll_);
    auto* foot = new QHBoxLayout;
    foot->addWidget(row_, 1);
    foot->addWidget(live_, 1);
    foot->addWidget(answer_);
    column->addLayout(foot);
    hide();
}

void GuideStrip::follow(LessonPane* pane)
{
    if (pane && pane == pane_) return;
    if (pane_) disconnect(pane_, nullptr, this, nullptr);
    pane_ = pane;
    setVisible(pane != nullptr);
    if (!pane) return live_->setValues({}, Case()); // whoever did not let go does so now
    connect(pane, &LessonPane::stepShown, this, &GuideStrip::showStep);
    connect(pane, &LessonPane::written, this, &GuideStrip::write);
    showStep();
}

void GuideStrip::showStep()
{
    const LessonStep& step = pane_->shown();
    const bool lesson = pane_->kind() == LessonPane::Kind::Lesson;
    qDeleteAll(runs_);
    runs_.clear();
    for (std::size_t i = 0; i < step.runs.size(); ++i) {
        auto* button = new QToolButton(row_);
        button->setText(QString::number(i + 1));
        const QString purpose = QString::fromStdString(step.runs[i].purpose);
        button->setAccessibleName(tr("Run %1: %2").arg(i + 1).arg(purpose));
        button->setToolTip(plainTip(purpose));
        if (i < keys) pressedBy(Qt::Key(Qt::Key_1 + static_cast<int>(i)), button);
        connect(button, &QToolButton::clicked, this, [this, i] { perform(i); });
        static_cast<QHBoxLayout*>(row_->layout())->insertWidget(static_cast<int>(i), button);
        button->show();
        runs_.push_back(button);
    }
    chosen_ = 0;
    live_->setStep(step);
    live_->showCase(pane_->live().shownCase());
    live_->setEnabled(pane_->live().isEnabled());
    answer_->setChecked(false);
    answer_->setText(lesson ? tr("Answer") : tr("How sure"));
    write();
}

void GuideStrip::perform(std::size_t run)
{
    chosen_ = run;
    pane_->perform(run);
    write();
}

void GuideStrip::write()
{
    if (!pane_ || runs_.size() != pane_->shown().runs.size()) return; // stepShown follows
    text_->setText(answer_->isChecked() ? pane_->answerText() : pane_->questionText());
    run_->setText(runs_.empty() ? QString() : pane_->runText(chosen_));
    fitText();
}

void GuideStrip::fitText()
{
    const int least = text_->fontMetrics().lineSpacing();
    const int room = std::max(static_cast<int>(mostOfWindow * window()->height()), 2 * least);
    scroll_->setFixedHeight(std::clamp(text_->heightForWidth(scroll_->viewport()->width()), least, room));
}

void GuideStrip::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitText();
}

void GuideStrip::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        QMetaObject::invokeMethod(this, &GuideStrip::fitText, Qt::QueuedConnection); // when the text has it, too
}

} // namespace touchdown
