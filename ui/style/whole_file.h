// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <QByteArray>
#include <QString>

namespace touchdown {

/// A file that appears whole or not at all (core/formats/text_file.h). Returns an empty string or a sentence that
/// states the problem.
[[nodiscard]] QString writeWholeFile(const QString& path, const QByteArray& bytes);

/// Several that belong together, each with its path: none appears unless all have been written.
[[nodiscard]] QString writeWholeFiles(const std::vector<std::pair<QString, QByteArray>>& files);

/// A copy of a file, in the same way.
[[nodiscard]] QString copyWholeFile(const QString& from, const QString& path);

} // namespace touchdown
