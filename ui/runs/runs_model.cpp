// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/runs_model.h"

#include "ui/case/parameter_text.h"
#include "ui/runs/run_record.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

RunRecord& RunsModel::add(std::unique_ptr<RunRecord> record)
{
    return static_cast<RunRecord&>(addRecord(std::move(record)));
}

void RunsModel::append(int number, const SampleBatch& batch, const std::vector<RunEvent>& events,
                       const std::vector<FieldSnapshot>& fields)
{
    if (RunRecord* run = find(number)) run->append(batch, events, fields);
}

void RunsModel::finish(int number, const Summary& summary)
{
    RunRecord* run = find(number);
    if (!run) return;
    run->finish(summary);
    const QModelIndex changed = index(rowOf(number));
    emit dataChanged(changed, changed);
}

const RunRecord& RunsModel::record(int row) const { return static_cast<const RunRecord&>(listed(row)); }

const RunRecord* RunsModel::find(int number) const
{
    const int row = rowOf(number);
    return row < 0 ? nullptr : &record(row);
}

RunRecord* RunsModel::find(int number)
{
    const int row = rowOf(number);
    return row < 0 ? nullptr : &static_cast<RunRecord&>(changeable(row));
}

QString RunsModel::changes(int row) const
{
    if (row == 0) return tr("first run");
    const QStringList list = caseDifference(record(row - 1).value, record(row).value);
    if (list.isEmpty()) return tr("same parameters as run %1").arg(record(row - 1).number);
    return list.join(QStringLiteral(", "));
}

QString RunsModel::result(int row) const
{
    const RunRecord& run = record(row);
    if (!run.summary) return tr("running");
    if (run.interrupted) return tr("interrupted");
    const QString status = statusText(name(run.summary->status));
    if (run.summary->status != RunStatus::Completed) return status;
    for (const RunFigure& figure : run.summary->figures)
        if (figure.quantity.name == "largest_contact_force")
            return figure.value > 0.0 ? forceText(figure.value) : tr("no contact");
    const int index = findQuantity(run.quantities, "flying_height");
    const std::optional<double> height = run.last("flying_height");
    return height ? readout(*height, run.quantities[static_cast<std::size_t>(index)]) : status;
}

bool RunsModel::failed(int row) const
{
    const std::optional<Summary>& summary = record(row).summary;
    return summary && (summary->status == RunStatus::Failed || summary->status == RunStatus::Diverged);
}

QStringList RunsModel::details(int row) const
{
    const RunRecord& run = record(row);
    QStringList lines{tr("Samples: %L1").arg(run.sampleCount())};
    if (run.summary) lines << QString::fromStdString(run.summary->message);
    return lines;
}

} // namespace touchdown
