// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawing styles of a study's chart. A series has a colour, a marker shape and a dash; the marker of a point is full,
// hollow or a cross by its outcome; a class of a map has a colour, a pattern and a letter: no information depends on
// colour alone.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <QBrush>
#include <QPainter>
#include <QPen>

#include "ui/plot/plot_theme.h"

namespace touchdown {

enum class PointKind : std::uint8_t;
struct ChartClass;
struct ChartSeries;
struct StudyChart;

enum class MarkerShape { Circle, Square, Triangle, Diamond, TriangleDown, Pentagon };

struct SeriesStyle {
    CurveStyle curve;
    MarkerShape shape = MarkerShape::Circle;
    bool quiet = false; // thin and grey
    bool operator==(const SeriesStyle&) const = default;
};

/// One style for each name of a series, whatever panel it is in; the first seven differ in colour, the first 42 in
/// colour or shape.
class ChartStyles {
public:
    explicit ChartStyles(const StudyChart& chart);
    /// Style of a series of the chart.
    const SeriesStyle& of(const std::string& name) const { return styles_.at(name); }

private:
    std::map<std::string, SeriesStyle> styles_;
};

QColor seriesColour(const SeriesStyle& style, const PlotTheme& theme);
/// A line without markers also has a dash pattern of its series.
QPen seriesPen(const SeriesStyle& style, const ChartSeries& series, const PlotTheme& theme);

/// `radius` is half the width of a full circle [px].
void paintMarker(QPainter& painter, const QPointF& at, double radius, const SeriesStyle& style, PointKind kind,
                 const PlotTheme& theme);
/// About the marker of a point that is chosen.
void paintRing(QPainter& painter, const QPointF& at, double radius, const PlotTheme& theme);

/// How the cells of a class are filled.
struct ClassStyle {
    QColor colour;                        // by severity: the worse, the more contrast
    Qt::BrushStyle pattern = Qt::NoBrush; // where another class is as severe
    QChar letter;                         // unique
    QColor ink;                           // of pattern and letter
};
std::vector<ClassStyle> classStyles(const std::vector<ChartClass>& classes, const PlotTheme& theme);
/// A cell, with its letter where it has room for it.
void paintCell(QPainter& painter, const QRectF& cell, const ClassStyle& style, bool letter);
/// A cell whose class is not known: empty, with a quiet frame.
void paintUnknownCell(QPainter& painter, const QRectF& cell, const PlotTheme& theme);

} // namespace touchdown
