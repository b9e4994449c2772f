// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures and numbers out of plots. Each function returns an empty string, or a sentence that says what went wrong.
//
// The end of the file's name chooses: .png (twice the pixels of the screen), .svg and .pdf (vectors and text).
// Pictures leave in the light theme, for paper; the clipboard gets what the screen shows.
#pragma once

#include "ui/plot_widget.h"
#include "ui/slider_plan.h"

#include <functional>

#include <QIODevice>
#include <QString>

namespace touchdown {

/// Anything that paints itself.
struct Picture {
    QSizeF size; // [px]
    QString title;
    std::function<void(QPainter&)> paint;
};
[[nodiscard]] QString savePicture(const Picture& picture, const QString& path);
void copyPicture(const Picture& picture);

[[nodiscard]] QString savePicture(PlotWidget& plot, const QString& path);
/// All visible plots, plans and charts of studies inside `page`, where they stand on it.
[[nodiscard]] QString savePage(QWidget& page, const QString& path, const QString& title = {});
void copyPicture(PlotWidget& plot);
void copyPage(QWidget& page);

/// Every sample of the visible curves that lies in the visible range of x, in display units, with a column for each
/// curve. Curves with different times share the column of x and leave cells empty.
[[nodiscard]] QString saveCsv(const PlotWidget& plot, const QString& path);
void writeCsv(const PlotWidget& plot, QIODevice& device);

} // namespace touchdown
