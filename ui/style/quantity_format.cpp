// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/quantity_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QCoreApplication>
#include <QRegularExpression>

#include "core/formats/units.h"

namespace touchdown {

namespace {

QString withDecimalPointOf(const QLocale& locale, QString number)
{
    return number.replace(QLatin1Char('.'), locale.decimalPoint());
}

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

bool separatesByComma(const QLocale& locale) { return locale.decimalPoint() != QLatin1String(","); }

/// A number as it may be typed, as the core reads it.
QString numberEntry(QString text, const Field& field, const QLocale& locale)
{
    text.replace(QChar(0x2212), QLatin1Char('-')); // minus sign
    text.replace(QChar(0x00A0), QLatin1Char(' '));
    text.replace(QChar(0x00B5), QLatin1Char('u')); // micro sign
    text.replace(QChar(0x03BC), QLatin1Char('u')); // Greek mu
    text.replace(QStringLiteral("²"), QLatin1String("^2"));
    text.replace(QStringLiteral("³"), QLatin1String("^3"));
    text.replace(QStringLiteral("·"), QLatin1String(" "));
    if (locale.decimalPoint() != QLatin1String(".") && text.count(locale.decimalPoint()) == 1 &&
        !text.contains(QLatin1Char('.')))
        text.replace(locale.decimalPoint(), QLatin1String("."));

    // In a form, a bare number means the unit that stands beside it; in a case file it means SI.
    static const QRegularExpression bareNumber(QStringLiteral("^[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?$"));
    if (!field.displayUnit.empty() && bareNumber.match(text).hasMatch())
        text += QLatin1Char(' ') + QString::fromStdString(field.displayUnit);
    return text;
}

} // namespace

QString unitText(std::string_view unit)
{
    static const QRegularExpression micro(QStringLiteral("\\bu(?=(m|rad|s|N|g|Pa|J)\\b)"));
    QString text = QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
    text.replace(micro, QStringLiteral("µ"));
    text.replace(QLatin1String("^2"), QStringLiteral("²"));
    text.replace(QLatin1String("^3"), QStringLiteral("³"));
    text.replace(QLatin1Char(' '), QStringLiteral("·"));
    return text;
}

QString symbolText(std::string_view symbol)
{
    static const std::array<std::pair<const char*, const char*>, 13> greek{{{"alpha", "α"},
                                                                            {"lambda", "λ"},
                                                                            {"xi", "ξ"},
                                                                            {"theta", "θ"},
                                                                            {"mu", "μ"},
                                                                            {"beta", "β"},
                                                                            {"gamma", "γ"},
                                                                            {"phi", "φ"},
                                                                            {"omega", "ω"},
                                                                            {"nu", "ν"},
                                                                            {"eta", "η"},
                                                                            {"sigma", "σ"},
                                                                            {"dgamma", "Δγ"}}};
    const QString text = QString::fromUtf8(symbol.data(), static_cast<qsizetype>(symbol.size()));
    const auto letters = [](const QString& name) {
        // "theta(0)": the letter, then what it is at.
        const qsizetype bracket = name.indexOf(QLatin1Char('('));
        const QString letter = bracket < 0 ? name : name.left(bracket);
        for (const auto& [spelled, drawn] : greek)
            if (letter == QLatin1String(spelled))
                return QString::fromUtf8(drawn) + name.mid(letter.size()).toHtmlEscaped();
        return name.toHtmlEscaped();
    };
    const qsizetype bar = text.indexOf(QLatin1Char('_'));
    if (bar < 0) return QStringLiteral("<i>%1</i>").arg(letters(text));
    return QStringLiteral("<i>%1</i><sub>%2</sub>").arg(letters(text.left(bar)), letters(text.mid(bar + 1)));
}

QString sentence(std::string_view reason)
{
    QString text = QString::fromUtf8(reason.data(), static_cast<qsizetype>(reason.size())).trimmed();
    if (text.isEmpty()) return text;
    // A symbol such as d_e keeps its spelling.
    if (text.size() > 1 && text[1] != QLatin1Char('_')) text[0] = text[0].toUpper();
    if (!text.endsWith(QLatin1Char('.'))) text += QLatin1Char('.');
    return text;
}

QString editorText(const Case& c, const Field& field, const QLocale& locale)
{
    const FieldValue value = field.get(c);
    const auto number = [&](double each) {
        return withDecimalPointOf(locale, QString::fromStdString(formatNumber(each, field.displayUnit)));
    };
    if (field.kind == FieldKind::Number) return number(std::get<double>(value));
    if (field.kind == FieldKind::List) {
        QStringList elements;
        for (const double each : std::get<std::vector<double>>(value)) elements << number(each);
        return elements.join(separatesByComma(locale) ? QStringLiteral(", ") : QStringLiteral("; "));
    }
    return QString::fromStdString(toText(c, field));
}

std::string entryText(const QString& typed, const Field& field, const QLocale& locale)
{
    const QString text = typed.trimmed();
    if (field.kind == FieldKind::Number) return numberEntry(text, field, locale).toStdString();
    if (field.kind != FieldKind::List) return text.toStdString();
    // Where the comma is the decimal point, one with a blank behind it still parts two numbers.
    static const QRegularExpression commas(QStringLiteral("[,;]"));
    static const QRegularExpression semicolons(QStringLiteral(";|,\\s"));
    QStringList elements;
    if (!text.isEmpty())
        for (const QString& element : text.split(separatesByComma(locale) ? commas : semicolons))
            elements << numberEntry(element.trimmed(), field, locale);
    return elements.join(QStringLiteral(", ")).toStdString();
}

QString valueText(const Case& c, const Field& field, const QLocale& locale)
{
    const QString text = editorText(c, field, locale);
    const bool numbers = field.kind == FieldKind::Number || field.kind == FieldKind::List;
    if (!numbers || field.displayUnit.empty() || text.isEmpty()) return text;
    return text + QChar(0x00A0) + unitText(field.displayUnit);
}

QString readout(double value, std::string_view displayUnit, int decimals, const QLocale& locale)
{
    double scaled = displayUnit.empty() ? value : value / unitFactor(displayUnit);
    // No "-0.000".
    if (std::abs(scaled) < 0.5 * std::pow(10.0, -decimals)) scaled = 0.0;
    const QString number = locale.toString(scaled, 'f', decimals);
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
    const double shown = displayUnit.empty() ? value : value / unitFactor(displayUnit);
    const QString number = locale.toString(shown, 'g', digits).replace(QLatin1Char('-'), QChar(0x2212));
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
    if (number.startsWith(QLatin1Char('-'))) number.replace(0, 1, QChar(0x2212)); // a true minus sign
    return number + QChar(0x00A0) + (micrometres ? QStringLiteral("µm") : QStringLiteral("nm"));
}

QString forceText(double newtons, const QLocale& locale) { return withPrefix(newtons, QStringLiteral("N"), locale); }

QString timeText(double seconds, const QLocale& locale) { return withPrefix(seconds, QStringLiteral("s"), locale); }

QString frequencyText(double hertz, const QLocale& locale) { return withPrefix(hertz, QStringLiteral("Hz"), locale); }

} // namespace touchdown
