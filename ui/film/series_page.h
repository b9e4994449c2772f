// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of a series of static states: what varies, plots over it, and a table. Points appear as they are solved;
// what was solved before a stop remains.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableWidget>
#include <QToolButton>

#include "core/simulation/static_state/contact_rest.h"
#include "ui/film/series_controller.h"
#include "ui/film/series_file.h"
#include "ui/film/series_plots.h"
#include "ui/style/whole_file.h"

namespace touchdown {

class ProgressStrip;
class SeriesSetup;

class SeriesPage : public QWidget {
    Q_OBJECT

public:
    explicit SeriesPage(SteadyController::Solver solver = steadyWithContact, QWidget* parent = nullptr);

    /// The case as it is edited.
    void setCase(const Case& c);
    /// Another case was opened: no series of it is known.
    void open(const Case& c);
    void fit() { plots_->fit(); }

    SeriesController& controller() { return controller_; }
    SeriesSetup* setup() const { return setup_; }
    SeriesPlots* plots() const { return plots_; }
    QTableWidget* table() const { return table_; }
    const std::vector<SeriesState>& states() const { return states_; }
    bool stale() const;
    /// The states that are known, and the case that lists their points; to be shown by another window.
    StoredSeries series() const;
    void restore(const StoredSeries& series);
    /// The states that no file has.
    std::size_t unsaved() const { return saved_.holds() ? 0 : states_.size(); }
    /// Writes csv(). "" or the problem in a sentence.
    QString save(const QString& path);

    /// See csvOf().
    QByteArray csv() const;

public slots:
    /// Solves the chosen series, or stops that.
    void startOrStop();
    /// The table, tab-separated, on the clipboard.
    void copy() const;
    void chooseSave();

signals:
    /// Another state is known, or none any more.
    void changed();
    /// A state of the series: the case at its point, and the result with its fields.
    void solved(const touchdown::Case& c, const touchdown::SteadyResult& result);

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildHead();
    QWidget* buildTable();
    QStringList tableHeads() const;
    QStringList tableCells(const SeriesState& state) const;
    void begin(const Case& c, std::vector<SteadySeriesPoint> points);
    void append(std::size_t index, const SteadyResult& result);
    void onSolved(std::size_t index, const SteadyResult& result);
    void onFinished(bool stopped);
    void showProblem(const QString& text);
    void addRow(const SeriesState& state);
    void colourState(int row, int column);
    void showNotes();

    SeriesController controller_;
    QPushButton* start_;
    SeriesSetup* setup_;
    ProgressStrip* progress_;
    QLabel *stale_, *problem_, *empty_;
    QStackedWidget* pages_;
    SeriesPlots* plots_;
    QTableWidget* table_;
    QToolButton *copy_, *save_;
    Case case_, solved_;
    std::vector<SteadySeriesPoint> points_;
    std::vector<SeriesState> states_;
    SavedFile saved_; // with what the table shows
};

} // namespace touchdown
