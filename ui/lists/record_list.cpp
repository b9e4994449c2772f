// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lists/record_list.h"

#include <algorithm>

#include <QFileInfo>

#include "ui/style/foreign_text.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

bool sameFile(const QString& one, const QString& other)
{
    if (one.isEmpty() || other.isEmpty()) return false;
    const QFileInfo a(one), b(other);
    return a.absoluteFilePath() == b.absoluteFilePath() ||
           (a.exists() && a.canonicalFilePath() == b.canonicalFilePath());
}

} // namespace

bool ListedRecord::isInFile() const
{
    return !file.isEmpty() && (!identity || fileNow(file.toStdString(), *identity) == FileNow::Same);
}

CurveStyle RecordList::style(const ListedRecord& record) { return {record.number - 1, record.number - 1}; }

int RecordList::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : count(); }

QVariant RecordList::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const int row = index.row();
    const ListedRecord& record = listed(row);
    switch (role) {
    case Qt::DisplayRole: return QStringLiteral("%1  %2").arg(record.number).arg(withoutTurns(shownName(row)));
    case Qt::EditRole:
    case NoteRole: return record.note;
    case Qt::CheckStateRole: return record.shown ? Qt::Checked : Qt::Unchecked;
    case Qt::ToolTipRole: return htmlTip(row);
    case Qt::AccessibleTextRole:
        return QStringLiteral("%1 %2, %3, %4, %5")
            .arg(kind())
            .arg(record.number)
            .arg(shownName(row), changes(row), result(row));
    case ChangesRole: return changes(row);
    case ResultRole: return result(row);
    case FailedRole: return failed(row);
    case StyleColourRole: return shownStyle(row).colour;
    case StyleDashRole: return shownStyle(row).dash;
    case SpeaksRole: return speaks(row);
    case BaselineRole: return record.number == baseline_;
    default: return {};
    }
}

bool RecordList::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return false;
    ListedRecord& record = changeable(index.row());
    if (role == Qt::CheckStateRole) {
        record.shown = value.toInt() == Qt::Checked;
        emit dataChanged(index, index, {Qt::CheckStateRole});
        emit shownChanged(record.number, record.shown);
        return true;
    }
    if (role == Qt::EditRole || role == NoteRole) {
        record.note = value.toString().trimmed();
        emit dataChanged(index, index, {Qt::EditRole, NoteRole});
        return true;
    }
    return false;
}

Qt::ItemFlags RecordList::flags(const QModelIndex& index) const
{
    if (!index.isValid()) return Qt::NoItemFlags;
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsEditable |
           Qt::ItemNeverHasChildren;
}

ListedRecord& RecordList::addRecord(std::unique_ptr<ListedRecord> record)
{
    const int row = count();
    beginInsertRows({}, row, row);
    records_.push_back(std::move(record));
    nextNumber_ = std::max(nextNumber_, records_.back()->number + 1);
    endInsertRows();
    emit added(records_.back()->number);
    return *records_.back();
}

void RecordList::remove(int row)
{
    const int number = listed(row).number;
    if (number == baseline_) setBaseline(-1);
    emit aboutToRemove(number);
    beginRemoveRows({}, row, row);
    records_.erase(records_.begin() + row);
    endRemoveRows();
    // The next record is compared with another one now.
    if (row < count()) emit dataChanged(index(row), index(row), {ChangesRole});
    onRemoved();
}

void RecordList::setFile(int number, const QString& file)
{
    setRecording(number, file);
    if (const int row = rowOf(number); row >= 0) changeable(row).identity = identityOf(file.toStdString());
}

void RecordList::setRecording(int number, const QString& file)
{
    const int row = rowOf(number);
    if (row < 0) return;
    for (int other = 0; other < count(); ++other) {
        if (other == row || !sameFile(listed(other).file, file)) continue;
        changeable(other).file.clear();
        changeable(other).identity.reset();
        emit dataChanged(index(other), index(other), {Qt::ToolTipRole});
    }
    changeable(row).file = file;
    changeable(row).identity.reset();
    changeable(row).place = 0;
    emit dataChanged(index(row), index(row), {Qt::ToolTipRole});
}

void RecordList::setKept(int number, const QString& file)
{
    if (const int row = rowOf(number); row >= 0) changeable(row).kept = file;
}

int RecordList::rowOf(int number) const
{
    const auto found = std::ranges::find(records_, number, [](const auto& record) { return record->number; });
    return found == records_.end() ? -1 : static_cast<int>(found - records_.begin());
}

void RecordList::setBaseline(int number)
{
    if (number == baseline_) return;
    baseline_ = number;
    if (count() > 0) emit dataChanged(index(0), index(count() - 1), {BaselineRole});
    emit baselineChanged(number);
}

QString RecordList::htmlTip(int row) const
{
    const ListedRecord& record = listed(row);
    QString text = QStringLiteral("<b>%1</b>")
                       .arg(QStringLiteral("%1 %2: %3")
                                .arg(kind())
                                .arg(record.number)
                                .arg(escapedForTip(readable(record.name.toStdString()))));
    const auto line = [&text](const QString& part) {
        if (!part.isEmpty()) text += QStringLiteral("<br>") + escapedForTip(part);
    };
    line(changes(row));
    for (const QString& part : details(row)) line(part);
    if (!record.note.isEmpty()) line(tr("Note: %1").arg(record.note));
    line(record.file);
    return text;
}

} // namespace touchdown
