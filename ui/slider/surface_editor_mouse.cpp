// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gestures of the mouse.
#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QMouseEvent>

#include "ui/slider/part_picking.h"
#include "ui/slider/surface_editor.h"

namespace touchdown {

namespace {

constexpr double snapReach = 7.0;    // [px]
constexpr double placeRaster = 1e-6; // [m]

QRectF box(const QPointF& a, const QPointF& b) { return QRectF(a, b).normalized(); }

} // namespace

SnapGrid SurfaceEditor::snapGrid() const
{
    const double metre = toPixel({1.0, 0.0}).x() - toPixel({0.0, 0.0}).x(); // [px/m]
    return {area().width(), area().height(), snapReach / metre, placeRaster};
}

SurfacePoint SurfaceEditor::snappedAt(const QPointF& pixel, Qt::KeyboardModifiers modifiers)
{
    const SurfacePoint at = toSlider(pixel);
    const bool snaps = snapping_ && !modifiers.testFlag(Qt::ControlModifier);
    snap_ = snaps ? snapped(committed_, {}, at, snapGrid()) : SnappedPlace{at, {}, {}, {}, {}};
    return snap_->at;
}

SurfaceShift SurfaceEditor::wantedShift(const QMouseEvent& event)
{
    const SurfacePoint to = toSlider(event.position());
    SurfaceShift by{to.x - pressedPoint_.x, to.y - pressedPoint_.y};
    snap_.reset();
    if (event.modifiers().testFlag(Qt::ShiftModifier)) (std::abs(by.x) > std::abs(by.y) ? by.y : by.x) = 0.0;
    if (!snapping_ || event.modifiers().testFlag(Qt::ControlModifier) || !grabbed_) return by;
    const SurfacePoint from = placeOf(committed_, *grabbed_, pressedPoint_);
    SnappedPlace place = snapped(committed_, selection_, {from.x + by.x, from.y + by.y}, snapGrid());
    if (by.x == 0.0) place.at.x = from.x, place.x = SnapTarget::None;
    if (by.y == 0.0) place.at.y = from.y, place.y = SnapTarget::None;
    if (selection_.size() == 1 && selection_.begin()->kind == PartKind::Edge) {
        // An edge moves normal to itself: along x or y it snaps that way, slanted it does not.
        const SurfaceShift normal = edgeNormal(committed_, *selection_.begin());
        if (normal.x != 0.0 && normal.y != 0.0) return by;
        if (normal.x == 0.0) place.at.x = from.x, place.x = SnapTarget::None;
        if (normal.y == 0.0) place.at.y = from.y, place.y = SnapTarget::None;
    }
    snap_ = place;
    return {place.at.x - from.x, place.at.y - from.y};
}

void SurfaceEditor::endMove(SurfaceShift by)
{
    const AirBearingSurface surface = movedSelection(by);
    stopTyping();
    commit(surface, tr("move %1").arg(selectionText(selection_)));
    updateCursor();
    update();
}

void SurfaceEditor::mousePressEvent(QMouseEvent* event)
{
    if (typing()) { // a click beside the numbers takes them
        if (const auto by = typedShift()) endMove(*by);
        return;
    }
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
    else if (tool_ == Tool::Measure)
        addMeasured(snappedAt(event->position(), event->modifiers())), gesture_ = Gesture::Measure;
    else if (const auto link = linkAt(pressedAt_))
        togglePair(*link);
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
        if (typing()) return;
        waiting_ = wantedShift(*event);
        if (!previewTimer_.isActive()) previewWaiting();
        return;
    }
    if (tool_ != Tool::Select) snappedAt(event->position(), event->modifiers());
    if (gesture_ == Gesture::None) {
        const auto under = tool_ == Tool::Select && planArea().contains(event->position())
                               ? partAt(*this, committed_, event->position(), selection_)
                               : std::nullopt;
        hovered_ = linkAt(event->position()) ? std::nullopt : under;
        updateCursor();
        SurfaceView::mouseMoveEvent(event);
    }
    update();
}

void SurfaceEditor::leaveEvent(QEvent* event)
{
    if (!dragging()) {
        snap_.reset();
        hovered_.reset();
        update();
    }
    SurfaceView::leaveEvent(event);
}

void SurfaceEditor::mouseReleaseEvent(QMouseEvent* event)
{
    const Gesture ended = gesture_;
    switch (ended) {
    case Gesture::View:
        gesture_ = Gesture::None;
        updateCursor();
        return;
    case Gesture::Move:
        if (!typing()) endMove(wantedShift(*event)); // else the numbers are still to come
        break;
    case Gesture::Measure:
        gesture_ = Gesture::None;
        if ((event->position() - pressedAt_).manhattanLength() >= QApplication::startDragDistance())
            addMeasured(snappedAt(event->position(), event->modifiers()));
        break;
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
    else if (linkAt(pointer_))
        setCursor(Qt::PointingHandCursor);
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
    if (hovered_ && hovered_->kind != PartKind::Rail && !dragging()) parts << partText(*hovered_);
    return parts;
}

} // namespace touchdown
