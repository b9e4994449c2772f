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
#include "ui/film/modes_text.h"
#include "ui/style/whole_file.h"

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
    /// The modes that are known; nothing where there are none.
    std::optional<FoundModes> known() const;
    /// Modes of another window.
    void restore(const FoundModes& modes);
    /// Whether there are modes that no file has.
    bool unsaved() const { return known().has_value() && !saved_.holds(); }
    /// Writes the table as comma-separated values. "" or the problem in a sentence.
    QString save(const QString& path);

signals:
    /// Other modes are known, or none any more.
    void changed();
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
    void take(const Case& c, const ModesResult& result);
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
    SavedFile saved_; // with what the table shows
};

} // namespace touchdown
