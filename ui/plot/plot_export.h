// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of widgets and pages, numbers of plots. Each function that saves returns an empty string or a sentence that
// states the problem.
//
// The ending of the file name chooses the format: .png (twice the pixels of the screen), .svg and .pdf (vectors and
// text). A file appears whole or not at all. Files are written in the light theme, for paper; the clipboard gets the
// theme of the screen.
#pragma once

#include <functional>

#include <QIODevice>
#include <QImage>
#include <QPainter>
#include <QString>

#include "ui/plot/plot_theme.h"

namespace touchdown {

class PlotWidget;

/// Anything that paints itself.
struct Picture {
    QSizeF size; // [px]
    QString title;
    std::function<void(QPainter&)> paint;
};

/// A widget that belongs to the picture of its page.
class PagePart {
public:
    virtual ~PagePart() = default;
    virtual QString title() const = 0;
    /// The whole widget into `target`, in the colours of `theme`. The proportions of the screen stay.
    virtual void paintInto(QPainter& painter, const QRectF& target, const PlotTheme& theme) = 0;
};

[[nodiscard]] QString savePicture(const Picture& picture, const QString& path);
/// A PagePart, or a page with every visible PagePart inside it at its place. `dashes`: runs differ in their dashes and
/// none is pale, for paper without colours.
[[nodiscard]] QString savePicture(QWidget& shown, const QString& path, bool dashes = false);
/// Pixels as they are; the ending is that of an image format of Qt.
[[nodiscard]] QString saveImage(const QImage& image, const QString& path);
void copyPicture(QWidget& shown);

/// Every sample of the visible curves that lies in the visible range of x, in display units, with a column for each
/// curve. Curves with different times share the column of x and leave cells empty.
[[nodiscard]] QString saveCsv(const PlotWidget& plot, const QString& path);
void writeCsv(const PlotWidget& plot, QIODevice& device);

} // namespace touchdown
