// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files that QSettings reads by itself, at the start of the program and whenever a value is asked for. It would
// wait for the writer of a FIFO without end, read a device without end, and write its own text over a file that holds
// no settings. A symbolic link to a file of settings is followed, also when settings are written: many people keep such
// files together in another folder.
#pragma once

#include <memory>

#include <QString>
#include <QTemporaryDir>

namespace touchdown {

/// Before the first QSettings, and after the program has its names. Where a file of settings cannot be used, the
/// program has its default settings, and none of these files is read or written while this lives.
class SettingsFile {
public:
    SettingsFile();

    /// Why the settings are the default ones, in a sentence; "": they are those of the files.
    QString problem() const { return problem_; }

private:
    QString problem_;
    std::unique_ptr<QTemporaryDir> instead_; // of the settings until the end of the program
};

} // namespace touchdown
