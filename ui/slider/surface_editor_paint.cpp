// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the editor draws over the plan: ghost, selection, warnings and problems at their places, and the gesture.
#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/slider/part_picking.h"
#include "ui/slider/plan_marks.h"
#include "ui/slider/surface_editor.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr double handle = 7.0; // width of a corner's square [px]

} // namespace

void SurfaceEditor::paintContent(QPainter& painter, const PlotTheme& theme)
{
    SurfaceView::paintContent(painter, theme);
    if (ghost_.rails != surface().rails) {
        QPen pen(QColor(255, 255, 255, 150), 1.2, Qt::DashLine);
        pen.setCosmetic(true);
        for (const Rail& rail : ghost_.rails)
            if (std::ranges::find(surface().rails, rail) == surface().rails.end()) paintOutline(painter, rail, pen);
    }
    if (!dragging()) paintInfluence(painter, theme);
    paintLinks(painter, theme);
    paintSelection(painter, theme);
    paintProblems(painter, theme);
    paintSnap(painter, theme);
    paintMeasure(painter, theme);
    paintGesture(painter, theme);
}

QStringList SurfaceEditor::snapWords() const
{
    if (!snap_) return {};
    QStringList words{snapText(snap_->x, snap_->xCorner), snapText(snap_->y, snap_->yCorner)};
    words.removeAll(QString());
    words.removeDuplicates();
    return words;
}

/// A line from what holds the place, and its name beside the place.
void SurfaceEditor::paintSnap(QPainter& painter, const PlotTheme& theme) const
{
    const QStringList words = snapWords();
    if (words.isEmpty()) return;
    const QPointF place = toPixel(snap_->at);
    const auto line = [&](SnapTarget target, const SurfacePart& corner, bool alongX) {
        if (snapText(target, corner).isEmpty()) return;
        QPointF from =
            alongX ? QPointF(toPixel({0.0, 0.0}).x(), place.y()) : QPointF(place.x(), toPixel({0.0, 0.0}).y());
        QPointF to = alongX ? QPointF(toPixel({area().right(), 0.0}).x(), place.y())
                            : QPointF(place.x(), toPixel({0.0, area().bottom()}).y());
        if (target == SnapTarget::Corner) {
            const RailPoint& held = committed_.rails[corner.item].points[corner.index];
            from = toPixel({held.x, held.y});
            to = place;
        }
        for (const QPen& pen : {QPen(theme.background, 3.0), QPen(theme.selection, 1.2, Qt::DashLine)}) {
            painter.setPen(pen);
            painter.drawLine(from, to);
        }
        if (target == SnapTarget::Corner) painter.drawEllipse(from, 4.0, 4.0);
    };
    painter.setBrush(Qt::NoBrush);
    line(snap_->x, snap_->xCorner, false);
    line(snap_->y, snap_->yCorner, true);
    const QString text = words.join(QStringLiteral("  ·  "));
    painter.setFont(font());
    const double half = 0.5 * QFontMetricsF(font()).horizontalAdvance(text) + 8.0;
    const bool atRight = place.x() + 14.0 + 2.0 * half < planArea().right();
    TakenRoom taken;
    paintPlanLabel(painter, place + QPointF(atRight ? 10.0 + half : -10.0 - half, -18.0), text, theme, taken);
}

void SurfaceEditor::paintRings(QPainter& painter, const SurfaceProblem& problem, double radius, const QColor& colour,
                               const PlotTheme& theme) const
{
    painter.setBrush(Qt::NoBrush);
    for (const SurfacePoint& place : problem.places)
        for (const QPen& pen : {QPen(theme.background, 4.0), QPen(colour, 2.0)}) {
            painter.setPen(pen);
            painter.drawEllipse(toPixel(place), radius, radius);
        }
}

/// Beside the first place, where there is room.
void SurfaceEditor::paintSentence(QPainter& painter, const SurfaceProblem& problem, const PlotTheme& theme,
                                  TakenRoom& taken) const
{
    if (problem.places.empty()) return;
    const QString sentence = QString::fromStdString(problem.sentence);
    const double half = 0.5 * QFontMetricsF(font()).horizontalAdvance(sentence) + 8.0;
    const QPointF place = toPixel(problem.places.front());
    const double x =
        std::clamp(place.x(), planArea().left() + half, std::max(planArea().left() + half, planArea().right() - half));
    painter.setFont(font());
    for (const double away : {24.0, -24.0, 46.0, -46.0})
        if (planArea().contains(x, place.y() + away) &&
            paintPlanLabel(painter, {x, place.y() + away}, sentence, theme, taken))
            return;
}

