// SPDX-License-Identifier: GPL-3.0-or-later
//
// The file of the case that is being edited: new, open, save, recent files, the question about unsaved changes. A file
// that another program has changed is not written over without a question. Files of the established program (CML) are
// imported and exported; saving never overwrites them. No dialog blocks the window.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <QPointer>
#include <QSet>
#include <QWidget>

#include "ui/case/case_edits.h"
#include "ui/style/watched_file.h"

class QMessageBox;

namespace touchdown {

struct CaseDocument;
struct CaseSetting;
struct InputProblem;
enum class OutsidePaths : std::uint8_t;

/// All that is needed to edit the case further in another window; undo excepted.
struct CaseState {
    QString name;                 // as shortName()
    QString file, sample, import; // where it comes from
    QString origin;               // see CaseFiles
    QString folder;               // of the files that it names
    QString savedText;            // as opened or saved
    QString text;                 // with its edits
    bool modified = false;
    std::map<QString, QString> entries; // typed for parameters and not taken, or not entered yet, by key
};

class CaseFiles : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this.
    CaseFiles(CaseEdits& edits, QWidget& window);

    /// A case that was read elsewhere. `file` is empty for a sample case and a new one; an imported case has the path
    /// of its import.
    void take(const CaseDocument& document, const QString& file);
    /// A case without a file, of a result: "st.h5", "run 3". Values of the case that is open are a step of undo in it
    /// (`step` is its text); another case is opened under the name `name`, after asking about changes. Then calls
    /// `next`.
    void use(
        const Case& c, const QString& name, const QString& step, const std::function<void()>& next = [] {});
    /// Whether the values are of the case that is open: the model and the title that it has now, or as saved.
    bool isOpen(const Case& c) const;
    /// Opens a case file or a sample case at once; shows problems. A case that names files outside its folder is opened
    /// after the person allowed it; asked once a session.
    bool openNow(const QString& fileOrSample);
    /// As openNow, after asking about changes. Results and the text of a study are left to who hears of them.
    void open(const QString& fileOrSample);
    /// A sample case with some values changed, after asking about changes; then calls `next`. The values are marked as
    /// changed and can be undone, but they are nothing to save.
    void openChanged(const QString& sample, const std::vector<CaseSetting>& settings,
                     const std::function<void()>& next);
    void newCase(const QString& slider = {});
    void chooseFile();
    void chooseImport();
    void chooseExport();
    /// Writes files of the established program: an archive if the name ends with .cml, else a folder.
    void exportTo(const QString& path);
    /// Writes the outlines of the surface as a DXF drawing. Returns the problem in a sentence, or "".
    QString exportDrawing(const QString& path);
    void chooseDrawing();
    void save();
    void saveAs();
    /// As save(); then calls `next`, unless the user chooses no file or it cannot be written.
    void saveThen(const std::function<void()>& next);
    /// Writes to a file, which is the case's from then on. Returns "" or the problem in a sentence: also that another
    /// program has changed the case's file.
    QString write(const QString& file);
    /// The case of the file as it is now, as one step of undo. Shows problems.
    void reload();
    /// Whether another program has changed the file since it was read or written.
    bool changedOutside() const { return changedOutside(file_); }
    /// Shows the differences to the file and asks what to do with it.
    void askAboutFile();

    CaseState state() const;
    /// Asks first where a case from another window reads files outside its folder, as open() does; calls `next` after
    /// either answer.
    void askBeforeRestoring(const CaseState& state, const std::function<void()>& next);
    /// A case from another window, with its edits as one step of undo. An open question about files outside the folder
    /// of a case is withdrawn. A text that cannot be read changes nothing: returns why, or "".
    QString restore(const CaseState& state);

    /// Asks about unsaved changes, if there are any; calls `next` unless the user cancels.
    void whenSettled(const std::function<void()>& next);
    /// Asks instead where another case would also take results away: about these and the changes. Returns false, and
    /// asks nothing, where there are no such results.
    using ResultsQuestion = std::function<bool(const std::function<void()>& next)>;
    void setResultsQuestion(ResultsQuestion question) { askAboutResults_ = std::move(question); }

