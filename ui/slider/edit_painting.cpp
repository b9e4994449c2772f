// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/edit_painting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/slider/kept_distances.h"
#include "ui/slider/part_picking.h"
#include "ui/slider/rail_drawing.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr double handle = 7.0;            // width of a corner's square [px]
const QPointF besideTheNumber{18.0, 0.0}; // of a rail [px]
constexpr double linkReach = 10.0;        // of a symbol from its middle [px]

/// The sentence without numbers: those of rails change with their order.
std::string kindOf(const SurfaceProblem& problem)
{
    std::string words = problem.sentence;
    std::erase_if(words, [](char each) { return each >= '0' && each <= '9'; });
    return words;
}

bool sameProblem(const SurfaceProblem& one, const SurfaceProblem& other)
{
    if (one.places.empty() || other.places.empty()) return one.sentence == other.sentence;
    constexpr double same = 1e-9; // [m]
    const SurfacePoint &a = one.places.front(), &b = other.places.front();
    return kindOf(one) == kindOf(other) && std::hypot(b.x - a.x, b.y - a.y) < same;
}

struct EditPainter {
    QPainter& painter;
    const SurfaceView& plan;
    const EditMarks& marks;
    const PlotTheme& theme;
    const GestureMarks& gesture = marks.gesture;
    const std::vector<Rail>& rails = plan.surface().rails;

    QPointF at(const RailPoint& point) const { return plan.toPixel({point.x, point.y}); }
    std::pair<RailPoint, RailPoint> ends(const SurfacePart& edge) const
    {
        const std::vector<RailPoint>& points = rails[edge.item].points;
        return {points[edge.index], points[(edge.index + 1) % points.size()]};
    }
    QPolygonF outline(const Rail& rail) const
    {
        QPolygonF outline;
        for (const RailPoint& point : rail.points) outline << at(point);
        return outline;
    }
    /// On a wider line in the colour of the background, so that it is seen on any colour.
    void drawSeen(double under, const QPen& pen, const auto& draw)
    {
        for (const QPen& each : {QPen(theme.background, under), pen}) {
            painter.setPen(each);
            draw();
        }
    }
    double halfWidth(const QString& text) const
    {
        return 0.5 * QFontMetricsF(plan.font()).horizontalAdvance(text) + 8.0;
    }
    bool label(const QPointF& centre, const QString& text, TakenRoom& taken)
    {
        painter.setFont(plan.font());
        return paintPlanLabel(painter, centre, text, theme, taken);
    }
    bool label(const QPointF& centre, const QString& text)
    {
        TakenRoom taken;
        return label(centre, text, taken);
    }
    /// The nearest place at which half of a label has room within the plan.
    double withRoom(double x, double half) const
    {
        const double left = plan.planArea().left() + half;
        return std::clamp(x, left, std::max(left, plan.planArea().right() - half));
    }

    void ghost()
    {
        if (marks.ghost.rails == rails) return;
        QPen pen(QColor(255, 255, 255, 150), 1.2, Qt::DashLine);
        pen.setCosmetic(true);
        painter.setPen(pen);
        painter.setBrush(Qt::NoBrush);
        for (const Rail& rail : marks.ghost.rails)
            if (std::ranges::find(rails, rail) == rails.end()) painter.drawPolygon(outline(rail));
    }

