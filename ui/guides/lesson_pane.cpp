// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/lesson_pane.h"

#include <algorithm>
#include <utility>

#include <QEvent>
#include <QGridLayout>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/guides/lesson_text.h"
#include "ui/guides/live_values.h"
#include "ui/guides/term_marks.h"
#include "ui/style/foreign_text.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

QLabel* textLabel(QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::RichText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::LinksAccessibleByMouse |
                                   Qt::LinksAccessibleByKeyboard);
    explainTerms(label);
    return label;
}

/// Of the first text of a demonstration.
QString reportTitle(const LessonStep& step)
{
    return step.title.starts_with("Not in the paper") ? LessonPane::tr("What this is")
                                                      : LessonPane::tr("What the paper reports");
}

} // namespace

LessonPane::LessonPane(Kind kind, std::vector<LessonStep> steps, QWidget* parent)
    : QWidget(parent),
      kind_(kind),
      steps_(std::move(steps)),
      scroll_(new QScrollArea(this)),
      runs_(new QWidget(this)),
      live_(new LiveValues(this)),
      show_(new QPushButton(this)),
      back_(new QPushButton(tr("&Back"), this)),
      next_(new QPushButton(tr("&Next"), this))
{
    for (QLabel** label : {&place_, &title_, &text_, &question_, &change_, &answer_}) {
        *label = textLabel(this);
        connect(*label, &QLabel::linkActivated, this, [this](const QString& link) {
            if (!linkedEntry(link)) emit keyChosen(link);
        });
    }
    build();
    connect(show_, &QPushButton::toggled, this, &LessonPane::showAnswer);
    connect(back_, &QPushButton::clicked, this, [this] { go(step_ - 1); });
    connect(next_, &QPushButton::clicked, this, [this] { go(step_ + 1); });
    go(0);
}

