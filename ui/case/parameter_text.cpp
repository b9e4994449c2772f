// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/parameter_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <QHash>
#include <QRegularExpression>

#include "core/case/case_difference.h"
#include "core/case/case_key.h"
#include "core/formats/units.h"
#include "ui/case/choice_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/translate.h"

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

/// A symbol without tags: "FH(0)", "k_f0", "ξ_f".
QString plainSymbol(const std::string& symbol)
{
    static const QRegularExpression tags(QStringLiteral("<[^>]*>"));
    QString text = symbolText(symbol).replace(QLatin1String("<sub>"), QLatin1String("_")).remove(tags);
    return text.replace(QLatin1String("&lt;"), QLatin1String("<")).replace(QLatin1String("&amp;"), QLatin1String("&"));
}

/// Both values with their unit; a number with as many digits as show the difference, at least five.
std::pair<QString, QString> changeTexts(const Case& before, const Case& after, const Parameter& parameter)
{
    if (parameter.kind != ParameterKind::Number) return {valueText(before, parameter), valueText(after, parameter)};
    const auto text = [&parameter](const Case& c, int digits) {
        // Rounded as it is shown: of 1.5 gf neither the SI value nor its rounding is short.
        const double shown = std::stod(formatNumber(std::get<double>(parameter.get(c)), parameter.displayUnit));
        QString number = QString::fromStdString(formatNumber(roundedTo(shown, digits)))
                             .replace(QLatin1Char('.'), QLocale().decimalPoint());
        return parameter.displayUnit.empty() ? number : number + QChar(0x00A0) + unitText(parameter.displayUnit);
    };
    int digits = 5;
    while (digits < 17 && text(before, digits) == text(after, digits)) ++digits;
    return {text(before, digits), text(after, digits)};
}

/// A coordinate of a point in `moved`, or the order of the points of a rail whose mirror image has the same outline.
bool isMove(const CaseChange& change, const std::vector<MovedPoints>& moved)
{
    const auto concerns = [&change](const MovedPoints& each) {
        const std::string point = "abs.rail[" + std::to_string(each.rail + 1) + "].point";
        if (change.kind == CaseChangeKind::Order) return change.key == point && each.how == MovedPoints::How::Mirrored;
        return change.kind == CaseChangeKind::Value && change.key.starts_with(point + '[') &&
               (change.key.ends_with(".x") || change.key.ends_with(".y"));
    };
    return std::ranges::any_of(moved, concerns);
}

/// "rail 3 moved by 2, −0.5 µm", "rail 3, corners 1, 2 moved by 2, 0 µm", "rail 3, edge 2 moved by ...", "rail 3
/// mirrored".
QString moveText(const MovedPoints& moved)
{
    using How = MovedPoints::How;
    QString what = tr("rail %1").arg(moved.rail + 1);
    if (moved.how == How::Mirrored) return tr("%1 mirrored").arg(what);
    QStringList points;
    for (const std::size_t point : moved.points) points << QString::number(point + 1);
    if (moved.how == How::Edge) what += tr(", edge %1").arg(points.front());
    if (moved.how == How::Points)
        what += (points.size() == 1 ? tr(", corner %1") : tr(", corners %1")).arg(points.join(QStringLiteral(", ")));
    // A part of a length that is 1e-5 of it is one of rounding.
    const double least = 1e-5 * std::hypot(moved.x, moved.y);
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const auto number = [&](double length) {
        return trueMinus(locale.toString(std::abs(length) < least ? 0.0 : length / 1e-6, 'g', 5));
    };
    const QString separator = separatesByComma(QLocale()) ? QStringLiteral(", ") : QStringLiteral("; ");
    return tr("%1 moved by %2\u00A0µm").arg(what, number(moved.x) + separator + number(moved.y));
}

/// The changes in words, points that were moved together as one; `valueChange` writes that of a value.
template <typename ValueChange>
QStringList changesAs(const Case& before, const Case& after, const ValueChange& valueChange)
{
    QStringList texts;
    const std::vector<MovedPoints> moved = movedPoints(before.surface, after.surface);
    bool movesListed = false;
    for (const CaseChange& change : caseChanges(before, after)) {
        if (isMove(change, moved)) {
            if (!std::exchange(movesListed, true))
                for (const MovedPoints& each : moved) texts << moveText(each);
            continue;
        }
        const QString label = QString::fromStdString(change.label);
        switch (change.kind) {
        case CaseChangeKind::Added: texts << tr("%1 added").arg(label); break;
        case CaseChangeKind::Removed: texts << tr("%1 removed").arg(label); break;
        case CaseChangeKind::Order: texts << tr("%1 changed").arg(label); break;
        case CaseChangeKind::Kind:
            texts << tr("%1: %2 → %3")
                         .arg(label, QString::fromStdString(change.before), QString::fromStdString(change.after));
            break;
        case CaseChangeKind::Value: texts << valueChange(label, std::get<Parameter>(caseKey(after, change.key))); break;
        }
    }
    return texts;
}

} // namespace

QString groupTitle(const std::string& name)
{
    static const QHash<QString, QString> titles{{"", tr("Model")},
                                                {"springs", tr("Air bearing springs")},
                                                {"pad", tr("Contact pad")},
                                                {"approach", tr("Approach and retraction")},
                                                {"elastic", tr("Elastic contact")},
                                                {"adhesion", tr("Intermolecular adhesion")},
                                                {"asperity", tr("Asperities")},
                                                {"meniscus", tr("Menisci")},
                                                {"disk.surface", tr("Disk surface")},
                                                {"ono_yamane", tr("Contact and adhesion")},
                                                {"initial", tr("Start")},
                                                {"run", tr("Run and numerics")},
                                                {"spectrum", tr("Spectrum")},
                                                {"abs", tr("Air bearing surface")},
                                                {"film", tr("Film and grid")},
                                                {"steady", tr("Static attitude")}};
    const QString key = QString::fromStdString(name);
    // A group that is missing in this list is shown by its key.
    QString text = titles.value(key, QString(key).replace(QLatin1Char('_'), QLatin1Char(' ')));
    text[0] = text[0].toUpper();
    return text;
}

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
    if (const QString name = choiceText(parameter.key, text.toStdString()).name; !name.isEmpty()) return name;
    const bool numbers = parameter.kind == ParameterKind::Number || parameter.kind == ParameterKind::List;
    if (!numbers || parameter.displayUnit.empty() || text.isEmpty()) return text;
    return text + QChar(0x00A0) + unitText(parameter.displayUnit);
}

QStringList caseDifference(const Case& before, const Case& after)
{
    return changesAs(before, after, [&](const QString& label, const Parameter& parameter) {
        const auto [then, now] = changeTexts(before, after, parameter);
        return QStringLiteral("%1 %2 → %3").arg(label, then, now);
    });
}

QStringList shortDifference(const Case& before, const Case& after)
{
    return changesAs(before, after, [&](const QString& label, const Parameter& parameter) {
        return QStringLiteral("%1 %2").arg(parameter.symbol.empty() ? label : plainSymbol(parameter.symbol),
                                           changeTexts(before, after, parameter).second);
    });
}

} // namespace touchdown