    void links()
    {
        if (marks.selection.noPairs()) {
            const QString text = tr("No mirror images within 0.1 µm");
            label(plan.planArea().bottomLeft() + QPointF(halfWidth(text), -14.0), text);
        }
        painter.setBrush(Qt::NoBrush);
        for (const PairLink& link : marks.selection.pairLinks()) {
            const QPointF middle = linkSymbol(plan, link);
            drawSeen(3.2, QPen(theme.text, 1.2, link.broken ? Qt::DotLine : Qt::SolidLine), [&] {
                painter.drawLine(plan.toPixel(link.from) + besideTheNumber, plan.toPixel(link.to) + besideTheNumber);
            });
            painter.setPen(QPen(theme.background, 1.0));
            painter.setBrush(theme.background);
            painter.drawEllipse(middle, linkReach, linkReach);
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(link.broken ? theme.mutedText : theme.text, 1.6));
            const double apart = link.broken ? 5.5 : 3.0; // of the two links of a chain
            for (const double side : {-1.0, 1.0})
                painter.drawRoundedRect(QRectF(middle.x() - 2.5, middle.y() + side * apart - 4.0, 5.0, 8.0), 2.5, 2.5);
        }
    }

    void selection()
    {
        const QColor mark = theme.selection;
        const PartSelection& parts = marks.selection.parts();
        const auto square = [&](const RailPoint& point, bool filled) {
            const QPointF middle = at(point);
            painter.setPen(QPen(mark, 1.4));
            painter.setBrush(filled ? mark : theme.background);
            painter.drawRect(QRectF(middle.x() - 0.5 * handle, middle.y() - 0.5 * handle, handle, handle));
        };
        const auto line = [&](const SurfacePart& edge, double width) {
            const auto [a, b] = ends(edge);
            painter.setPen(QPen(mark, width, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(at(a), at(b));
        };
        if (const auto& hovered = gesture.hovered; hovered && has(plan.surface(), *hovered)) {
            if (hovered->kind == PartKind::Edge) line(*hovered, 2.5);
            if (hovered->kind == PartKind::Corner) square(rails[hovered->item].points[hovered->index], false);
        }
        for (const SurfacePart& part : parts) {
            if (!has(plan.surface(), part)) continue;
            painter.setBrush(Qt::NoBrush);
            if (part.kind == PartKind::Interest) {
                painter.setPen(QPen(mark, 2.5));
                painter.drawEllipse(plan.toPixel(plan.surface().pointsOfInterest[part.item]), 9.0, 9.0);
                continue;
            }
            if (part.kind == PartKind::Distance) continue;
            if (part.kind == PartKind::Symmetry) {
                const auto [one, other] = plan.surface().symmetries[part.item];
                painter.setPen(QPen(mark, 2.6, Qt::DashLine));
                for (const std::size_t each : {one, other}) painter.drawPolygon(outline(rails[each]));
                continue;
            }
            const Rail& rail = rails[part.item];
            painter.setPen(QPen(mark, part.kind == PartKind::Rail ? 2.6 : 1.4));
            painter.drawPolygon(outline(rail));
            for (std::size_t k = 0; k < rail.points.size(); ++k)
                square(rail.points[k],
                       part.kind == PartKind::Corner && parts.contains({PartKind::Corner, part.item, k}));
            if (part.kind == PartKind::Edge) line(part, 4.0);
        }
    }

    void problems()
    {
        const MeaningColours colours = meaningColours(plan.palette());
        TakenRoom taken;
        painter.setBrush(Qt::NoBrush);
        for (const SurfaceProblem& warning : marks.warnings) rings(warning, 6.0, colours.warning);
        for (const SurfaceProblem& problem : marks.problems) rings(problem, 8.0, colours.failure);
        for (const SurfaceProblem& problem : marks.problems) sentence(problem, taken);
        for (const SurfaceProblem& warning : marks.warnings)
            if (isTold(warning)) sentence(warning, taken);
    }

    void rings(const SurfaceProblem& problem, double radius, const QColor& colour)
    {
        for (const SurfacePoint& place : problem.places)
            drawSeen(4.0, QPen(colour, 2.0), [&] { painter.drawEllipse(plan.toPixel(place), radius, radius); });
    }

    /// Beside the first place, where there is room.
    void sentence(const SurfaceProblem& problem, TakenRoom& taken)
    {
        if (problem.places.empty()) return;
        const QString words = QString::fromStdString(problem.sentence);
        const QPointF place = plan.toPixel(problem.places.front());
        const double x = withRoom(place.x(), halfWidth(words));
        for (const double away : {24.0, -24.0, 46.0, -46.0})
            if (plan.planArea().contains(x, place.y() + away) && label({x, place.y() + away}, words, taken)) return;
    }

    /// A warning that was at its place when the case was opened is told where the pointer is; a new one at once.
    bool isTold(const SurfaceProblem& warning) const
    {
        if (std::ranges::none_of(marks.knownWarnings, [&](const auto& known) { return sameProblem(known, warning); }))
            return true;
        constexpr double near = 12.0; // [px]
        return std::ranges::any_of(warning.places, [&](const SurfacePoint& place) {
            const QPointF away = plan.toPixel(place) - gesture.pointer;
            return std::hypot(away.x(), away.y()) < near;
        });
    }

    /// A line from what holds the place, and its name beside the place.
    void snap()
    {
        const QStringList words = snapWords(gesture);
        if (words.isEmpty()) return;
        const QPointF place = plan.toPixel(gesture.snap->at);
        const QPointF low = plan.toPixel({0.0, 0.0}), high = plan.toPixel({plan.area().right(), plan.area().bottom()});
        const auto line = [&](SnapTarget target, const SurfacePart& corner, bool alongX) {
            if (snapText(target, corner).isEmpty()) return;
            QPointF from = alongX ? QPointF(low.x(), place.y()) : QPointF(place.x(), low.y());
            QPointF to = alongX ? QPointF(high.x(), place.y()) : QPointF(place.x(), high.y());
            if (target == SnapTarget::Corner) {
                from = at(marks.selection.surface().rails[corner.item].points[corner.index]);
                to = place;
            }
            drawSeen(3.0, QPen(theme.selection, 1.2, Qt::DashLine), [&] { painter.drawLine(from, to); });
            if (target == SnapTarget::Corner) painter.drawEllipse(from, 4.0, 4.0);
        };
        painter.setBrush(Qt::NoBrush);
        line(gesture.snap->x, gesture.snap->xCorner, false);
        line(gesture.snap->y, gesture.snap->yCorner, true);
        const QString text = words.join(QStringLiteral("  ·  "));
        const double half = halfWidth(text);
        const bool atRight = place.x() + 14.0 + 2.0 * half < plan.planArea().right();
        label(place + QPointF(atRight ? 10.0 + half : -10.0 - half, -18.0), text);
    }

    /// How far the dragged parts are from where they were.
    void shift()
    {
        if (!gesture.shift) return;
        const QString text =
            tr("dx %1   dy %2 µm").arg(typeset(gesture.shift->x * 1e6, 2), typeset(gesture.shift->y * 1e6, 2));
        const double half = halfWidth(text);
        label({withRoom(gesture.pointer.x() + 14.0 + half, half), gesture.pointer.y() + 26.0}, text);
    }

    void measure()
    {
        const QString text = measureText(gesture);
        if (text.isEmpty()) return;
        const QPointF from = plan.toPixel(gesture.measured.front());
        const QPointF to = plan.toPixel(gesture.measured.size() == 2 ? gesture.measured.back() : gesture.snap->at);
        const double length = std::max(std::hypot(to.x() - from.x(), to.y() - from.y()), 1e-9);
        const QPointF across = 6.0 * QPointF(from.y() - to.y(), to.x() - from.x()) / length;
        drawSeen(4.0, QPen(theme.text, 1.6), [&] {
            painter.drawLine(from, to);
            for (const QPointF& end : {from, to}) painter.drawLine(end - across, end + across);
        });
        const double half = halfWidth(text);
        // Above a flat line; beside a steep one, at the right where there is room.
        QPointF middle = 0.5 * (from + to);
        if (std::abs(across.y()) > std::abs(across.x()))
            middle.ry() -= 18.0;
        else
            middle.rx() += middle.x() + 2.0 * half + 8.0 < plan.planArea().right() ? half + 8.0 : -half - 8.0;
        label({withRoom(middle.x(), half), middle.y()}, text);
    }

    /// The rectangle or the polygon under way.
    void shape()
    {
        painter.setPen(QPen(theme.selection, 1.4, Qt::DashLine));
        QColor fill = theme.selection;
        fill.setAlphaF(0.12F);
        painter.setBrush(fill);
        if (gesture.boxFrom) painter.drawRect(QRectF(plan.toPixel(*gesture.boxFrom), gesture.pointer).normalized());
        if (gesture.polygon.empty()) return;
        QPolygonF outline;
        for (const SurfacePoint& corner : gesture.polygon) outline << plan.toPixel(corner);
        painter.drawPolygon(outline << gesture.pointer);
    }
};

} // namespace

