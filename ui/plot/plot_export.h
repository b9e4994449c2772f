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
#include <optional>
#include <vector>

#include <QIODevice>
#include <QImage>
#include <QPainter>
#include <QString>

#include "ui/plot/paper_curves.h"
#include "ui/plot/plot_theme.h"

namespace touchdown {

class PlotWidget;

/// Anything that paints itself.
struct Picture {
    QSizeF size; // [px]
    QString title;
    std::function<void(QPainter&)> paint;
    double pixelsPerInch = 96.0; // of `size`
    double dotsPerInch = 192.0;  // of a PNG
};

/// A widget that belongs to the picture of its page.
class PagePart {
public:
    virtual ~PagePart() = default;
    virtual QString title() const = 0;
    /// The whole widget into `target`, in the colours of `theme`. The proportions of the screen stay.
    virtual void paintInto(QPainter& painter, const QRectF& target, const PlotTheme& theme) = 0;

    /// For a figure on paper: laid out anew in `size` from the painter's origin, with a font whose size is in pixels. A
    /// picture with long texts may draw them smaller.
    virtual void paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours) = 0;
    /// A height that suits this width there [px].
    virtual double heightOnPaper(double width, const QFont& font) const = 0;
    /// Writes the numbers that are shown, as comma-separated values; nothing: it shows none.
    virtual std::function<void(QIODevice&)> dataWriter() const { return {}; }
};

[[nodiscard]] QString savePicture(const Picture& picture, const QString& path);
/// A PagePart, or a page with every visible PagePart inside it at its place.
[[nodiscard]] QString savePicture(QWidget& shown, const QString& path);
/// The bytes of a file of that name; nothing if its ending is not known, none if a PNG would be too large.
std::optional<QByteArray> pictureBytes(const Picture& picture, const QString& path);
/// The visible PageParts of a page, from the top to the bottom and from the left to the right.
std::vector<QWidget*> visibleParts(QWidget& page);
/// What of a widget its page shows, in the coordinates of the widget: the rest is scrolled away.
QRect partInView(const QWidget& widget, const QWidget& page);
/// Pixels as they are; the ending is that of an image format of Qt.
[[nodiscard]] QString saveImage(const QImage& image, const QString& path);
void copyPicture(QWidget& shown);

/// Every sample of the visible curves that lies in the visible range of x, in display units, with a column for each
/// curve. Curves with different times share the column of x and leave cells empty.
[[nodiscard]] QString saveCsv(const PlotWidget& plot, const QString& path);
void writeCsv(const PlotWidget& plot, QIODevice& device);

} // namespace touchdown
