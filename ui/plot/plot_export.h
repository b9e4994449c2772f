// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures and numbers out of plots. Each function returns an empty string, or a sentence that says what went wrong.
//
// The end of the file's name chooses: .png (twice the pixels of the screen), .svg and .pdf (vectors and text).
// Pictures leave in the light theme, for paper; the clipboard gets what the screen shows.
#pragma once

#include "ui/plot/picture.h"
#include "ui/plot/plot_widget.h"

#include <QIODevice>
#include <QString>

namespace touchdown {

[[nodiscard]] QString savePicture(const Picture& picture, const QString& path);
void copyPicture(const Picture& picture);

[[nodiscard]] QString savePicture(PlotWidget& plot, const QString& path);
/// Every visible PagePart inside `page`, where it stands on the page.
[[nodiscard]] QString savePage(QWidget& page, const QString& path, const QString& title = {});
void copyPicture(PlotWidget& plot);
void copyPage(QWidget& page);

/// Every sample of the visible curves that lies in the visible range of x, in display units, with a column for each
/// curve. Curves with different times share the column of x and leave cells empty.
[[nodiscard]] QString saveCsv(const PlotWidget& plot, const QString& path);
void writeCsv(const PlotWidget& plot, QIODevice& device);

} // namespace touchdown
