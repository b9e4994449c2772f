// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/run_continuation.h"

#include <algorithm>
#include <utility>

#include <QAction>

#include "core/case_files/case_text.h"
#include "core/results/continued_run.h"
#include "ui/case/case_edits.h"
#include "ui/lists/record_panel.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/style/message_strip.h"
#include "ui/style/translate.h"
#include "ui/style/window_words.h"
#include "ui/window/recording.h"

namespace touchdown {

namespace {

bool isLonger(const Case& edited, const Case& own)
{
    Case same = edited;
    same.run.duration = own.run.duration;
    same.folder = own.folder;
    return edited.run.duration > own.run.duration && same == own;
}

/// What a file of the run would say of it.
StoredRun aboutOf(const RunRecord& run)
{
    StoredRun about;
    about.status = run.interrupted ? std::string("interrupted") : std::string(name(run.summary->status));
    about.message = run.summary->message;
    about.continued = run.continued;
    about.quantities = run.quantities;
    for (const auto& checkpoint : run.checkpoints.all()) about.checkpoints.push_back(*checkpoint);
    return about;
}

bool holdsMapsOf(const RunRecord& run, const StoredCheckpoint& state)
{
    if (state.snapshots.size() != run.fields.size()) return false;
    for (std::size_t set = 0; set < run.fields.size(); ++set)
        if (state.snapshots[set] > run.fields[set].snapshots.size()) return false;
    return true;
}

std::shared_ptr<const EarlierRun> earlierOf(const RunRecord& run, const ContinuedRun& continued)
{
    auto earlier = std::make_shared<EarlierRun>();
    const StoredCheckpoint& from = *continued.from;
    std::size_t left = from.samples;
    for (std::size_t part = 0; part < run.parts() && left > 0; ++part) {
        SampleBatch samples = run.samples(part);
        const std::size_t count = std::min(left, samples.size());
        samples.time.resize(count);
        for (std::vector<double>& column : samples.columns) column.resize(count);
        left -= count;
        earlier->samples.push_back(std::move(samples));
    }
    for (const RunEvent& event : run.events)
        if (event.time <= from.at.time) earlier->events.push_back(event);
    for (std::size_t set = 0; set < run.fields.size(); ++set)
        for (std::size_t k = 0; k < from.snapshots[set]; ++k) earlier->fields.push_back(run.fields[set].snapshot(k));
    std::ranges::stable_sort(earlier->fields, {}, &FieldSnapshot::time);
    earlier->states = continued.states;
    earlier->remark = continued.remark;
    return earlier;
}

} // namespace

RunContinuation continuationOf(const RunRecord& run, const Case& edited)
{
    const auto refused = [](QString problem) { return RunContinuation{std::move(problem), {}, {}}; };
    if (!run.finished()) return refused(tr("It is under way."));
    if (!run.caseProblem.isEmpty()) return refused(tr("Its case is not known: %1").arg(run.caseProblem));
    if (!run.fieldsComplete()) return refused(tr("Its first maps are no longer held."));
    const Case& now = isLonger(edited, run.value) ? edited : run.value;
    const ContinuedRun continued = continueRun(aboutOf(run), run.value, now);
    if (!continued.problem.empty()) return refused(inWindowWords(continued.problem));
    if (continued.from && !holdsMapsOf(run, *continued.from)) return refused(tr("Its maps are not complete."));
    RunContinuation result;
    result.request = {now, updateCaseText(run.caseText, now), {}};
    if (continued.from) result.request.earlier = earlierOf(run, continued);
    result.startsAgain = inWindowWords(continued.startsAgain);
    return result;
}

void offerToContinue(const ContinuationParts& parts, const std::function<void()>& show)
{
    const auto perform = [parts, show](int number) {
        const RunRecord* run = parts.runs.runs().find(number);
        if (!run) return;
        // What is edited counts where it can be run.
        const bool good = parts.edits.reasonNotToRun().isEmpty();
        RunContinuation next = continuationOf(*run, good ? parts.edits.value() : run->value);
        if (!next.problem.isEmpty())
            return parts.messages.show(MessageStrip::Kind::Failure,
                                       tr("Run %1 does not continue: %2").arg(QString::number(number), next.problem));
        if (next.request.earlier)
            parts.messages.clear();
        else
            parts.messages.show(MessageStrip::Kind::Information,
                                tr("Run %1 starts again, as %2.").arg(QString::number(number), next.startsAgain));
        show();
        parts.recording.whenFree([parts, request = std::move(next.request)]() mutable {
            request.recordTo = parts.recording.file().toStdString();
            parts.runs.start(std::move(request));
        });
    };
    RecordPanel* panel = parts.runs.panel();
    panel->offerInMenu(tr("Continue"),
                       tr("Continue the run to its end, or to the longer duration that the case has now"), perform);
    QObject::connect(&parts.action, &QAction::triggered, panel, [panel, perform] { perform(panel->chosen()); });
    const auto update = [panel, &action = parts.action] { action.setEnabled(panel->chosen() >= 0); };
    QObject::connect(panel, &RecordPanel::recordChosen, &parts.action, update);
    update();
}

} // namespace touchdown
