// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <QByteArray>
#include <QString>

#include "core/formats/file_identity.h"

namespace touchdown {

/// A file that appears whole or not at all (core/formats/text_file.h). Returns an empty string or a sentence that
/// states the problem.
[[nodiscard]] QString writeWholeFile(const QString& path, const QByteArray& bytes);

/// Several that belong together, each with its path: none appears unless all have been written.
[[nodiscard]] QString writeWholeFiles(const std::vector<std::pair<QString, QByteArray>>& files);

/// A copy of a file, in the same way.
[[nodiscard]] QString copyWholeFile(const QString& from, const QString& path);

/// A file of the user that something was written to, or read from.
class SavedFile {
public:
    /// None.
    SavedFile() = default;
    /// As it is now; an empty path: none.
    explicit SavedFile(const QString& path);
    /// Whether it is still there, with the same bytes.
    bool holds() const;

private:
    QString path_;
    FileIdentity identity_;
};

} // namespace touchdown
