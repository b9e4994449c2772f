// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the message strip shows when a calculation, an import or an export has ended.
#include <QDir>

#include "core/simulation/static_state/steady.h"
#include "core/studies/study/study.h"
#include "ui/runs/about_case_pane.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/slider/attitude_sections.h"
#include "ui/style/message_strip.h"
#include "ui/style/quantity_format.h"
#include "ui/window/main_window.h"

namespace touchdown {

void MainWindow::onStudied(const StudyReport& report)
{
    updateRunActions();
    const QString title = QString::fromStdString(report.title);
    QStringList lines{report.findings.empty() ? tr("Completed: %1").arg(title)
                                              : QString::fromStdString(report.findings.front())};
    if (!report.warnings.empty()) lines << tr("Limitations are listed below the findings (⚠).");
    switch (report.status) {
    case StudyStatus::Completed:
        messages_->show(report.warnings.empty() ? MessageStrip::Kind::Success : MessageStrip::Kind::Warning,
                        lines.join(QLatin1Char('\n')));
        break;
    case StudyStatus::Cancelled: messages_->show(MessageStrip::Kind::Information, tr("Stopped: %1").arg(title)); break;
    case StudyStatus::Failed: messages_->show(MessageStrip::Kind::Failure, sentence(report.message)); break;
    }
    emit calculationEnded(report.status == StudyStatus::Completed, QString::fromStdString(report.message));
}

void MainWindow::onRunEnded(int number, const Summary& summary)
{
    updateRunActions();
    const RunRecord& run = *runs().find(number);
    const QString result = resultText(run);
    aboutCase_->setResult(result, sentence(summary.bouncingRule), figuresText(summary));
    QStringList lines{tr("Run %1: %2").arg(number).arg(result)};
    MessageStrip::Kind kind = MessageStrip::Kind::Success;
    for (const std::string& warning : summary.warnings) lines << sentence(warning);
    // A check that found a difference is among the warnings.
    if (summary.stepCheck && summary.stepCheck->sameEndState) lines << sentence(summary.stepCheck->message);
    if (!summary.warnings.empty() || (summary.stepCheck && !summary.stepCheck->sameEndState))
        kind = MessageStrip::Kind::Warning;
    if (summary.status == RunStatus::Cancelled) kind = MessageStrip::Kind::Information;
    if (summary.status == RunStatus::Failed || summary.status == RunStatus::Diverged) {
        kind = MessageStrip::Kind::Failure;
        lines.front() = tr("Run %1 failed at %2: %3").arg(number).arg(timeText(summary.endTime), result);
    }
    messages_->show(kind, lines.join(QLatin1Char('\n')));
    emit calculationEnded(summary.status == RunStatus::Completed, QString::fromStdString(summary.message));
}

void MainWindow::onSolved(const SteadyResult& result)
{
    updateRunActions();
    const QString text = steadyText(result);
    aboutCase_->setResult(result.status == SteadyStatus::Cancelled ? QString() : text);
    switch (result.status) {
    case SteadyStatus::Converged:
        messages_->show(result.message.empty() ? MessageStrip::Kind::Success : MessageStrip::Kind::Warning, text);
        break;
    case SteadyStatus::Cancelled: messages_->show(MessageStrip::Kind::Information, text); break;
    case SteadyStatus::NotConverged:
    case SteadyStatus::Failed: messages_->show(MessageStrip::Kind::Failure, text); break;
    }
    emit calculationEnded(result.status == SteadyStatus::Converged, QString::fromStdString(result.message));
}

void MainWindow::onImported(const QString& path, const QStringList& warnings)
{
    aboutCase_->setWarnings(warnings);
    const QString text = tr("Imported: %1.").arg(QDir::toNativeSeparators(path));
    if (warnings.isEmpty())
        messages_->show(MessageStrip::Kind::Success, text);
    else
        messages_->show(MessageStrip::Kind::Warning,
                        text + QLatin1Char(' ') +
                            tr("%n entry(ies) of the file are not modelled: see About this case.", nullptr,
                               static_cast<int>(warnings.size())));
}

void MainWindow::onExported(const QString& path, const QStringList& warnings)
{
    const QString text = tr("Written: %1").arg(QDir::toNativeSeparators(path));
    if (warnings.isEmpty())
        messages_->show(MessageStrip::Kind::Success, text);
    else
        messages_->show(MessageStrip::Kind::Warning,
                        text + QLatin1Char('\n') +
                            tr("Written as comments of run.dat, which the established program ignores: %1")
                                .arg(warnings.join(QStringLiteral(", "))));
}

} // namespace touchdown
