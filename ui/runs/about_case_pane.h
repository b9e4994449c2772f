// SPDX-License-Identifier: GPL-3.0-or-later
//
// Description of a case: the paper's result, what to look at, assumptions, and the result of the run. A result is shown
// as long as the case is the one that it belongs to, also again after undo.
#pragma once

#include <functional>

#include "core/case/case.h"

#include <QTextBrowser>

namespace touchdown {

struct RunFigure;
struct RunRecord;
struct Summary;

class AboutCasePane : public QTextBrowser {
    Q_OBJECT

public:
    explicit AboutCasePane(QWidget* parent = nullptr);

    void setCase(const Case& c);
    /// Result of the last run or solution, its criterion, its figures and those of the solver. `belongsTo` says of
    /// which cases it is the result.
    void setResult(const std::function<bool(const Case&)>& belongsTo, const QString& result, const QString& rule = {},
                   const QString& figures = {}, const QString& details = {});
    /// During a run, and without one.
    void clearResult();
    /// The figures of the solver, which are folded away at first; a click on their heading does the same.
    void showDetails(bool shown);
    /// Entries of the file that have no effect or are not modelled.
    void setWarnings(const QStringList& warnings);

protected:
    void changeEvent(QEvent* event) override;

private:
    void write();
    bool hasResult() const { return belongsTo_ && belongsTo_(case_); }

    Case case_;
    std::function<bool(const Case&)> belongsTo_;
    QString result_;
    QString rule_;
    QString figures_;
    QString details_;
    bool detailsShown_ = false;
    QStringList warnings_;
};

/// Result of a run in a few sentences, without warnings and the check of the step.
QString resultText(const RunRecord& run);
/// The value of one figure: "3.577 mN"; "6" for a count.
QString figureText(const RunFigure& figure);
/// Figures of the slider or the pad, a line for each.
QString figuresText(const Summary& summary);
/// Figures of the solver, a line for each.
QString solverText(const Summary& summary);

} // namespace touchdown
