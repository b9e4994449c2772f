// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the window keeps on disk of its work, so that a crash or a kill of the program loses one or two seconds of it.
// When the computer stops, what the system had not written to the disk yet is lost as well, and a results file may then
// be unreadable. Each window has a folder of its own, <local data of the program>/sessions/<UTC time>-<process>:
//
//   lock                 locked (flock) while a window uses the folder; the system releases it however the window ends
//   session.json         the case with its edits and what is in the lists (session_state.h), replaced as a whole
//   run<number>.h5       each run (core/results/results_writer.h), written while it lasts
//   solution<number>.h5  each static solution (core/results/steady_writer.h)
//   series.h5            the series of static states (ui/film/series_file.h)
//   study-<kind>.h5      the last report of each kind of study (core/studies/study/study_file.h)
//
// Only files of these names, and the parts of those that were being written, are ever removed: not what else lies in
// the folder, and nothing through a symbolic link.
#pragma once

#include <memory>

#include <QString>
#include <QStringList>

namespace touchdown {

class SessionFolder {
public:
    /// A new folder. nullptr if none can be created, with `problem` set to a sentence.
    static std::unique_ptr<SessionFolder> create(QString& problem);
    /// The folder of a session that has ended. nullptr while a window uses it.
    static std::unique_ptr<SessionFolder> take(const QString& path);
    /// Folders that no window uses, by their names from the last on. A symbolic link is no session.
    static QStringList ended();
    /// All folders.
    static QStringList all();
    /// Whether something else has the name of a folder's lock, so that nobody can take the folder.
    static bool hasForeignLock(const QString& path);
    /// Releases the folder; its files stay.
    ~SessionFolder();
    SessionFolder(const SessionFolder&) = delete;
    SessionFolder& operator=(const SessionFolder&) = delete;

    QString path() const { return path_; }
    QString file(const QString& name) const { return path_ + QLatin1Char('/') + name; }
    QString stateFile() const { return file(QStringLiteral("session.json")); }
    QString runFile(int number) const { return file(QStringLiteral("run%1.h5").arg(number)); }
    QString solutionFile(int number) const { return file(QStringLiteral("solution%1.h5").arg(number)); }
    QString seriesFile() const { return file(QStringLiteral("series.h5")); }
    QString studyFile(const QString& kind) const { return file(QStringLiteral("study-%1.h5").arg(kind)); }
    /// Whether the folder is still at its path.
    bool stands() const;
    /// Renames a session.json that is not understood, so that it stays. Returns a sentence with the reason and the
    /// path.
    QString setStateAside(const QString& reason) const;
    /// Removes the files of the session, then the folder if it is empty, and releases it.
    static void remove(std::unique_ptr<SessionFolder> folder);

private:
    SessionFolder(QString path, int folder, int lock) : path_(std::move(path)), folder_(folder), lock_(lock) {}

    QString path_;
    int folder_, lock_; // descriptors
};

/// Whether anything lies at a path, also a link that leads nowhere.
bool liesAt(const QString& path);
/// Whether a path is a regular file, and no link, with a name that a session writes.
bool isOwnFile(const QString& path);
/// Moves such a file, unless anything lies there already.
bool moveOwnFile(const QString& from, const QString& to);
/// The names of such files in a folder.
QStringList ownFiles(const QString& folder);
/// Their bytes.
qint64 bytesIn(const QString& folder);

} // namespace touchdown
