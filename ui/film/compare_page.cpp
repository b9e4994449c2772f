// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/compare_page.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <QTextDocument>

#include "core/formats/units.h"
#include "core/simulation/static_state/film_setup.h"
#include "ui/case/parameter_text.h"
#include "ui/slider/attitude_sections.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

struct ComparedNumber {
    QString name;
    std::string unit; // shown
    std::function<double(const SteadyResult&, const Case&)> value;
    std::function<double(const SteadyResult&)> error = [](const SteadyResult&) { return noNumber; };
    bool ofAnySize = false; // four digits of small numbers, too, as of stiffnesses
};

QString valueText(const ComparedNumber& number, double value, double error, const QLocale& locale)
{
    if (!number.ofAnySize) return withError(value, error, number.unit, locale);
    return fourDigits(value / unitFactor(number.unit), locale) + QChar(0x00A0) + unitText(number.unit);
}

QString differenceText(const ComparedNumber& number, double difference, double value, double error,
                       const QLocale& locale)
{
    if (!number.ofAnySize) return changeText(difference, value, error, number.unit, locale);
    const QString text = fourDigits(difference / unitFactor(number.unit), locale);
    return difference > 0.0 ? QLatin1Char('+') + text : text;
}

std::vector<ComparedNumber> comparedNumbers(const std::vector<const SolutionRecord*>& solutions)
{
    using Result = const SteadyResult&;
    std::vector<ComparedNumber> numbers{
        {tr("Minimum spacing"), "nm", [](Result r, const Case&) { return r.minimumSpacing; },
         [](Result r) { return r.discretisationError.minimumSpacing; }},
        {tr("Nominal trailing edge height"), "nm", [](Result r, const Case&) { return r.attitude.height; }},
        {tr("Pitch"), "urad", [](Result r, const Case&) { return r.attitude.pitch; },
         [](Result r) { return r.discretisationError.pitch; }},
        {tr("Roll"), "urad", [](Result r, const Case&) { return r.attitude.roll; },
         [](Result r) { return r.discretisationError.roll; }},
        {tr("Net force"), "mN", [](Result r, const Case&) { return r.forces.net; },
         [](Result r) { return r.discretisationError.load; }},
        {tr("Force above ambient"), "mN", [](Result r, const Case&) { return r.forces.positive; }},
        {tr("Force below ambient"), "mN", [](Result r, const Case&) { return r.forces.negative; }},
        {tr("Peak pressure above ambient"), "kPa",
         [](Result r, const Case& c) { return r.forces.maximumPressure - airOf(c.air).pressure; }},
        {tr("Smallest pressure above ambient"), "kPa",
         [](Result r, const Case& c) { return r.forces.minimumPressure - airOf(c.air).pressure; }},
    };
    std::size_t points = 0;
    bool stiffness = false;
    for (const SolutionRecord* each : solutions) {
        points = std::max(points, each->result.interestSpacing.size());
        stiffness = stiffness || each->result.stiffness;
    }
    for (std::size_t i = 0; i < points; ++i)
        numbers.push_back({tr("Spacing at P%1").arg(i + 1), "nm", [i](Result r, const Case&) {
                               return i < r.interestSpacing.size() ? r.interestSpacing[i] : noNumber;
                           }});
    const auto diagonal = [&numbers](const QString& name, const char* unit, int i) {
        numbers.push_back(
            {name, unit, [i](Result r, const Case&) { return r.stiffness ? (*r.stiffness)(i, i) : noNumber; }});
        numbers.back().ofAnySize = true;
    };
    if (stiffness) {
        diagonal(tr("Vertical stiffness"), "mN/nm", 0);
        diagonal(tr("Pitch stiffness"), "N m/rad", 1);
        diagonal(tr("Roll stiffness"), "N m/rad", 2);
    }
    return numbers;
}

QString cell(const QString& text, const QString& style)
{
    return QStringLiteral("<td align='right' style='padding:2px 0 2px 18px; %1'>%2</td>").arg(style, text);
}

} // namespace

