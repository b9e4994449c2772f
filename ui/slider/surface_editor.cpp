// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/surface_editor.h"

#include <algorithm>
#include <iterator>

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>

#include "core/numerics/cell_grid.h"
#include "core/physics/slider/meeting_walls.h"
#include "core/physics/slider/short_edges.h"
#include "core/physics/slider/surface_relations.h"
#include "ui/plot/picture_widget.h"
#include "ui/plot/plot_frame.h"
#include "ui/slider/array_dialog.h"
#include "ui/slider/cell_painting.h"
#include "ui/slider/part_picking.h"
#include "ui/slider/wall_menu.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr double keyStep = 1e-6; // [m]

QString influenceUnit() { return QStringLiteral("nm per 10 nm"); }

} // namespace

SurfaceEditor::SurfaceEditor(QWidget* parent)
    : SurfaceView(parent), gestures_(*this, selection_), underlay_(new Underlay(this))
{
    setAcceptDrops(true);
    connect(underlay_, &Underlay::changed, this, [this] {
        std::vector<SurfacePoint> corners;
        if (underlay_->shown())
            for (const DrawnPath& path : underlay_->paths())
                std::ranges::copy(path.points, std::back_inserter(corners));
        gestures_.setDrawing(std::move(corners));
        update();
    });
    connect(&selection_, &SurfaceSelection::edited, this, &SurfaceEditor::edited);
    connect(&selection_, &SurfaceSelection::wallWanted, this, &SurfaceEditor::wallWanted);
    connect(&selection_, &SurfaceSelection::linksChanged, this, qOverload<>(&QWidget::update));
    connect(&selection_, &SurfaceSelection::changed, this, [this] {
        update();
        emit selectionChanged();
    });
    connect(&gestures_, &EditGestures::toolChanged, this, &SurfaceEditor::toolChanged);
    connect(&gestures_, &EditGestures::previewed, this, [this](const AirBearingSurface& surface) {
        showSurface(surface, area().width(), area().height());
        emit previewed(surface);
    });
    setAccessibleDescription(
        tr("Arrow keys move what is selected by 1 µm, with Shift by 10 µm, with Alt by 0.1 µm. Ctrl+A selects all "
           "rails, N and B the next and previous one, E and C the next edge and corner of a rail, Del removes, Ctrl+D "
           "copies, Shift+M makes mirrored copies, K keeps the distance of two selected parts, L breaks or joins the "
           "pair, Page Up and Page Down change the order of overlap, M measures between two selected corners, F shows "
           "everything, the menu key has more."));
}

void SurfaceEditor::setCase(const AirBearingSurface& surface, double length, double width)
{
    gestures_.end();
    showSurface(surface, length, width);
    selection_.setSurface(surface, width);
    gestures_.updateCursor();
}

void SurfaceEditor::open()
{
    gestures_.open();
    selection_.open();
    setGhost(committed());
}

void SurfaceEditor::setGhost(const AirBearingSurface& surface)
{
    ghost_ = surface;
    ghostWarnings_ = surfaceProblems(surface).empty() ? findWarnings(surface) : std::vector<SurfaceProblem>{};
    update();
}

void SurfaceEditor::setInfluence(const ShownInfluence& influence)
{
    influence_ = influence;
    update();
}

void SurfaceEditor::showSurface(const AirBearingSurface& surface, double length, double width)
{
    setSurface(surface, length, width, gestures_.moving());
    problems_ = surfaceProblems(surface);
    warnings_ = problems_.empty() ? findWarnings(surface) : std::vector<SurfaceProblem>{};
}

std::vector<SurfaceProblem> SurfaceEditor::findWarnings(const AirBearingSurface& surface) const
{
    std::vector<SurfaceProblem> found = surfaceWarnings(surface, area().width(), area().height());
    std::ranges::move(relationProblems(surface, area().height()), std::back_inserter(found));
    std::ranges::move(meetingWalls(surface), std::back_inserter(found));
    if (gridOf_) std::ranges::move(shortEdges(surface, gridOf_(surface)), std::back_inserter(found));
    return found;
}

