// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers that a text states, with their units and digits, to compare them with what runs give.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <QRegularExpression>
#include <QString>
#include <QStringList>

namespace touchdown {

struct Amount {
    double value = 0.0;
    QString unit{};               // "" for a count or a ratio
    double half = 0.0;            // half a unit of the last digit
    QString text{};               // "7.00 nm"
    qsizetype begin = 0, end = 0; // of it in the text
};

/// Whether a found value is rounded to what is said.
inline bool rounds(double found, const Amount& said)
{
    return std::abs(found - said.value) <= said.half * (1.0 + 1e-9);
}

/// All numbers of a text but those that name a figure, a step or an equation. In a list such as "5 and 10 nm" the last
/// number has the unit of the others, too.
inline std::vector<Amount> amountsIn(const QString& text)
{
    static const QRegularExpression names(
        QStringLiteral("\\b(Figs?\\.|Table|[Ss]teps?|equation) \\(?\\d+\\)?((, | and | to )\\d+)*"));
    static const QRegularExpression number(QStringLiteral(
        "(?<![\\w.^])(-?\\d+(?:\\.(\\d+))?(?:e(-?\\d+))?)(?![\\w]|\\.\\d)"
        "( (nm|um|µm|mm|urad|mN/m|N/m|N s/m|uN|mN|gf|mg|pJ|us|µs|ms|ns|s|kHz|MPa|GPa|atmospheres|rpm|m/s|%)(?!\\w))?"));
    static const QStringList between{QStringLiteral(", "), QStringLiteral(" and "), QStringLiteral(" to "),
                                     QStringLiteral(" or ")};
    QString plain = text;
    for (auto match = names.globalMatch(text); match.hasNext();) {
        const QRegularExpressionMatch name = match.next();
        plain.replace(name.capturedStart(), name.capturedLength(), QString(name.capturedLength(), u'#'));
    }
    std::vector<Amount> amounts;
    for (auto match = number.globalMatch(plain); match.hasNext();) {
        const QRegularExpressionMatch m = match.next();
        const double lastDigit = std::pow(10.0, m.captured(3).toInt() - int(m.capturedLength(2)));
        amounts.push_back({m.captured(1).toDouble(), m.captured(5), 0.5 * lastDigit, m.captured(), m.capturedStart(),
                           m.capturedEnd()});
    }
    for (std::size_t i = amounts.size(); i-- > 1;)
        if (amounts[i - 1].unit.isEmpty() &&
            between.contains(plain.mid(amounts[i - 1].end, amounts[i].begin - amounts[i - 1].end)))
            amounts[i - 1].unit = amounts[i].unit;
    return amounts;
}
inline std::vector<Amount> amountsIn(const std::string& text)
{
    return amountsIn(QString::fromStdString(text).simplified());
}

} // namespace touchdown
