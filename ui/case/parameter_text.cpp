// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/parameter_text.h"

#include <array>
#include <utility>

#include <QRegularExpression>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

bool separatesByComma(const QLocale& locale) { return locale.decimalPoint() != QLatin1String(","); }

/// A number as it may be typed, as the core reads it.
QString numberEntry(QString text, const Parameter& parameter, const QLocale& locale)
{
    // Minus sign, space that does not break, micro sign, Greek mu, and what unitText writes.
    static const std::array<std::pair<QString, QString>, 7> spellings{
        {{"\u2212", "-"}, {"\u00A0", " "}, {"\u00B5", "u"}, {"\u03BC", "u"}, {"²", "^2"}, {"³", "^3"}, {"·", " "}}};
    for (const auto& [typed, read] : spellings) text.replace(typed, read);
    if (locale.decimalPoint() != QLatin1String(".") && text.count(locale.decimalPoint()) == 1 &&
        !text.contains(QLatin1Char('.')))
        text.replace(locale.decimalPoint(), QLatin1String("."));

    // In a form, a bare number is in the unit beside it; in a case file it is in SI.
    static const QRegularExpression bareNumber(QStringLiteral("^[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?$"));
    if (!parameter.displayUnit.empty() && bareNumber.match(text).hasMatch())
        text += QLatin1Char(' ') + QString::fromStdString(parameter.displayUnit);
    return text;
}

} // namespace

QString editorText(const Case& c, const Parameter& parameter, const QLocale& locale)
{
    const ParameterValue value = parameter.get(c);
    const auto number = [&](double each) {
        return QString::fromStdString(formatNumber(each, parameter.displayUnit))
            .replace(QLatin1Char('.'), locale.decimalPoint());
    };
    if (parameter.kind == ParameterKind::Number) return number(std::get<double>(value));
    if (parameter.kind == ParameterKind::List) {
        QStringList elements;
        for (const double each : std::get<std::vector<double>>(value)) elements << number(each);
        return elements.join(separatesByComma(locale) ? QStringLiteral(", ") : QStringLiteral("; "));
    }
    return QString::fromStdString(toText(c, parameter));
}

std::string entryText(const QString& typed, const Parameter& parameter, const QLocale& locale)
{
    const QString text = typed.trimmed();
    if (parameter.kind == ParameterKind::Number) return numberEntry(text, parameter, locale).toStdString();
    if (parameter.kind != ParameterKind::List) return text.toStdString();
    // Where the comma is the decimal point, a comma with a blank after it still separates two numbers.
    static const QRegularExpression commas(QStringLiteral("[,;]"));
    static const QRegularExpression semicolons(QStringLiteral(";|,\\s"));
    QStringList elements;
    if (!text.isEmpty())
        for (const QString& element : text.split(separatesByComma(locale) ? commas : semicolons))
            elements << numberEntry(element.trimmed(), parameter, locale);
    return elements.join(QStringLiteral(", ")).toStdString();
}

QString valueText(const Case& c, const Parameter& parameter, const QLocale& locale)
{
    const QString text = editorText(c, parameter, locale);
    const bool numbers = parameter.kind == ParameterKind::Number || parameter.kind == ParameterKind::List;
    if (!numbers || parameter.displayUnit.empty() || text.isEmpty()) return text;
    return text + QChar(0x00A0) + unitText(parameter.displayUnit);
}

QStringList caseDifference(const Case& before, const Case& after)
{
    QStringList changes;
    for (const Parameter& parameter : parameters()) {
        if (parameter.kind == ParameterKind::Text || parameter.get(before) == parameter.get(after)) continue;
        if (!parameter.used(before) && !parameter.used(after)) continue;
        changes << QStringLiteral("%1 %2 → %3")
                       .arg(QString::fromStdString(parameter.label), valueText(before, parameter),
                            valueText(after, parameter));
    }
    return changes;
}

} // namespace touchdown