/// A warning that was at its place when the case was opened is told where the pointer is; a new one at once.
namespace {

/// The sentence without numbers: those of rails change with their order.
std::string kindOf(const SurfaceProblem& problem)
{
    std::string words = problem.sentence;
    std::erase_if(words, [](char each) { return each >= '0' && each <= '9'; });
    return words;
}

} // namespace

bool SurfaceEditor::isTold(const SurfaceProblem& warning) const
{
    const auto known = [&](const SurfaceProblem& one) {
        if (one.places.empty() || warning.places.empty()) return one.sentence == warning.sentence;
        constexpr double same = 1e-9; // [m]
        const SurfacePoint &a = one.places.front(), &b = warning.places.front();
        return kindOf(one) == kindOf(warning) && std::hypot(b.x - a.x, b.y - a.y) < same;
    };
    if (std::ranges::none_of(ghostWarnings_, known)) return true;
    constexpr double near = 12.0; // [px]
    return std::ranges::any_of(warning.places, [&](const SurfacePoint& place) {
        const QPointF away = toPixel(place) - pointer_;
        return std::hypot(away.x(), away.y()) < near;
    });
}

void SurfaceEditor::paintProblems(QPainter& painter, const PlotTheme& theme) const
{
    const MeaningColours colours = meaningColours(palette());
    TakenRoom taken;
    for (const SurfaceProblem& warning : warnings_) paintRings(painter, warning, 6.0, colours.warning, theme);
    for (const SurfaceProblem& problem : problems_) paintRings(painter, problem, 8.0, colours.failure, theme);
    for (const SurfaceProblem& problem : problems_) paintSentence(painter, problem, theme, taken);
    for (const SurfaceProblem& warning : warnings_)
        if (isTold(warning)) paintSentence(painter, warning, theme, taken);
}

void SurfaceEditor::paintOutline(QPainter& painter, const Rail& rail, const QPen& pen) const
{
    QPolygonF outline;
    for (const RailPoint& point : rail.points) outline << toPixel({point.x, point.y});
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(outline);
}

void SurfaceEditor::paintSelection(QPainter& painter, const PlotTheme& theme) const
{
    const QColor mark = theme.selection;
    const auto& rails = surface().rails;
    const auto square = [&](const RailPoint& point, bool filled) {
        const QPointF at = toPixel({point.x, point.y});
        painter.setPen(QPen(mark, 1.4));
        painter.setBrush(filled ? mark : theme.background);
        painter.drawRect(QRectF(at.x() - 0.5 * handle, at.y() - 0.5 * handle, handle, handle));
    };
    const auto line = [&](const SurfacePart& edge, double width) {
        const std::vector<RailPoint>& points = rails[edge.item].points;
        const RailPoint &a = points[edge.index], &b = points[(edge.index + 1) % points.size()];
        painter.setPen(QPen(mark, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(toPixel({a.x, a.y}), toPixel({b.x, b.y}));
    };
    if (hovered_ && has(surface(), *hovered_) && hovered_->kind == PartKind::Edge) line(*hovered_, 2.5);
    if (hovered_ && has(surface(), *hovered_) && hovered_->kind == PartKind::Corner)
        square(rails[hovered_->item].points[hovered_->index], false);
    for (const SurfacePart& part : selection_) {
        if (!has(surface(), part)) continue;
        if (part.kind == PartKind::Interest) {
            painter.setPen(QPen(mark, 2.5));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(toPixel(surface().pointsOfInterest[part.item]), 9.0, 9.0);
            continue;
        }
        paintOutline(painter, rails[part.item], QPen(mark, part.kind == PartKind::Rail ? 2.6 : 1.4));
        for (std::size_t k = 0; k < rails[part.item].points.size(); ++k)
            square(rails[part.item].points[k],
                   part.kind == PartKind::Corner && selection_.contains({PartKind::Corner, part.item, k}));
        if (part.kind == PartKind::Edge) line(part, 4.0);
    }
}

void SurfaceEditor::paintGesture(QPainter& painter, const PlotTheme& theme) const
{
    painter.setPen(QPen(theme.selection, 1.4, Qt::DashLine));
    QColor fill = theme.selection;
    fill.setAlphaF(0.12F);
    painter.setBrush(fill);
    if (gesture_ == Gesture::Band || gesture_ == Gesture::Rectangle)
        painter.drawRect(QRectF(toPixel(pressedPoint_), pointer_).normalized());
    if (polygon_.empty()) return;
    QPolygonF outline;
    for (const SurfacePoint& corner : polygon_) outline << toPixel(corner);
    painter.drawPolygon(outline << pointer_);
}

} // namespace touchdown
