// SPDX-License-Identifier: GPL-3.0-or-later
//
// Description of a case: the paper's result, what to look at, assumptions, and the result of the run.
#pragma once

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
    /// Result of the last run of this case, its criterion and its figures; empty during a run.
    void setResult(const QString& result, const QString& rule = {}, const QString& figures = {});
    /// Entries of the file that have no effect or are not modelled.
    void setWarnings(const QStringList& warnings);

protected:
    void changeEvent(QEvent* event) override;

private:
    void write();

    QString title_;
    About about_;
    QString result_;
    QString rule_;
    QString figures_;
    QStringList warnings_;
};

/// Result of a run in a few sentences, without warnings and the check of the step.
QString resultText(const RunRecord& run);
/// The value of one figure: "3.577 mN".
QString figureText(const RunFigure& figure);
/// Figures of a contact run, a line for each.
QString figuresText(const Summary& summary);

} // namespace touchdown
