// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/readable.h"

#include <array>
#include <iterator>
#include <utility>

#include <QHash>
#include <QRegularExpression>

namespace touchdown {

namespace {

QString raised(QString digits)
{
    static const QString plain = QStringLiteral("0123456789-"), high = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹⁻");
    for (QChar& digit : digits) digit = high[plain.indexOf(digit)];
    return digits;
}

QString lowered(QString letters)
{
    // Not r, though there is one: what is in front has the index f, which has none, and both are written alike.
    static const QString plain = QStringLiteral("0123456789aehijklmnopstuvx");
    static const QString low = QStringLiteral("₀₁₂₃₄₅₆₇₈₉"
                                              "ₐₑₕᵢⱼₖₗₘₙₒₚₛₜᵤᵥₓ");
    for (QChar& letter : letters) {
        const qsizetype found = plain.indexOf(letter);
        if (found < 0) return {};
        letter = low[found];
    }
    return letters;
}

/// Each match, as `change` writes it.
template <typename Change>
QString replaced(const QString& text, const QRegularExpression& pattern, const Change& change)
{
    QString result;
    qsizetype end = 0;
    for (auto matches = pattern.globalMatch(text); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        result += text.mid(end, match.capturedStart() - end) + change(match);
        end = match.capturedEnd();
    }
    return result + text.mid(end);
}

/// Text without quotations.
QString printed(QString text)
{
    using Match = const QRegularExpressionMatch&;
    static const std::array<std::pair<QRegularExpression, QString>, 6> signs{{
        {QRegularExpression(QStringLiteral(R"((?:(?<=[0-9] )|(?<=[[/(])|(?<=\bper ))u(?=(?:m|rad|s|N|g|Pa|J)\b))")),
         QStringLiteral("µ")},
        {QRegularExpression(QStringLiteral(R"(\+-|\+/-)")), QStringLiteral("±")},
        {QRegularExpression(QStringLiteral(">=")), QStringLiteral("≥")},
        {QRegularExpression(QStringLiteral("<=")), QStringLiteral("≤")},
        {QRegularExpression(QStringLiteral(R"((?<=[0-9]) x (?=[0-9]))")), QStringLiteral(" × ")},
        {QRegularExpression(QStringLiteral(R"((?<![\w.^)/\-])-(?=\.?[0-9]))")), QStringLiteral("−")},
    }};
    for (const auto& [pattern, sign] : signs) text.replace(pattern, sign);

    static const QRegularExpression power(QStringLiteral(R"((?<=[\w)])\^(-?[0-9]+)(?!\w|\.[0-9]))"));
    text = replaced(text, power, [](Match match) { return raised(match.captured(1)); });

    static const QHash<QString, QString> greek{{QStringLiteral("lambda"), QStringLiteral("λ")},
                                               {QStringLiteral("mu"), QStringLiteral("μ")},
                                               {QStringLiteral("xi"), QStringLiteral("ξ")},
                                               {QStringLiteral("sigma"), QStringLiteral("σ")}};
    static const QRegularExpression letter(QStringLiteral(R"((?<![\w.\-])(lambda|mu|xi|sigma)(?=$|_|\W)(?![.\-]\w))"));
    text = replaced(text, letter, [](Match match) { return greek.value(match.captured(1)); });

    static const QRegularExpression symbol(
        QStringLiteral(R"((?<![\w.])([A-Zdefhkpvzξσμ])_([a-z0-9]{1,2})(?!\w|[.\[]\w))"),
        QRegularExpression::UseUnicodePropertiesOption);
    return replaced(text, symbol, [](Match match) {
        const QString low = lowered(match.captured(2));
        return low.isEmpty() ? match.captured() : match.captured(1) + low;
    });
}

} // namespace

QString readable(std::string_view text)
{
    static const QRegularExpression quotation(QStringLiteral(R"("[^"]*"|`[^`]*`)"));
    const QString all = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    QString result;
    qsizetype end = 0;
    for (auto quotations = quotation.globalMatch(all); quotations.hasNext();) {
        const QRegularExpressionMatch match = quotations.next();
        result += printed(all.mid(end, match.capturedStart() - end)) + match.captured();
        end = match.capturedEnd();
    }
    return result + printed(all.mid(end));
}

} // namespace touchdown
