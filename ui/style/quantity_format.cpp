// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/quantity_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>

#include "core/formats/units.h"
#include "ui/style/window_words.h"

namespace touchdown {

namespace {

QString withPrefix(double value, const QString& unit, const QLocale& locale)
{
    static constexpr std::array<std::pair<double, const char*>, 7> prefixes{
        {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}}};
    if (value == 0.0) return QStringLiteral("0 ") + unit;
    const double size = std::abs(value) * (1.0 + 1e-9);
    for (const auto& [factor, prefix] : prefixes) {
        if (size < factor && factor > 1e-9) continue;
        const double scaled = value / factor;
        const int digits =
            std::clamp(3 - static_cast<int>(std::floor(std::log10(std::abs(scaled) * (1.0 + 1e-9)))), 0, 3);
        return locale.toString(scaled, 'f', digits) + QChar(0x00A0) + QString::fromUtf8(prefix) + unit;
    }
    return {};
}

} // namespace

QString unitText(std::string_view unit)
{
    static const QRegularExpression micro(QStringLiteral("\\bu(?=(m|rad|s|N|g|Pa|J|W)\\b)"));
    QString text = QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
    text.replace(micro, QStringLiteral("µ"));
    text.replace(QLatin1String("^2"), QStringLiteral("²"));
    text.replace(QLatin1String("^3"), QStringLiteral("³"));
    text.replace(QLatin1Char(' '), QStringLiteral("·"));
    return text;
}

QString symbolText(std::string_view symbol)
{
    static const QHash<QString, QString> greek{{"dgamma", "Δγ"}, // the work of adhesion
                                               {"alpha", "α"},   {"beta", "β"},   {"gamma", "γ"}, {"eta", "η"},
                                               {"theta", "θ"},   {"lambda", "λ"}, {"mu", "μ"},    {"nu", "ν"},
                                               {"xi", "ξ"},      {"sigma", "σ"},  {"phi", "φ"},   {"omega", "ω"}};
    const QString text = QString::fromUtf8(symbol.data(), static_cast<qsizetype>(symbol.size()));
    const auto letters = [](const QString& name) {
        // "theta(0)": the letter, then its argument.
        const qsizetype bracket = name.indexOf(QLatin1Char('('));
        const QString letter = bracket < 0 ? name : name.left(bracket);
        return greek.value(letter, letter.toHtmlEscaped()) + name.mid(letter.size()).toHtmlEscaped();
    };
    const qsizetype bar = text.indexOf(QLatin1Char('_'));
    if (bar < 0) return QStringLiteral("<i>%1</i>").arg(letters(text));
    return QStringLiteral("<i>%1</i><sub>%2</sub>").arg(letters(text.left(bar)), letters(text.mid(bar + 1)));
}

QString trueMinus(QString number) { return number.replace(QLatin1Char('-'), QChar(0x2212)); }

QString typeset(double value, int decimals, QLocale locale)
{
    locale.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator);
    if (std::abs(value) < 0.5 * std::pow(10.0, -decimals)) value = 0.0; // no "−0.0"
    return trueMinus(locale.toString(value, 'f', decimals));
}

QString typesetChange(double value, int decimals, QLocale locale)
{
    const bool rises = value >= 0.5 * std::pow(10.0, -decimals);
    return (rises ? QStringLiteral("+") : QString()) + typeset(value, decimals, std::move(locale));
}

QString sentence(std::string_view reason)
{
    QString text = QString::fromUtf8(reason.data(), static_cast<qsizetype>(reason.size())).trimmed();
    if (text.isEmpty()) return text;
    // A symbol such as d_e, a key or the name of a file keeps its spelling.
    static const QRegularExpression name(QStringLiteral("^\\w*(_|\\.\\w)"));
    if (!name.match(text).hasMatch()) text[0] = text[0].toUpper();
    if (!text.endsWith(QLatin1Char('.'))) text += QLatin1Char('.');
    return inWindowWords(text.toStdString());
}

QString readout(double value, std::string_view displayUnit, int decimals, const QLocale& locale)
{
    if (displayUnit == "1") displayUnit = {};
    double scaled = displayUnit.empty() ? value : value / unitFactor(displayUnit);
    // No "-0.000".
    if (std::abs(scaled) < 0.5 * std::pow(10.0, -decimals)) scaled = 0.0;
    const QString number = trueMinus(locale.toString(scaled, 'f', decimals));
    return displayUnit.empty() ? number : number + QChar(0x00A0) + unitText(displayUnit);
}

QString readout(double value, const Quantity& quantity, const QLocale& locale)
{
    return readout(value, quantity.displayUnit, quantity.unit == "rad" ? 2 : 3, locale);
}

QString roundedText(double value, std::string_view displayUnit, int digits, const QLocale& locale)
{
    if (displayUnit == "ms") return timeText(value, locale);
    if (displayUnit == "nm") return lengthText(value, digits, locale);
    if (displayUnit == "1") displayUnit = {};
    const double shown = displayUnit.empty() ? value : value / unitFactor(displayUnit);
    const QString number = trueMinus(locale.toString(shown, 'g', digits));
    return displayUnit.empty() ? number : number + QChar(0x00A0) + unitText(displayUnit);
}

QString statusText(std::string_view status)
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("Status", text); };
    if (status == "completed") return tr("completed");
    if (status == "converged") return tr("converged");
    if (status == "not converged") return tr("not converged");
    if (status == "cancelled") return tr("stopped");
    if (status == "diverged") return tr("diverged");
    return tr("failed");
}

QString lengthText(double metres, int digits, const QLocale& locale)
{
    const bool micrometres = std::abs(metres) >= 0.9999995e-6;
    const double shown = metres / (micrometres ? 1e-6 : 1e-9);
    // A value near zero has as many decimals as one nanometre.
    const double size = std::max(std::abs(shown), micrometres ? 0.0 : 1.0);
    const int decimals = std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(size))), 0, 9);
    QString number = locale.toString(shown, 'f', decimals);
    if (decimals > 0 && digits > 3) {
        while (number.endsWith(QLatin1Char('0'))) number.chop(1);
        if (number.endsWith(locale.decimalPoint())) number.chop(locale.decimalPoint().size());
    }
    if (number == QLatin1String("-0")) number = QStringLiteral("0");
    return trueMinus(number) + QChar(0x00A0) + (micrometres ? QStringLiteral("µm") : QStringLiteral("nm"));
}

QString forceText(double newtons, const QLocale& locale) { return withPrefix(newtons, QStringLiteral("N"), locale); }

QString timeText(double seconds, const QLocale& locale) { return withPrefix(seconds, QStringLiteral("s"), locale); }

QString frequencyText(double hertz, const QLocale& locale) { return withPrefix(hertz, QStringLiteral("Hz"), locale); }

} // namespace touchdown
