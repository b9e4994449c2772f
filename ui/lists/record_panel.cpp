// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lists/record_panel.h"

#include <utility>

#include <QEvent>
#include <QMenu>
#include <QVBoxLayout>

#include "ui/lists/record_delegate.h"
#include "ui/lists/record_list.h"
#include "ui/style/foreign_text.h"
#include "ui/style/loss_question.h"
#include "ui/style/result_table.h"

namespace touchdown {

RecordPanel::Words RecordPanel::wordsOfRuns()
{
    return {tr("Runs"),
            tr("Overlay runs"),
            tr("Show earlier runs beside the newest"),
            tr("Subtract this run from the others"),
            tr("Write a note on this run (F2)"),
            tr("Save this run as HDF5, or its time series as CSV"),
            tr("Remove this run from the list and the plots"),
            tr("Open a run that was saved"),
            tr("Use the parameters of this run")};
}

RecordPanel::Words RecordPanel::wordsOfSolutions()
{
    return {tr("Solutions"),
            {},
            {},
            tr("Tell the others, and their maps, by their difference to this solution"),
            tr("Write a note on this solution (F2)"),
            tr("Save this solution as HDF5"),
            tr("Remove this solution from the list"),
            tr("Open solutions that were saved"),
            {}};
}

RecordPanel::RecordPanel(RecordList& model, const Words& words, QWidget* parent)
    : QWidget(parent),
      model_(model),
      words_(words),
      list_(new QListView(this)),
      overlay_(new QCheckBox(words.overlay, this)),
      top_(new QHBoxLayout)
{
    list_->setModel(&model_);
    list_->setItemDelegate(new RecordDelegate(list_));
    list_->setAccessibleName(words.title);
    list_->setAlternatingRowColors(true);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setResizeMode(QListView::Adjust);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(list_, &QWidget::customContextMenuRequested, this, &RecordPanel::showMenu);

    overlay_->setChecked(true);
    overlay_->setVisible(!words.overlay.isEmpty());
    overlay_->setToolTip(plainTip(words.overlayTip));
    connect(overlay_, &QCheckBox::toggled, this, [this](bool on) {
        if (on)
            showHidden();
        else if (const int newest = newestShown(); newest >= 0)
            hideOthers(newest);
    });
    list_->setMouseTracking(true);
    list_->viewport()->installEventFilter(this);
    connect(list_, &QAbstractItemView::entered, this,
            [this](const QModelIndex& index) { emit recordHovered(model_.listed(index.row()).number); });
    connect(list_, &QAbstractItemView::viewportEntered, this, [this] { emit recordHovered(-1); });

    const auto button = [this](const QString& text, const QString& tip, auto action) {
        QToolButton* made = quietButton(text, tip, text, this);
        connect(made, &QToolButton::clicked, this, action);
        return made;
    };
    baseline_ = button(tr("Baseline"), words.baselineTip, &RecordPanel::toggleBaseline);
    baseline_->setCheckable(true);
    note_ = button(tr("Note"), words.noteTip, &RecordPanel::editNote);
    save_ = button(tr("Save…"), words.saveTip, [this] { emit saveRequested(chosen()); });
    remove_ = button(tr("Delete"), words.removeTip, &RecordPanel::removeChosen);
    auto* open = button(tr("Open…"), words.openTip, &RecordPanel::openRequested);

    auto* tools = new QHBoxLayout;
    tools->setSpacing(2);
    for (QToolButton* made : {baseline_, note_, save_, remove_}) tools->addWidget(made);
    tools->addStretch(1);
    top_->setSpacing(2);
    top_->addWidget(overlay_);
    top_->addStretch(1);
    top_->addWidget(open);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 4);
    layout->setSpacing(4);
    layout->addLayout(top_);
    layout->addWidget(list_, 1);
    layout->addLayout(tools);

    connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& now) {
        updateButtons();
        emit recordChosen(now.isValid() ? model_.listed(now.row()).number : -1);
    });
    connect(&model_, &RecordList::dataChanged, this, &RecordPanel::updateButtons);
    connect(&model_, &RecordList::rowsRemoved, this, &RecordPanel::updateButtons);
    connect(&model_, &RecordList::rowsInserted, this, [this](const QModelIndex&, int, int last) {
        if (model_.listed(last).shown) {
            list_->setCurrentIndex(model_.index(last));
            if (!overlay()) hideOthers(model_.listed(last).number);
        }
        list_->scrollToBottom();
        updateButtons();
    });
    updateButtons();
}

