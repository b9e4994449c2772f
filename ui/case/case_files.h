// SPDX-License-Identifier: GPL-3.0-or-later
//
// The file of the case that is being edited: new, open, save, recent files, the question about unsaved changes. Files
// of the established program (CML) are imported and exported; saving never overwrites them. No dialog blocks the
// window.
#pragma once

#include <filesystem>
#include <functional>
#include <map>

#include <QPointer>
#include <QSet>
#include <QWidget>

#include "ui/case/case_edits.h"

class QMessageBox;

namespace touchdown {

struct CaseDocument;
struct CaseSetting;

/// All that is needed to edit the case further in another window; undo excepted.
struct CaseState {
    QString name;                 // as shortName()
    QString file, sample, import; // where it comes from
    QString folder;               // of the files that it names
    QString savedText;            // as opened or saved
    QString text;                 // with its edits
    bool modified = false;
    std::map<QString, QString> entries; // typed for parameters and not taken, by key
};

class CaseFiles : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this.
    CaseFiles(CaseEdits& edits, QWidget& window);

    /// A case that was read elsewhere. `file` is empty for a sample case and a new one; an imported case has the path
    /// of its import.
    void take(const CaseDocument& document, const QString& file);
    /// Opens a case file or a sample case at once; shows problems. A case that names files outside its folder is opened
    /// after the person allowed it; asked once a session.
    bool openNow(const QString& fileOrSample);
    /// As openNow, after asking about changes.
    void open(const QString& fileOrSample);
    /// A sample case with some values changed, after asking about changes; then calls `next`. The values are marked as
    /// changed and can be undone, but they are nothing to save.
    void openChanged(const QString& sample, const std::vector<CaseSetting>& settings,
                     const std::function<void()>& next);
    void newCase();
    void chooseFile();
    void chooseImport();
    void chooseExport();
    /// Writes files of the established program: an archive if the name ends with .cml, else a folder.
    void exportTo(const QString& path);
    void save();
    void saveAs();
    /// As save(); then calls `next`, unless the user chooses no file or it cannot be written.
    void saveThen(const std::function<void()>& next);
    /// Writes to a file, which is the case's from then on. Returns "" or the problem in a sentence.
    QString write(const QString& file);

    CaseState state() const;
    /// A case from another window, with its edits as one step of undo. An open question about files outside the folder
    /// of a case is withdrawn.
    void restore(const CaseState& state);

    /// Asks about unsaved changes, if there are any; calls `next` unless the user cancels.
    void whenSettled(const std::function<void()>& next);

    bool modified() const;
    /// The changes so far are nothing to ask about.
    void leaveUnsaved();
    QString file() const { return file_; }
    QString sample() const { return sample_; }
    /// "fig10a", "slider.toml", "femto" for one that was imported from there, "Untitled".
    QString shortName() const;
    /// The exact input that the current values make.
    std::string text() const;
    /// The same with what it reads from a file of rails, so that it needs no folder.
    std::string wholeText() const;
    QStringList recent() const;

    /// A case file, or what can be imported.
    static bool isCaseFile(const QString& file);
    static bool isResultsFile(const QString& file);
    /// The text of a study.
    static bool isStudyFile(const QString& file);

signals:
    void opened();
    void saved();
    void resultsFileChosen(const QString& file);
    void studyFileChosen(const QString& file);
    /// After `opened`; the warnings list the entries that are not modelled.
    void imported(const QString& path, const QStringList& warnings);
    /// After `opened`, of a case file with entries that are not modelled or have no effect.
    void warned(const QStringList& warnings);
    void exported(const QString& path, const QStringList& warnings);

private:
    /// Asks whether a case may read files outside its folder; on yes opens it.
    void askForOutsideFiles(const QString& file, const std::vector<std::string>& outside);
    void askForFile(const QString& title, const QString& filter);
    void writeAndTell(const QString& file);
    void remember(const QString& file);
    void showProblems(const QString& what, const QStringList& problems);

    CaseEdits& edits_;
    QWidget& window_;
    QString file_;
    QString sample_;
    QString imported_;             // name of an imported case
    std::string text_;             // as opened or saved
    std::filesystem::path folder_; // of the files that it names
    Case saved_;                   // the values in it
    std::function<void()> afterSave_;
    QPointer<QMessageBox> outside_; // the question about files outside a folder
    QSet<QString> allowed_;         // cases that may read the files outside their folders which they name
};

} // namespace touchdown
