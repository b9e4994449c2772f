// SPDX-License-Identifier: GPL-3.0-or-later
//
// The file of the case that is being edited: new, open, save, recent, and what happens to changes
// that were not saved. Nothing here blocks: questions are asked by boxes that leave the window alive.
#pragma once

#include "ui/case_edits.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <functional>

namespace touchdown {

class CaseFiles : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this.
    CaseFiles(CaseEdits& edits, QWidget& window);

    /// A case that was read elsewhere; `file` is empty for a sample case or a new one.
    void take(const CaseDocument& document, const QString& file);
    /// Opens a case file or a sample case at once; problems are shown.
    bool openNow(const QString& fileOrSample);
    /// As openNow, after asking about changes.
    void open(const QString& fileOrSample);
    void newCase();
    void chooseFile();
    void save();
    void saveAs();

    /// Asks about changes, if there are any, and goes on unless the answer is to stay.
    void whenSettled(const std::function<void()>& next);

    bool modified() const;
    QString file() const { return file_; }
    QString sample() const { return sample_; }
    /// "fig10a", "slider.toml", "Untitled".
    QString shortName() const;
    /// The exact input that the current values make.
    std::string text() const;
    QStringList recent() const;

    static bool isCaseFile(const QString& file);
    static bool isResultsFile(const QString& file);

signals:
    void opened();
    void saved();
    void resultsFileChosen(const QString& file);

private:
    bool write(const QString& file);
    void remember(const QString& file);
    void showProblems(const QString& what, const QStringList& problems);

    CaseEdits& edits_;
    QWidget& window_;
    QString file_;
    QString sample_;
    std::string text_; // as opened or saved
    Case saved_;       // the values in it
    std::function<void()> afterSave_;
};

} // namespace touchdown
