// SPDX-License-Identifier: GPL-3.0-or-later
//
// The icons of the window, drawn in the colour of the text, so that they fit light and dark.
#pragma once

#include <QIcon>
#include <QPalette>
#include <QString>

namespace touchdown {

/// resources/icons/<name>.svg, with its currentColor replaced.
QIcon icon(const QString& name, const QPalette& palette);
/// The icon of the program itself.
QIcon programIcon();

} // namespace touchdown
