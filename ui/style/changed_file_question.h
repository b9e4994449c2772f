// SPDX-License-Identifier: GPL-3.0-or-later
//
// The question before a file is written over that another program has changed.
#pragma once

#include <functional>

#include <QStringList>
#include <QWidget>

#include "core/formats/file_identity.h"

namespace touchdown {

/// What changed, in a sentence, and what the answers do.
struct ChangedFile {
    QString sentence;        // "mine.toml was changed by another program."
    QString heading;         // of the differences
    QStringList differences; // between the file and the window
    std::function<void()> writeOver;
    std::function<void()> reload; // none: the file cannot be opened
    std::function<void()> saveAs;
    std::function<void()> cancel;
};
/// Asks without blocking the window. Esc cancels.
void askAboutChangedFile(QWidget& window, const ChangedFile& file);

/// "mine.toml was changed by another program."; of a file that cannot be read why not. "" for the same file.
QString changeOfFile(const QString& file, FileNow now);

} // namespace touchdown
