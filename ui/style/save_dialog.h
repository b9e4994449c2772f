// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asking where to write something, without blocking the window.
#pragma once

#include <functional>

#include <QStringList>
#include <QWidget>

class QFileDialog;

namespace touchdown {

/// Opens a dialog that asks for a file to write. Each filter names the ending that a name without one gets;
/// `suggestion` is a file with its ending, or an ending alone.
QFileDialog* openSaveDialog(QWidget* parent, const QString& title, const QStringList& filters,
                            const QString& suggestion);

/// The same; then calls `save` and shows the sentence that it returns, if any.
void askAndSave(QWidget* parent, const QString& title, const QStringList& filters, const QString& suggestion,
                const std::function<QString(const QString&)>& save);

/// PDF, SVG, PNG.
QStringList pictureFilters();

} // namespace touchdown
