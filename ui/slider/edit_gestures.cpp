// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/edit_gestures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>

#include "ui/slider/drag_field.h"
#include "ui/slider/part_picking.h"

namespace touchdown {

namespace {

constexpr int previewInterval = 40;  // between two pictures of a drag [ms]
constexpr double snapReach = 7.0;    // [px]
constexpr double placeRaster = 1e-6; // [m]
constexpr double closing = 8.0;      // of a polygon: from its first corner [px]

bool isSpace(const QEvent& event)
{
    const auto& key = static_cast<const QKeyEvent&>(event);
    return key.key() == Qt::Key_Space && !key.isAutoRepeat();
}

bool far(const QPointF& from, const QPointF& to)
{
    return (to - from).manhattanLength() >= QApplication::startDragDistance();
}

} // namespace

EditGestures::EditGestures(SurfaceView& plan, SurfaceSelection& selection)
    : plan_(plan), selection_(selection), field_(new DragField(&plan))
{
    connect(field_, &DragField::changed, this, &EditGestures::previewTyped);
    connect(field_, &DragField::taken, this, &EditGestures::takeTyped);
    connect(field_, &DragField::givenBack, this, &EditGestures::giveUp);
    previewTimer_.setSingleShot(true);
    connect(&previewTimer_, &QTimer::timeout, this, &EditGestures::previewWaiting);
    plan.installEventFilter(this);
}

bool EditGestures::eventFilter(QObject* /*watched*/, QEvent* event)
{
    const auto mouse = [event]() -> const QMouseEvent& { return *static_cast<QMouseEvent*>(event); };
    switch (event->type()) {
    case QEvent::MouseButtonPress: return press(mouse()), true;
    case QEvent::MouseMove: return !move(mouse());
    case QEvent::MouseButtonRelease: return release(mouse()), true;
    case QEvent::MouseButtonDblClick: return !doubleClick(mouse());
    case QEvent::Leave: return leave(), false;
    case QEvent::FocusOut: return holdSpace(false), false;
    case QEvent::KeyPress: return type(static_cast<QKeyEvent*>(event)->text()) || (isSpace(*event) && holdSpace(true));
    case QEvent::KeyRelease: return isSpace(*event) && holdSpace(false);
    default: return false;
    }
}

void EditGestures::begin(Gesture gesture)
{
    gesture_ = gesture;
    marks_.dragging = gesture != Gesture::None;
    selection_.hold(marks_.dragging);
    marks_.boxFrom.reset();
    if (gesture == Gesture::Band || gesture == Gesture::Rectangle) marks_.boxFrom = pressedPoint_;
}

void EditGestures::end()
{
    begin(Gesture::None);
    marks_.shift = {};
    marks_.snap.reset();
    marks_.hovered.reset();
    stopTyping();
    updateCursor();
}

void EditGestures::open()
{
    end();
    marks_.measured.clear();
    marks_.polygon.clear();
    marks_.snap.reset();
}

void EditGestures::giveUp()
{
    const bool previewing = moving();
    end();
    if (previewing) emit previewed(selection_.surface());
    plan_.update();
}

bool EditGestures::stepBack()
{
    if (dragging()) return giveUp(), true;
    if (!marks_.measured.empty()) return marks_.measured.clear(), plan_.update(), true;
    if (tool_ == Tool::Select) return false;
    return setTool(Tool::Select), true;
}

void EditGestures::setTool(Tool tool)
{
    if (tool == tool_) return;
    giveUp();
    marks_.polygon.clear();
    tool_ = tool;
    if (tool == Tool::Measure) measureSelection();
    updateCursor();
    plan_.update();
    emit toolChanged();
}

bool EditGestures::holdSpace(bool held)
{
    spaceHeld_ = held;
    updateCursor();
    return true;
}

void EditGestures::updateCursor()
{
    const auto& hovered = marks_.hovered;
    const Qt::CursorShape shape = gesture_ == Gesture::View               ? Qt::ClosedHandCursor
                                  : spaceHeld_                            ? Qt::OpenHandCursor
                                  : moving()                              ? Qt::SizeAllCursor
                                  : tool_ != Tool::Select                 ? Qt::CrossCursor
                                  : linkAt(marks_.pointer)                ? Qt::PointingHandCursor
                                  : !hovered                              ? Qt::ArrowCursor
                                  : selection_.parts().contains(*hovered) ? Qt::SizeAllCursor
                                                                          : Qt::PointingHandCursor;
    plan_.setCursor(shape);
}

SnapGrid EditGestures::snapGrid() const
{
    const double metre = plan_.toPixel({1.0, 0.0}).x() - plan_.toPixel({0.0, 0.0}).x(); // [px/m]
    return {plan_.area().width(), plan_.area().height(), snapReach / metre, placeRaster};
}

SurfacePoint EditGestures::snappedAt(const QMouseEvent& event)
{
    const SurfacePoint at = plan_.toSlider(event.position());
    const bool snaps = snapping_ && !event.modifiers().testFlag(Qt::ControlModifier);
    marks_.snap =
        snaps ? snappedTo(marks_.drawing, selection_.surface(), {}, at, snapGrid()) : SnappedPlace{at, {}, {}, {}, {}};
    return marks_.snap->at;
}

SurfaceShift EditGestures::wantedShift(const QMouseEvent& event)
{
    const SurfacePoint to = plan_.toSlider(event.position());
    SurfaceShift by{to.x - pressedPoint_.x, to.y - pressedPoint_.y};
    marks_.snap.reset();
    if (event.modifiers().testFlag(Qt::ShiftModifier)) (std::abs(by.x) > std::abs(by.y) ? by.y : by.x) = 0.0;
    if (!snapping_ || event.modifiers().testFlag(Qt::ControlModifier) || !grabbed_) return by;
    const AirBearingSurface& surface = selection_.surface();
    const SurfacePoint from = placeOf(surface, *grabbed_, pressedPoint_);
    bool alongX = by.x != 0.0, alongY = by.y != 0.0;
    if (const auto edge = selection_.oneEdge()) {
        // An edge moves normal to itself: along x or y it snaps that way, slanted it does not.
        const SurfaceShift normal = edgeNormal(surface, *edge);
        if (normal.x != 0.0 && normal.y != 0.0) return by;
        alongX = alongX && normal.x != 0.0;
        alongY = alongY && normal.y != 0.0;
    }
    SnappedPlace place =
        snappedTo(marks_.drawing, surface, selection_.parts(), {from.x + by.x, from.y + by.y}, snapGrid());
    if (!alongX) place.at.x = from.x, place.x = SnapTarget::None;
    if (!alongY) place.at.y = from.y, place.y = SnapTarget::None;
    marks_.snap = place;
    return {place.at.x - from.x, place.at.y - from.y};
}

void EditGestures::press(const QMouseEvent& event)
{
    if (typing()) return takeTyped(); // a click beside the numbers takes them
    if (dragging()) return;
    pressedAt_ = marks_.pointer = event.position();
    pressedPoint_ = plan_.toSlider(pressedAt_);
    if (event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && spaceHeld_)) {
        begin(Gesture::View);
        return updateCursor();
    }
    if (event.button() != Qt::LeftButton || !plan_.planArea().contains(pressedAt_)) return;
    switch (tool_) {
    case Tool::Polygon: return addPolygonCorner(snappedAt(event));
    case Tool::Rectangle: pressedPoint_ = snappedAt(event); return begin(Gesture::Rectangle);
    case Tool::Measure: addMeasured(snappedAt(event)); return begin(Gesture::Measure);
    case Tool::Select: break;
    }
    if (const auto link = linkAt(pressedAt_))
        selection_.togglePair(*link);
    else
        selectAt(event);
}

