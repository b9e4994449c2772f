// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_chart_style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <QFontMetricsF>

#include "core/studies/study/study.h"
#include "ui/plot/colour_scale.h"

namespace touchdown {

namespace {

constexpr int shapes = 6;
constexpr int mostSevere = 3;

/// A regular polygon with a corner at `first` [rad, clockwise from the right].
QPolygonF polygon(const QPointF& at, double radius, int corners, double first)
{
    QPolygonF result;
    for (int i = 0; i < corners; ++i) {
        const double angle = first + 2.0 * std::numbers::pi * i / corners;
        result << at + radius * QPointF(std::cos(angle), std::sin(angle));
    }
    return result;
}

/// Shapes of about the area of the circle, so that none looks more important.
void paintShape(QPainter& painter, const QPointF& at, double radius, MarkerShape shape)
{
    constexpr double up = -0.5 * std::numbers::pi;
    switch (shape) {
    case MarkerShape::Circle: painter.drawEllipse(at, radius, radius); return;
    case MarkerShape::Square: painter.drawPolygon(polygon(at, 1.25 * radius, 4, 0.5 * up)); return;
    case MarkerShape::Triangle: painter.drawPolygon(polygon(at, 1.4 * radius, 3, up)); return;
    case MarkerShape::Diamond: painter.drawPolygon(polygon(at, 1.3 * radius, 4, up)); return;
    case MarkerShape::TriangleDown: painter.drawPolygon(polygon(at, 1.4 * radius, 3, -up)); return;
    case MarkerShape::Pentagon: painter.drawPolygon(polygon(at, 1.2 * radius, 5, up)); return;
    }
}

/// Blue, yellow, orange, red: they differ in lightness, too, which is what the colour-blind and a grey copy leave.
QColor severityColour(int severity, bool dark)
{
    static const std::array<QColor, 4> onLight{"#d6e6f4", "#f2d675", "#e8893a", "#a8223c"};
    static const std::array<QColor, 4> onDark{"#24405a", "#7d6418", "#d4772b", "#ff9a9a"};
    return (dark ? onDark : onLight)[static_cast<std::size_t>(std::clamp(severity, 0, mostSevere))];
}

QChar freeLetter(const QString& name, QString& taken)
{
    for (const QChar c : name + QStringLiteral("ABCDEFGHIJKLMNOPQRSTUVWXYZ")) {
        const QChar letter = c.toUpper();
        if (!letter.isLetter() || taken.contains(letter)) continue;
        taken += letter;
        return letter;
    }
    return {};
}

} // namespace

ChartStyles::ChartStyles(const StudyChart& chart)
{
    int next = 0;
    for (const ChartPanel& panel : chart.panels)
        for (const ChartSeries& series : panel.series) {
            if (styles_.contains(series.name)) continue;
            SeriesStyle style;
            style.quiet = series.quiet;
            if (!series.quiet) {
                style.curve = {next % 7, (next + next / 7) % 4};
                style.shape = static_cast<MarkerShape>(next % shapes);
                ++next;
            }
            styles_.emplace(series.name, style);
        }
}

QColor seriesColour(const SeriesStyle& style, const PlotTheme& theme)
{
    return style.quiet ? theme.referenceLine : theme.colour(style.curve);
}

QPen seriesPen(const SeriesStyle& style, const ChartSeries& series, const PlotTheme& theme)
{
    CurveStyle curve = style.curve;
    if (series.markers || style.quiet) curve.dash = 0;
    if (series.line == ChartLine::Dashed) curve.dash = 1;
    QPen pen = curvePen(curve, theme);
    pen.setColor(seriesColour(style, theme));
    pen.setWidthF(style.quiet ? 1.0 : 1.8);
    return pen;
}

void paintMarker(QPainter& painter, const QPointF& at, double radius, const SeriesStyle& style, PointKind kind,
                 const PlotTheme& theme)
{
    const QColor colour = seriesColour(style, theme);
    if (kind == PointKind::Failed) {
        const QPointF down(radius, radius), up(radius, -radius);
        QPen pen(colour, 0.45 * radius);
        pen.setCapStyle(Qt::RoundCap);
        painter.setPen(pen);
        painter.drawLine(at - down, at + down);
        painter.drawLine(at - up, at + up);
        return;
    }
    const bool full = kind == PointKind::Good;
    painter.setBrush(full ? colour : theme.plotArea);
    // Paper round a full marker keeps it apart from the lines that cross it.
    painter.setPen(full ? QPen(theme.plotArea, 0.8) : QPen(colour, 0.38 * radius));
    paintShape(painter, at, full ? radius : 0.92 * radius, style.shape);
}

void paintRing(QPainter& painter, const QPointF& at, double radius, const PlotTheme& theme)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.plotArea, 0.9 * radius));
    painter.drawEllipse(at, 1.95 * radius, 1.95 * radius);
    painter.setPen(QPen(theme.text, 0.42 * radius));
    painter.drawEllipse(at, 1.95 * radius, 1.95 * radius);
}

std::vector<ClassStyle> classStyles(const std::vector<ChartClass>& classes, const PlotTheme& theme)
{
    static constexpr std::array patterns{Qt::NoBrush,      Qt::BDiagPattern, Qt::Dense6Pattern,
                                         Qt::FDiagPattern, Qt::HorPattern,   Qt::VerPattern};
    const bool dark = theme.plotArea.lightness() < 128;
    std::array<std::size_t, mostSevere + 1> asSevere{};
    QString letters;
    std::vector<ClassStyle> styles;
    for (const ChartClass& c : classes) {
        const auto severity = static_cast<std::size_t>(std::clamp(c.severity, 0, mostSevere));
        ClassStyle style;
        if (c.shade >= 0.0) {
            style.colour = mapColour(ColourMap::Viridis, c.shade);
            style.letter = QChar('A' + static_cast<int>(styles.size() % 26)); // in the order of the scale
            letters += style.letter;
        } else {
            style.colour = severityColour(c.severity, dark);
            style.pattern = patterns[asSevere[severity]++ % patterns.size()];
        }
        if (style.letter.isNull()) style.letter = freeLetter(QString::fromStdString(c.name), letters);
        style.ink = qGray(style.colour.rgb()) > 125 ? QColor("#14181c") : QColor("#ffffff");
        styles.push_back(style);
    }
    return styles;
}

void paintCell(QPainter& painter, const QRectF& cell, const ClassStyle& style, bool letter)
{
    painter.fillRect(cell, style.colour);
    if (style.pattern != Qt::NoBrush) {
        QColor faint = style.ink;
        faint.setAlphaF(0.38F);
        painter.fillRect(cell, QBrush(faint, style.pattern));
    }
    const QFontMetricsF metrics(painter.font());
    if (!letter || cell.height() < 0.95 * metrics.height() ||
        cell.width() < 1.05 * metrics.horizontalAdvance(style.letter))
        return;
    if (style.pattern != Qt::NoBrush) {
        QRectF behind(0.0, 0.0, 1.15 * metrics.horizontalAdvance(style.letter), 0.9 * metrics.height());
        behind.moveCenter(cell.center());
        painter.fillRect(behind, style.colour);
    }
    painter.setPen(style.ink);
    painter.drawText(cell, Qt::AlignCenter, QString(style.letter));
}

void paintUnknownCell(QPainter& painter, const QRectF& cell, const PlotTheme& theme)
{
    painter.fillRect(cell, theme.plotArea);
    painter.setPen(QPen(theme.grid, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(cell.adjusted(0.5, 0.5, -0.5, -0.5));
}

} // namespace touchdown
