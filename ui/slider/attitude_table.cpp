// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/attitude_table.h"

#include <algorithm>

#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int longName = 12; // characters

QString cell(const QString& text, const QString& style)
{
    return QStringLiteral("<td align='right' style='padding:1px 0 1px 8px; %1'>%2</td>").arg(style, text);
}

/// An error is read after its value: in a quieter colour.
QString valueHtml(const QString& value, const QColor& muted)
{
    const QString text = value.toHtmlEscaped();
    const qsizetype sign = text.indexOf(QChar(0x00B1));
    if (sign < 0) return text;
    const qsizetype end = text.lastIndexOf(QChar(0x00A0));
    return text.left(sign) + QStringLiteral("<span style='color:%1'>").arg(muted.name()) + text.mid(sign, end - sign) +
           QStringLiteral("</span>") + text.mid(end);
}

QString sectionHtml(const AttitudeSection& section, const MeaningColours& colours)
{
    const QString muted = QStringLiteral("color:%1").arg(colours.muted.name());
    QString html =
        QStringLiteral(
            "<p style='margin:10px 0 2px 0; color:%1; font-weight:600'>%2</p><table width='98%' cellspacing='0'>")
            .arg(colours.change.name(), section.title.toHtmlEscaped());
    if (!section.columns.isEmpty()) {
        html += QStringLiteral("<tr><td></td>");
        for (const QString& column : section.columns) html += cell(column.toHtmlEscaped(), muted);
        html += QStringLiteral("</tr>");
    }
    // Names wrap, so that units and places are seen in a narrow pane; beside several values a long one has a line.
    const bool isLong = std::ranges::any_of(
        section.rows, [](const QStringList& row) { return row.size() > 2 && row.front().size() > longName; });
    const bool many = section.columns.size() > 2 || isLong;
    for (const QStringList& row : section.rows) {
        const qsizetype columns = many ? section.columns.size() + 1 : row.size() == 1 ? 2 : 1;
        html += QStringLiteral("<tr><td colspan='%1' style='padding:1px 0'>%2</td>")
                    .arg(QString::number(columns), row.front().toHtmlEscaped());
        if (many) html += QStringLiteral("</tr><tr><td></td>");
        for (qsizetype i = 1; i < row.size(); ++i)
            html += cell(valueHtml(row[i], colours.muted), QStringLiteral("white-space:nowrap"));
        html += QStringLiteral("</tr>");
    }
    return html + QStringLiteral("</table>");
}

} // namespace

AttitudeTable::AttitudeTable(QWidget* parent)
    : CopiedText(tr("Static attitude"), tr("Copy the static attitude"), parent)
{
    text()->setMinimumHeight(80);
    write();
}

void AttitudeTable::setResult(const Case& c, const SteadyResult& result)
{
    sections_ = attitudeSections(c, result);
    stale_ = false;
    write();
}

void AttitudeTable::clear()
{
    sections_.clear();
    stale_ = false;
    write();
}

void AttitudeTable::setStale(bool stale)
{
    if (stale == stale_ || sections_.empty()) return;
    stale_ = stale;
    write();
}

QString AttitudeTable::plainText() const { return sections_.empty() ? QString() : sectionsAsText(sections_); }

QString AttitudeTable::html() const
{
    const MeaningColours colours = meaningColours(palette());
    QString html;
    if (sections_.empty())
        html = QStringLiteral("<p style='color:%1'>%2</p>").arg(colours.muted.name(), tr("Not solved yet."));
    if (stale_)
        html = QStringLiteral("<p style='color:%1'>%2</p>")
                   .arg(colours.warning.name(), tr("The parameters have changed since."));
    for (const AttitudeSection& section : sections_) html += sectionHtml(section, colours);
    return html;
}

} // namespace touchdown