void EditGestures::selectAt(const QMouseEvent& event)
{
    grabbed_ = partAt(plan_, selection_.surface(), event.position(), selection_.parts());
    begin(grabbed_ ? Gesture::Pressed : Gesture::Band);
    addedByPress_ = false;
    const bool adds = event.modifiers().testFlag(Qt::ShiftModifier);
    if (!grabbed_) {
        if (!adds) selection_.select({});
        return;
    }
    if (selection_.parts().contains(*grabbed_)) return;
    PartSelection parts = adds ? selection_.parts() : PartSelection{};
    parts.insert(*grabbed_);
    addedByPress_ = true;
    selection_.select(parts);
}

bool EditGestures::move(const QMouseEvent& event)
{
    const QPointF last = std::exchange(marks_.pointer, event.position());
    if (gesture_ == Gesture::View) return plan_.pan(event.position() - last), false;
    if (gesture_ == Gesture::Pressed && far(pressedAt_, event.position())) begin(Gesture::Move), updateCursor();
    if (moving()) {
        if (typing()) return false;
        marks_.shift = selection_.shiftOf(*(waiting_ = wantedShift(event)));
        if (!previewTimer_.isActive()) previewWaiting();
        return false;
    }
    if (tool_ != Tool::Select) snappedAt(event);
    if (!dragging()) {
        marks_.hovered.reset();
        if (tool_ == Tool::Select && plan_.planArea().contains(event.position()) && !linkAt(event.position()))
            marks_.hovered = partAt(plan_, selection_.surface(), event.position(), selection_.parts());
        updateCursor();
    }
    plan_.update();
    return !dragging();
}