void paintEditMarks(QPainter& painter, const SurfaceView& plan, const EditMarks& marks, const PlotTheme& theme)
{
    EditPainter paint{painter, plan, marks, theme};
    paint.ghost();
    if (!marks.gesture.dragging) {
        paintInfluenceArrows(painter, plan, marks.influence, theme);
        paint.links();
    }
    paint.selection();
    if (!plan.onPaper())
        paintKeptDistances(painter, plan, plan.surface(), marks.selection.parts(), marks.warnings, theme);
    paint.problems();
    paint.snap();
    paint.shift();
    paint.measure();
    paint.shape();
}

QPointF linkSymbol(const SliderPlan& plan, const PairLink& link)
{
    return 0.5 * (plan.toPixel(link.from) + plan.toPixel(link.to)) + besideTheNumber;
}

std::optional<std::size_t> linkAt(const SliderPlan& plan, const std::vector<PairLink>& links, const QPointF& pixel)
{
    for (const PairLink& link : links)
        if (const QPointF away = linkSymbol(plan, link) - pixel; std::hypot(away.x(), away.y()) < linkReach)
            return link.rail;
    return {};
}

QStringList snapWords(const GestureMarks& gesture)
{
    if (!gesture.snap) return {};
    if (std::ranges::find(gesture.drawing, gesture.snap->at) != gesture.drawing.end())
        return {tr("corner of the drawing")};
    QStringList words{snapText(gesture.snap->x, gesture.snap->xCorner),
                      snapText(gesture.snap->y, gesture.snap->yCorner)};
    words.removeAll(QString());
    words.removeDuplicates();
    return words;
}

QString measureText(const GestureMarks& gesture)
{
    const bool underWay = gesture.measured.size() == 1;
    if (gesture.measured.empty() || (underWay && !gesture.snap)) return {};
    const SurfacePoint from = gesture.measured.front(), to = underWay ? gesture.snap->at : gesture.measured.back();
    const double dx = to.x - from.x, dy = to.y - from.y;
    const auto micrometres = [](double length) { return typeset(length * 1e6, 2); };
    return tr("%1 µm   dx %2   dy %3   %4°")
        .arg(micrometres(std::hypot(dx, dy)), micrometres(dx), micrometres(dy),
             typeset(std::atan2(dy, dx) * 180.0 / std::numbers::pi, 2));
}

} // namespace touchdown
