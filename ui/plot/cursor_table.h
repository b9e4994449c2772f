// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of all curves at the two cursors, their differences, and 1/dt in Hz: the quantity as a heading, its runs
// below it, the newest first. Of spectra also the ratio of the powers in dB, 10 log10(P2/P1), and which cursor is at a
// peak of the newest run. With several groups of plots, tabs show whose cursors are read: those that moved last. Ctrl+C
// or the button copies all of it.
#pragma once

#include <vector>

#include <QHash>
#include <QIcon>
#include <QLabel>
#include <QTabBar>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>

#include "ui/plot/plot_group.h"

namespace touchdown {

class CursorTable : public QWidget {
    Q_OBJECT

public:
    /// `group` must outlive the table or be destroyed together with it.
    explicit CursorTable(PlotGroup* group, QWidget* parent = nullptr);
    /// Another group of plots; its table is shown while its cursors are used.
    void add(PlotGroup* group);

    /// Fills the table again soon: after curves came or went. The table follows the cursors by itself.
    void scheduleUpdate();
    QTableWidget* table() const { return table_; }
    QTabBar* tabs() const { return tabs_; }
    const PlotGroup* shown() const { return shown_; }
    /// The table for a spreadsheet: cells between tabulators, one number in each, with the units in the heads.
    QString asText() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void cursorMoved(PlotGroup* group);
    void showGroup(PlotGroup* group);
    void fill();
    void fillHeading(int row, const CursorReading& reading);
    void fillRow(int row, const CursorReading& reading);
    QTableWidgetItem* put(int row, int column, const QString& text);
    QString placesText() const;
    void copy() const;

    std::vector<PlotGroup*> groups_;
    PlotGroup* shown_;
    QTabBar* tabs_; // one for each group
    QToolButton* copy_;
    QLabel* places_; // of the cursors, their difference and its inverse
    QTableWidget* table_;
    QHash<int, QIcon> samples_; // of lines, by their look
    QStringList headings_;      // of the rows that are there: empty where a row has values
    QTimer timer_;
    bool stale_ = true;
};

} // namespace touchdown
