// SPDX-License-Identifier: GPL-3.0-or-later
//
// The look of the window: Qt's Fusion style with a light and a dark palette of ours, and the colours
// that mean something (a failure, a warning, a change).
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

namespace touchdown {

enum class Theme { System, Light, Dark };

/// "system", "light", "dark": as stored in the settings.
QString themeName(Theme theme);
Theme themeFromName(const QString& name);

/// Style, palette and font size of the whole application; `pointSize` 0 is the system's own.
void applyTheme(Theme theme, int pointSize = 0);

/// The system's own font size [pt].
int systemPointSize();

/// Colours that mean something, readable (4.5:1) on the window of the palette.
struct MeaningColours {
    QColor failure;
    QColor warning;
    QColor success;
    QColor change; // of a value that differs from the opened case
    QColor muted;  // of text that is secondary
};
MeaningColours meaningColours(const QPalette& palette);

bool isDark(const QPalette& palette);

} // namespace touchdown
