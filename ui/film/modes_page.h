// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of the air bearing modes about the static state: a table, and the selected mode as an animation.
#pragma once

#include <optional>

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableWidget>
#include <QToolButton>

#include "ui/film/modes_controller.h"

namespace touchdown {

class ModePicture;
class ProgressStrip;

class ModesPage : public QWidget {
    Q_OBJECT

public:
    explicit ModesPage(ModesController::Solver solver = modes, QWidget* parent = nullptr);

    /// The case as it is edited.
    void setCase(const Case& c);
    /// Another case was opened: its modes are not known.
    void clear();

    ModesController& controller() { return controller_; }
    ModePicture* picture() const { return picture_; }
    QTableWidget* table() const { return table_; }
    bool stale() const;

signals:
    /// Modes were found, or none, for this case.
    void found(const touchdown::Case& solved, const touchdown::ModesResult& result);

public slots:
    /// Finds the modes of the case, or stops that.
    void startOrStop();
    /// The table, tab-separated, on the clipboard.
    void copy() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildHead();
    QWidget* buildPicture();
    QWidget* buildTable();
    void onFinished(const ModesResult& result);
    void fillTable();
    void showMode(int row);
    void showSpeed();
    void showNotes();

    ModesController controller_;
    QPushButton* start_;
    ProgressStrip* progress_;
    QLabel *stale_, *remarks_, *empty_, *cycle_;
    QStackedWidget* pages_;
    ModePicture* picture_;
    QToolButton *play_, *copy_;
    QSlider* speed_;
    QTableWidget* table_;
    Case case_, asked_, solved_;
    QString refusal_; // why the last search did not start
    std::optional<ModesResult> result_;
};

} // namespace touchdown
