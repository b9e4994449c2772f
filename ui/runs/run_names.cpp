// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_names.h"

#include <algorithm>
#include <iterator>

#include <QRegularExpression>
#include <QSet>

#include "core/case/parameters.h"
#include "ui/case/parameter_text.h"
#include "ui/style/readable.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr qsizetype mostInName = 2;    // changes
constexpr qsizetype longestHead = 20;  // of the case [characters]
constexpr qsizetype longestPart = 28;  // a change
constexpr qsizetype longestParts = 40; // of a second change and the first one
constexpr qsizetype longLabel = 16;    // of a parameter: its value stands before it

struct Named {
    int number;
    const Case* value;
    QString head;
    QStringList changes, numerics;
};

bool isNumerics(const Parameter& parameter)
{
    static const QSet<QString> keys{QStringLiteral("elastic.cell"),
                                    QStringLiteral("elastic.tolerance"),
                                    QStringLiteral("elastic.maximum_iterations"),
                                    QStringLiteral("elastic.patch_pitch"),
                                    QStringLiteral("elastic.patch_reach"),
                                    QStringLiteral("disk.surface.cell"),
                                    QStringLiteral("disk.surface.seed"),
                                    QStringLiteral("steady.load_tolerance"),
                                    QStringLiteral("steady.stiffness"),
                                    QStringLiteral("steady.sensitivities"),
                                    QStringLiteral("steady.all_equilibria")};
    const std::string group = parameter.group();
    return group == "run" || group == "film" || group == "spectrum" ||
           keys.contains(QString::fromStdString(parameter.key));
}

Case withNumericsOf(const Case& numerics, Case c)
{
    for (const Parameter& parameter : parameters())
        if (isNumerics(parameter)) parameter.set(c, parameter.get(numerics));
    return c;
}

/// Whole words, "Fig. 2, case II…".
QString cutWords(const QString& text, qsizetype longest)
{
    if (text.size() <= longest) return text;
    const qsizetype space = text.lastIndexOf(u' ', longest - 1);
    QString cut = text.left(space > 0 ? space : longest - 1);
    while (!cut.isEmpty() && !cut.back().isLetterOrNumber() && cut.back() != u')') cut.chop(1);
    return cut + QChar(0x2026);
}

/// Of a parameter without a symbol whose label is long, the value first: "held (potential below the cutoff)".
QString valueFirst(const QString& change)
{
    for (const Parameter& parameter : parameters()) {
        const QString label = QString::fromStdString(parameter.label);
        if (parameter.symbol.empty() && label.size() >= longLabel && change.startsWith(label + u' '))
            return QStringLiteral("%1 (%2)").arg(change.mid(label.size() + 1), label);
    }
    return change;
}

QStringList changeTexts(const Case& before, const Case& after)
{
    QStringList texts;
    for (const QString& change : shortDifference(before, after)) {
        QString text = readable(valueFirst(change).toStdString());
        if (text.size() > longestPart)
            text = text.left(2 * longestPart / 3) + QChar(0x2026) + text.right(longestPart / 3 - 1);
        texts += text;
    }
    return texts;
}

/// "Fig. 10 (a)" of "Fig. 10 (a): a 7 nm slider dropped from 250 nm".
QString figureOf(const QString& title)
{
    const qsizetype colon = title.indexOf(QLatin1String(": "));
    return colon > 0 ? title.left(colon) : title;
}

/// Of a title that begins as others do: what it has of its own, "Fig. 5: force 15 mN".
QString headBeside(const QString& title, const QStringList& others)
{
    const QString figure = figureOf(title);
    if (figure == title) return title;
    const qsizetype rest = figure.size() + 2;
    const QStringList words = title.mid(rest).split(u' ');
    qsizetype common = words.size() - 1;
    for (const QString& other : others) {
        const QStringList theirs = other.mid(rest).split(u' ');
        const auto [mine, end] = std::mismatch(words.begin(), words.begin() + common, theirs.begin(), theirs.end());
        common = mine - words.begin();
    }
    const auto needsMore = [](const QString& word) { return word.isEmpty() || word[0].isDigit() || word[0] == u'='; };
    while (common > 0 && needsMore(words[common])) --common;
    return tr("%1: %2").arg(figure, words.mid(common).join(u' '));
}

/// `titles`: of all runs, as they are read.
QString headOf(const QString& title, int number, const QStringList& titles)
{
    if (title.isEmpty()) return tr("Run %1").arg(number);
    const QString figure = figureOf(title);
    QStringList others; // that would have the same name
    for (const QString& other : titles)
        if (other != title && figureOf(other) == figure) others += other;
    return cutWords(others.isEmpty() ? figure : headBeside(title, others), longestHead);
}

