// SPDX-License-Identifier: GPL-3.0-or-later
//
// The look of the window: Qt's Fusion style with a light and a dark palette, the colours that mean something (a
// failure, a warning, a change), the icons.
#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>
#include <QTableWidget>

namespace touchdown {

enum class Theme { System, Light, Dark };

/// "system", "light", "dark": as stored in the settings; an unknown name is the system's.
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

/// The contrast of two colours, 1 to 21 (WCAG 2.1): 3 lets a line be seen, 4.5 a text be read.
double contrast(const QColor& a, const QColor& b);

/// The text of `widget` in this colour; in that of its palette when the colour is invalid.
void setTextColour(QWidget* widget, const QColor& colour);

/// A table to read and copy from: without lines and row numbers.
void makePlain(QTableView& table);
/// The same with heads; the first column takes the free width.
void makePlainTable(QTableWidget* table, const QStringList& headers);

/// resources/icons/<name>.svg, with its currentColor replaced by that of the text.
QIcon icon(const QString& name, const QPalette& palette);
QIcon programIcon();

} // namespace touchdown
