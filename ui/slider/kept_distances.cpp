// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/kept_distances.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "core/physics/slider/surface_relations.h"
#include "ui/plot/plot_theme.h"
#include "ui/slider/rail_drawing.h"
#include "ui/slider/slider_plan.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr double lineReach = 5.0; // of the line of a distance [px]
constexpr double tip = 7.0;       // length of an arrow [px]

struct Dimension {
    QPointF from, to;           // ends of the line [px]
    QPointF fromPlace, toPlace; // middles of the places [px]
    QString text;

    QRectF label(const QFontMetricsF& metrics) const
    {
        const QSizeF size(metrics.horizontalAdvance(text) + 8.0, metrics.height() + 2.0);
        return {0.5 * (from + to) - QPointF(0.5 * size.width(), 0.5 * size.height()), size};
    }
};

/// The line runs halfway between the two places, across the axis.
Dimension dimensionOf(const SliderPlan& plan, const AirBearingSurface& surface, const KeptDistance& distance)
{
    const QPointF a = plan.toPixel(middleOf(surface, distance.from)), b = plan.toPixel(middleOf(surface, distance.to));
    const QPointF middle = 0.5 * (a + b);
    const QString text = lengthText(distance.value);
    if (distance.alongX) return {{a.x(), middle.y()}, {b.x(), middle.y()}, a, b, text};
    return {{middle.x(), a.y()}, {middle.x(), b.y()}, a, b, text};
}

} // namespace

void paintKeptDistances(QPainter& painter, const SliderPlan& plan, const AirBearingSurface& surface,
                        const PartSelection& selected, const std::vector<SurfaceProblem>& problems,
                        const PlotTheme& theme)
{
    painter.setFont(plan.font());
    TakenRoom taken;
    for (std::size_t i = 0; i < surface.distances.size(); ++i) {
        if (!exists(surface, surface.distances[i])) continue;
        const SurfacePart part{PartKind::Distance, i};
        const QColor colour = selected.contains(part)                      ? theme.selection
                              : !relationProblem(problems, part).isEmpty() ? meaningColours(plan.palette()).failure
                                                                           : theme.text;
        const Dimension line = dimensionOf(plan, surface, surface.distances[i]);
        const QPointF along = line.to - line.from;
        const double length = std::hypot(along.x(), along.y());
        for (const QPen& pen : {QPen(theme.background, 3.0), QPen(colour, 1.0)}) {
            painter.setPen(pen);
            painter.drawLine(line.from, line.to);
        }
        painter.setPen(QPen(colour, 1.0, Qt::DotLine));
        painter.drawLine(line.fromPlace, line.from);
        painter.drawLine(line.toPlace, line.to);
        painter.setPen(QPen(colour, 1.0));
        painter.setBrush(colour);
        if (length > 2.0 * tip)
            for (const double sense : {1.0, -1.0}) {
                const QPointF end = sense > 0.0 ? line.to : line.from, back = sense * tip / length * along;
                const QPointF across = 0.35 * QPointF(-back.y(), back.x());
                painter.drawPolygon(QPolygonF({end, end - back + across, end - back - across}));
            }
        painter.setBrush(Qt::NoBrush);
        paintPlanLabel(painter, line.label(QFontMetricsF(plan.font())).center(), line.text, theme, taken);
    }
}

std::optional<std::size_t> keptDistanceAt(const SliderPlan& plan, const AirBearingSurface& surface,
                                          const QPointF& pixel)
{
    const QFontMetricsF metrics(plan.font());
    for (std::size_t i = 0; i < surface.distances.size(); ++i) {
        if (!exists(surface, surface.distances[i])) continue;
        const Dimension line = dimensionOf(plan, surface, surface.distances[i]);
        if (line.label(metrics).contains(pixel) || distanceToEdge(pixel, line.from, line.to) < lineReach) return i;
    }
    return {};
}

QString relationProblem(const std::vector<SurfaceProblem>& problems, const SurfacePart& relation)
{
    const std::string kind = relation.kind == PartKind::Distance ? "abs.distance[" : "abs.symmetric[";
    const std::string key = kind + std::to_string(relation.item + 1) + ']';
    const auto found = std::ranges::find(problems, key, &SurfaceProblem::key);
    return found == problems.end() ? QString() : QString::fromStdString(found->sentence);
}

} // namespace touchdown