void SurfaceEditor::paintContent(QPainter& painter, const PlotTheme& theme)
{
    SurfaceView::paintContent(painter, theme);
    paintEditMarks(painter, *this, {selection_, gesture(), ghost_, influence_, problems_, warnings_, ghostWarnings_},
                   theme);
}

void SurfaceEditor::paintKey(QPainter& painter, const QRectF& column, const PlotTheme& theme)
{
    if (showsPressure()) {
        const ColourScale pressure = pressureScale(theme);
        return paintColourBar(painter, column, font(), theme, pressure, pressureTicks(pressure, column.height()),
                              unitText("kPa"));
    }
    const auto scale = influenceScale(influence_, theme);
    if (dragging() || !scale) return SurfaceView::paintKey(painter, column, theme);
    constexpr double unit = 0.1; // nm per 10 nm [m/m]
    paintColourBar(painter, column, font(), theme, *scale, scale->ticks(unit, colourBarRoom(font(), column.height())),
                   influenceUnit());
}

/// The plan stays where it is when the influence or the pressure is shown.
double SurfaceEditor::keyWidth() const
{
    const double title = QFontMetricsF(plotNumberFont(font())).horizontalAdvance(influenceUnit()) + 6.0;
    const double own = std::max(SurfaceView::keyWidth(), title);
    if (pressure_.empty()) return own;
    if (pressureKey_.height != height() || pressureKey_.font != font()) {
        const auto ticks = pressureTicks(pressureScale(plotTheme(palette())), height() - 90.0);
        pressureKey_ = {height(), font(), colourBarWidth(font(), ticks) + 4.0};
    }
    return std::max(own, pressureKey_.width);
}

QStringList SurfaceEditor::readingAt(const SurfacePoint& point) const
{
    QStringList parts = SurfaceView::readingAt(point);
    const auto& hovered = gesture().hovered;
    if (hovered && hovered->kind != PartKind::Rail && !dragging()) parts << partText(*hovered);
    const QString influence = hovered && !dragging() ? influenceText(influence_, *hovered) : QString();
    if (!influence.isEmpty()) parts << influence;
    const int i = cellIndex(grid().x, point.x), j = cellIndex(grid().y, point.y);
    if (showsPressure() && i >= 0 && j >= 0)
        parts
            << tr("%1 above ambient").arg(readout(pressure_[static_cast<std::size_t>(j * grid().nx() + i)], "kPa", 1));
    return parts;
}

bool SurfaceEditor::moveByKey(const QKeyEvent& event)
{
    if (selection().empty()) return false;
    const double step = event.modifiers().testFlag(Qt::ShiftModifier) ? 10.0 * keyStep
                        : event.modifiers().testFlag(Qt::AltModifier) ? 0.1 * keyStep
                                                                      : keyStep;
    switch (event.key()) {
    case Qt::Key_Left: return selection_.nudge({-step, 0.0}), true;
    case Qt::Key_Right: return selection_.nudge({step, 0.0}), true;
    case Qt::Key_Up: return selection_.nudge({0.0, step}), true;
    case Qt::Key_Down: return selection_.nudge({0.0, -step}), true;
    default: return false;
    }
}

