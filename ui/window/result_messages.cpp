// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/result_messages.h"

#include <QStringList>

#include "core/simulation/static_state/static_solution.h"
#include "core/studies/study/study.h"
#include "core/studies/study/study_verdict.h"
#include "ui/film/film_window.h"
#include "ui/runs/about_case_pane.h"
#include "ui/runs/run_record.h"
#include "ui/slider/attitude_sections.h"
#include "ui/style/message_strip.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

/// How a completed study is shown: what it checks may not hold.
MessageStrip::Kind kindOf(const StudyReport& report)
{
    const StudyVerdict verdict = verdictOf(report);
    if (!report.warnings.empty() || verdict == StudyVerdict::HoldsNot) return MessageStrip::Kind::Warning;
    return verdict == StudyVerdict::HoldsPartly ? MessageStrip::Kind::Information : MessageStrip::Kind::Success;
}

} // namespace

ResultMessages::ResultMessages(MessageStrip& messages, AboutCasePane& about, const FilmWindow& film)
    : messages_(messages), about_(about), film_(film)
{}

void ResultMessages::runEnded(const RunRecord& run, bool quiet)
{
    const Summary& summary = *run.summary;
    const QString result = resultText(run);
    about_.setResult([made = run.value](const Case& c) { return c == made; }, result, sentence(summary.verdict.rule),
                     figuresText(summary), solverText(summary));
    QStringList lines{tr("Run %1: %2").arg(run.number).arg(result)};
    MessageStrip::Kind kind = MessageStrip::Kind::Success;
    for (const std::string& warning : summary.warnings) lines << sentence(warning);
    // A check that found a difference is among the warnings.
    if (summary.stepCheck && summary.stepCheck->sameEndState) lines << sentence(summary.stepCheck->message);
    if (!summary.warnings.empty() || (summary.stepCheck && !summary.stepCheck->sameEndState))
        kind = MessageStrip::Kind::Warning;
    if (summary.status == RunStatus::Cancelled) {
        kind = MessageStrip::Kind::Information;
        lines = {lines.front()}; // remarks on a run that was given up are in the way
    }
    if (summary.status == RunStatus::Failed || summary.status == RunStatus::Diverged) {
        kind = MessageStrip::Kind::Failure;
        lines.front() = tr("Run %1 failed at %2: %3").arg(run.number).arg(timeText(summary.endTime), result);
    }
    // A start that was not thought about may lie in the disk.
    const bool startGiven = kind == MessageStrip::Kind::Failure && run.value.model == ModelKind::Film &&
                            run.value.initial.state == InitialState::Given;
    if (kind == MessageStrip::Kind::Success && quiet)
        messages_.clear();
    else
        messages_.show(kind, lines.join(QLatin1Char('\n')), {}, MessageStrip::Topic::Any,
                       startGiven ? tr("Start where it flies") : QString());
}

void ResultMessages::studied(const StudyReport& report, bool onItsPage)
{
    const QString title = readable(report.title);
    QStringList lines{report.findings.empty() || onItsPage ? tr("Completed: %1").arg(title)
                                                           : readable(report.findings.front())};
    if (onItsPage && verdictOf(report) == StudyVerdict::HoldsNot) lines << tr("What it checks does not hold.");
    if (!report.warnings.empty()) lines << tr("Limitations are listed below the findings (⚠).");
    switch (report.status) {
    case StudyStatus::Completed: messages_.show(kindOf(report), lines.join(QLatin1Char('\n'))); break;
    case StudyStatus::Interrupted: // only in a file
    case StudyStatus::Cancelled: messages_.show(MessageStrip::Kind::Information, tr("Stopped: %1").arg(title)); break;
    case StudyStatus::Failed: messages_.show(MessageStrip::Kind::Failure, sentence(report.message)); break;
    }
}

void ResultMessages::solved(const SteadyResult& result)
{
    if (result.status == SteadyStatus::Cancelled)
        about_.clearResult();
    else
        showBesideCase(film_.asked(), result);
    show(result);
}

void ResultMessages::solutionShown(bool onItsPage)
{
    const SolutionRecord* shown = film_.shown();
    const SteadyResult* result = shown ? &shown->result : nullptr;
    if (result)
        showBesideCase(shown->value, *result);
    else
        about_.clearResult();
    if (messages_.kind() == MessageStrip::Kind::Success) messages_.clear(); // of another solution
    clearSolution();
    // What was found wrong with a shape comes back with it, and a remark on its state.
    const bool remarkable = result && !(result->status == SteadyStatus::Converged && result->message.empty());
    if (remarkable && !film_.stale() && onItsPage) show(*result);
}

void ResultMessages::clearSolution()
{
    if (!solutionText_.isEmpty() && messages_.text() == solutionText_) messages_.clear();
    solutionText_.clear();
}

void ResultMessages::show(const SteadyResult& result)
{
    solutionText_ = steadyText(result);
    switch (result.status) {
    case SteadyStatus::Converged:
        messages_.show(result.message.empty() ? MessageStrip::Kind::Success : MessageStrip::Kind::Warning,
                       solutionText_);
        break;
    case SteadyStatus::Cancelled: messages_.show(MessageStrip::Kind::Information, solutionText_); break;
    case SteadyStatus::NotConverged:
    case SteadyStatus::Failed: messages_.show(MessageStrip::Kind::Failure, solutionText_); break;
    }
}

void ResultMessages::showBesideCase(const Case& solved, const SteadyResult& result)
{
    const auto belongsTo = [solved, found = result.attitude](const Case& c) {
        // A solution at a given attitude is one of the case as it is, though that does not hold the attitude.
        Case same = solved;
        same.steady.fixedAttitude = c.steady.fixedAttitude;
        return hasStaticState(c, same, found);
    };
    about_.setResult(belongsTo, steadyText(result));
}

} // namespace touchdown