void EditGestures::leave()
{
    if (dragging()) return;
    marks_.snap.reset();
    marks_.hovered.reset();
    plan_.update();
}

void EditGestures::release(const QMouseEvent& event)
{
    const Gesture ended = gesture_;
    if (ended == Gesture::Move) {
        if (!typing()) endMove(wantedShift(event)); // else the numbers are still to come
        return;
    }
    const SurfacePoint to = plan_.toSlider(event.position());
    const bool adds = event.modifiers().testFlag(Qt::ShiftModifier);
    PartSelection parts = selection_.parts();
    begin(Gesture::None);
    switch (ended) {
    case Gesture::Measure:
        if (far(pressedAt_, event.position())) addMeasured(snappedAt(event));
        break;
    case Gesture::Pressed:
        if (addedByPress_) break;
        parts.erase(*grabbed_);
        selection_.select(adds ? parts : PartSelection{*grabbed_});
        break;
    case Gesture::Band: {
        const QRectF box(QPointF(pressedPoint_.x, pressedPoint_.y), QPointF(to.x, to.y));
        PartSelection found = partsWithin(selection_.surface(), box.normalized());
        if (adds) found.merge(parts);
        selection_.select(found);
        break;
    }
    case Gesture::Rectangle: {
        const SurfacePoint a = pressedPoint_, b = snappedAt(event);
        if (a.x != b.x && a.y != b.y) addRail({a, {b.x, a.y}, b, {a.x, b.y}});
        break;
    }
    default: break;
    }
    updateCursor();
    plan_.update();
}

bool EditGestures::doubleClick(const QMouseEvent& event)
{
    if (tool_ == Tool::Polygon) return finishPolygon(), false;
    const AirBearingSurface& surface = selection_.surface();
    const auto part = partAt(plan_, surface, event.position(), selection_.parts());
    if (tool_ != Tool::Select || !part) return tool_ == Tool::Select;
    if (part->kind != PartKind::Edge) return false;
    begin(Gesture::None);
    const SurfacePoint at = plan_.toSlider(event.position());
    selection_.insertCorner(part->item, part->index, placeOnEdge(surface, *part, at, snapping_ ? placeRaster : 0.0));
    return false;
}

std::optional<std::size_t> EditGestures::linkAt(const QPointF& pixel) const
{
    if (tool_ != Tool::Select || dragging()) return {};
    return touchdown::linkAt(plan_, selection_.pairLinks(), pixel);
}

void EditGestures::previewWaiting()
{
    if (!moving() || !waiting_) return;
    emit previewed(selection_.moved(*std::exchange(waiting_, std::nullopt)));
    const SurfacePoint point = plan_.toSlider(marks_.pointer);
    emit plan_.pointed(plan_.onSlider(point) ? std::optional(point) : std::nullopt);
    previewTimer_.start(previewInterval);
}

