// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gestures of the mouse, and what is drawn of them.
#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>

#include "ui/slider/part_picking.h"
#include "ui/slider/rail_drawing.h"
#include "ui/slider/surface_editor.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr double snapReach = 7.0;    // [px]
constexpr double placeRaster = 1e-6; // [m]
constexpr double handle = 7.0;       // width of a corner's square [px]

QRectF box(const QPointF& a, const QPointF& b) { return QRectF(a, b).normalized(); }

} // namespace

SnapGrid SurfaceEditor::snapGrid() const
{
    const double metre = toPixel({1.0, 0.0}).x() - toPixel({0.0, 0.0}).x(); // [px/m]
    return {area().width(), area().height(), snapReach / metre, placeRaster};
}

SurfacePoint SurfaceEditor::snappedAt(const QPointF& pixel, Qt::KeyboardModifiers modifiers) const
{
    const SurfacePoint at = toSlider(pixel);
    if (!snapping_ || modifiers.testFlag(Qt::ControlModifier)) return at;
    return snapped(committed_, {}, at, snapGrid()).at;
}

SurfaceShift SurfaceEditor::wantedShift(const QMouseEvent& event) const
{
    const SurfacePoint to = toSlider(event.position());
    SurfaceShift by{to.x - pressedPoint_.x, to.y - pressedPoint_.y};
    if (event.modifiers().testFlag(Qt::ShiftModifier)) (std::abs(by.x) > std::abs(by.y) ? by.y : by.x) = 0.0;
    if (!snapping_ || event.modifiers().testFlag(Qt::ControlModifier) || !grabbed_) return by;
    const SurfacePoint from = placeOf(committed_, *grabbed_, pressedPoint_);
    const SnappedPlace place = snapped(committed_, selection_, {from.x + by.x, from.y + by.y}, snapGrid());
    return {by.x == 0.0 ? 0.0 : place.at.x - from.x, by.y == 0.0 ? 0.0 : place.at.y - from.y};
}

void SurfaceEditor::mousePressEvent(QMouseEvent* event)
{
    if (dragging()) return;
    pressedAt_ = pointer_ = event->position();
    pressedPoint_ = toSlider(pressedAt_);
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && spaceHeld_)) {
        gesture_ = Gesture::View;
        updateCursor();
        return;
    }
    if (event->button() != Qt::LeftButton || !planArea().contains(pressedAt_)) return;
    if (tool_ == Tool::Polygon)
        addPolygonCorner(snappedAt(event->position(), event->modifiers()));
    else if (tool_ == Tool::Rectangle)
        pressedPoint_ = snappedAt(event->position(), event->modifiers()), gesture_ = Gesture::Rectangle;
    else
        press(*event);
}

void SurfaceEditor::press(const QMouseEvent& event)
{
    grabbed_ = partAt(*this, committed_, event.position(), selection_);
    gesture_ = grabbed_ ? Gesture::Pressed : Gesture::Band;
    addedByPress_ = false;
    const bool adds = event.modifiers().testFlag(Qt::ShiftModifier);
    if (!grabbed_) {
        if (!adds) select({});
        return;
    }
    if (selection_.contains(*grabbed_)) return;
    PartSelection parts = adds ? selection_ : PartSelection{};
    parts.insert(*grabbed_);
    addedByPress_ = true;
    select(parts);
}

void SurfaceEditor::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF last = std::exchange(pointer_, event->position());
    if (gesture_ == Gesture::View) {
        pan(event->position() - last);
        return;
    }
    if (gesture_ == Gesture::Pressed &&
        (event->position() - pressedAt_).manhattanLength() >= QApplication::startDragDistance()) {
        gesture_ = Gesture::Move;
        updateCursor();
    }
    if (gesture_ == Gesture::Move) {
        waiting_ = wantedShift(*event);
        if (!previewTimer_.isActive()) previewWaiting();
        return;
    }
    if (gesture_ == Gesture::None) {
        const auto under = tool_ == Tool::Select && planArea().contains(event->position())
                               ? partAt(*this, committed_, event->position(), selection_)
                               : std::nullopt;
        if (under != hovered_) {
            hovered_ = under;
            updateCursor();
        }
        SurfaceView::mouseMoveEvent(event);
    }
    update();
}

void SurfaceEditor::mouseReleaseEvent(QMouseEvent* event)
{
    const Gesture ended = gesture_;
    switch (ended) {
    case Gesture::View:
        gesture_ = Gesture::None;
        updateCursor();
        return;
    case Gesture::Move: {
        const AirBearingSurface surface = movedSelection(wantedShift(*event));
        commit(surface, tr("move %1").arg(selectionText(selection_)));
        break;
    }
    case Gesture::Pressed:
        gesture_ = Gesture::None;
        if (!addedByPress_ && event->modifiers().testFlag(Qt::ShiftModifier)) {
            PartSelection parts = selection_;
            parts.erase(*grabbed_);
            select(parts);
        } else if (!addedByPress_) {
            select({*grabbed_});
        }
        break;
    case Gesture::Band: {
        gesture_ = Gesture::None;
        const SurfacePoint to = toSlider(event->position());
        PartSelection found = partsWithin(committed_, box({pressedPoint_.x, pressedPoint_.y}, {to.x, to.y}));
        if (event->modifiers().testFlag(Qt::ShiftModifier)) found.insert(selection_.begin(), selection_.end());
        select(found);
        break;
    }
    case Gesture::Rectangle: {
        gesture_ = Gesture::None;
        const SurfacePoint a = pressedPoint_, b = snappedAt(event->position(), event->modifiers());
        if (a.x != b.x && a.y != b.y) addOutline({a, {b.x, a.y}, b, {a.x, b.y}});
        break;
    }
    case Gesture::None: break;
    }
    updateCursor();
    update();
}

