// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/runs_model.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "ui/case/parameter_text.h"
#include "ui/runs/run_names.h"
#include "ui/runs/run_record.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

/// The sample case with a title, if there is one. A film takes some milliseconds to read: each is read once.
const Case* sampleOf(const std::string& title)
{
    static std::map<std::string, std::optional<Case>> known;
    const auto [entry, isNew] = known.try_emplace(title);
    if (isNew)
        for (const SampleCase& sample : sampleCases())
            if (titleOf(sample) == title) entry->second = parseCase(sample.text, sample.name).value;
    return entry->second ? &*entry->second : nullptr;
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
    const bool others = nameAll(record.get());
    auto& added = static_cast<RunRecord&>(addRecord(std::move(record)));
    if (others) tellNames();
    return added;
}

void RunsModel::setOpened(const Case& c)
{
    // Runs of the list keep the names that they have.
    bool listed = false;
    for (int row = 0; row < count(); ++row) listed = listed || record(row).value.title == c.title;
    listed ? void(opened_.try_emplace(c.title, c)) : void(opened_[c.title] = c);
}

bool RunsModel::isUnsaved(int row) const
{
    const RunRecord& run = record(row);
    return RecordList::isUnsaved(row) && run.sampleCount() > 0 && (!run.ofGuide || !run.note.isEmpty());
}

/// From which the case of a run was changed: as it was opened, the sample or the first run of its title.
const Case* RunsModel::beforeOf(const RunRecord& run) const
{
    const std::string& title = run.value.title;
    if (const auto opened = opened_.find(title); opened != opened_.end()) return &opened->second;
    if (const Case* sample = sampleOf(title)) return sample;
    for (int row = 0; row < count(); ++row)
        if (record(row).value.title == title) return &record(row).value;
    return &run.value;
}

/// Also of a run that is to come; whether a run of the list has another name now.
bool RunsModel::nameAll(RunRecord* next)
{
    std::vector<RunRecord*> all;
    for (int row = 0; row < count(); ++row) all.push_back(static_cast<RunRecord*>(&changeable(row)));
    if (next) all.push_back(next);
    std::vector<RunToName> runs;
    const RunRecord* base = find(baseline());
    for (const RunRecord* run : all) {
        const bool based = base && base->value.title == run->value.title;
        runs.push_back({run->number, &run->value, based ? &base->value : beforeOf(*run)});
    }
    const QStringList names = runNames(runs);
    bool changed = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const QString& name = names[static_cast<qsizetype>(i)];
        changed = changed || (all[i] != next && all[i]->label != name);
        all[i]->label = name;
    }
    return changed;
}

void RunsModel::relabel()
{
    nameAll();
    tellNames();
}

void RunsModel::tellNames()
{
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
    const QStringList list =
        caseDifference(row > 0 ? record(row - 1).value : *beforeOf(record(row)), record(row).value);
    if (row == 0 && list.isEmpty()) return tr("first run");
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
    if (const QString end = run.summary ? endText(run) : QString(); !end.isEmpty())
        lines << sentence(end.toStdString());
    lines << tr("Samples: %L1").arg(run.sampleCount());
    if (run.summary) lines << sentence(run.summary->message);
    return lines;
}

} // namespace touchdown
