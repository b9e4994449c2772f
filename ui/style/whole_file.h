// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace touchdown {

/// A file that appears whole or not at all (core/formats/text_file.h). Returns an empty string or a sentence that
/// states the problem.
[[nodiscard]] QString writeWholeFile(const QString& path, const QByteArray& bytes);

/// A copy of a file, in the same way.
[[nodiscard]] QString copyWholeFile(const QString& from, const QString& path);

} // namespace touchdown
