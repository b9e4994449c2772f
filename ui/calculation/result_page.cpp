// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calculation/result_page.h"

#include <QEvent>
#include <QSplitter>
#include <QVBoxLayout>

#include "ui/style/foreign_text.h"
#include "ui/style/save_dialog.h"
#include "ui/style/theme.h"

namespace touchdown {

ResultPages::ResultPages(QWidget* parent) : QStackedWidget(parent), introduction_(new QLabel(this))
{
    introduction_->setTextFormat(Qt::RichText);
    introduction_->setWordWrap(true);
    introduction_->setAlignment(Qt::AlignCenter);
    introduction_->setMargin(60);
    introduction_->setAutoFillBackground(true);
    introduction_->setBackgroundRole(QPalette::Base);
    addWidget(introduction_);
}

void ResultPages::setParts(QWidget* upper, QWidget* lower, const QList<int>& heights, int upperShare, int lowerShare)
{
    auto* split = new QSplitter(Qt::Vertical, this);
    split->addWidget(upper);
    split->addWidget(lower);
    split->setStretchFactor(0, upperShare);
    split->setStretchFactor(1, lowerShare);
    split->setSizes(heights);
    split->setChildrenCollapsible(false);
    addWidget(split);
}

void ResultPages::introduce(const QString& title, const QString& html)
{
    introduction_->setText(QStringLiteral("<h2>%1</h2><p>%2</p>").arg(title, html));
}

void ResultPage::build(CalculationController& controller, const Words& words, QWidget* setup, QWidget* picture,
                       const QList<int>& heights)
{
    words_ = words;
    controller_ = &controller;
    setup_ = setup;
    progress_ = new ProgressStrip(controller, words.calculation, words.running, this);
    pages_ = new ResultPages(this);
    remark_ = new QLabel(this);
    remark_->setAccessibleName(tr("Remarks on the %1").arg(words.result));
    remark_->setWordWrap(true);
    remark_->setContentsMargins(10, 2, 10, 4);
    remark_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(buildHead());
    layout->addWidget(remark_);
    layout->addWidget(pages_, 1);
    pages_->setParts(picture, buildTable(), heights);
    connect(controller_, &CalculationController::stateChanged, this, &ResultPage::showNotes);
}

/// What is chosen stands above the progress; without it all is one line.
QLayout* ResultPage::buildHead()
{
    start_->setAutoDefault(false);
    start_->setToolTip(plainTip(words_.startTip));
    connect(start_, &QPushButton::clicked, this, &ResultPage::startOrStop);
    stale_ = new QLabel(tr("The parameters have changed since this was solved."), this);
    auto* head = new QVBoxLayout;
    head->setSpacing(2);
    auto* state = new QHBoxLayout;
    state->setContentsMargins(setup_ ? 0 : 8, setup_ ? 0 : 4, 8, setup_ ? 2 : 4);
    if (setup_) {
        auto* choice = new QHBoxLayout;
        choice->setContentsMargins(8, 4, 8, 0);
        choice->addWidget(setup_);
        choice->addWidget(start_, 0, Qt::AlignTop);
        choice->addStretch(1);
        head->addLayout(choice);
    } else {
        state->addWidget(start_);
    }
    state->addWidget(progress_, 1);
    state->addWidget(stale_);
    head->addLayout(state);
    return head;
}

QWidget* ResultPage::buildTable()
{
    auto* part = new QWidget(this);
    table_ = new ResultTable(tr("Table of the %1").arg(words_.result), part);
    copy_ = quietButton(tr("Copy"), tr("Copy the table for a spreadsheet"),
                        tr("Copy the table of the %1").arg(words_.result), part);
    connect(copy_, &QToolButton::clicked, table_, &ResultTable::copy);
    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(6, 0, 6, 2);
    tools->addStretch(1);
    tools->addWidget(copy_);
    save_ = quietButton(tr("Save…"), tr("Save all numbers of the %1 as comma-separated values").arg(words_.result),
                        tr("Save the numbers of the %1").arg(words_.result), part);
    connect(save_, &QToolButton::clicked, this, &ResultPage::chooseSave);
    tools->addWidget(save_);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(table_, 1);
    layout->addLayout(tools);
    return part;
}

void ResultPage::showNotes()
{
    const Notes notes = this->notes();
    const bool active = controller_->active();
    const MeaningColours colours = meaningColours(palette());
    start_->setText(active ? tr("Stop") : words_.start);
    start_->setEnabled(controller_->state() != CalculationController::State::Stopping);
    if (setup_) setup_->setEnabled(!active);
    for (QToolButton* button : {copy_, save_}) button->setEnabled(table_->rowCount() > 0);
    pages_->introduce(words_.title, active ? words_.awaited : words_.introduction);
    setTextColour(stale_, colours.warning);
    stale_->setVisible(notes.stale);
    setTextColour(remark_, notes.failed ? colours.failure : colours.muted);
    remark_->setText(notes.remark);
    remark_->setVisible(!notes.remark.isEmpty());
}

QString ResultPage::save(const QString& path)
{
    QString problem = writeWholeFile(path, csv());
    saved_ = problem.isEmpty() ? SavedFile(path) : SavedFile();
    return problem;
}

void ResultPage::chooseSave()
{
    askAndSave(this, tr("Save the %1").arg(words_.result), {tr("Comma-separated values (*.csv)")},
               words_.result + QStringLiteral(".csv"), [this](const QString& path) { return save(path); });
}

void ResultPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && controller_) showNotes();
}

} // namespace touchdown
