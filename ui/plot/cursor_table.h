// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of all curves at the two cursors, their differences, and 1/dt in Hz. Ctrl+C copies all of it.
#pragma once

#include <QLabel>
#include <QTableWidget>
#include <QTimer>

#include "ui/plot/plot_group.h"

namespace touchdown {

class CursorTable : public QWidget {
    Q_OBJECT

public:
    /// `group` must outlive the table or be destroyed together with it.
    explicit CursorTable(PlotGroup* group, QWidget* parent = nullptr);

    /// Fills the table again soon: after curves came or went. The table follows the cursors by itself.
    void scheduleUpdate();
    QTableWidget* table() const { return table_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void fill();
    QString asText() const; // with tabulators, for a spreadsheet

    PlotGroup* group_;
    QLabel* times_; // of the cursors, their difference and its inverse
    QTableWidget* table_;
    QTimer timer_;
    bool stale_ = true;
};

} // namespace touchdown
