// SPDX-License-Identifier: GPL-3.0-or-later
//
// Terms of the glossary in the texts of a step: the first use of each is a link with a dotted line, which shows its
// explanation.
#pragma once

#include <map>
#include <set>
#include <vector>

#include <QColor>
#include <QLabel>
#include <QRegularExpression>
#include <QString>

#include "ui/guides/glossary.h"

namespace touchdown {

class TermMarks {
public:
    /// `entries` must outlive it.
    explicit TermMarks(const std::vector<GlossaryEntry>& entries = glossaryEntries());

    /// The terms count as not used.
    void restart() { used_.clear(); }
    /// Texts of the step in the order in which they are read: HTML as lessonHtml() writes it, with the first use of
    /// each term marked. What stands in a link, in <code>, in a subscript or in a tag is left as it is.
    QString marked(const QString& html, const QColor& colour);

private:
    QRegularExpression pattern_;                        // what is left as it is, or a term
    std::map<QString, const GlossaryEntry*> spellings_; // as HTML
    std::set<const GlossaryEntry*> used_;
};

/// The entry that a link leads to; nullptr for another link.
const GlossaryEntry* linkedEntry(const QString& link);

/// The label shows the explanation of a term under the pointer, and of a term that is chosen by mouse or keyboard.
void explainTerms(QLabel* label);

} // namespace touchdown