/// The changes that not all of `group` have, those of the fewest runs first.
QStringList rareOf(const Named& run, const std::vector<const Named*>& group, QStringList Named::*kind)
{
    const auto holders = [&](const QString& change) {
        return std::ranges::count_if(group, [&](const Named* each) { return (each->*kind).contains(change); });
    };
    QStringList rare;
    const auto all = static_cast<std::ptrdiff_t>(group.size());
    std::ranges::copy_if(run.*kind, std::back_inserter(rare),
                         [&](const QString& change) { return holders(change) < all; });
    std::ranges::stable_sort(rare, {}, holders);
    return rare;
}

/// Of a run that has no change of its own: what sets it apart from each other one, "FH(0) 250 nm" beside "FH(0) 20 nm".
QStringList apartFrom(const Named& run, const std::vector<const Named*>& group)
{
    QStringList apart;
    std::vector<const QStringList*> met{&run.changes};
    for (const Named* other : group) {
        if (std::ranges::any_of(met, [&](const QStringList* changes) { return *changes == other->changes; })) continue;
        met.push_back(&other->changes);
        const QStringList texts = changeTexts(*other->value, withNumericsOf(*other->value, *run.value));
        if (met.size() == 2) apart = texts;
        apart.removeIf([&](const QString& text) { return !texts.contains(text); });
        if (apart.isEmpty()) break;
    }
    return apart;
}

/// As many as a name has room for: "fₘ 1 mN, dₑ 8 nm +1".
QString fewOf(const QStringList& changes)
{
    QString text = changes.first();
    qsizetype named = 1;
    for (; named < std::min(mostInName, changes.size()); ++named) {
        if (text.size() + 2 + changes[named].size() > longestParts) break;
        text += QStringLiteral(", ") + changes[named];
    }
    return named == changes.size() ? text : QStringLiteral("%1 +%2").arg(text).arg(changes.size() - named);
}

bool differEarly(const QString& one, const QString& other)
{
    const QStringList a = one.split(u' '), b = other.split(u' ');
    qsizetype at = 0;
    for (qsizetype word = 0; word < std::min(a.size(), b.size()); ++word) {
        if (a[word] != b[word]) return at < earlyDifference;
        at += a[word].size() + 1;
    }
    return a.size() != b.size() && at < earlyDifference;
}

/// Without the number where two begin alike.
QString plainName(const Named& run, const std::vector<Named>& all)
{
    std::vector<const Named*> group;
    for (const Named& each : all)
        if (each.value->title == run.value->title) group.push_back(&each);
    // Alone, or the same case again and again: nothing of it differs.
    const bool same = std::ranges::all_of(
        group, [&](const Named* each) { return each->changes == run.changes && each->numerics == run.numerics; });
    const bool hasTwin = std::ranges::any_of(
        group, [&](const Named* each) { return each->changes == run.changes && each->numerics != run.numerics; });
    QStringList parts = same ? run.changes : rareOf(run, group, &Named::changes);
    if (hasTwin) parts += rareOf(run, group, &Named::numerics);
    if (parts.isEmpty() && !same) parts = apartFrom(run, group);
    if (parts.isEmpty()) return run.head;
    const bool named = group.size() < all.size() || same;
    return named ? tr("%1, %2").arg(run.head, fewOf(parts)) : fewOf(parts);
}

} // namespace

QStringList runNames(const std::vector<RunToName>& runs)
{
    QStringList titles;
    for (const RunToName& run : runs) titles += readable(run.value->title).trimmed();
    std::vector<Named> all;
    for (const RunToName& run : runs) {
        const QString& title = titles[static_cast<qsizetype>(all.size())];
        const Case* before = run.before ? run.before : run.value;
        const Case moved = withNumericsOf(*before, *run.value);
        all.push_back({run.number, run.value, headOf(title, run.number, titles), changeTexts(*before, moved),
                       changeTexts(moved, *run.value)});
    }
    QStringList names;
    for (const Named& run : all) {
        QString name = plainName(run, all);
        for (qsizetype k = 0; k < names.size(); ++k) {
            const Case& other = *all[static_cast<std::size_t>(k)].value;
            const bool equal = names[k] == name;
            if (!equal && differEarly(names[k], name)) continue;
            const bool same = other.title == run.value->title && caseDifference(other, *run.value).isEmpty();
            if (same && !equal) continue;
            name = (same ? tr("%2, run %1") : tr("Run %1: %2")).arg(QString::number(run.number), name);
            break;
        }
        names += name;
    }
    return names;
}

} // namespace touchdown
