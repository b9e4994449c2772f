// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/runs_model.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "ui/case/parameter_text.h"
#include "ui/runs/run_record.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

constexpr qsizetype mostInLabel = 2; // changes

/// "Fig. 10 (a)" of "Fig. 10 (a): a 7 nm slider dropped from 250 nm".
QString headOf(const std::string& title)
{
    const QString text = QString::fromStdString(title);
    const qsizetype colon = text.indexOf(QLatin1String(": "));
    return colon > 0 ? text.left(colon) : text;
}

/// The sample case with a title, if there is one. A film takes some milliseconds to read: each is read once.
const Case* sampleOf(const std::string& title)
{
    static std::map<std::string, std::optional<Case>> known;
    const auto [entry, isNew] = known.try_emplace(title);
    if (isNew)
        for (const SampleCase& sample : sampleCases()) {
            if (sample.text.find("title = \"" + title + '"') == std::string::npos) continue;
            if (Case c = parseCase(sample.text, sample.name).value; c.title == title) entry->second = std::move(c);
        }
    return entry->second ? &*entry->second : nullptr;
}

QString firstOf(const QStringList& changes)
{
    const QString more =
        changes.size() > mostInLabel ? QStringLiteral(" +%1").arg(changes.size() - mostInLabel) : QString();
    return changes.first(std::min(mostInLabel, changes.size())).join(QStringLiteral(", ")) + more;
}

} // namespace

RunsModel::RunsModel(QObject* parent) : RecordList(parent)
{
    // Before the plots hear of it: they show the names.
    connect(this, &RecordList::baselineChanged, this, &RunsModel::relabel);
    connect(this, &RecordList::shownChanged, this, [this] {
        if (count() > 0) emit dataChanged(index(0), index(count() - 1), {SpeaksRole});
    });
}

RunRecord& RunsModel::add(std::unique_ptr<RunRecord> record)
{
    record->label = labelOf(*record);
    return static_cast<RunRecord&>(addRecord(std::move(record)));
}

bool RunsModel::isUnsaved(int row) const
{
    const RunRecord& run = record(row);
    return RecordList::isUnsaved(row) && run.sampleCount() > 0 && (!run.ofGuide || !run.note.isEmpty());
}

QString RunsModel::labelOf(const RunRecord& run) const
{
    const RunRecord* base = nullptr;
    for (int row = 0; row < count() && !base; ++row)
        if (record(row).value.title == run.value.title) base = &record(row);
    if (const RunRecord* chosen = find(baseline()); chosen && chosen->value.title == run.value.title) base = chosen;
    QString own = run.value.title.empty() ? tr("Run %1").arg(run.number) : headOf(run.value.title);
    // The figures of the paper have several cases each.
    for (int row = 0; row < count(); ++row)
        if (const std::string& other = record(row).value.title;
            record(row).number < run.number && other != run.value.title && headOf(other) == own)
            own = readable(run.value.title);
    if (!base || base->number == run.number) {
        // A figure of the paper that was changed is that figure no more.
        const Case* sample = sampleOf(run.value.title);
        const QStringList changes = sample ? shortDifference(*sample, run.value) : QStringList();
        return changes.isEmpty() ? own : readable(tr("%1, %2").arg(own, firstOf(changes)).toStdString());
    }
    const QStringList changes = shortDifference(base->value, run.value);
    if (changes.isEmpty())
        return run.value.title.empty() ? own : tr("%1, run %2").arg(own, QString::number(run.number));
    return readable(firstOf(changes).toStdString());
}

void RunsModel::relabel()
{
    for (int row = 0; row < count(); ++row) {
        auto& run = static_cast<RunRecord&>(changeable(row));
        run.label = labelOf(run);
    }
    if (count() > 0) emit dataChanged(index(0), index(count() - 1), {Qt::DisplayRole, ChangesRole});
    emit namesChanged();
}

void RunsModel::rename(int number, const QString& name)
{
    for (int row = 0; row < count(); ++row)
        if (auto& run = static_cast<RunRecord&>(changeable(row)); run.number == number) run.label = name;
    emit namesChanged();
}

const RunRecord* RunsModel::newestShown() const
{
    for (int row = count() - 1; row >= 0; --row)
        if (record(row).shown) return &record(row);
    return nullptr;
}

int RunsModel::speaker() const
{
    const RunRecord* raised = find(raised_);
    if (raised && raised->shown) return raised_;
    const RunRecord* newest = newestShown();
    return newest ? newest->number : -1;
}

void RunsModel::raise(int number)
{
    const int before = speaker();
    raised_ = number;
    if (speaker() == before) return;
    if (count() > 0) emit dataChanged(index(0), index(count() - 1), {SpeaksRole});
    emit speakerChanged();
}

QString RunsModel::shownName(int row) const { return record(row).label; }

CurveStyle RunsModel::shownStyle(int row) const { return style(record(row)); }

bool RunsModel::speaks(int row) const { return record(row).number == speaker(); }

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
            return figure.value > 0.0 ? tr("largest force %1").arg(forceText(figure.value)) : tr("no contact");
    const QString end = endText(run);
    return end.isEmpty() ? status : end;
}

bool RunsModel::failed(int row) const
{
    const std::optional<Summary>& summary = record(row).summary;
    return summary && (summary->status == RunStatus::Failed || summary->status == RunStatus::Diverged);
}

QStringList RunsModel::details(int row) const
{
    const RunRecord& run = record(row);
    QStringList lines;
    if (const std::optional<EndHeight> end = endHeight(run); end && run.summary)
        lines << tr("%1 at the end: %2")
                     .arg(QString::fromStdString(end->quantity->longName), readout(end->value, *end->quantity));
    lines << tr("Samples: %L1").arg(run.sampleCount());
    if (run.summary) lines << QString::fromStdString(run.summary->message);
    return lines;
}

} // namespace touchdown
