// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps the work of the window in the folder of its session: each run while it lasts, each static solution and study
// report when it is there, the case with its edits within a second. Nothing here makes the window or a solver wait.
//
// When the disk is full or too slow, this is reported once, and the work continues in memory.
#pragma once

#include <functional>
#include <memory>

#include <QObject>
#include <QTimer>

#include "ui/calculation/task_queue.h"
#include "ui/sessions/session_folder.h"
#include "ui/sessions/session_reader.h"
#include "ui/sessions/session_state.h"
#include "ui/workbench/unsaved_work.h"

namespace touchdown {

class RecordList;
struct RecordedFields;
struct RunDelivery;
struct RunRecord;
struct Summary;

class Session : public QObject {
    Q_OBJECT

public:
    /// Bytes that the folders of all sessions may take; a setting.
    static qint64 budget();
    static void setBudget(qint64 bytes);
    static constexpr qint64 defaultBudget = qint64(2) << 30;

    Session(Workbench& bench, QObject* parent);
    /// Leaves the folder as after a kill, with all that was asked for written.
    ~Session() override;

    /// nullptr: it could not be created, or was removed.
    const SessionFolder* folder() const { return folder_.get(); }
    /// Why not all of the work is kept, in a sentence; empty: it is.
    QString problem() const { return problem_; }
    /// Takes over the work of an earlier session. The case in the window is replaced at once; results are read beside
    /// the window and added to the lists one by one. Results that could not be taken over, or not yet when this is
    /// stopped, stay in its folder, else this is removed. Asks first where the case reads files outside its folder.
    void restore(std::unique_ptr<SessionFolder> from);
    bool restoring() const { return from_ != nullptr; }
    /// Shows the progress; its stop() ends the restoring.
    SessionReader& reader() { return reader_; }
    /// Tries again what could not be kept.
    void keepAgain();
    /// Writes the state of the window within a moment, and now.
    void schedule();
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
    void problemChanged();
    /// `problems`: a sentence for each result that is not in the window.
    void restored(const QString& what, const QStringList& problems, bool stopped);

private:
    struct Stream; // of the run under way

    void connectRuns();
    void connectSolutions();
    void connectStudies();
    void connectState();
    SessionState state() const;
    void onRunStarted(int number);
    void beginStream(RunRecord& run);
    void openStream(const RunRecord& run, const std::vector<RecordedFields>& sets);
    void onDelivered(const RunDelivery& delivery);
    void onRunEnded(int number, const Summary& summary);
    void onSolutionAdded(int number);
    /// The report of a kind, also of a study under way.
    void keepStudy(const std::string& kind);
    void keepSeries();
    /// Performs a task behind those of before and reports its problem; calls `then` if there is none. `bytes`: see
    /// TaskQueue::post.
    void write(TaskQueue::Task task, std::function<void()> then = {}, std::size_t bytes = 0);
    void removeFile(const QString& file);
    void keepWithinBudget();
    void restore(std::unique_ptr<SessionFolder> from, const SessionState& state);
    /// What was asked for when the session is to be restored.
    std::vector<std::shared_ptr<LeftResult>> resultsOf(const SessionState& state);
    void onRead(LeftResult& result);
    QString takeRun(LeftResult& result);
    QString takeSolutions(LeftResult& result);
    QString takeStudy(LeftResult& result);
    QString takeSeries(LeftResult& result);
    void onRestored(bool stopped);
    void report(const QString& problem);
    /// Keeps the state and waits for it: whether it is on the disk.
    bool keptState();
    /// Whether so many more bytes of results cannot be kept now, which is reported.
    bool refuses(std::size_t bytes);
    void setProblem(const QString& problem);
    /// Whether the folder is still there; tries again what could not be kept.
    void look();
    /// Results that no file has, neither of the user nor of the session.
    UnsavedWork notKept() const;
    /// Whether a file gets all of the run under way.
    bool recordsWholeRun() const;
    static constexpr std::size_t mostPending = std::size_t(256) << 20; // that may wait for the disk [byte]

    Workbench& bench_;
    QString problem_;                       // why not all is kept
    std::unique_ptr<SessionFolder> folder_; // none after close()
    std::shared_ptr<Stream> stream_;
    int fieldsKnownOf_ = -1; // number of the run under way, from its first delivery on
    QTimer soon_;            // writes the state
    QByteArray written_;     // the state that was written last, without its time
    QTimer studySoon_, watch_;
    bool adding_ = false; // results that are added are in the folder already
    QString overBudget_;  // why no more results are kept; empty: there is room
    bool reported_ = false;
    bool closed_ = false;
    int failures_ = 0;
    // While another session is restored:
    std::unique_ptr<SessionFolder> from_;
    SessionState arriving_; // the results that are not in the lists yet, with the numbers that they get
    SessionState left_;     // what stays in its folder
    QString what_;          // was in it
    QStringList refused_;   // sentences
    std::vector<std::shared_ptr<LeftResult>> waiting_;
    SessionReader reader_{this};
    TaskQueue results_{this};
    TaskQueue states_{this}; // a large result does not hold up the state
};

} // namespace touchdown
