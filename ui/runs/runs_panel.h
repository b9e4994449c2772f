// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of runs: overlay on and off, what changed, note, baseline, save, delete, reopen.
#pragma once

#include <QCheckBox>
#include <QListView>
#include <QToolButton>
#include <QWidget>

namespace touchdown {

class RunsModel;

class RunsPanel : public QWidget {
    Q_OBJECT

public:
    /// `model` must outlive the panel.
    explicit RunsPanel(RunsModel& model, QWidget* parent = nullptr);

    QListView* list() const { return list_; }
    /// Whether earlier runs stay in the plots when a new one starts.
    bool overlay() const { return overlay_->isChecked(); }
    void setOverlay(bool on) { overlay_->setChecked(on); }
    /// Number of the chosen run, or of the newest; -1 when there is none.
    int chosen() const;
    /// The active run cannot be deleted.
    void setRunningRun(int number);

signals:
    /// The chosen run is another one, or there is none (-1).
    void runChosen(int number);
    void openRequested();
    void saveRequested(int number);
    /// The parameters of a run are wanted in the panel again.
    void parametersRequested(int number);

private:
    void editNote();
    void removeChosen();
    void toggleBaseline();
    void showMenu(const QPoint& at);
    void updateButtons();

    RunsModel& model_;
    QListView* list_;
    QCheckBox* overlay_;
    QToolButton* baseline_;
    QToolButton* note_;
    QToolButton* save_;
    QToolButton* remove_;
    int running_ = -1;
};

} // namespace touchdown
