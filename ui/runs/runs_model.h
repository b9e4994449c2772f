// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs of this session: newest last, each with what changed since the run before it.
#pragma once

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
    using RecordList::RecordList;

    RunRecord& add(std::unique_ptr<RunRecord> record);
    void append(int number, const SampleBatch& batch, const std::vector<RunEvent>& events,
                const std::vector<FieldSnapshot>& fields = {});
    void finish(int number, const Summary& summary);

    const RunRecord& record(int row) const;
    RunRecord* find(int number);
    const RunRecord* find(int number) const;

protected:
    QString changes(int row) const override;
    QString result(int row) const override;
    bool failed(int row) const override;
    QStringList details(int row) const override;
    QString kind() const override { return tr("Run"); }
};

} // namespace touchdown
