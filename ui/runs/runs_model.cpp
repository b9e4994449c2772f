// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/runs_model.h"

#include <algorithm>

#include "ui/case/parameter_text.h"
#include "ui/runs/run_record.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

RunsModel::RunsModel(QObject* parent) : QAbstractListModel(parent) {}

RunsModel::~RunsModel() = default;

CurveStyle RunsModel::style(const RunRecord& record) { return {record.number - 1, record.number - 1}; }

int RunsModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : count(); }

QVariant RunsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const RunRecord& run = record(index.row());
    switch (role) {
    case Qt::DisplayRole: return tr("%1  %2").arg(run.number).arg(run.name);
    case Qt::EditRole:
    case NoteRole: return run.note;
    case Qt::CheckStateRole: return run.shown ? Qt::Checked : Qt::Unchecked;
    case Qt::ToolTipRole: return toolTip(index.row());
    case Qt::AccessibleTextRole:
        return tr("Run %1, %2, %3, %4").arg(run.number).arg(run.name, changes(index.row()), result(run));
    case ChangesRole: return changes(index.row());
    case ResultRole: return result(run);
    case FailedRole:
        return run.summary && (run.summary->status == RunStatus::Failed || run.summary->status == RunStatus::Diverged);
    case StyleColourRole: return style(run).colour;
    case StyleDashRole: return style(run).dash;
    case BaselineRole: return run.number == baseline_;
    default: return {};
    }
}

bool RunsModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return false;
    RunRecord& run = *records_[static_cast<std::size_t>(index.row())];
    if (role == Qt::CheckStateRole) {
        run.shown = value.toInt() == Qt::Checked;
        emit dataChanged(index, index, {Qt::CheckStateRole});
        emit shownChanged(run.number, run.shown);
        return true;
    }
    if (role == Qt::EditRole || role == NoteRole) {
        run.note = value.toString().trimmed();
        emit dataChanged(index, index, {Qt::EditRole, NoteRole});
        return true;
    }
    return false;
}

Qt::ItemFlags RunsModel::flags(const QModelIndex& index) const
{
    if (!index.isValid()) return Qt::NoItemFlags;
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsEditable |
           Qt::ItemNeverHasChildren;
}

RunRecord& RunsModel::add(std::unique_ptr<RunRecord> record)
{
    const int row = count();
    beginInsertRows({}, row, row);
    records_.push_back(std::move(record));
    nextNumber_ = std::max(nextNumber_, records_.back()->number + 1);
    endInsertRows();
    emit added(records_.back()->number);
    return *records_.back();
}

void RunsModel::remove(int row)
{
    const int number = record(row).number;
    if (number == baseline_) setBaseline(-1);
    emit aboutToRemove(number);
    beginRemoveRows({}, row, row);
    records_.erase(records_.begin() + row);
    endRemoveRows();
    // The next run is compared with another run now.
    if (row < count()) emit dataChanged(index(row), index(row), {ChangesRole});
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

RunRecord* RunsModel::find(int number) const
{
    const int row = rowOf(number);
    return row < 0 ? nullptr : records_[static_cast<std::size_t>(row)].get();
}

int RunsModel::rowOf(int number) const
{
    const auto found = std::ranges::find(records_, number, [](const auto& record) { return record->number; });
    return found == records_.end() ? -1 : static_cast<int>(found - records_.begin());
}

void RunsModel::setBaseline(int number)
{
    if (number == baseline_) return;
    baseline_ = number;
    if (count() > 0) emit dataChanged(index(0), index(count() - 1), {BaselineRole});
    emit baselineChanged(number);
}

QString RunsModel::changes(int row) const
{
    if (row == 0) return tr("first run");
    const QStringList list = caseDifference(record(row - 1).value, record(row).value);
    if (list.isEmpty()) return tr("same parameters as run %1").arg(record(row - 1).number);
    return list.join(QStringLiteral(", "));
}

QString RunsModel::result(const RunRecord& run) const
{
    if (!run.summary) return tr("running");
    const QString status = statusText(name(run.summary->status));
    if (run.summary->status != RunStatus::Completed) return status;
    for (const RunFigure& figure : run.summary->figures)
        if (figure.quantity.name == "largest_contact_force")
            return figure.value > 0.0 ? forceText(figure.value) : tr("no contact");
    const int index = findQuantity(run.quantities, "flying_height");
    const std::optional<double> height = run.last("flying_height");
    return height ? readout(*height, run.quantities[static_cast<std::size_t>(index)]) : status;
}

QString RunsModel::toolTip(int row) const
{
    const RunRecord& run = record(row);
    QString text = QStringLiteral("<b>%1</b>").arg(tr("Run %1: %2").arg(run.number).arg(run.name.toHtmlEscaped()));
    const auto line = [&text](const QString& part) {
        if (!part.isEmpty()) text += QStringLiteral("<br>") + part.toHtmlEscaped();
    };
    line(changes(row));
    line(tr("Samples: %L1").arg(run.sampleCount()));
    if (run.summary) line(QString::fromStdString(run.summary->message));
    if (!run.note.isEmpty()) line(tr("Note: %1").arg(run.note));
    line(run.file);
    return text;
}

} // namespace touchdown
