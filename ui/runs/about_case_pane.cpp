// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/about_case_pane.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QScrollBar>

#include "core/formats/units.h"
#include "core/simulation/recording/run_statistics.h"
#include "ui/runs/run_record.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr auto detailsLink = "#details";

QStringList figureLines(const Summary& summary, bool ofSolver)
{
    QStringList lines;
    for (const RunFigure& figure : summary.figures)
        if (figure.ofSolver == ofSolver)
            lines << AboutCasePane::tr("%1: %2").arg(QString::fromStdString(figure.quantity.longName),
                                                     figureText(figure));
    return lines;
}

} // namespace

AboutCasePane::AboutCasePane(QWidget* parent) : OwnTextBrowser(parent)
{
    setAccessibleName(tr("About this case"));
    setFrameShape(QFrame::NoFrame);
    setOpenLinks(false);
    connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
        if (link == QUrl(QLatin1String(detailsLink))) showDetails(!detailsShown_);
    });
    document()->setDocumentMargin(8);
    setMinimumHeight(80);
}

void AboutCasePane::setCase(const Case& c)
{
    const bool had = hasResult();
    const Case before = std::exchange(case_, c);
    if (c.title != before.title || c.about != before.about || hasResult() != had) write();
}

void AboutCasePane::setResult(const std::function<bool(const Case&)>& belongsTo, const QString& result,
                              const QString& rule, const QString& figures, const QString& details)
{
    belongsTo_ = belongsTo;
    result_ = result;
    rule_ = rule;
    figures_ = figures;
    details_ = details;
    write();
}

void AboutCasePane::clearResult()
{
    if (belongsTo_) setResult(nullptr, {});
}

void AboutCasePane::showDetails(bool shown)
{
    detailsShown_ = shown;
    const int place = verticalScrollBar()->value();
    write();
    verticalScrollBar()->setValue(place);
}

void AboutCasePane::setWarnings(const QStringList& warnings)
{
    if (warnings == warnings_) return;
    warnings_ = warnings;
    write();
}

void AboutCasePane::changeEvent(QEvent* event)
{
    OwnTextBrowser::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) write();
}

void AboutCasePane::write()
{
    const MeaningColours colours = meaningColours(palette());
    QString html = QStringLiteral("<p><b>%1</b></p>").arg(escaped(readable(case_.title)));
    const auto part = [&html](const QString& heading, const QString& text, const QColor& colour) {
        if (text.isEmpty()) return;
        html +=
            QStringLiteral("<p style='margin:6px 0 0 0'><span style='color:%1; font-weight:600'>%2</span><br>%3</p>")
                .arg(colour.name(), heading, escaped(text.trimmed()));
    };
    part(tr("Result of the paper"), readable(case_.about.paper), colours.muted);
    part(tr("What to look at"), readable(case_.about.watch), colours.muted);
    const bool hasResult = this->hasResult();
    if (hasResult) {
        part(tr("Result of this run"), result_, colours.change);
        part(tr("Criterion"), rule_, colours.muted);
        part(tr("Its figures"), figures_, colours.muted);
    }
    if (hasResult && !details_.isEmpty())
        html += QStringLiteral("<p style='margin:6px 0 0 0'><a href='%1' style='color:%2; font-weight:600; "
                               "text-decoration:none'>%3 %4</a></p>")
                    .arg(QLatin1String(detailsLink), colours.muted.name(),
                         detailsShown_ ? QStringLiteral("▾") : QStringLiteral("▸"), tr("Details of the solver"));
    if (hasResult && detailsShown_ && !details_.isEmpty())
        html += QStringLiteral("<p style='margin:0'>%1</p>").arg(escaped(details_));
    part(tr("⚠ Remarks on the file"), warnings_.join(QLatin1Char('\n')), colours.warning);
    part(tr("≈ Assumptions"), readable(case_.about.assumed), colours.warning);
    setHtml(html);
}

