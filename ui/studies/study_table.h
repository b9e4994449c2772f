// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table of a study's report to look at, sort, select and copy.
#pragma once

#include <QTableView>

#include "ui/studies/study_table_model.h"

namespace touchdown {

class StudyTableView : public QTableView {
    Q_OBJECT

public:
    explicit StudyTableView(QWidget* parent = nullptr);

    /// Keeps the order that was chosen, if the table has the same columns.
    void setTable(StudyTable table);
    const StudyTableModel& content() const { return model_; }
    /// The selected rows, or all, in the order shown: tab-separated, with a header.
    QString toText() const;

public slots:
    void copy() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    StudyTableModel model_;
    StudyTableOrder order_;
};

} // namespace touchdown