/// Only this record stays shown.
void RecordPanel::hideOthers(int number)
{
    for (int row = 0; row < model_.count(); ++row) {
        const ListedRecord& each = model_.listed(row);
        if (!each.shown || each.number == number) continue;
        hidden_.push_back(each.number);
        model_.setData(model_.index(row), Qt::Unchecked, Qt::CheckStateRole);
    }
}

void RecordPanel::showHidden()
{
    for (const int number : std::exchange(hidden_, {})) {
        const int row = model_.rowOf(number);
        if (row >= 0 && !model_.listed(row).shown) model_.setData(model_.index(row), Qt::Checked, Qt::CheckStateRole);
    }
}

int RecordPanel::newestShown() const
{
    for (int row = model_.count() - 1; row >= 0; --row)
        if (model_.listed(row).shown) return model_.listed(row).number;
    return -1;
}

bool RecordPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Leave) emit recordHovered(-1);
    return QWidget::eventFilter(watched, event);
}

int RecordPanel::chosen() const
{
    const QModelIndex current = list_->currentIndex();
    return current.isValid() ? model_.listed(current.row()).number : -1;
}

void RecordPanel::choose(int number)
{
    const int row = model_.rowOf(number);
    list_->setCurrentIndex(row < 0 ? QModelIndex() : model_.index(row));
}

void RecordPanel::setActive(int number)
{
    active_ = number;
    updateButtons();
}

QAction* RecordPanel::offerInMenu(const QString& text, const QString& tip,
                                  const std::function<void(int number)>& perform)
{
    auto* action = new QAction(text, this);
    action->setToolTip(plainTip(tip));
    connect(action, &QAction::triggered, this, [this, perform] { perform(chosen()); });
    actions_.push_back(action);
    updateButtons();
    return action;
}

void RecordPanel::offer(const QString& text, const QString& tip, const std::function<void(int number)>& perform)
{
    QAction* action = offerInMenu(text, tip, perform);
    QToolButton* made = quietButton(text, tip, text, this);
    made->setDefaultAction(action);
    top_->insertWidget(top_->count() - 2, made); // before the stretch
}

void RecordPanel::editNote()
{
    const int row = model_.rowOf(chosen());
    if (row >= 0) list_->edit(model_.index(row));
}

void RecordPanel::removeChosen()
{
    const int number = chosen(), row = model_.rowOf(number);
    if (row < 0 || number == active_) return;
    if (!model_.isUnsaved(row)) return model_.remove(row);
    askBeforeLoss(
        *window(),
        {QStringLiteral("unsavedRecord"), tr("Delete"),
         tr("%1 %2 “%3” is not saved.").arg(model_.kind(), QString::number(number), inOneLine(model_.listed(row).name)),
         tr("Nothing brings it back after it is deleted."), tr("&Delete")},
        [this, number] {
            if (const int now = model_.rowOf(number); now >= 0) model_.remove(now);
        });
}

void RecordPanel::toggleBaseline() { model_.setBaseline(model_.baseline() == chosen() ? -1 : chosen()); }

void RecordPanel::showMenu(const QPoint& at)
{
    if (!list_->indexAt(at).isValid()) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const int number = chosen();
    if (!words_.useParameters.isEmpty())
        menu->addAction(words_.useParameters, this, [this, number] { emit parametersRequested(number); });
    for (QAction* action : actions_) menu->addAction(action);
    menu->addAction(baseline_->isChecked() ? tr("No baseline") : tr("Use as baseline"), this,
                    &RecordPanel::toggleBaseline);
    menu->addAction(tr("Write a note"), this, &RecordPanel::editNote);
    menu->addAction(tr("Save…"), this, [this, number] { emit saveRequested(number); });
    menu->addAction(tr("Delete"), this, &RecordPanel::removeChosen)->setEnabled(remove_->isEnabled());
    menu->popup(list_->viewport()->mapToGlobal(at));
}

void RecordPanel::updateButtons()
{
    const int number = chosen();
    const bool any = number >= 0;
    for (QToolButton* button : {baseline_, note_, save_}) button->setEnabled(any);
    for (QAction* action : actions_) action->setEnabled(any);
    save_->setEnabled(any && number != active_);
    remove_->setEnabled(any && number != active_);
    baseline_->setChecked(any && number == model_.baseline());
}

} // namespace touchdown
