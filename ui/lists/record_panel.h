// SPDX-License-Identifier: GPL-3.0-or-later
//
// A list of records: what is shown beside the newest, what changed, note, baseline, save, delete, reopen.
#pragma once

#include <functional>
#include <vector>

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QListView>
#include <QToolButton>
#include <QWidget>

namespace touchdown {

class RecordList;

class RecordPanel : public QWidget {
    Q_OBJECT

public:
    struct Words {
        QString title;               // "Runs"
        QString overlay, overlayTip; // of the box that says whether earlier records stay shown; empty: no box
        QString baselineTip, noteTip, saveTip, removeTip, openTip;
        QString useParameters; // "Use the parameters of this run", in the menu; empty: not there
    };
    static Words wordsOfRuns();
    static Words wordsOfSolutions();

    /// `model` must outlive the panel.
    explicit RecordPanel(RecordList& model, const Words& words, QWidget* parent = nullptr);

    /// One more button above the list, for the chosen record, and an entry of its menu.
    void offer(const QString& text, const QString& tip, const std::function<void(int number)>& perform);
    /// The entry alone.
    QAction* offerInMenu(const QString& text, const QString& tip, const std::function<void(int number)>& perform);

    QListView* list() const { return list_; }
    /// Whether earlier records stay shown when a new one comes.
    bool overlay() const { return overlay_->isChecked(); }
    void setOverlay(bool on) { overlay_->setChecked(on); }
    /// Number of the chosen record; -1 when there is none.
    int chosen() const;
    void choose(int number);
    /// One that is still calculated cannot be deleted or saved; -1: none is.
    void setActive(int number);

signals:
    /// The pointer came to the row of a record, or left the rows (-1).
    void recordHovered(int number);
    /// The chosen record is another one, or there is none (-1).
    void recordChosen(int number);
    void openRequested();
    void saveRequested(int number);
    /// The parameters of a record are wanted in the panel again.
    void parametersRequested(int number);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void hideOthers(int number);
    void showHidden();
    int newestShown() const; // -1: none is
    void editNote();
    void removeChosen();
    void toggleBaseline();
    void showMenu(const QPoint& at);
    void updateButtons();

    RecordList& model_;
    Words words_;
    QListView* list_;
    QCheckBox* overlay_;
    QToolButton* baseline_;
    QToolButton* note_;
    QToolButton* save_;
    QToolButton* remove_;
    QHBoxLayout* top_;
    std::vector<QAction*> actions_;
    std::vector<int> hidden_; // numbers of the records that the box of overlays has hidden
    int active_ = -1;
};

} // namespace touchdown
