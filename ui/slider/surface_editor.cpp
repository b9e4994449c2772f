// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/surface_editor.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/numerics/cell_grid.h"
#include "core/physics/slider/meeting_walls.h"
#include "core/physics/slider/short_edges.h"
#include "core/physics/slider/surface_symmetry.h"
#include "ui/slider/drag_field.h"
#include "ui/slider/part_picking.h"
#include "ui/slider/wall_menu.h"

namespace touchdown {

namespace {

constexpr int previewInterval = 40;  // between two pictures of a drag [ms]
constexpr double copyOffset = 10e-6; // [m]

} // namespace

SurfaceEditor::SurfaceEditor(QWidget* parent) : SurfaceView(parent), field_(new DragField(this))
{
    connect(field_, &DragField::changed, this, [this] {
        if (const auto by = typedShift()) preview(movedSelection(*by));
    });
    connect(field_, &DragField::taken, this, [this] {
        if (const auto by = typedShift()) endMove(*by);
    });
    connect(field_, &DragField::givenBack, this, &SurfaceEditor::giveUp);
    previewTimer_.setSingleShot(true);
    connect(&previewTimer_, &QTimer::timeout, this, &SurfaceEditor::previewWaiting);
    setAccessibleDescription(
        tr("Arrow keys move what is selected by 1 µm, with Shift by 10 µm, with Alt by 0.1 µm. Ctrl+A selects all "
           "rails, N and B the next and previous one, E and C the next edge and corner of a rail, Del removes, Ctrl+D "
           "copies, Shift+M mirrors, L breaks or joins the "
           "pair, Page Up and Page Down change the order of overlap, M measures between two selected corners, F shows "
           "everything, the menu key has more."));
}

void SurfaceEditor::setCase(const AirBearingSurface& surface, double length, double width)
{
    gesture_ = Gesture::None;
    snap_.reset();
    stopTyping();
    single_ = sameRails(committed_, surface, single_);
    committed_ = surface;
    showSurface(surface, length, width);
    hovered_.reset();
    PartSelection kept;
    std::ranges::copy_if(selection_, std::inserter(kept, kept.end()),
                         [&](const SurfacePart& part) { return has(surface, part); });
    select(kept);
    findLinks();
    updateCursor();
}

void SurfaceEditor::open()
{
    single_.clear();
    measured_.clear();
    polygon_.clear();
    snap_.reset();
    select({});
    findLinks();
    setGhost(committed_);
}

void SurfaceEditor::setGhost(const AirBearingSurface& surface)
{
    ghost_ = surface;
    ghostWarnings_ = surfaceProblems(surface).empty() ? findWarnings(surface) : std::vector<SurfaceProblem>{};
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
    if (tool == Tool::Measure) chooseMeasure();
    updateCursor();
    update();
    emit toolChanged();
}

void SurfaceEditor::commit(const AirBearingSurface& surface, const QString& text, int merge)
{
    gesture_ = Gesture::None;
    snap_.reset();
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
    warnings_ = problems_.empty() ? findWarnings(surface) : std::vector<SurfaceProblem>{};
}

std::vector<SurfaceProblem> SurfaceEditor::findWarnings(const AirBearingSurface& surface) const
{
    std::vector<SurfaceProblem> found = surfaceWarnings(surface, area().width(), area().height());
    std::ranges::move(meetingWalls(surface), std::back_inserter(found));
    if (gridOf_) std::ranges::move(shortEdges(surface, gridOf_(surface)), std::back_inserter(found));
    return found;
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
    stopTyping();
    snap_.reset();
    if (previewing) preview(committed_);
    updateCursor();
    update();
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

void SurfaceEditor::makeSymmetric()
{
    const PartSelection rails = railsOf(selection_);
    if (rails.empty() || dragging()) return;
    commit(madeSymmetric(committed_, rails, area().height(), pairReach),
           tr("make %1 symmetric").arg(selectionText(rails)));
}

void SurfaceEditor::chooseWall(int wall)
{
    PartSelection parts;
    std::ranges::copy_if(selection_, std::inserter(parts, parts.end()), [](const SurfacePart& part) {
        return part.kind == PartKind::Edge || part.kind == PartKind::Rail;
    });
    if (parts.empty() || dragging()) return;
    const bool added = wall > static_cast<int>(committed_.walls.size());
    commit(withChosenWall(committed_, parts, wall), tr("wall of %1").arg(selectionText(parts)));
    if (added) emit wallWanted(wall);
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

} // namespace touchdown