bool SurfaceEditor::actByKey(const QKeyEvent& event)
{
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    if (event.modifiers().testFlag(Qt::ControlModifier)) {
        if (event.key() == Qt::Key_A) return selection_.selectAll(), true;
        if (event.key() == Qt::Key_D) return selection_.copy(), true;
        return false;
    }
    switch (event.key()) {
    case Qt::Key_Escape:
        if (!gestures_.stepBack()) select({});
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (tool() == Tool::Polygon) return gestures_.finishPolygon(), true;
        return gestures_.askForShift(), true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace: return selection_.remove(), true;
    case Qt::Key_PageUp: return selection_.moveInOrder(1), true;
    case Qt::Key_PageDown: return selection_.moveInOrder(-1), true;
    case Qt::Key_M:
        if (shift)
            selection_.mirrorCopy();
        else if (tool() == Tool::Measure)
            gestures_.measureSelection();
        else
            setTool(Tool::Measure);
        return true;
    case Qt::Key_L:
        if (const PartSelection rails = selection_.rails(); rails.size() == 1)
            selection_.togglePair(rails.begin()->item);
        return true;
    case Qt::Key_K:
        if (const auto alongX = selection_.suggestedAxis()) selection_.keepDistance(*alongX);
        return true;
    case Qt::Key_N: return selection_.selectRail(1), true;
    case Qt::Key_B: return selection_.selectRail(-1), true;
    case Qt::Key_E: return selection_.selectAround(PartKind::Edge, shift), true;
    case Qt::Key_C: return selection_.selectAround(PartKind::Corner, shift), true;
    case Qt::Key_F: return fit(), true;
    case Qt::Key_V: return setTool(Tool::Select), true;
    case Qt::Key_R: return setTool(Tool::Rectangle), true;
    case Qt::Key_P: return setTool(Tool::Polygon), true;
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
    if (!moveByKey(*event) && !actByKey(*event)) SurfaceView::keyPressEvent(event);
}

void SurfaceEditor::contextMenuEvent(QContextMenuEvent* event)
{
    if (dragging() || tool() != Tool::Select) return;
    if (event->reason() != QContextMenuEvent::Mouse) {
        const bool some = !selection().empty() && has(committed(), *selection().begin());
        const QPointF at = some ? toPixel(placeOf(committed(), *selection().begin(), {})) : planArea().center();
        return popUpMenu(mapToGlobal(at.toPoint()), std::nullopt);
    }
    const QPointF pixel = event->pos();
    const auto part = partAt(*this, committed(), pixel, selection());
    const bool ofSelected = part && isOfRail(*part) && selection().contains({PartKind::Rail, part->item});
    if (part && !selection().contains(*part) && !ofSelected) select({*part});
    popUpMenu(event->globalPos(), part && part->kind == PartKind::Edge ? std::optional(toSlider(pixel)) : std::nullopt);
}

void SurfaceEditor::popUpMenu(const QPoint& globalPos, const std::optional<SurfacePoint>& insertAt)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const PartSelection rails = selection_.rails();
    const bool some = !selection().empty(), one = rails.size() == 1;
    const auto add = [&](const QString& text, const QString& keys, bool enabled, auto perform) {
        menu->addAction(keys.isEmpty() ? text : text + QLatin1Char('\t') + keys, this, perform)->setEnabled(enabled);
    };
    const auto edge = selection_.oneEdge();
    if (edge) {
        const std::vector<RailPoint>& points = committed().rails[edge->item].points;
        const RailPoint &a = points[edge->index], &b = points[(edge->index + 1) % points.size()];
        const SurfacePoint at = insertAt.value_or(SurfacePoint{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)});
        add(insertAt ? tr("Insert a corner here") : tr("Insert a corner in the middle"), {}, true,
            [this, edge, at] { selection_.insertCorner(edge->item, edge->index, at); });
    }
    const auto ofKind = [this](PartKind kind) {
        return std::ranges::any_of(selection(), [kind](const SurfacePart& part) { return part.kind == kind; });
    };
    if (ofKind(PartKind::Edge) || ofKind(PartKind::Rail)) {
        QMenu* walls = menu->addMenu(edge                     ? tr("Wall of this edge")
                                     : ofKind(PartKind::Edge) ? tr("Walls of these edges")
                                     : one                    ? tr("Walls of this rail")
                                                              : tr("Walls of these rails"));
        fillWallMenu(*walls, committed(), commonWall(committed(), selection()),
                     [this](int wall) { selection_.chooseWall(wall); });
    }
    add(tr("Move by…"), QStringLiteral("Enter"), some, [this] { gestures_.askForShift(); });
    add(tr("Coordinates…"), {}, some, [this] { emit coordinatesWanted(); });
    add(tr("Recess…"), {}, !rails.empty(), [this] { emit recessWanted(); });
    menu->addSeparator();
    add(tr("Duplicate"), QStringLiteral("Ctrl+D"), !rails.empty(), [this] { selection_.copy(); });
    QMenu* arrange = menu->addMenu(tr("Arrange"));
    arrange->setEnabled(some);
    fillArrangeMenu(*arrange);
    add(tr("Make symmetric"), {}, selection_.lopsided(), [this] { selection_.makeSymmetric(); });
    fillKeepMenu(*menu->addMenu(tr("Keep")));
    for (const PairLink& link : selection_.pairLinks())
        if (one && link.holds(rails.begin()->item))
            add(link.broken ? tr("Join the pair") : tr("Break the pair"), QStringLiteral("L"), true,
                [this, rail = link.rail] { selection_.togglePair(rail); });
    add(tr("Forward"), QStringLiteral("PgUp"), one, [this] { selection_.moveInOrder(1); });
    add(tr("Backward"), QStringLiteral("PgDown"), one, [this] { selection_.moveInOrder(-1); });
    menu->addSeparator();
    add(tr("Delete"), QStringLiteral("Del"), some, [this] { selection_.remove(); });
    menu->addSeparator();
    add(tr("Drawing under the plan…"), {}, true, [this] { placeUnderlay(); });
    addPictureActions(*menu, *this);
    menu->popup(globalPos);
}

