// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of the editor, and the numbers that are typed during a drag.
#include <algorithm>
#include <cmath>

#include <QKeyEvent>

#include "ui/slider/drag_field.h"
#include "ui/slider/part_picking.h"
#include "ui/slider/surface_editor.h"

namespace touchdown {

namespace {

constexpr double keyStep = 1e-6; // [m]

} // namespace

bool SurfaceEditor::moveByKey(const QKeyEvent& event)
{
    if (selection_.empty()) return false;
    const double step = event.modifiers().testFlag(Qt::ShiftModifier) ? 10.0 * keyStep
                        : event.modifiers().testFlag(Qt::AltModifier) ? 0.1 * keyStep
                                                                      : keyStep;
    switch (event.key()) {
    case Qt::Key_Left: nudge({-step, 0.0}); return true;
    case Qt::Key_Right: nudge({step, 0.0}); return true;
    case Qt::Key_Up: nudge({0.0, step}); return true;
    case Qt::Key_Down: nudge({0.0, -step}); return true;
    default: return false;
    }
}

bool SurfaceEditor::actByKey(const QKeyEvent& event)
{
    const auto selectRail = [&](std::size_t step) {
        const std::size_t count = committed_.rails.size();
        if (count == 0) return;
        const PartSelection rails = railsOf(selection_);
        const std::size_t from = rails.empty() ? count - step % count : rails.begin()->item;
        select({{PartKind::Rail, (from + step) % count}});
    };
    const auto selectAround = [&](PartKind kind) {
        const PartSelection rails = railsOf(selection_);
        if (rails.empty()) return;
        const std::size_t rail = rails.begin()->item, count = committed_.rails[rail].points.size();
        const SurfacePart first = *selection_.begin();
        const std::size_t step = event.modifiers().testFlag(Qt::ShiftModifier) ? count - 1 : 1;
        const bool goesOn = selection_.size() == 1 && first.kind == kind;
        select({{kind, rail, goesOn ? (first.index + step) % count : 0}});
    };
    const bool control = event.modifiers().testFlag(Qt::ControlModifier);
    if (control && event.key() == Qt::Key_A) {
        PartSelection all;
        for (std::size_t i = 0; i < committed_.rails.size(); ++i) all.insert({PartKind::Rail, i});
        select(all);
        return true;
    }
    if (control && event.key() == Qt::Key_D) return copySelected(), true;
    if (control) return false;
    switch (event.key()) {
    case Qt::Key_Escape:
        if (dragging())
            giveUp();
        else if (!measured_.empty())
            measured_.clear(), update();
        else if (tool_ != Tool::Select)
            setTool(Tool::Select);
        else
            select({});
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (tool_ != Tool::Polygon) return false;
        finishPolygon();
        return true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace: removeSelected(); return true;
    case Qt::Key_PageUp: moveInOrder(1); return true;
    case Qt::Key_PageDown: moveInOrder(-1); return true;
    case Qt::Key_M:
        if (event.modifiers().testFlag(Qt::ShiftModifier))
            mirrorSelected();
        else if (tool_ == Tool::Measure)
            chooseMeasure();
        else
            setTool(Tool::Measure);
        return true;
    case Qt::Key_L:
        if (const PartSelection rails = railsOf(selection_); rails.size() == 1) togglePair(rails.begin()->item);
        return true;
    case Qt::Key_N: selectRail(1); return true;
    case Qt::Key_B: selectRail(std::max<std::size_t>(committed_.rails.size(), 1) - 1); return true;
    case Qt::Key_E: selectAround(PartKind::Edge); return true;
    case Qt::Key_C: selectAround(PartKind::Corner); return true;
    case Qt::Key_F: fit(); return true;
    case Qt::Key_V: setTool(Tool::Select); return true;
    case Qt::Key_R: setTool(Tool::Rectangle); return true;
    case Qt::Key_P: setTool(Tool::Polygon); return true;
    default: return false;
    }
}

bool SurfaceEditor::event(QEvent* event)
{
    // Keys of the editor come before actions of the window with the same key.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool control = key->modifiers().testFlag(Qt::ControlModifier);
        const bool plain = key->modifiers() == Qt::NoModifier || key->modifiers() == Qt::KeypadModifier;
        const bool own =
            control ? key->key() == Qt::Key_A || key->key() == Qt::Key_D
            : key->key() == Qt::Key_M && key->modifiers() == Qt::ShiftModifier
                ? true
                : plain && key->key() != Qt::Key_Tab && (key->key() < Qt::Key_F1 || key->key() > Qt::Key_F35);
        if (own) event->accept();
    }
    return SurfaceView::event(event);
}

void SurfaceEditor::keyPressEvent(QKeyEvent* event)
{
    static const QString numbers = QStringLiteral("0123456789.,-−");
    if (gesture_ == Gesture::Move && !typing() && event->text().size() == 1 && numbers.contains(event->text())) {
        beginTyping(event->text());
        return;
    }
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        spaceHeld_ = true;
        updateCursor();
        return;
    }
    if (!moveByKey(*event) && !actByKey(*event)) SurfaceView::keyPressEvent(event);
}

void SurfaceEditor::keyReleaseEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        spaceHeld_ = false;
        updateCursor();
    } else {
        SurfaceView::keyReleaseEvent(event);
    }
}

void SurfaceEditor::focusOutEvent(QFocusEvent* event)
{
    spaceHeld_ = false;
    updateCursor();
    SurfaceView::focusOutEvent(event);
}

/// One number normal to a single edge, else one along x and one along y, each positive towards the pointer.
void SurfaceEditor::beginTyping(const QString& typed)
{
    const SurfacePoint to = toSlider(pointer_);
    const SurfaceShift way{to.x - pressedPoint_.x, to.y - pressedPoint_.y};
    QStringList names;
    int first = 0;
    if (selection_.size() == 1 && selection_.begin()->kind == PartKind::Edge) {
        const SurfaceShift normal = edgeNormal(committed_, *selection_.begin());
        const double sign = way.x * normal.x + way.y * normal.y < 0.0 ? -1.0 : 1.0;
        typed_ = {{sign * normal.x, sign * normal.y}};
        names << tr("normal to the edge");
    } else {
        typed_ = {{way.x < 0.0 ? -1.0 : 1.0, 0.0}, {0.0, way.y < 0.0 ? -1.0 : 1.0}};
        names << (way.x < 0.0 ? tr("← dx") : tr("→ dx")) << (way.y < 0.0 ? tr("↓ dy") : tr("↑ dy"));
        first = std::abs(way.y) > std::abs(way.x) ? 1 : 0;
    }
    waiting_.reset();
    snap_.reset();
    field_->open(pointer_.toPoint(), names, first, typed);
    if (const auto by = typedShift()) preview(movedSelection(*by));
}

std::optional<SurfaceShift> SurfaceEditor::typedShift() const
{
    const auto distances = field_->distances();
    if (!typing() || !distances || distances->size() != typed_.size()) return {};
    SurfaceShift by;
    for (std::size_t i = 0; i < typed_.size(); ++i) {
        by.x += (*distances)[i] * typed_[i].x;
        by.y += (*distances)[i] * typed_[i].y;
    }
    return by;
}

void SurfaceEditor::stopTyping()
{
    if (!typing()) return;
    typed_.clear();
    field_->hide();
    setFocus();
}

} // namespace touchdown