void EditGestures::endMove(SurfaceShift by)
{
    end();
    if (!selection_.move(by)) emit previewed(selection_.surface());
    plan_.update();
}

bool EditGestures::type(const QString& text)
{
    static const QString numbers = QStringLiteral("0123456789.,-−");
    if (!moving() || typing() || text.size() != 1 || !numbers.contains(text)) return false;
    const SurfacePoint to = plan_.toSlider(marks_.pointer);
    return openField(text, {to.x - pressedPoint_.x, to.y - pressedPoint_.y}), true;
}

void EditGestures::askForShift()
{
    if (selection_.parts().empty() || dragging()) return;
    setTool(Tool::Select);
    const SurfacePart& first = *selection_.parts().begin();
    pressedPoint_ = placeOf(selection_.surface(), first, {});
    marks_.pointer = plan_.toPixel(pressedPoint_);
    begin(Gesture::Move);
    openField(QStringLiteral("0"), {});
    field_->selectText();
}

/// One number normal to a single edge, else one along x and one along y.
void EditGestures::openField(const QString& text, SurfaceShift way)
{
    std::vector<DragWay> ways;
    int first = 0;
    if (const auto edge = selection_.oneEdge()) {
        const SurfaceShift normal = edgeNormal(selection_.surface(), *edge);
        const double sign = way.x * normal.x + way.y * normal.y < 0.0 ? -1.0 : 1.0;
        ways = {{tr("normal to the edge"), {sign * normal.x, sign * normal.y}}};
    } else {
        ways = {way.x < 0.0 ? DragWay{tr("← dx"), {-1.0, 0.0}} : DragWay{tr("→ dx"), {1.0, 0.0}},
                way.y < 0.0 ? DragWay{tr("↓ dy"), {0.0, -1.0}} : DragWay{tr("↑ dy"), {0.0, 1.0}}};
        first = std::abs(way.y) > std::abs(way.x) ? 1 : 0;
    }
    waiting_ = marks_.shift = {};
    marks_.snap.reset();
    field_->open(marks_.pointer.toPoint(), ways, first, text);
    previewTyped();
}

bool EditGestures::typing() const { return !field_->isHidden(); }

void EditGestures::previewTyped()
{
    if (const auto by = field_->shift()) emit previewed(selection_.moved(*by));
}

void EditGestures::takeTyped()
{
    if (const auto by = field_->shift()) endMove(*by);
}

void EditGestures::stopTyping()
{
    if (!typing()) return;
    field_->hide();
    plan_.setFocus();
}

void EditGestures::measureSelection()
{
    const std::vector<SurfacePoint> places = placesToMeasure(selection_.surface(), selection_.parts());
    if (places.size() == 2) marks_.measured = places;
    plan_.update();
}

void EditGestures::addMeasured(const SurfacePoint& at)
{
    if (marks_.measured.size() == 2) marks_.measured.clear();
    if (marks_.measured.empty() || marks_.measured.front() != at) marks_.measured.push_back(at);
    plan_.update();
}

void EditGestures::addPolygonCorner(const SurfacePoint& at)
{
    std::vector<SurfacePoint>& corners = marks_.polygon;
    if (corners.size() > 2 && (plan_.toPixel(at) - plan_.toPixel(corners.front())).manhattanLength() < closing)
        return finishPolygon();
    if (corners.empty() || corners.back() != at) corners.push_back(at);
    plan_.update();
}

void EditGestures::finishPolygon()
{
    const std::vector<SurfacePoint> corners = std::exchange(marks_.polygon, {});
    corners.size() > 2 ? addRail(corners) : setTool(Tool::Select);
}

void EditGestures::addRail(const std::vector<SurfacePoint>& corners)
{
    marks_.snap.reset();
    selection_.addRail(corners);
    setTool(Tool::Select);
}

} // namespace touchdown