/// The deviation is that of the last tenth, as swing and means beside it.
QString motionText(const Summary& summary)
{
    const MotionVerdict& verdict = summary.verdict;
    const QString frequency =
        verdict.frequency > 0.0 ? QString::fromStdString(fewDigits(verdict.frequency, "kHz", 3)) + QStringLiteral(", ")
                                : QString();
    const Statistics* tail = valueIn(summary.tail, "minimum_spacing");
    const double rms = tail ? tail->std : verdict.rms;
    if (verdict.forced)
        return AboutCasePane::tr("The disk forces it to vibrate%1: %2%3 rms.")
            .arg(verdict.touch == Touch::Never    ? AboutCasePane::tr(" without contact")
                 : verdict.touch == Touch::Always ? AboutCasePane::tr(" in contact")
                                                  : AboutCasePane::tr(" in and out of contact"),
                 frequency, QString::fromStdString(fewDigits(rms, "nm")));
    switch (verdict.motion) {
    case Motion::NotJudged: break;
    case Motion::AtRest: return AboutCasePane::tr("It is at rest.");
    case Motion::Settles: return AboutCasePane::tr("It settles.");
    case Motion::Swings: return AboutCasePane::tr("It continues to swing without contact.");
    case Motion::Vibrates: return AboutCasePane::tr("It continues to vibrate in contact.");
    case Motion::Bounces: return AboutCasePane::tr("It continues to bounce.");
    case Motion::TooShort: return AboutCasePane::tr("The run is too short to tell whether it settles.");
    }
    return {};
}

QString resultText(const RunRecord& run)
{
    if (!run.summary) return {};
    const Summary& summary = *run.summary;
    QString text;
    if (summary.status == RunStatus::Completed && run.value.model == ModelKind::Contact) {
        const auto add = [&](const char* name, const QString& what) {
            const auto figure =
                std::ranges::find(summary.figures, name, [](const RunFigure& f) { return f.quantity.name; });
            if (figure == summary.figures.end()) return;
            const QString part = figure->value == 0.0 ? AboutCasePane::tr("No contact") : what.arg(figureText(*figure));
            text += (text.isEmpty() ? QString() : QStringLiteral(", ")) + part;
        };
        add("largest_contact_force", AboutCasePane::tr("Largest contact force %1"));
        add("pull_off_force", AboutCasePane::tr("pull-off force %1"));
        add("snap_in_separation", AboutCasePane::tr("snap-in at %1"));
        text += QLatin1Char('.');
    } else if (summary.status == RunStatus::Completed) {
        // The last sample of a motion that lasts is anywhere: its means stand for it.
        const bool lasting = lasts(summary.verdict.motion);
        const auto valueOf = [&](const std::string& name) -> std::optional<double> {
            if (!lasting) return run.last(name);
            const Statistics* tail = valueIn(summary.tail, name);
            return tail ? std::optional(tail->mean) : std::nullopt;
        };
        const std::optional<EndHeight> end = endHeight(run);
        QStringList values;
        for (const auto& [name, words] :
             {std::pair(end ? end->quantity->name : std::string(), run.value.model == ModelKind::Film
                                                                       ? AboutCasePane::tr("minimum spacing %1")
                                                                       : AboutCasePane::tr("flying height %1")),
              std::pair(std::string("pitch"), AboutCasePane::tr("pitch %1")),
              std::pair(std::string("net_contact_force"), AboutCasePane::tr("net contact force %1"))}) {
            const std::optional<double> value = valueOf(name);
            if (!value || (*value == 0.0 && name == "net_contact_force")) continue;
            const auto index = static_cast<std::size_t>(findQuantity(run.quantities, name));
            values << words.arg(readout(*value, run.quantities[index]));
        }
        const QString with = values.join(QStringLiteral(", "));
        text = !lasting ? AboutCasePane::tr("Ends at %1 with %2.").arg(timeText(summary.endTime), with)
               : values.isEmpty()
                   ? sentence(endText(run).toStdString())
                   : sentence(AboutCasePane::tr("%1, with %2 in the mean").arg(endText(run), with).toStdString());
        if (const QString motion = motionText(summary); !motion.isEmpty()) text += QLatin1Char(' ') + motion;
    } else {
        text = sentence(summary.message);
    }
    return text;
}

QString figureText(const RunFigure& figure)
{
    const Quantity& quantity = figure.quantity;
    if (std::isnan(figure.value)) return AboutCasePane::tr("not known");
    if (figure.isCount) return QLocale().toString(std::llround(figure.value));
    if (quantity.unit == "s") return timeText(figure.value);
    // Between sliders and single asperities forces differ by powers of ten, and so do the errors of a solver.
    QString text = quantity.unit == "N" ? forceText(figure.value)
                   : figure.ofSolver    ? roundedText(figure.value, quantity.displayUnit, 3)
                                        : readout(figure.value, quantity).trimmed();
    return text.replace(QLatin1Char('-'), QChar(0x2212)); // a true minus sign
}

QString figuresText(const Summary& summary)
{
    QStringList lines = figureLines(summary, false);
    if (summary.fit) lines << sentence(summary.fit->message);
    return lines.join(QLatin1Char('\n'));
}

QString solverText(const Summary& summary) { return figureLines(summary, true).join(QLatin1Char('\n')); }

} // namespace touchdown