    bool modified() const;
    /// Whether leaving the case would lose changes: not those of a sample whose values a result has. `isKept` looks for
    /// them in the results; without it, none has them.
    bool hasChangesToSave() const;
    void setKeptTest(std::function<bool(const Case&)> isKept) { isKept_ = std::move(isKept); }
    /// The changes so far are nothing to ask about.
    void leaveUnsaved();
    QString file() const { return file_; }
    /// What opens the case again as it was saved or imported: a path, or the name of a sample case. Empty: nothing.
    const QString& origin() const { return origin_; }
    QString sample() const { return sample_; }
    /// "fig10a", "slider.toml", "femto" for one that was imported from there, "Untitled".
    QString shortName() const;
    /// The exact input that the current values make.
    std::string text() const;
    /// The same with what it reads from a file of rails, so that it needs no folder.
    std::string wholeText() const;
    QStringList recent() const;

    /// By the name of the file: a case, results, or what can be imported.
    static bool canOpen(const QString& file);
    static bool isResultsFile(const QString& file);
    /// The text of a study.
    static bool isStudyFile(const QString& file);

signals:
    /// The case is about to be saved or left: editors commit typed text now.
    void aboutToUse();
    void opened();
    void saved();
    /// The warnings are as those of warned().
    void reloaded(const QStringList& warnings);
    /// Another program has changed the file, or one that the case names, in a sentence; "": they are as they were read
    /// or written. `valid`: it can be reloaded.
    void fileChanged(const QString& sentence, bool valid);
    void resultsFileChosen(const QString& file);
    void studyFileChosen(const QString& file);
    /// After `opened`; the warnings list the entries that are not modelled.
    void imported(const QString& path, const QStringList& warnings);
    /// After `opened`, of a case file with entries that are not modelled or have no effect.
    void warned(const QStringList& warnings);
    /// `remark`: what is not in the file, or only for us; empty: all is.
    void exported(const QString& path, const QString& remark);

private:
    /// Opens a case unless it has problems, which are shown, or names files outside its folder: then it asks, and calls
    /// `again` on yes.
    std::optional<CaseDocument> read(const QString& fileOrSample, const std::function<void()>& again);
    /// Asks whether a case may read files outside its folder; on yes calls `again`, else `refused`.
    void askForOutsideFiles(
        const QString& file, const std::vector<std::string>& outside, const std::function<void()>& again,
        const std::function<void()>& refused = [] {});
    /// A case with what it may read outside its folder.
    CaseDocument readAllowed(const QString& file, const std::function<CaseDocument(OutsidePaths)>& read) const;
    /// The same, of a file as it is now, and of a text of a state.
    CaseDocument readNow(const QString& fileOrSample) const;
    CaseDocument readState(const CaseState& state, const QString& text) const;
    /// The case's file holds text_, and the files that it names are those of the document.
    void watch(const CaseDocument& document);
    void tellChange();
    /// Whether this is the case's file, and another program has changed it.
    bool changedOutside(const QString& file) const;
    /// Asks first if another program has changed the file.
    void saveTo(const QString& file);
    /// Writes without asking, whatever the file holds.
    QString writeOver(const QString& file);
    void askForFile(const QString& title, const QString& filter);
    void writeAndTell(const QString& file);
    void remember(const QString& file);
    static QStringList textsOf(const std::vector<InputProblem>& problems);
    /// Without those of a combination of values, which stand at their fields.
    static QStringList lastingWarnings(const CaseDocument& document);
    void showProblems(const QString& what, const QStringList& problems);

    CaseEdits& edits_;
    QWidget& window_;
    QString file_;
    QString sample_;
    QString imported_; // name of an imported case, or of the result that a case comes from
    QString origin_;
    std::string text_;                                // as opened or saved
    std::filesystem::path folder_;                    // of the files that it names
    Case saved_;                                      // the values in it
    WatchedFile* watched_;                            // file_, which holds text_ as far as this window knows
    std::vector<std::unique_ptr<WatchedFile>> named_; // by the case: rails, a measured surface
    std::function<void()> afterSave_;
    ResultsQuestion askAboutResults_;
    std::function<bool(const Case&)> isKept_;
    QPointer<QMessageBox> outside_; // the question about files outside a folder
    QSet<QString> allowed_;         // see permission()
};

} // namespace touchdown
