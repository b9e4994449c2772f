// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/runs_panel.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QVBoxLayout>

#include "ui/runs/run_delegate.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"

namespace touchdown {

RunsPanel::RunsPanel(RunsModel& model, QWidget* parent)
    : QWidget(parent), model_(model), list_(new QListView(this)), overlay_(new QCheckBox(tr("Overlay runs"), this))
{
    list_->setModel(&model_);
    list_->setItemDelegate(new RunDelegate(list_));
    list_->setAccessibleName(tr("Runs"));
    list_->setAlternatingRowColors(true);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setResizeMode(QListView::Adjust);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(list_, &QWidget::customContextMenuRequested, this, &RunsPanel::showMenu);

    overlay_->setChecked(true);
    overlay_->setToolTip(tr("Keep earlier runs in the plots when a new one starts"));

    const auto button = [this](const QString& text, const QString& tip, auto action) {
        auto* made = new QToolButton(this);
        made->setText(text);
        made->setToolTip(tip);
        made->setAccessibleName(text);
        made->setAutoRaise(true);
        made->setFocusPolicy(Qt::TabFocus);
        connect(made, &QToolButton::clicked, this, action);
        return made;
    };
    baseline_ = button(tr("Baseline"), tr("Subtract this run from the others"), &RunsPanel::toggleBaseline);
    baseline_->setCheckable(true);
    note_ = button(tr("Note"), tr("Write a note on this run (F2)"), &RunsPanel::editNote);
    save_ = button(tr("Save…"), tr("Save this run as HDF5, or its time series as CSV"),
                   [this] { emit saveRequested(chosen()); });
    remove_ = button(tr("Delete"), tr("Remove this run from the list and the plots"), &RunsPanel::removeChosen);
    auto* open = button(tr("Open…"), tr("Open a run that was saved"), &RunsPanel::openRequested);

    auto* tools = new QHBoxLayout;
    tools->setSpacing(2);
    for (QToolButton* made : {baseline_, note_, save_, remove_}) tools->addWidget(made);
    tools->addStretch(1);
    auto* top = new QHBoxLayout;
    top->addWidget(overlay_);
    top->addStretch(1);
    top->addWidget(open);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 4);
    layout->setSpacing(4);
    layout->addLayout(top);
    layout->addWidget(list_, 1);
    layout->addLayout(tools);

    connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
        updateButtons();
        emit runChosen(chosen());
    });
    connect(&model_, &RunsModel::dataChanged, this, &RunsPanel::updateButtons);
    connect(&model_, &RunsModel::rowsRemoved, this, &RunsPanel::updateButtons);
    connect(&model_, &RunsModel::rowsInserted, this, [this](const QModelIndex&, int, int last) {
        list_->setCurrentIndex(model_.index(last));
        list_->scrollToBottom();
        updateButtons();
    });
    updateButtons();
}

int RunsPanel::chosen() const
{
    const QModelIndex current = list_->currentIndex();
    if (current.isValid()) return model_.record(current.row()).number;
    return model_.count() > 0 ? model_.record(model_.count() - 1).number : -1;
}

void RunsPanel::setRunningRun(int number)
{
    running_ = number;
    updateButtons();
}

void RunsPanel::editNote()
{
    const int row = model_.rowOf(chosen());
    if (row >= 0) list_->edit(model_.index(row));
}

void RunsPanel::removeChosen()
{
    const int row = model_.rowOf(chosen());
    if (row >= 0 && chosen() != running_) model_.remove(row);
}

void RunsPanel::toggleBaseline() { model_.setBaseline(model_.baseline() == chosen() ? -1 : chosen()); }

void RunsPanel::showMenu(const QPoint& at)
{
    if (!list_->indexAt(at).isValid()) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const int number = chosen();
    menu->addAction(tr("Use the parameters of this run"), this, [this, number] { emit parametersRequested(number); });
    menu->addAction(baseline_->isChecked() ? tr("No baseline") : tr("Use as baseline"), this,
                    &RunsPanel::toggleBaseline);
    menu->addAction(tr("Write a note"), this, &RunsPanel::editNote);
    menu->addAction(tr("Save…"), this, [this, number] { emit saveRequested(number); });
    menu->addAction(tr("Delete"), this, &RunsPanel::removeChosen)->setEnabled(remove_->isEnabled());
    menu->popup(list_->viewport()->mapToGlobal(at));
}

void RunsPanel::updateButtons()
{
    const int number = chosen();
    const bool any = number >= 0;
    for (QToolButton* button : {baseline_, note_, save_}) button->setEnabled(any);
    save_->setEnabled(any && number != running_);
    remove_->setEnabled(any && number != running_);
    baseline_->setChecked(any && number == model_.baseline());
}

} // namespace touchdown
