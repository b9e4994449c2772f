// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file that was read and may be written again. Another program may change it in between.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <QWidget>

#include "core/formats/file_identity.h"

namespace touchdown {

class WatchedFile : public QObject {
    Q_OBJECT

public:
    /// Looks at the file when the system reports a change, and when the window comes to the front.
    explicit WatchedFile(QWidget& window, QObject* parent = nullptr);

    /// The file as it was read or written just now; an empty path: none.
    void expect(const QString& path, const FileIdentity& identity);
    QString path() const { return path_; }
    /// What lies at its path now; Same without a file.
    FileNow now() const;
    void look();

signals:
    /// What lies at its path differs from what lay there at the last look; Same: it is as expected again.
    void changed(touchdown::FileNow now);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void watch();

    QWidget& window_;
    QString path_;
    FileIdentity expected_;
    FileNow seen_ = FileNow::Same;
    FileIdentity seenIdentity_; // of another file
    QFileSystemWatcher watcher_;
    QTimer soon_; // a program that writes reports several changes
};

} // namespace touchdown
