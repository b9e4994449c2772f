// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything of a plot but its curves: paper, grid, axes, legend, marks, cursors. The same on the screen and on paper.
#pragma once

#include <optional>
#include <vector>

#include "ui/plot/paper_curves.h"
#include "ui/plot/plot_frame.h"
#include "ui/plot/plot_legend.h"
#include "ui/plot/plot_widget.h"

namespace touchdown {

/// A place in a figure on paper.
struct PaperSheet {
    QSizeF size; // [px]
    QFont font;  // its size in pixels
    PaperColours colours = PaperColours::Coloured;
    std::vector<PaperStyle> styles = {}; // of the figure
    double labelWidth = 0.0;             // that labels of reference lines have at least, as in other panels [px]
    bool title = true;                   // what the plot is called stands above it where its axis has another name
};

/// Words in a shaded area, beside a reference line or a point mark, where they are drawn.
struct PlotLabel {
    QRectF box; // [px]
    QString text;
    QColor colour;
    bool behind = false; // the curves
    QFont font = {};
    QString line = {};  // the whole label of a reference line, which stands outside the area
    QLineF leader = {}; // to its line, where it had to move
};

struct WantedPlace {
    double at = 0.0;   // the centre [px]
    double size = 0.0; // along the row [px]
};
/// Labels in a row beside what they name: the centre of each, in the order of `wanted`, which rises, without an
/// overlap, within [low, high], each as near to its place as the others let it: the sum of the squared shifts is least
/// ("pool adjacent violators": Ayer et al., 1955). Where not all have room, the label with the nearest neighbour is
/// left out, one after another: it gets nothing.
std::vector<std::optional<double>> labelPlaces(const std::vector<WantedPlace>& wanted, double low, double high);

class PlotPainter {
public:
    /// As on the screen. Both must outlive the painter.
    PlotPainter(const PlotWidget& plot, const PlotTheme& theme);
    /// Laid out anew for paper: both axes have their titles, what the plot is called stands at the axis where that has
    /// no name of its own, the legend has as many rows as it needs, no curve is pale and no two look alike.
    PlotPainter(const PlotWidget& plot, const PlotTheme& theme, const PaperSheet& sheet);
    PlotPainter(const PlotPainter&) = delete;
    PlotPainter& operator=(const PlotPainter&) = delete;

    void paintBehind(QPainter& painter) const;
    void paintAbove(QPainter& painter) const;
    /// The curves themselves, cut at the border: for pictures. On the screen Qt Charts draws them.
    void paintCurves(QPainter& painter) const;
    void paintCursors(QPainter& painter) const;
    void paintSelection(QPainter& painter, const QRectF& box) const;
    /// On the screen beside the title.
    Legend legend() const;
    /// None over another nor over the pointer of a mark. A label without such a place is left out. Those of reference
    /// lines stand outside the area in the order of the lines, on the screen smaller where they have no room, at last
    /// cut in the middle; the others inside.
    std::vector<PlotLabel> labels() const;
    /// Labels of reference lines that are cut or left out.
    std::size_t labelsWithoutRoom() const;
    static constexpr double aroundLabel = 4.0; // wider than its text is a label [px]
    /// The triangles that point at marks.
    std::vector<QRectF> pointers() const;
    /// Where the curves are [px].
    const QRectF& area() const { return area_; }
    /// The height of the area in which the title of the upright axis has room [px].
    double heightOfTitle() const;

private:
    struct PlacedMark {
        const PointMark* mark;
        QPointF tip; // of the pointer, just above the point
    };

    void paintHeader(QPainter& painter) const;
    QPolygonF outlineOf(const ShadedArea& shaded) const;
    void paintShadedAreas(QPainter& painter) const;
    bool isSeen(const ReferenceLine& line) const;
    void paintReferenceLines(QPainter& painter) const;
    std::vector<PlotLabel> labelsOfLines(bool upright) const;
    void paintEventMarks(QPainter& painter) const;
    void paintArrows(QPainter& painter) const;
    void paintDots(QPainter& painter) const;
    void paintCursorTag(QPainter& painter, int which, const QPointF& bottomLeft) const;
    std::vector<PlacedMark> placeMarks() const;
    void paintPointers(QPainter& painter) const;
    void paintLabels(QPainter& painter, bool behind) const;

    std::vector<QPointF> pathOf(const PlotCurve& curve) const;

    const PlotWidget& plot_;
    const PlotTheme& theme_;
    const bool paper_;
    const double width_; // of widget or sheet [px]
    const std::vector<PlotCurve> printed_;
    const std::vector<PlotCurve>& curves_;
    const PlotAxis x_;
    const PlotAxis y_;
    const QString title_; // above the area
    QRectF area_;
    PlotFrame frame_;
    Legend paperLegend_;
};

} // namespace touchdown
