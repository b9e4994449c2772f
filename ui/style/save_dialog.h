// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asking where to write something, without blocking the window.
#pragma once

#include <functional>

#include <QStringList>
#include <QWidget>

namespace touchdown {

/// Asks for a file, calls `save`, and shows the sentence that it returns, if any. The filters name one ending each,
/// which a name without one gets; `suggestion` is the name of a file with an ending, or an ending alone.
void askAndSave(QWidget* parent, const QString& title, const QStringList& filters, const QString& suggestion,
                const std::function<QString(const QString&)>& save);

/// PDF, SVG, PNG.
QStringList pictureFilters();

} // namespace touchdown
