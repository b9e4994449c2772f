// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/glossary.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <QFile>
#include <QStringList>

#include "core/case/case.h"
#include "core/formats/quotation.h"
#include "core/formats/toml_document.h"
#include "core/studies/study/study_reader.h"
#include "ui/guides/lesson_text.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

const std::vector<std::string> glossaryUnits{"nm", "um", "urad", "deg", "mN", "gf", "N/m", "pJ"};

/// The text of a key that must be there, and say something.
std::string neededGlossaryText(StudyReader& reader, const std::string& key)
{
    const std::optional<std::string> text = reader.text(key);
    if (!reader.has(key))
        reader.add(key, "is missing");
    else if (text && text->empty())
        reader.add(key, "must be a text that is not empty");
    return text.value_or("");
}

/// `spellings`: those of the entries before.
GlossaryEntry readGlossaryEntry(StudyReader& reader, const std::string& table, std::set<std::string>& spellings)
{
    GlossaryEntry entry;
    entry.term = neededGlossaryText(reader, table + ".term");
    entry.also = reader.texts(table + ".also").value_or(std::vector<std::string>());
    entry.unit = reader.choice(table + ".unit", glossaryUnits).value_or("");
    entry.text = neededGlossaryText(reader, table + ".text");
    const auto note = [&](const std::string& spelling, const char* key) {
        if (!spelling.empty() && !spellings.insert(spelling).second)
            reader.add(table + key, inQuotes(spelling) + " is a spelling of an entry before it, too");
    };
    note(entry.term, ".term");
    if (std::erase(entry.also, std::string()) > 0) reader.add(table + ".also", "has a text that is empty");
    for (const std::string& spelling : entry.also) note(spelling, ".also");
    return entry;
}

/// "<b>take-off height</b> d_e [nm]", typeset.
QString headOf(const GlossaryEntry& entry)
{
    QStringList symbols;
    for (const std::string& spelling : entry.also)
        if (isSymbol(spelling)) symbols << symbolText(spelling);
    QString head = QStringLiteral("<b>%1</b> ").arg(lessonHtml(entry.term)) + symbols.join(QStringLiteral(", "));
    if (!entry.unit.empty()) head += QStringLiteral(" [%1]").arg(unitText(entry.unit).toHtmlEscaped());
    return head;
}

} // namespace

bool isSymbol(std::string_view spelling) { return spelling.size() <= 2 || spelling.find('_') != spelling.npos; }

Glossary readGlossary(std::string_view text, const std::string& name)
{
    Glossary glossary;
    const TomlDocument toml = readToml(text);
    if (!toml.problem.empty()) {
        glossary.problems.push_back({name, toml.problemLine, "", toml.problem});
        return glossary;
    }
    const Case none;
    StudyReader reader(toml, name, none, glossary.problems);
    std::set<std::string> spellings;
    for (const std::string& table : reader.tables("entry")) {
        GlossaryEntry entry = readGlossaryEntry(reader, table, spellings);
        if (!entry.term.empty() && !entry.text.empty()) glossary.entries.push_back(std::move(entry));
    }
    reader.finish();
    return glossary;
}

const std::vector<GlossaryEntry>& glossaryEntries()
{
    static const std::vector<GlossaryEntry> entries = [] {
        QFile file(QStringLiteral(":/help/glossary.toml"));
        return file.open(QIODevice::ReadOnly) ? readGlossary(file.readAll().toStdString(), "glossary.toml").entries
                                              : std::vector<GlossaryEntry>();
    }();
    return entries;
}

QString glossaryHtmlTip(const GlossaryEntry& entry)
{
    return QStringLiteral("<p style='margin:0'>%1</p><p style='margin:2px 0 0 0'>%2</p>")
        .arg(headOf(entry), lessonHtml(entry.text));
}

QString glossaryPage(const std::vector<GlossaryEntry>& entries)
{
    std::vector<const GlossaryEntry*> sorted;
    for (const GlossaryEntry& entry : entries) sorted.push_back(&entry);
    std::ranges::sort(sorted, [](const GlossaryEntry* a, const GlossaryEntry* b) {
        return QString::fromStdString(a->term).compare(QString::fromStdString(b->term), Qt::CaseInsensitive) < 0;
    });
    QString html = QStringLiteral("<table cellpadding='4' cellspacing='0' border='0'>");
    for (const GlossaryEntry* entry : sorted)
        html += QStringLiteral("<tr><td>%1</td><td>%2</td></tr>").arg(headOf(*entry), lessonHtml(entry->text));
    return html + QStringLiteral("</table>");
}

} // namespace touchdown
