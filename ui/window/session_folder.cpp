// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/session_folder.h"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QStandardPaths>

#include "ui/style/translate.h"

namespace touchdown {

namespace {

QDir allSessions()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/sessions"));
}

/// A locked descriptor of the folder's lock file, or -1 and errno.
int lockFolder(const QString& folder, int flags)
{
    const QByteArray file = QFile::encodeName(folder + QStringLiteral("/lock"));
    const int descriptor = ::open(file.constData(), O_RDWR | O_CLOEXEC | flags, 0600);
    if (descriptor < 0) return -1;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
    const int reason = errno;
    ::close(descriptor);
    errno = reason;
    return -1;
}

} // namespace

std::unique_ptr<SessionFolder> SessionFolder::create(QString& problem)
{
    const QDir sessions = allSessions();
    problem = tr("The work of this window is not kept against a crash: %1 cannot be written.")
                  .arg(QDir::toNativeSeparators(sessions.path()));
    if (!sessions.mkpath(QStringLiteral("."))) return nullptr;
    // Of one time, so that the order of the names is that of the folders.
    const QString first = QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz-")) +
                          QString::number(QCoreApplication::applicationPid());
    for (int attempt = 0; attempt < 100; ++attempt) {
        const QString name = attempt == 0 ? first : QStringLiteral("%1-%2").arg(first).arg(attempt);
        if (!sessions.mkdir(name)) {
            if (sessions.exists(name)) continue;
            return nullptr;
        }
        const QString path = sessions.filePath(name);
        if (const int lock = lockFolder(path, O_CREAT); lock >= 0) {
            problem.clear();
            return std::unique_ptr<SessionFolder>(new SessionFolder(path, lock));
        }
        const int reason = errno;
        QFile::remove(path + QStringLiteral("/lock"));
        sessions.rmdir(name);
        if (reason != EWOULDBLOCK) return nullptr; // a file system without locks
        // Another window looked just now whether the folder is in use.
    }
    return nullptr;
}

std::unique_ptr<SessionFolder> SessionFolder::take(const QString& path)
{
    const int lock = lockFolder(path, 0);
    return lock < 0 ? nullptr : std::unique_ptr<SessionFolder>(new SessionFolder(path, lock));
}

QStringList SessionFolder::all()
{
    QStringList paths;
    const QDir sessions = allSessions();
    for (const QString& name : sessions.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name | QDir::Reversed))
        paths << sessions.filePath(name);
    return paths;
}

QStringList SessionFolder::ended()
{
    QStringList paths = all();
    paths.removeIf([](const QString& path) { return !take(path); });
    return paths;
}

SessionFolder::~SessionFolder() { ::close(lock_); }

void SessionFolder::remove(std::unique_ptr<SessionFolder> folder)
{
    // The lock goes last: a folder that is half removed is still seen as used.
    const QDir dir(folder->path_);
    for (const QString& name : dir.entryList(QDir::Files | QDir::Hidden))
        if (name != QLatin1String("lock")) QFile::remove(dir.filePath(name));
    QDir(folder->path_).removeRecursively();
}

qint64 bytesIn(const QString& folder)
{
    qint64 bytes = 0;
    QDirIterator files(folder, QDir::Files | QDir::Hidden);
    while (files.hasNext()) {
        files.next();
        bytes += files.fileInfo().size();
    }
    return bytes;
}

} // namespace touchdown
