// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs of this session: newest last, each with what changed since the run before it.
#pragma once

#include "ui/plot/plot_theme.h"

#include <QAbstractListModel>

#include <memory>
#include <vector>

namespace touchdown {

struct FieldSnapshot;
struct RunEvent;
struct RunRecord;
struct SampleBatch;
struct Summary;

class RunsModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        ChangesRole = Qt::UserRole, // "Take-off height 5 nm → 8 nm"
        ResultRole,                 // "7.000 nm", or "failed"
        FailedRole,
        StyleColourRole, // of CurveStyle
        StyleDashRole,
        NoteRole,
        BaselineRole, // the run that others are compared with
    };

    explicit RunsModel(QObject* parent = nullptr);
    ~RunsModel() override;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    /// A number for a run that is to be added.
    int nextNumber() const { return nextNumber_; }
    RunRecord& add(std::unique_ptr<RunRecord> record);
    /// Not the active run.
    void remove(int row);
    void append(int number, const SampleBatch& batch, const std::vector<RunEvent>& events,
                const std::vector<FieldSnapshot>& fields = {});
    void finish(int number, const Summary& summary);

    int count() const { return static_cast<int>(records_.size()); }
    const RunRecord& record(int row) const { return *records_[static_cast<std::size_t>(row)]; }
    RunRecord* find(int number) const;
    int rowOf(int number) const; // -1 if it is gone
    /// How its curves look where a plot has one curve for each run.
    static CurveStyle style(const RunRecord& record);

    /// -1: none.
    int baseline() const { return baseline_; }
    void setBaseline(int number);

signals:
    void added(int number);
    /// Its data are about to be deleted: remove its curves.
    void aboutToRemove(int number);
    void shownChanged(int number, bool shown);
    void baselineChanged(int number);

private:
    QString changes(int row) const;
    QString result(const RunRecord& record) const;
    QString toolTip(int row) const;

    std::vector<std::unique_ptr<RunRecord>> records_;
    int nextNumber_ = 1;
    int baseline_ = -1;
};

} // namespace touchdown
