// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/surface_editor.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>

#include "core/numerics/cell_grid.h"
#include "core/physics/slider/meeting_walls.h"
#include "core/physics/slider/short_edges.h"
#include "ui/slider/part_picking.h"

namespace touchdown {

namespace {

constexpr int previewInterval = 40;  // between two pictures of a drag [ms]
constexpr double keyStep = 1e-6;     // [m]
constexpr double copyOffset = 10e-6; // [m]
constexpr double pairReach = 0.1e-6; // within which rails are mirror images [m]

PartSelection railsOf(const PartSelection& parts)
{
    PartSelection rails;
    for (const SurfacePart& part : parts)
        if (part.kind != PartKind::Interest) rails.insert({PartKind::Rail, part.item});
    return rails;
}

} // namespace

SurfaceEditor::SurfaceEditor(QWidget* parent) : SurfaceView(parent)
{
    previewTimer_.setSingleShot(true);
    connect(&previewTimer_, &QTimer::timeout, this, &SurfaceEditor::previewWaiting);
    setAccessibleDescription(tr(
        "Arrow keys move what is selected by 1 µm, with Shift by 10 µm, with Alt by 0.1 µm. Ctrl+A selects all "
        "rails, N and B the next and previous one, Del removes, Ctrl+D copies, M mirrors, Page Up and Page Down change "
        "the order of overlap, F shows everything."));
}

void SurfaceEditor::setCase(const AirBearingSurface& surface, double length, double width)
{
    gesture_ = Gesture::None;
    committed_ = surface;
    showSurface(surface, length, width);
    hovered_.reset();
    PartSelection kept;
    std::ranges::copy_if(selection_, std::inserter(kept, kept.end()),
                         [&](const SurfacePart& part) { return has(surface, part); });
    select(kept);
    updateCursor();
}

void SurfaceEditor::setGhost(const AirBearingSurface& surface)
{
    ghost_ = surface;
    update();
}

void SurfaceEditor::setInfluence(const std::vector<std::pair<SurfacePart, double>>& influence)
{
    influence_ = influence;
    update();
}

void SurfaceEditor::select(const PartSelection& parts)
{
    if (parts == selection_) return;
    selection_ = parts;
    ++nudges_;
    update();
    emit selectionChanged();
}

void SurfaceEditor::setTool(Tool tool)
{
    if (tool == tool_) return;
    giveUp();
    polygon_.clear();
    tool_ = tool;
    updateCursor();
    update();
    emit toolChanged();
}

void SurfaceEditor::commit(const AirBearingSurface& surface, const QString& text, int merge)
{
    gesture_ = Gesture::None;
    if (merge == 0) ++nudges_;
    if (surface == committed_) {
        preview(committed_);
        return;
    }
    emit edited(surface, text, merge);
}

void SurfaceEditor::showSurface(const AirBearingSurface& surface, double length, double width)
{
    setSurface(surface, length, width, gesture_ == Gesture::Move);
    problems_ = surfaceProblems(surface);
    warnings_.clear();
    if (!problems_.empty()) return;
    warnings_ = surfaceWarnings(surface, length, width);
    std::ranges::move(meetingWalls(surface), std::back_inserter(warnings_));
    if (gridOf_) std::ranges::move(shortEdges(surface, gridOf_(surface)), std::back_inserter(warnings_));
}

void SurfaceEditor::preview(const AirBearingSurface& surface)
{
    showSurface(surface, area().width(), area().height());
    emit previewed(surface);
}

void SurfaceEditor::previewWaiting()
{
    if (gesture_ != Gesture::Move || !waiting_) return;
    preview(movedSelection(*std::exchange(waiting_, std::nullopt)));
    const SurfacePoint point = toSlider(pointer_);
    emit pointed(onSlider(point) ? std::optional(point) : std::nullopt);
    previewTimer_.start(previewInterval);
}

void SurfaceEditor::giveUp()
{
    const bool previewing = std::exchange(gesture_, Gesture::None) == Gesture::Move;
    if (previewing) preview(committed_);
    updateCursor();
    update();
}

AirBearingSurface SurfaceEditor::movedSelection(SurfaceShift by) const
{
    return pairs_ ? movedInPairs(committed_, selection_, by, area().height(), pairReach)
                  : moved(committed_, selection_, by);
}

void SurfaceEditor::nudge(SurfaceShift by)
{
    if (selection_.empty() || dragging()) return;
    commit(movedSelection(by), tr("move %1").arg(selectionText(selection_)), nudges_ + 1);
}

void SurfaceEditor::removeSelected()
{
    if (selection_.empty() || dragging()) return;
    commit(without(committed_, selection_), tr("delete %1").arg(selectionText(selection_)));
}

void SurfaceEditor::copySelected()
{
    const PartSelection rails = railsOf(selection_);
    if (rails.empty() || dragging()) return;
    const std::size_t count = committed_.rails.size();
    commit(withCopies(committed_, rails, {copyOffset, copyOffset}), tr("copy %1").arg(selectionText(rails)));
    PartSelection copies;
    for (std::size_t i = count; i < committed_.rails.size(); ++i) copies.insert({PartKind::Rail, i});
    select(copies);
}

void SurfaceEditor::mirrorSelected()
{
    PartSelection parts = railsOf(selection_);
    for (const SurfacePart& part : selection_)
        if (part.kind == PartKind::Interest) parts.insert(part);
    if (parts.empty() || dragging()) return;
    commit(mirrored(committed_, parts, area().height()), tr("mirror %1").arg(selectionText(parts)));
}

void SurfaceEditor::moveInOrder(int places)
{
    const PartSelection rails = railsOf(selection_);
    if (rails.size() != 1 || dragging()) return;
    const std::size_t rail = rails.begin()->item;
    const auto last = static_cast<std::ptrdiff_t>(committed_.rails.size()) - 1;
    const auto place =
        static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(rail) + places, 0, last));
    if (place == rail) return;
    commit(reordered(committed_, rail, place), places > 0 ? tr("move %1 forward").arg(partText(*rails.begin()))
                                                          : tr("move %1 backward").arg(partText(*rails.begin())));
    select({{PartKind::Rail, place}});
}

