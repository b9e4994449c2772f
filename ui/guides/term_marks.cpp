// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/term_marks.h"

#include <algorithm>

#include <QCursor>
#include <QStringList>
#include <QToolTip>

#include "core/formats/words.h"
#include "ui/guides/lesson_text.h"

namespace touchdown {

namespace {

const QString termLink = QStringLiteral("term:");

/// A regular expression of a spelling, given as HTML.
QString patternOf(const QString& spelling, bool symbol)
{
    const QString exact = QRegularExpression::escape(spelling);
    if (symbol || !spelling.front().isLower()) return exact;
    return QStringLiteral("[%1%2]%3").arg(spelling.front().toUpper()).arg(spelling.front()).arg(exact.mid(1));
}

} // namespace

TermMarks::TermMarks(const std::vector<GlossaryEntry>& entries)
{
    QStringList spellings;
    const auto add = [&](const std::string& spelling, const GlossaryEntry& entry) {
        const QString html = lessonHtml(spelling);
        spellings_.emplace(html, &entry);
        spellings << patternOf(html, isSymbol(spelling));
    };
    for (const GlossaryEntry& entry : entries) {
        add(entry.term, entry);
        for (const std::string& spelling : entry.also) add(spelling, entry);
    }
    // The first alternative that fits counts: "minimum spacing" comes before "minimum".
    std::ranges::stable_sort(spellings, [](const QString& a, const QString& b) { return a.size() > b.size(); });
    pattern_.setPattern(
        QStringLiteral("<(a|code|sub|sup)\\b.*?</\\1>|<[^>]*>|&\\w+;|(?<![\\w-])(?<term>%1)(?![\\w-]|<su)")
            .arg(spellings.join(QLatin1Char('|'))));
    pattern_.setPatternOptions(QRegularExpression::UseUnicodePropertiesOption |
                               QRegularExpression::DotMatchesEverythingOption);
}

QString TermMarks::marked(const QString& html, const QColor& colour)
{
    if (spellings_.empty()) return html;
    QString all;
    qsizetype done = 0;
    for (auto matches = pattern_.globalMatch(html); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        const QString term = match.captured(QStringLiteral("term"));
        if (term.isEmpty()) continue;
        auto found = spellings_.find(term);
        if (found == spellings_.end())
            found = spellings_.find(QString::fromStdString(uncapitalized(term.toStdString())));
        if (!used_.insert(found->second).second) continue;
        all += QStringView(html).mid(done, match.capturedStart() - done);
        all += QStringLiteral("<a href='%1%2' style='color:%3; text-underline-style:dotted'>%4</a>")
                   .arg(termLink, QString::fromStdString(found->second->term), colour.name(), term);
        done = match.capturedEnd();
    }
    return all + html.mid(done);
}

const GlossaryEntry* linkedEntry(const QString& link)
{
    if (!link.startsWith(termLink)) return nullptr;
    const auto& entries = glossaryEntries();
    const auto found = std::ranges::find(entries, link.mid(termLink.size()).toStdString(), &GlossaryEntry::term);
    return found == entries.end() ? nullptr : &*found;
}

void explainTerms(QLabel* label)
{
    const auto show = [label](const GlossaryEntry& entry, QPoint at) {
        QToolTip::showText(at, glossaryHtmlTip(entry), label);
    };
    QObject::connect(label, &QLabel::linkHovered, label, [show](const QString& link) {
        if (const GlossaryEntry* entry = linkedEntry(link))
            show(*entry, QCursor::pos());
        else
            QToolTip::hideText();
    });
    QObject::connect(label, &QLabel::linkActivated, label, [show, label](const QString& link) {
        const GlossaryEntry* entry = linkedEntry(link);
        if (entry) show(*entry, label->underMouse() ? QCursor::pos() : label->mapToGlobal(label->rect().bottomLeft()));
    });
}

} // namespace touchdown
