// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results that the window keeps, newest last: runs in time, or static solutions. Each has a number, a name, a note and
// a check box; one may be the baseline that others are compared with.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include <QAbstractListModel>
#include <QString>

#include "core/case/case.h"
#include "core/formats/file_identity.h"
#include "ui/plot/plot_theme.h"

namespace touchdown {

struct ListedRecord {
    int number = 0; // in its list, from 1
    QString name;
    Case value; // that was calculated
    QString note;
    QString file;                         // of the user: it was read from, or written to
    std::optional<FileIdentity> identity; // of that file then; none while it is written
    int place = 0;                        // among the records of that file
    QString kept;                         // the whole of it in the folder of the session; empty: not there
    bool shown = true;                    // beside others: in the plots, in the comparison

    virtual ~ListedRecord() = default;
    /// Whether the file of the user still holds it; true while it is written.
    bool isInFile() const;
};

class RecordList : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        ChangesRole = Qt::UserRole, // "Take-off height 5 nm → 8 nm"
        ResultRole,                 // "7.000 nm", or "failed"
        FailedRole,
        StyleColourRole, // of CurveStyle
        StyleDashRole,
        SpeaksRole, // whether its curves are wide
        NoteRole,
        BaselineRole, // the record that others are compared with
    };

    using QAbstractListModel::QAbstractListModel;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    /// A number for a record that is to be added.
    int nextNumber() const { return nextNumber_; }
    /// Numbers up to this one are for records that come later.
    void keepFree(int number) { nextNumber_ = std::max(nextNumber_, number + 1); }
    /// Not a record that is still calculated.
    void remove(int row);
    /// It was written to the file: another record that had this file has none any more.
    void setFile(int number, const QString& file);
    /// The same of a file that is being written.
    void setRecording(int number, const QString& file);
    void setKept(int number, const QString& file);

    int count() const { return static_cast<int>(records_.size()); }
    const ListedRecord& listed(int row) const { return *records_[static_cast<std::size_t>(row)]; }
    int rowOf(int number) const; // -1 if it is gone
    /// Whether it is work that no file of the user has.
    virtual bool isUnsaved(int row) const { return !listed(row).isInFile(); }
    virtual QString kind() const = 0; // "Run"
    /// How its curves look where a plot has one curve for each record.
    static CurveStyle style(const ListedRecord& record);

    /// -1: none.
    int baseline() const { return baseline_; }
    void setBaseline(int number);

signals:
    void added(int number);
    /// Its data are about to be deleted: remove its curves.
    void aboutToRemove(int number);
    void shownChanged(int number, bool shown);
    void baselineChanged(int number);

protected:
    ListedRecord& addRecord(std::unique_ptr<ListedRecord> record);
    ListedRecord& changeable(int row) { return *records_[static_cast<std::size_t>(row)]; }

    virtual QString changes(int row) const = 0;
    virtual QString result(int row) const = 0;
    virtual bool failed(int row) const = 0;
    /// Lines of the tool tip after the changes.
    virtual QStringList details(int row) const = 0;
    virtual QString shownName(int row) const { return listed(row).name; }
    virtual CurveStyle shownStyle(int row) const { return style(listed(row)); }
    /// A record has been removed: the others may have new names.
    virtual void onRemoved() {}
    virtual bool speaks(int row) const { return listed(row).shown; }

private:
    QString htmlTip(int row) const;

    std::vector<std::unique_ptr<ListedRecord>> records_;
    int nextNumber_ = 1;
    int baseline_ = -1;
};

} // namespace touchdown