void LessonPane::build()
{
    show_->setCheckable(true);
    const bool lesson = kind_ == Kind::Lesson;
    place_->setAccessibleName(lesson ? tr("Place in the lesson") : tr("Place in the demonstrations"));
    title_->setAccessibleName(tr("Title of the step"));
    text_->setAccessibleName(lesson ? tr("Text of the step") : tr("What the paper reports"));
    question_->setAccessibleName(lesson ? tr("Question") : tr("What to watch"));
    change_->setAccessibleName(lesson ? tr("What to change") : tr("What to try"));
    answer_->setAccessibleName(lesson ? tr("Answer") : tr("How sure it is"));

    auto* content = new QWidget(scroll_);
    content->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // as wide as the pane: texts wrap
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(10, 8, 10, 10);
    column->setSpacing(8);
    for (QWidget* part : {static_cast<QWidget*>(title_), static_cast<QWidget*>(text_), static_cast<QWidget*>(question_),
                          runs_, static_cast<QWidget*>(live_), static_cast<QWidget*>(change_)})
        column->addWidget(part);
    column->addWidget(show_, 0, Qt::AlignLeft);
    show_->setVisible(lesson);
    column->addWidget(answer_);
    column->addStretch(1);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setWidgetResizable(true);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setWidget(content);
    scroll_->setAccessibleName(lesson ? tr("Lesson") : tr("Demonstrations"));

    auto* row = new QHBoxLayout;
    row->setContentsMargins(10, 6, 10, 8);
    row->addWidget(back_);
    place_->setAlignment(Qt::AlignCenter);
    row->addWidget(place_, 1);
    row->addWidget(next_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(scroll_, 1);
    layout->addLayout(row);
    setMinimumSize(260, 160);
}

void LessonPane::go(std::size_t step)
{
    step_ = std::min(step, steps_.size() - 1);
    back_->setEnabled(step_ > 0);
    next_->setEnabled(step_ + 1 < steps_.size());
    show_->setChecked(false);
    live_->setStep(shown());
    results_.assign(shown().runs.size(), {});
    buildRuns();
    showAnswer(kind_ == Kind::Demonstrations);
    write();
    scroll_->verticalScrollBar()->setValue(0);
    emit stepShown(step_);
}

void LessonPane::buildRuns()
{
    qDeleteAll(runs_->findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
    delete runs_->layout();
    purposes_.clear();
    auto* grid = new QGridLayout(runs_);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(1, 1);
    QWidget* last = scroll_;
    for (const LessonRun& run : steps_.at(step_).runs) {
        const QString purpose = QString::fromStdString(run.purpose);
        auto* button = new QPushButton(run.kind.empty() ? tr("Run") : tr("Study"), runs_);
        button->setAccessibleName(run.kind.empty() ? tr("Run: %1").arg(purpose) : tr("Study: %1").arg(purpose));
        button->setToolTip(plainTip(QString::fromStdString(commandOf(run))));
        connect(button, &QPushButton::clicked, this, [this, run] { emit runRequested(run); });
        purposes_.push_back(textLabel(runs_));
        grid->addWidget(button, grid->rowCount(), 0, Qt::AlignTop);
        grid->addWidget(purposes_.back(), grid->rowCount() - 1, 1);
        setTabOrder(last, button);
        last = button;
    }
    std::vector<QWidget*> rest = live_->inputs();
    rest.insert(rest.end(), {show_, back_, next_});
    for (QWidget* next : rest) {
        setTabOrder(last, next);
        last = next;
    }
}

void LessonPane::write()
{
    const bool lesson = kind_ == Kind::Lesson;
    const LessonStep& step = steps_.at(step_);
    const MeaningColours colours = meaningColours(palette());
    place_->setText(QStringLiteral("<span style='color:%1'>%2</span>")
                        .arg(colours.muted.name(),
                             (lesson ? tr("Step %1 of %2") : tr("%1 of %2")).arg(step_ + 1).arg(steps_.size())));
    const QString number = lesson ? QStringLiteral("%1. ").arg(step_ + 1) : QString();
    title_->setText(QStringLiteral("<h3 style='margin:0'>%1%2</h3>").arg(number, lessonHtml(step.title)));
    // In the order in which they are read.
    terms_.restart();
    const auto marked = [this](const QString& html) { return terms_.marked(html, palette().windowText().color()); };
    text_->setText(marked(lessonBlock(lesson ? QString() : reportTitle(step), step.text, colours.muted)));
    question_->setText(
        marked(lessonBlock(lesson ? tr("Question") : tr("What to watch"), step.question, colours.change)));
    for (std::size_t i = 0; i < purposes_.size(); ++i) {
        const LessonRun& run = step.runs.at(i);
        QString text = QStringLiteral("%1<br><span style='color:%2'>%3</span>")
                           .arg(marked(lessonHtml(run.purpose)), colours.muted.name(), lessonSubject(run));
        if (const auto& [result, completed] = results_[i]; !result.isEmpty())
            text += QStringLiteral("<br><span style='color:%1'>→ %2</span>")
                        .arg((completed ? colours.success : colours.failure).name(), result.toHtmlEscaped());
        purposes_[i]->setText(text);
    }
    change_->setText(
        marked(lessonBlock(lesson ? tr("Then change it yourself") : tr("What to try"), step.change, colours.muted)));
    answer_->setText(marked(lessonBlock(lesson ? tr("Answer") : tr("How sure it is"), step.answer, colours.success)));
    emit written();
}

void LessonPane::showResult(std::size_t run, const QString& result, bool completed)
{
    if (results_.at(run) == std::pair(result, completed)) return;
    results_.at(run) = {result, completed};
    write();
}

void LessonPane::showAnswer(bool shown)
{
    answer_->setVisible(shown);
    show_->setText(shown ? tr("Hide the &answer") : tr("Show the &answer"));
    // After the layout has made room for it.
    if (shown && kind_ == Kind::Lesson)
        QTimer::singleShot(0, this, [this] { scroll_->verticalScrollBar()->setValue(show_->y() - 8); });
}

void LessonPane::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) write();
}

} // namespace touchdown
