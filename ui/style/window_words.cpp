// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/window_words.h"

#include <QRegularExpression>

#include "core/case/parameters.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

/// "Preload" as "preload", but "FH" as it is.
QString withinSentence(QString label)
{
    if (label.size() > 1 && label[1].isLower()) label[0] = label[0].toLower();
    return label;
}

/// Empty where it is the name of nothing.
QString labelOf(const QString& name)
{
    static const QRegularExpression rail(QStringLiteral("^abs\\.rail\\[(\\d+)\\]\\.(recess|x|y|length|width)$"));
    if (const auto found = rail.match(name); found.hasMatch())
        return QStringLiteral("rail %1: %2").arg(found.captured(1), found.captured(2));
    if (name.contains(u'.')) {
        const Parameter* parameter = findParameter(name.toStdString());
        return parameter == nullptr ? QString() : readable(parameter->label);
    }
    static const std::vector<SteadyQuantity> quantities = steadyQuantities({});
    for (const SteadyQuantity& each : quantities)
        if (name.contains(u'_') && each.quantity.name == name.toStdString())
            return withinSentence(readable(each.quantity.longName));
    return {};
}

} // namespace

QString labelOfKey(const std::string& key)
{
    QString label = labelOf(QString::fromStdString(key));
    if (const Parameter* root = findParameter(key); label.isEmpty() && root != nullptr) label = readable(root->label);
    if (!label.isEmpty()) label[0] = label[0].toUpper();
    return label;
}

QString inWindowWords(std::string_view sentence)
{
    // Texts in quotation marks are those of the user.
    static const QRegularExpression word(QStringLiteral("\"[^\"]*\"|\\b[a-z]\\w*(?:\\.[a-z]\\w*(?:\\[\\d+\\])?)*"));
    QString text = readable(sentence), all;
    text.replace(QStringLiteral("(--apply FILE, or Apply to the case)"), QStringLiteral("(Apply to the case)"));
    qsizetype done = 0;
    bool beginsWithLabel = false;
    for (auto words = word.globalMatch(text); words.hasNext();) {
        const auto found = words.next();
        const QString label = labelOf(found.captured());
        beginsWithLabel |= found.capturedStart() == 0 && !label.isEmpty();
        all += text.mid(done, found.capturedStart() - done) + (label.isEmpty() ? found.captured() : label);
        done = found.capturedEnd();
    }
    all += text.mid(done);
    if (beginsWithLabel) all[0] = all[0].toUpper();
    return all;
}

} // namespace touchdown