void SurfaceEditor::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (tool_ == Tool::Polygon) {
        finishPolygon();
        return;
    }
    const auto part = partAt(*this, committed_, event->position(), selection_);
    if (tool_ == Tool::Select && part && part->kind == PartKind::Edge) {
        gesture_ = Gesture::None;
        const std::vector<RailPoint>& points = committed_.rails[part->item].points;
        const RailPoint &a = points[part->index], &b = points[(part->index + 1) % points.size()];
        const SurfacePoint at = toSlider(event->position());
        const double squared = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
        const double share = squared > 0.0 ? ((at.x - a.x) * (b.x - a.x) + (at.y - a.y) * (b.y - a.y)) / squared : 0.5;
        const double kept = std::clamp(share, 0.0, 1.0);
        const auto between = [&](double from, double to) {
            const double place = from + kept * (to - from);
            return from == to ? from : snapping_ ? std::round(place / placeRaster) * placeRaster : place;
        };
        insertCorner(part->item, part->index, {between(a.x, b.x), between(a.y, b.y)});
    } else if (tool_ == Tool::Select && !part) {
        SurfaceView::mouseDoubleClickEvent(event);
    }
}

void SurfaceEditor::updateCursor()
{
    if (gesture_ == Gesture::View)
        setCursor(Qt::ClosedHandCursor);
    else if (spaceHeld_)
        setCursor(Qt::OpenHandCursor);
    else if (gesture_ == Gesture::Move)
        setCursor(Qt::SizeAllCursor);
    else if (tool_ != Tool::Select)
        setCursor(Qt::CrossCursor);
    else if (hovered_ && selection_.contains(*hovered_))
        setCursor(Qt::SizeAllCursor);
    else if (hovered_)
        setCursor(Qt::PointingHandCursor);
    else
        unsetCursor();
}

QStringList SurfaceEditor::readingAt(const SurfacePoint& point) const
{
    QStringList parts = SurfaceView::readingAt(point);
    constexpr double near = 10.0; // [px]
    for (const SurfaceProblem& warning : warnings_)
        for (const SurfacePoint& place : warning.places)
            if (QPointF away = toPixel(place) - toPixel(point); std::hypot(away.x(), away.y()) < near)
                return {QString::fromStdString(warning.sentence)};
    if (hovered_ && hovered_->kind != PartKind::Rail && !dragging()) parts << partText(*hovered_);
    return parts;
}

void SurfaceEditor::paintContent(QPainter& painter, const PlotTheme& theme)
{
    SurfaceView::paintContent(painter, theme);
    if (ghost_.rails != surface().rails) {
        QPen pen(QColor(255, 255, 255, 150), 1.2, Qt::DashLine);
        pen.setCosmetic(true);
        for (std::size_t i = 0; i < ghost_.rails.size(); ++i)
            if (i >= surface().rails.size() || !(ghost_.rails[i] == surface().rails[i]))
                paintOutline(painter, ghost_.rails[i], pen);
    }
    if (!dragging()) paintInfluence(painter, theme);
    paintSelection(painter, theme);
    paintProblems(painter, theme);
    paintGesture(painter, theme);
}

void SurfaceEditor::paintProblems(QPainter& painter, const PlotTheme& theme) const
{
    const MeaningColours colours = meaningColours(palette());
    const auto ring = [&](const SurfaceProblem& problem, const QColor& colour) {
        for (const SurfacePoint& place : problem.places) {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(theme.background, 4.0));
            painter.drawEllipse(toPixel(place), 8.0, 8.0);
            painter.setPen(QPen(colour, 2.0));
            painter.drawEllipse(toPixel(place), 8.0, 8.0);
        }
    };
    for (const SurfaceProblem& warning : warnings_) ring(warning, colours.warning);
    TakenRoom taken;
    painter.setFont(font());
    for (const SurfaceProblem& problem : problems_) {
        ring(problem, colours.failure);
        if (problem.places.empty()) continue;
        const QString sentence = QString::fromStdString(problem.sentence);
        const double half = 0.5 * QFontMetricsF(font()).horizontalAdvance(sentence) + 8.0;
        QPointF at = toPixel(problem.places.front()) + QPointF(0.0, 24.0);
        at.setX(std::clamp(at.x(), planArea().left() + half,
                           std::max(planArea().left() + half, planArea().right() - half)));
        paintPlanLabel(painter, at, sentence, theme, taken);
    }
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
        painter.drawRect(box(toPixel(pressedPoint_), pointer_));
    if (polygon_.empty()) return;
    QPolygonF outline;
    for (const SurfacePoint& corner : polygon_) outline << toPixel(corner);
    painter.drawPolygon(outline << pointer_);
}

} // namespace touchdown