SolutionComparison comparisonOf(const std::vector<const SolutionRecord*>& solutions, int baseline,
                                const QLocale& locale)
{
    SolutionComparison all;
    if (solutions.empty()) return all;
    const auto chosen =
        std::ranges::find_if(solutions, [baseline](const SolutionRecord* each) { return each->number == baseline; });
    all.base = chosen == solutions.end() ? 0 : chosen - solutions.begin();
    const SolutionRecord& base = *solutions[static_cast<std::size_t>(all.base)];
    for (const SolutionRecord* each : solutions) {
        all.columns << QStringLiteral("%1  %2").arg(each->number).arg(each->name);
        all.states << notFoundText(each->result);
        all.changes.push_back(caseDifference(base.value, each->value));
    }
    for (const ComparedNumber& number : comparedNumbers(solutions)) {
        ComparedRow row{number.name, {}, {}};
        const double reference = number.value(base.result, base.value);
        for (const SolutionRecord* each : solutions) {
            const double value = number.value(each->result, each->value);
            const bool known = std::isfinite(value);
            const double error = number.error(each->result);
            row.values << (known ? valueText(number, value, error, locale) : QString());
            const bool bothFound = notFoundText(each->result).isEmpty() && notFoundText(base.result).isEmpty();
            row.differences << (each == &base || !known || !std::isfinite(reference) || !bothFound
                                    ? QString()
                                    : differenceText(number, value - reference, value, error, locale));
        }
        all.rows.push_back(std::move(row));
    }
    ComparedRow cells{tr("Cells"), {}, {}};
    for (const SolutionRecord* each : solutions) {
        cells.values << tr("%1 × %2").arg(each->result.grid.nx()).arg(each->result.grid.ny());
        cells.differences << QString();
    }
    all.rows.push_back(std::move(cells));
    return all;
}

ComparePage::ComparePage(QWidget* parent) : CopiedText(tr("Solutions side by side"), tr("Copy the comparison"), parent)
{
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    text()->document()->setDocumentMargin(12);
    write();
}

void ComparePage::setSolutions(const std::vector<const SolutionRecord*>& solutions, int baseline)
{
    comparison_ = comparisonOf(solutions, baseline);
    write();
}

QString ComparePage::plainText() const
{
    const SolutionComparison& all = comparison_;
    if (all.columns.isEmpty()) return {};
    QStringList lines{QStringList(QStringList{QString()} + all.columns).join(QLatin1Char('\t'))};
    if (!all.states.join(QString()).isEmpty())
        lines << QStringList(QStringList{tr("State")} + all.states).join(QLatin1Char('\t'));
    for (const ComparedRow& row : all.rows) {
        lines << QStringList(QStringList{row.name} + row.values).join(QLatin1Char('\t'));
        if (!row.differences.join(QString()).isEmpty())
            lines << QStringList(QStringList{tr("difference")} + row.differences).join(QLatin1Char('\t'));
    }
    QStringList changes{tr("Changed")};
    for (const QStringList& each : all.changes) changes << each.join(QStringLiteral(", "));
    lines << changes.join(QLatin1Char('\t'));
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

QString ComparePage::html() const
{
    const SolutionComparison& all = comparison_;
    const MeaningColours colours = meaningColours(palette());
    const QString muted = QStringLiteral("color:%1").arg(colours.muted.name());
    if (all.columns.isEmpty())
        return QStringLiteral("<p style='%1'>%2</p>")
            .arg(muted, tr("Check the boxes of solutions in the list to see them side by side."));
    QString html = QStringLiteral("<table cellspacing='0'><tr><td></td>");
    for (qsizetype i = 0; i < all.columns.size(); ++i)
        html += cell(QStringLiteral("<b>%1</b>").arg(escaped(all.columns[i])) +
                         (all.states[i].isEmpty() ? QString()
                                                  : QStringLiteral("<br><span style='color:%1'>%2</span>")
                                                        .arg(colours.failure.name(), escaped(all.states[i]))) +
                         (i == all.base && all.columns.size() > 1
                              ? QStringLiteral("<br><span style='%1'>%2</span>").arg(muted, tr("compared with"))
                              : QString()),
                     QStringLiteral("vertical-align:top"));
    html += QStringLiteral("</tr>");
    for (const ComparedRow& row : all.rows) {
        html +=
            QStringLiteral("<tr><td style='padding:2px 0; white-space:nowrap'>%1</td>").arg(row.name.toHtmlEscaped());
        for (qsizetype i = 0; i < row.values.size(); ++i) {
            QString text = row.values[i].toHtmlEscaped();
            if (!row.differences[i].isEmpty())
                text += QStringLiteral("<br><span style='color:%1'>%2</span>")
                            .arg(colours.change.name(), row.differences[i].toHtmlEscaped());
            html += cell(text, QStringLiteral("white-space:nowrap; vertical-align:top"));
        }
        html += QStringLiteral("</tr>");
    }
    html += QStringLiteral("<tr><td style='padding:8px 0 2px 0'>%1</td>").arg(tr("Changed"));
    for (const QStringList& each : all.changes)
        html += cell(escaped(each.join(QLatin1Char('\n'))), QStringLiteral("vertical-align:top; ") + muted);
    html += QStringLiteral("</tr></table>");
    if (!all.states.join(QString()).isEmpty())
        html += QStringLiteral("<p style='color:%1'>%2</p>")
                    .arg(colours.failure.name(),
                         tr("A search that did not converge found no state: its numbers are those of its last step."));
    return html +
           QStringLiteral("<p style='%1'>%2</p>")
               .arg(muted, tr("Of the solutions whose boxes you leave alone, the last %1 are side by side. Check "
                              "the boxes of others in the list.")
                               .arg(SolutionsModel::mostByItself));
}

} // namespace touchdown
