// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of the window as one figure on paper: in the width of a journal's column, with its font, on white.
#pragma once

#include <optional>

#include "ui/plot/plot_export.h"

namespace touchdown {

struct FigureFormat {
    static constexpr double oneColumn = 85.0, twoColumns = 170.0; // widths [mm]

    double width = oneColumn; // [mm], 20 to 500
    double height = 0.0;      // [mm], at most 2000; 0: as high as its panels need
    int columns = 1;          // of panels beside each other, 1 to 4
    QString family = {};      // of the font; empty: that of the window
    double fontSize = 8.0;    // [pt], 4 to 36
    int dotsPerInch = 600;    // of a PNG, 72 to 1200
    PaperColours colours = PaperColours::Coloured;
    bool letters = true; // "(a)", "(b)", ... where there is more than one panel
    bool titles = true;  // over spectra and other plots whose axis does not say what they show
    bool data = true;    // the numbers of each panel in a file beside the figure
    bool operator==(const FigureFormat&) const = default;
};

struct PaperSheet;

class PaperFigure {
public:
    /// The PageParts `panels`, row by row; they must outlive this.
    PaperFigure(const std::vector<QWidget*>& panels, const FigureFormat& format);

    bool empty() const { return cells_.empty(); }
    /// [mm]
    QSizeF size() const;
    /// A title, a number or a curve has no room, or two curves look alike: a sentence; "" where all can be read.
    QString problem() const;
    /// How many labels of reference lines are cut or left out, as text is never smaller than nine tenths of the font:
    /// a sentence; "" where none is.
    QString remark() const;
    Picture picture() const;

    /// Writes the figure, and the numbers of its panels beside it: figure.pdf, figure-a.csv, figure-b.csv. All of them
    /// or none. Returns a sentence that states the problem, or "".
    [[nodiscard]] QString save(const QString& path) const;
    /// Names of the files of numbers that `save` writes.
    QStringList dataFiles(const QString& path) const;

private:
    struct Cell {
        QWidget* panel;
        QRectF box; // [px]
    };
    void paint(QPainter& painter) const;
    QString letter(std::size_t cell) const;
    PaperSheet sheetOf(const Cell& cell) const;

    FigureFormat format_;
    QFont font_;
    double pixelsPerInch_;
    QSizeF size_; // [px]
    std::vector<Cell> cells_;
    std::vector<PaperStyle> styles_; // of the curves of all panels
};

} // namespace touchdown
