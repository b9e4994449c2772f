// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs of this session: newest last, each with what changed since the run before it.
//
// A run is named by what tells it from the others (ui/runs/run_names.h): "FH(0) 20 nm". The newest run that is shown,
// or the run that is raised, is wide; the other runs are pale.
#pragma once

#include <map>
#include <string>

#include "ui/lists/record_list.h"

namespace touchdown {

struct FieldSnapshot;
struct RunEvent;
struct RunRecord;
struct SampleBatch;
struct Summary;

class RunsModel : public RecordList {
    Q_OBJECT

public:
    explicit RunsModel(QObject* parent = nullptr);

    /// One colour each; runs do not differ in dashes.
    static CurveStyle style(const ListedRecord& record) { return {record.number - 1, 0}; }

    RunRecord& add(std::unique_ptr<RunRecord> record);
    void append(int number, const SampleBatch& batch, const std::vector<RunEvent>& events,
                const std::vector<FieldSnapshot>& fields = {});
    void finish(int number, const Summary& summary);

    const RunRecord& record(int row) const;
    RunRecord* find(int number);
    const RunRecord* find(int number) const;

    /// The case with this title as it was opened: names say what was changed in it.
    void setOpened(const Case& c);
    /// Another name of a run, until names are made anew.
    void rename(int number, const QString& name);

    /// A run without samples, or of a guide that nobody wrote a note on, is no work.
    bool isUnsaved(int row) const override;
    QString kind() const override { return tr("Run"); }

    /// The newest run that is shown; nullptr: none is.
    const RunRecord* newestShown() const;
    /// Number of the run that speaks; -1: none is shown.
    int speaker() const;
    /// Raises a shown run above the newest one for a while; -1: none.
    void raise(int number);

signals:
    /// Another run speaks.
    void speakerChanged();
    void namesChanged();

protected:
    QString changes(int row) const override;
    QString result(int row) const override;
    bool failed(int row) const override;
    QStringList details(int row) const override;
    QString shownName(int row) const override;
    CurveStyle shownStyle(int row) const override;
    void onRemoved() override { relabel(); }
    bool speaks(int row) const override;

private:
    const Case* beforeOf(const RunRecord& run) const;
    bool nameAll(RunRecord* next = nullptr);
    void relabel();
    void tellNames();

    std::map<std::string, Case> opened_; // by title
    int raised_ = -1;
};

} // namespace touchdown
