// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of all curves at the two cursors, their differences, and 1/dt in Hz. Follows its group by itself; Ctrl+C
// copies.
#pragma once

#include "ui/plot/plot_group.h"

#include <QLabel>
#include <QTableWidget>
#include <QTimer>
#include <QWidget>

namespace touchdown {

class CursorTable : public QWidget {
    Q_OBJECT

public:
    /// `group` must outlive the table or be destroyed together with it.
    explicit CursorTable(PlotGroup* group, QWidget* parent = nullptr);

    /// Fills the table again at the next turn of the event loop, as after curves came or went; the cursors need no
    /// call.
    void scheduleUpdate();
    /// As text with tabulators, for a spreadsheet.
    QString asText() const;
    QTableWidget* table() const { return table_; }
    QString timeText() const { return times_->text(); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fill();

    PlotGroup* group_;
    QLabel* times_;
    QTableWidget* table_;
    QTimer timer_;
};

} // namespace touchdown
