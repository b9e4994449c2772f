// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/watched_file.h"

#include <utility>

#include <QEvent>
#include <QFileInfo>

namespace touchdown {

namespace {

constexpr int writingTime = 100; // [ms]

} // namespace

WatchedFile::WatchedFile(QWidget& window, QObject* parent) : QObject(parent), window_(window)
{
    window_.installEventFilter(this);
    soon_.setSingleShot(true);
    soon_.setInterval(writingTime);
    connect(&soon_, &QTimer::timeout, this, &WatchedFile::look);
    // Its folder, too: a file that is replaced is watched no longer.
    for (const auto signal : {&QFileSystemWatcher::fileChanged, &QFileSystemWatcher::directoryChanged})
        connect(&watcher_, signal, this, [this] {
            if (!soon_.isActive()) soon_.start();
        });
}

void WatchedFile::expect(const QString& path, const FileIdentity& identity)
{
    path_ = path;
    expected_ = identity;
    if (std::exchange(seen_, FileNow::Same) != FileNow::Same) emit changed(seen_);
    const QStringList before = watcher_.files() + watcher_.directories();
    if (!before.isEmpty()) watcher_.removePaths(before);
    watch();
    soon_.start();
}

void WatchedFile::watch()
{
    if (path_.isEmpty()) return;
    for (const QString& path : {path_, QFileInfo(path_).absolutePath()})
        if (!watcher_.files().contains(path) && !watcher_.directories().contains(path) && QFileInfo::exists(path))
            watcher_.addPath(path);
}

FileNow WatchedFile::now() const { return path_.isEmpty() ? FileNow::Same : fileNow(path_.toStdString(), expected_); }

void WatchedFile::look()
{
    watch();
    const FileNow before = std::exchange(seen_, now());
    FileIdentity identity;
    if (seen_ == FileNow::Other) identity = identityOf(path_.toStdString()).value_or(FileIdentity{});
    const FileIdentity identityBefore = std::exchange(seenIdentity_, identity);
    const bool sameBytes = identity.size == identityBefore.size && identity.hash == identityBefore.hash;
    if (seen_ != before || (seen_ == FileNow::Other && !sameBytes)) emit changed(seen_);
}

bool WatchedFile::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &window_ && event->type() == QEvent::WindowActivate) look();
    return QObject::eventFilter(watched, event);
}

} // namespace touchdown
