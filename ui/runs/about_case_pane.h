// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a case is about: what the paper saw, what to watch, what is a stand-in, and what this run shows.
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
    /// Of the run of this case that has ended, by which rule, and what else is read off it; empty while it runs.
    void setResult(const QString& result, const QString& rule = {}, const QString& figures = {});
    /// What the file says and has no effect or is not modelled.
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

/// What a run came to, in a few sentences; warnings and the check of the step are not among them.
QString resultText(const RunRecord& run);
/// The value of one figure: "3.577 mN".
QString figureText(const RunFigure& figure);
/// What one reads off a contact run, a line for each figure.
QString figuresText(const Summary& summary);

} // namespace touchdown