void SurfaceEditor::fillArrangeMenu(QMenu& menu)
{
    const std::size_t rails = selection_.rails().size();
    const auto add = [&](const QString& text, bool enabled, auto perform) {
        menu.addAction(text, this, perform)->setEnabled(enabled);
    };
    add(tr("Mirrored copy") + QStringLiteral("\tShift+M"), rails > 0, [this] { selection_.mirrorCopy(); });
    add(tr("Flip about the centre line"), true, [this] { selection_.flip(); });
    add(tr("Array…"), rails > 0, [this] { askForArray(); });
    menu.addSeparator();
    for (const auto& [text, to] :
         {std::pair(tr("Align left edges"), Alignment::Left), std::pair(tr("Align right edges"), Alignment::Right),
          std::pair(tr("Align top edges"), Alignment::Top), std::pair(tr("Align bottom edges"), Alignment::Bottom),
          std::pair(tr("Align centres at one x"), Alignment::MiddleX),
          std::pair(tr("Align centres at one y"), Alignment::MiddleY)})
        add(text, rails > 1, [this, to = to] { selection_.align(to); });
    menu.addSeparator();
    add(tr("Equal gaps along x"), rails > 2, [this] { selection_.distribute(true); });
    add(tr("Equal gaps along y"), rails > 2, [this] { selection_.distribute(false); });
}

void SurfaceEditor::fillKeepMenu(QMenu& menu)
{
    const auto suggested = selection_.suggestedAxis();
    for (const bool alongX : {true, false}) {
        const auto distance = selection_.offeredDistance(alongX);
        QString text = alongX ? tr("Distance along x") : tr("Distance along y");
        if (distance) text += QStringLiteral(": ") + lengthText(distance->value);
        if (suggested == alongX) text += QStringLiteral("\tK");
        menu.addAction(text, this, [this, alongX] { selection_.keepDistance(alongX); })
            ->setEnabled(distance.has_value());
    }
    const auto symmetry = selection_.offeredSymmetry();
    const bool pair = symmetry && symmetry->rail != symmetry->image;
    menu.addAction(pair ? tr("Mirror images") : tr("Symmetric"), this, [this] { selection_.keepSymmetric(); })
        ->setEnabled(symmetry.has_value());
    menu.menuAction()->setEnabled(suggested || symmetry);
}

void SurfaceEditor::askForArray()
{
    auto* dialog = new ArrayDialog(this);
    connect(dialog, &ArrayDialog::taken, &selection_, &SurfaceSelection::array);
    dialog->open();
}

} // namespace touchdown
