// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/lesson_text.h"

#include <QRegularExpression>
#include <QStringList>

#include "core/case/parameters.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"

namespace touchdown {

QString lessonHtml(const std::string& text)
{
    static const QRegularExpression symbol(QStringLiteral("\\b([a-zA-Z])_(\\w+)"));
    static const QRegularExpression amount(QStringLiteral("(\\d) (u?)(m?[sNm]|nm|ns|pJ|rad)\\b"));
    static const QRegularExpression minus(QStringLiteral("(^|[ (])-(?=[\\d(])|(?<= )-(?= )"));
    static const QRegularExpression key(QStringLiteral("\\b([a-z_]+(?:\\.[a-z_]+)+)\\b"));
    static const QRegularExpression friction(QStringLiteral("\\bmu\\b(?= = )"));
    QString html = QString::fromStdString(text).toHtmlEscaped();
    html.replace(friction, QStringLiteral("μ"));
    html.replace(QStringLiteral("&gt;="), QStringLiteral("≥")).replace(QStringLiteral("^2"), QStringLiteral("²"));
    html.replace(minus, QStringLiteral("\\1−"));
    html.replace(symbol, QStringLiteral("\\1<sub>\\2</sub>"));
    html.replace(amount, QStringLiteral("\\1\u00a0\\2\\3"))
        .replace(QStringLiteral("\u00a0u"), QStringLiteral("\u00a0µ"));
    qsizetype from = 0;
    for (auto found = key.match(html); found.hasMatch(); found = key.match(html, from)) {
        const QString name = found.captured(1);
        const Parameter* parameter = findParameter(name.toStdString());
        const QString shown =
            parameter != nullptr
                ? QStringLiteral("<a href='%1'>%2</a>").arg(name, readable(parameter->label).toHtmlEscaped())
                : QStringLiteral("<code>%1</code>").arg(name);
        html.replace(found.capturedStart(), found.capturedLength(), shown);
        from = found.capturedStart() + shown.size();
    }
    return html;
}

QString lessonBlock(const QString& heading, const std::string& text, const QColor& colour)
{
    QString all;
    if (!heading.isEmpty())
        all = QStringLiteral("<p style='margin:0; color:%1; font-weight:600'>%2</p>").arg(colour.name(), heading);
    for (const QString& part : lessonHtml(text).split(QLatin1Char('\n')))
        all += QStringLiteral("<p style='margin:2px 0 4px 0'>%1</p>").arg(part);
    return all;
}

QString lessonSubject(const LessonRun& run)
{
    QString text = QString::fromStdString(run.name);
    for (const CaseSetting& setting : run.settings) {
        const Parameter& parameter = *findParameter(setting.key);
        const QString name =
            parameter.symbol.empty() ? QString::fromStdString(parameter.label) : symbolText(parameter.symbol);
        text += QStringLiteral(", %1\u00a0=\u00a0%2").arg(name, lessonHtml(setting.value));
    }
    return text;
}

} // namespace touchdown
