// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static solutions side by side: their numbers, the differences to the one that they are compared with, and in what
// their cases differ.
#pragma once

#include <vector>

#include <QLocale>

#include "ui/film/solutions_model.h"
#include "ui/style/copied_text.h"

namespace touchdown {

/// A number of each solution in words; differences are empty in the column that the others are compared with, where a
/// number is not known, and where a search found no state.
struct ComparedRow {
    QString name; // "Minimum spacing"
    QStringList values, differences;
};
struct SolutionComparison {
    QStringList columns; // "3  rail 2 moved by 1, 0 µm"
    QStringList states;  // of each column: "not converged", empty where a state was found
    qsizetype base = 0;  // the column that the others are compared with
    std::vector<ComparedRow> rows;
    std::vector<QStringList> changes; // of each column's case from that of the base
};
/// `baseline`: a number of the list; where it is not among `solutions`, the first of them is the base.
SolutionComparison comparisonOf(const std::vector<const SolutionRecord*>& solutions, int baseline,
                                const QLocale& locale = QLocale());

class ComparePage : public CopiedText {
    Q_OBJECT

public:
    explicit ComparePage(QWidget* parent = nullptr);

    void setSolutions(const std::vector<const SolutionRecord*>& solutions, int baseline);
    const SolutionComparison& comparison() const { return comparison_; }

protected:
    QString html() const override;
    QString plainText() const override;

private:
    SolutionComparison comparison_;
};

} // namespace touchdown
