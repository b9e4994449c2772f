// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps the work of the window in the folder of its session: each run while it lasts, each static solution and study
// report when it is there, the case with its edits within a second. Nothing here makes the window or a solver wait.
//
// When the disk is full or too slow, this is said once, and the work goes on in memory.
#pragma once

#include <memory>

#include <QObject>
#include <QTimer>

#include "ui/calculation/task_queue.h"
#include "ui/window/session_folder.h"
#include "ui/window/session_state.h"

namespace touchdown {

class CaseEdits;
class FilmWindow;
class RecordList;
class RunWindow;
class StudyWindow;
class WindowPages;
struct RecordedFields;
struct RunDelivery;
struct RunRecord;
struct StudyReport;
struct Summary;

/// The parts of a window whose work is kept; all must outlive the session.
struct SessionParts {
    CaseFiles& files;
    CaseEdits& edits;
    RunWindow& runs;
    FilmWindow& film;
    StudyWindow& studies;
    WindowPages& pages;
};

class Session : public QObject {
    Q_OBJECT

public:
    /// Bytes that the folders of all sessions may take; a setting.
    static qint64 budget();
    static void setBudget(qint64 bytes);
    static constexpr qint64 defaultBudget = qint64(2) << 30;

    Session(const SessionParts& parts, std::unique_ptr<SessionFolder> folder, QObject* parent);
    /// Leaves the folder as after a kill, with all that was asked for written.
    ~Session() override;

    const SessionFolder& folder() const { return *folder_; }
    /// Takes over the work of an earlier session. The case in the window is replaced, results are added to the lists.
    /// Results that could not be taken over stay in its folder, else this is removed. Returns a sentence for each
    /// result that is not in the window.
    QStringList restore(std::unique_ptr<SessionFolder> from);
    /// Writes the state of the window now.
    void keepState();
    /// Waits until everything is on disk.
    void wait();
    /// Whether all that was not saved is on disk, so that close(true) leaves it whole. Waits for the disk.
    bool keepsAll();
    /// The window closes. `keep`: what was not saved stays in the folder; else the folder is removed.
    void close(bool keep);

signals:
    /// Once in a session: its work is not kept any more, or not all of it.
    void failed(const QString& sentence);

private:
    struct Stream; // of the run under way

    void connectRuns();
    void connectSolutions();
    void connectState();
    void schedule();
    SessionState state() const;
    void onRunStarted(int number);
    void beginStream(RunRecord& run);
    void openStream(const RunRecord& run, const std::vector<RecordedFields>& sets);
    void onDelivered(const RunDelivery& delivery);
    void onRunEnded(int number, const Summary& summary);
    void onSolutionAdded(int number);
    void onStudied(const StudyReport& report);
    void removeFile(const QString& file);
    void keepWithinBudget();
    QString restoreRun(const SessionFolder& from, const ListedState& entry);
    QString restoreSolution(const SessionFolder& from, const ListedState& entry);
    QString restoreOpened(const QString& file, const std::vector<ListedState>& entries);
    QString restoreStudy(const SessionFolder& from, const QString& kind);
    void report(const QString& problem);

    SessionParts parts_;
    std::unique_ptr<SessionFolder> folder_; // none after close()
    std::shared_ptr<Stream> stream_;
    int fieldsKnownOf_ = -1; // number of the run under way, from its first delivery on
    QTimer soon_;            // writes the state
    QByteArray written_;     // the state that was written last, without its time
    bool restoring_ = false; // results that are added are in the folder already
    bool overBudget_ = false;
    bool reported_ = false;
    TaskQueue results_{this};
    TaskQueue states_{this}; // a large result does not hold up the state
};

} // namespace touchdown
