// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sessions/session_folder.h"

#include <cerrno>
#include <cstdio>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>

#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr auto lockName = "lock";

QDir allSessions()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/sessions"));
}

/// The names that create() gives.
bool isSessionName(const QString& name)
{
    static const QRegularExpression pattern(QStringLiteral("^\\d{8}-\\d{6}-\\d{3}-\\d+(-\\d+)?$"));
    return pattern.match(name).hasMatch();
}

/// The names of the files that a session writes, and of what stands beside them meanwhile
/// (core/formats/output_file.h).
bool isOwnName(const QString& name)
{
    static const QRegularExpression pattern(
        QStringLiteral("^(lock|(session\\.json|series\\.h5|(run|solution)\\d{1,9}\\.h5|study-[a-z0-9-]+\\.h5)"
                       "(\\.touchdown\\.(lock|[0-9a-f]{8}\\.part))?)$"));
    return pattern.match(name).hasMatch();
}

/// A directory, never through a symbolic link. -1 and errno if that failed.
int openFolder(const QString& path)
{
    return ::open(QFile::encodeName(path).constData(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

bool isRegular(int folder, const QByteArray& name)
{
    struct stat status {};
    return ::fstatat(folder, name.constData(), &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(status.st_mode);
}

/// A locked descriptor of the folder's lock file, which is empty, or -1 and errno.
int lockFolder(int folder, int flags)
{
    const int descriptor = ::openat(folder, lockName, O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | flags, 0600);
    if (descriptor < 0) return -1;
    struct stat status {};
    int reason = EINVAL;
    if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size == 0) {
        if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
        reason = errno;
    }
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
    // All attempts use the same time, so that the order of the names is that of the folders.
    const QString first = QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz-")) +
                          QString::number(QCoreApplication::applicationPid());
    for (int attempt = 0; attempt < 100; ++attempt) {
        const QString name = attempt == 0 ? first : QStringLiteral("%1-%2").arg(first).arg(attempt);
        if (!sessions.mkdir(name)) {
            if (sessions.exists(name)) continue;
            return nullptr;
        }
        const QString path = sessions.filePath(name);
        const int opened = openFolder(path);
        const int lock = opened < 0 ? -1 : lockFolder(opened, O_CREAT);
        if (lock >= 0) {
            problem.clear();
            return std::unique_ptr<SessionFolder>(new SessionFolder(path, opened, lock));
        }
        const int reason = errno;
        if (opened >= 0) {
            ::unlinkat(opened, lockName, 0);
            ::close(opened);
        }
        sessions.rmdir(name);
        if (reason != EWOULDBLOCK) return nullptr; // a file system without locks
        // Another window looked just now whether the folder is in use.
    }
    return nullptr;
}

std::unique_ptr<SessionFolder> SessionFolder::take(const QString& path)
{
    const int folder = isSessionName(QFileInfo(path).fileName()) ? openFolder(path) : -1;
    if (folder < 0) return nullptr;
    if (const int lock = lockFolder(folder, O_CREAT); lock >= 0)
        return std::unique_ptr<SessionFolder>(new SessionFolder(path, folder, lock));
    ::close(folder);
    return nullptr;
}

QStringList SessionFolder::all()
{
    QStringList paths;
    const QDir sessions = allSessions();
    const auto folders = QDir::Dirs | QDir::NoSymLinks | QDir::NoDotAndDotDot;
    for (const QString& name : sessions.entryList(folders, QDir::Name | QDir::Reversed))
        if (isSessionName(name)) paths << sessions.filePath(name);
    return paths;
}

QStringList SessionFolder::ended()
{
    QStringList paths = all();
    paths.removeIf([](const QString& path) { return !take(path); });
    return paths;
}

bool SessionFolder::hasForeignLock(const QString& path)
{
    struct stat status {};
    return ::lstat(QFile::encodeName(path + QLatin1Char('/') + lockName).constData(), &status) == 0 &&
           !(S_ISREG(status.st_mode) && status.st_size == 0);
}

SessionFolder::~SessionFolder()
{
    ::close(lock_);
    ::close(folder_);
}

bool SessionFolder::stands() const
{
    struct stat held {
    }, found{};
    return ::fstat(folder_, &held) == 0 && ::lstat(QFile::encodeName(path_).constData(), &found) == 0 &&
           held.st_dev == found.st_dev && held.st_ino == found.st_ino;
}

QString SessionFolder::setStateAside(const QString& reason) const
{
    QString kept = stateFile();
    for (int copy = 1; copy < 100; ++copy) {
        const QString name = copy == 1 ? QStringLiteral("session-not-understood.json")
                                       : QStringLiteral("session-not-understood-%1.json").arg(copy);
        const bool done =
            ::renameat2(folder_, "session.json", folder_, QFile::encodeName(name).constData(), RENAME_NOREPLACE) == 0;
        if (done) kept = file(name);
        if (done || errno != EEXIST) break;
    }
    return tr("The state of a session could not be read: %1. The file is kept: %2")
        .arg(reason, QDir::toNativeSeparators(kept));
}

void SessionFolder::remove(std::unique_ptr<SessionFolder> folder)
{
    for (const QString& name : ownFiles(folder->path_))
        if (const QByteArray file = QFile::encodeName(name); file != lockName && isRegular(folder->folder_, file))
            ::unlinkat(folder->folder_, file.constData(), 0);
    // The lock goes last: a folder that is half removed is still seen as used.
    ::unlinkat(folder->folder_, lockName, 0);
    ::rmdir(QFile::encodeName(folder->path_).constData()); // only when it is empty, and not through a link
}

bool liesAt(const QString& path) { return QFileInfo::exists(path) || QFileInfo(path).isSymbolicLink(); }

bool moveOwnFile(const QString& from, const QString& to)
{
    return isOwnFile(from) && !liesAt(to) && QFile::rename(from, to);
}

bool isOwnFile(const QString& path)
{
    return isOwnName(QFileInfo(path).fileName()) && isRegular(AT_FDCWD, QFile::encodeName(path));
}

QStringList ownFiles(const QString& folder)
{
    QStringList names = QDir(folder).entryList(QDir::Files | QDir::NoSymLinks | QDir::Hidden, QDir::Name);
    names.removeIf([](const QString& name) { return !isOwnName(name); });
    return names;
}

qint64 bytesIn(const QString& folder)
{
    qint64 bytes = 0;
    for (const QString& name : ownFiles(folder)) bytes += QFileInfo(folder + QLatin1Char('/') + name).size();
    return bytes;
}

} // namespace touchdown