void SurfaceEditor::insertCorner(std::size_t rail, std::size_t edge, SurfacePoint at)
{
    if (dragging() || !has(committed_, {PartKind::Edge, rail, edge})) return;
    commit(withCorner(committed_, rail, edge, at), tr("insert a corner into %1").arg(partText({PartKind::Rail, rail})));
    select({{PartKind::Corner, rail, edge + 1}});
}

void SurfaceEditor::addOutline(const std::vector<SurfacePoint>& corners)
{
    const PartSelection rails = railsOf(selection_);
    Rail rail;
    rail.recess[0] = rails.empty() || rails.begin()->item >= committed_.rails.size()
                         ? 0.0
                         : committed_.rails[rails.begin()->item].recess[0];
    for (const SurfacePoint& corner : corners) rail.points.push_back({corner.x, corner.y, 0});
    AirBearingSurface surface = committed_;
    surface.rails.push_back(std::move(rail));
    const std::size_t added = surface.rails.size() - 1;
    commit(surface, tr("add %1").arg(partText({PartKind::Rail, added})));
    setTool(Tool::Select);
    if (has(committed_, {PartKind::Rail, added})) select({{PartKind::Rail, added}});
}

void SurfaceEditor::addPolygonCorner(const SurfacePoint& at)
{
    constexpr double same = 8.0; // [px]
    if (polygon_.size() > 2 && (toPixel(at) - toPixel(polygon_.front())).manhattanLength() < same) {
        finishPolygon();
        return;
    }
    if (polygon_.empty() || polygon_.back() != at) polygon_.push_back(at);
    update();
}

void SurfaceEditor::finishPolygon()
{
    const std::vector<SurfacePoint> corners = std::exchange(polygon_, {});
    if (corners.size() > 2)
        addOutline(corners);
    else
        setTool(Tool::Select);
}

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
    case Qt::Key_M: mirrorSelected(); return true;
    case Qt::Key_N: selectRail(1); return true;
    case Qt::Key_B: selectRail(std::max<std::size_t>(committed_.rails.size(), 1) - 1); return true;
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
        const bool own = control ? key->key() == Qt::Key_A || key->key() == Qt::Key_D
                                 : key->modifiers() == Qt::NoModifier && key->key() != Qt::Key_Tab &&
                                       (key->key() < Qt::Key_F1 || key->key() > Qt::Key_F35);
        if (own) event->accept();
    }
    return SurfaceView::event(event);
}

void SurfaceEditor::keyPressEvent(QKeyEvent* event)
{
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

void SurfaceEditor::contextMenuEvent(QContextMenuEvent* event)
{
    if (dragging() || tool_ != Tool::Select) return;
    const QPointF pixel = event->reason() == QContextMenuEvent::Mouse ? QPointF(event->pos()) : QPointF(-1.0, -1.0);
    const auto part = partAt(*this, committed_, pixel, selection_);
    if (part && !selection_.contains(*part) && !selection_.contains({PartKind::Rail, part->item})) select({*part});
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (part && part->kind == PartKind::Edge)
        menu->addAction(tr("Insert a corner here"), this,
                        [this, edge = *part, at = toSlider(pixel)] { insertCorner(edge.item, edge.index, at); });
    const auto add = [&](const QString& text, auto perform) {
        menu->addAction(text, this, perform)->setEnabled(!selection_.empty());
    };
    add(tr("Copy") + QStringLiteral("\tCtrl+D"), [this] { copySelected(); });
    add(tr("Mirror about the centre line") + QStringLiteral("\tM"), [this] { mirrorSelected(); });
    add(tr("Forward") + QStringLiteral("\tPgUp"), [this] { moveInOrder(1); });
    add(tr("Backward") + QStringLiteral("\tPgDown"), [this] { moveInOrder(-1); });
    menu->addSeparator();
    add(tr("Delete") + QStringLiteral("\tDel"), [this] { removeSelected(); });
    menu->popup(event->globalPos());
}

} // namespace touchdown
