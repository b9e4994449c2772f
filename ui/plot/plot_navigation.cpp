// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_navigation.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QToolTip>
#include <QWheelEvent>

#include "ui/plot/cursor_place.h"
#include "ui/plot/plot_painter.h"
#include "ui/style/foreign_text.h"

namespace touchdown {

namespace {

constexpr double wheelStep = 1.25;  // of the range for one notch
constexpr double keyStep = 0.1;     // of the range
constexpr double flatBox = 8.0;     // a side shorter than this does not zoom [px]
constexpr double grabReach = 4.0;   // of a cursor's line [px]
constexpr double snapReach = 8.0;   // of a peak [px]
constexpr double widestView = 20.0; // of the data

} // namespace

PlotNavigation::PlotNavigation(PlotWidget* plot) : QObject(plot), plot_(*plot) { plot->installEventFilter(this); }

bool PlotNavigation::eventFilter(QObject* /*watched*/, QEvent* event)
{
    switch (event->type()) {
    case QEvent::Wheel: return wheel(*static_cast<QWheelEvent*>(event));
    case QEvent::MouseButtonPress: return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove: return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease: return release(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonDblClick: return doubleClick(*static_cast<QMouseEvent*>(event));
    case QEvent::KeyPress: return key(*static_cast<QKeyEvent*>(event));
    case QEvent::Leave: leave(); return false;
    case QEvent::ToolTip: showToolTip(*static_cast<QHelpEvent*>(event)); return true;
    default: return false;
    }
}

QPointF PlotNavigation::inArea(const QPointF& pixel) const
{
    const QRectF area = plot_.plotArea();
    return {(pixel.x() - area.left()) / area.width(), (area.bottom() - pixel.y()) / area.height()};
}

std::optional<int> PlotNavigation::cursorNear(const QPointF& pixel) const
{
    if (plot_.isPhasePortrait()) return std::nullopt;
    for (const int which : {1, 0}) {
        const auto at = plot_.plotCursor(which);
        const bool fixed = which == 1 || plot_.cursorPinned();
        if (at && fixed && std::abs(plot_.toPixel(*at, 0.0).x() - pixel.x()) <= grabReach) return which;
    }
    return std::nullopt;
}

void PlotNavigation::zoom(double factorX, double factorY, const QPointF& about, PlotWidget::Gesture gesture)
{
    PlotView view = plot_.view();
    const auto part = [](const PlotAxis& axis, double factor, double centre) {
        return axis.part(centre - centre / factor, centre + (1.0 - centre) / factor);
    };
    if (factorX != 1.0) {
        view.x = part(plot_.xAxis(), factorX, std::clamp(about.x(), 0.0, 1.0));
        const auto data = plot_.dataRangeX();
        if (factorX < 1.0 && data && view.x->width() > widestView * data->width()) view.x = plot_.xAxis().range();
    }
    if (factorY != 1.0) view.y = part(plot_.yAxis(), factorY, std::clamp(about.y(), 0.0, 1.0));
    plot_.userView(view, gesture);
}

void PlotNavigation::shift(double partX, double partY, PlotWidget::Gesture gesture)
{
    PlotView view = plot_.view();
    if (partX != 0.0) view.x = plot_.xAxis().part(partX, 1.0 + partX);
    if (partY != 0.0) view.y = plot_.yAxis().part(partY, 1.0 + partY);
    plot_.userView(view, gesture);
}

bool PlotNavigation::wheel(const QWheelEvent& event)
{
    // Qt turns the wheel sideways while Alt is held.
    const int turned = event.angleDelta().y() != 0 ? event.angleDelta().y() : event.angleDelta().x();
    if (turned == 0) return false;
    const double factor = std::pow(wheelStep, turned / 120.0);
    const bool overNumbers = event.position().x() < plot_.plotArea().left();
    const bool both = event.modifiers().testFlag(Qt::ShiftModifier) || (plot_.isPhasePortrait() && !overNumbers);
    const bool onlyY = !both && (event.modifiers().testFlag(Qt::ControlModifier) || overNumbers);
    zoom(onlyY ? 1.0 : factor, onlyY || both ? factor : 1.0, inArea(event.position()),
         turned > 0 ? PlotWidget::Gesture::WheelIn : PlotWidget::Gesture::WheelOut);
    return true;
}

bool PlotNavigation::press(const QMouseEvent& event)
{
    if (drag_ != Drag::None) return true;
    plot_.setFocus(Qt::MouseFocusReason);
    pressedAt_ = event.position();
    pressedView_ = plot_.view();
    pressedX_ = plot_.xAxis().range();
    pressedY_ = plot_.yAxis().range();
    dragged_ = false;
    if (event.button() == Qt::LeftButton) {
        const auto grabbed = cursorNear(pressedAt_);
        drag_ = grabbed ? Drag::Cursor : Drag::Box;
        draggedCursor_ = grabbed.value_or(0);
    } else if (event.button() == Qt::MiddleButton || event.button() == Qt::RightButton) {
        drag_ = Drag::Move;
    }
    return true;
}

bool PlotNavigation::move(const QMouseEvent& event)
{
    const QPointF at = event.position();
    const bool inside = plot_.plotArea().contains(at);
    if (drag_ == Drag::None) {
        plot_.hoverLegend(at);
        plot_.setCursor(cursorNear(at) ? Qt::SplitHCursor : inside ? Qt::CrossCursor : Qt::ArrowCursor);
        if (plot_.cursorPinned() || plot_.isPhasePortrait()) return true;
        plot_.userCursor(0, inside ? std::optional(cursorAt(event)) : std::nullopt);
        return true;
    }
    dragged_ = dragged_ || (at - pressedAt_).manhattanLength() >= QApplication::startDragDistance();
    if (!dragged_) return true;
    if (drag_ == Drag::Cursor) {
        plot_.userCursor(draggedCursor_, cursorAt(event));
    } else if (drag_ == Drag::Box) {
        plot_.showSelection(QRectF(pressedAt_, at).normalized());
    } else {
        const QPointF by = inArea(pressedAt_) - inArea(at);
        PlotAxis x = plot_.xAxis(); // from where the drag began, so that nothing adds up
        PlotAxis y = plot_.yAxis();
        x.setRange(pressedX_);
        y.setRange(pressedY_);
        PlotView view = pressedView_;
        view.x = x.part(by.x(), 1.0 + by.x());
        // A height that follows the data stays so until the hand has clearly left the horizontal.
        if (view.y || std::abs(pressedAt_.y() - at.y()) > 2.0 * flatBox) view.y = y.part(by.y(), 1.0 + by.y());
        plot_.setCursor(Qt::ClosedHandCursor);
        plot_.userView(view, PlotWidget::Gesture::Move);
    }
    return true;
}

bool PlotNavigation::release(const QMouseEvent& event)
{
    const Drag ended = std::exchange(drag_, Drag::None);
    plot_.showSelection(std::nullopt);
    if (ended == Drag::Box && dragged_)
        zoomToBox(pressedAt_, event.position());
    else if (!dragged_ && event.button() == Qt::RightButton)
        emit plot_.menuRequested(event.globalPosition().toPoint());
    else if (!dragged_ && event.button() == Qt::LeftButton && ended == Drag::Box)
        click(event);
    plot_.setCursor(Qt::CrossCursor);
    return true;
}

/// Where the mouse sets a cursor, within the plot area.
double PlotNavigation::cursorAt(const QMouseEvent& event) const
{
    const double x = plot_.xAxis().valueAt(std::clamp(inArea(event.position()).x(), 0.0, 1.0));
    if (!plot_.cursorsSnap() || event.modifiers().testFlag(Qt::ControlModifier)) return x;
    return peakNear(plot_, x, snapReach).value_or(x);
}

void PlotNavigation::click(const QMouseEvent& event)
{
    cursorBefore_ = plot_.plotCursor(0);
    pinnedBefore_ = plot_.cursorPinned();
    if (!plot_.plotArea().contains(event.position())) return;
    const std::optional<double> at =
        plot_.isPhasePortrait() ? phaseTimeNear(plot_, event.position()) : std::optional(cursorAt(event));
    if (!at) return;
    const bool second = event.modifiers().testFlag(Qt::ShiftModifier);
    if (!second) plot_.userPin(true);
    plot_.userCursor(second ? 1 : 0, at);
}

void PlotNavigation::zoomToBox(const QPointF& from, const QPointF& to)
{
    const QRectF box = QRectF(from, to).normalized().intersected(plot_.plotArea());
    PlotView view = plot_.view();
    const QPointF lower = inArea(box.bottomLeft());
    const QPointF upper = inArea(box.topRight());
    if (box.width() >= flatBox) view.x = plot_.xAxis().part(lower.x(), upper.x());
    if (box.height() >= flatBox) view.y = plot_.yAxis().part(lower.y(), upper.y());
    if (view == plot_.view()) return;
    plot_.userView(view, PlotWidget::Gesture::Box);
}

bool PlotNavigation::doubleClick(const QMouseEvent& event)
{
    if (event.button() != Qt::LeftButton) return true;
    // The first of the two clicks pinned the cursor, which was not meant.
    plot_.userPin(pinnedBefore_);
    plot_.userCursor(0, cursorBefore_);
    drag_ = Drag::Move; // the release of this click is neither a box nor a click
    dragged_ = true;
    plot_.userView({}, PlotWidget::Gesture::Fit);
    return true;
}

bool PlotNavigation::key(const QKeyEvent& event)
{
    using enum PlotWidget::Gesture;
    const bool shifted = event.modifiers().testFlag(Qt::ShiftModifier);
    const bool control = event.modifiers().testFlag(Qt::ControlModifier);
    const bool alt = event.modifiers().testFlag(Qt::AltModifier);
    const double sign = event.key() == Qt::Key_Left || event.key() == Qt::Key_Down ? -1.0 : 1.0;
    switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (alt) {
            emit plot_.historyRequested(static_cast<int>(sign));
        } else if (shifted && plot_.plotCursor(0) && !plot_.isPhasePortrait()) {
            const double pixel = sign / plot_.plotArea().width();
            plot_.userPin(true);
            plot_.userCursor(0, plot_.xAxis().valueAt(plot_.xAxis().position(*plot_.plotCursor(0)) + pixel));
        } else {
            shift(sign * keyStep, 0.0, Key);
        }
        return true;
    case Qt::Key_Up:
    case Qt::Key_Down: shift(0.0, sign * keyStep, Key); return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus: {
        const double factor = event.key() == Qt::Key_Minus ? 1.0 / wheelStep : wheelStep;
        zoom(control ? 1.0 : factor, control || plot_.isPhasePortrait() ? factor : 1.0, {0.5, 0.5}, Key);
        return true;
    }
    case Qt::Key_Home: plot_.userView({}, Fit); return true;
    case Qt::Key_Backspace: emit plot_.historyRequested(-1); return true;
    case Qt::Key_L:
        plot_.setYScale(plot_.yAxis().logarithmic() ? AxisScale::Linear : AxisScale::Logarithmic);
        return true;
    case Qt::Key_Escape:
        plot_.userPin(false);
        plot_.userCursor(0, std::nullopt);
        plot_.userCursor(1, std::nullopt);
        return true;
    default: return false;
    }
}

void PlotNavigation::leave()
{
    plot_.hoverLegend({-1.0, -1.0});
    if (plot_.cursorPinned() || drag_ != Drag::None || plot_.isPhasePortrait()) return;
    plot_.userCursor(0, std::nullopt);
}

/// The labels of the reference lines there: one may be cut or have no room.
QStringList PlotNavigation::linesAt(const QPointF& at) const
{
    QStringList lines;
    for (const PlotLabel& label : PlotPainter(plot_, plot_.theme()).labels())
        if (label.box.contains(at) && !label.line.isEmpty()) lines += label.line;
    for (const ReferenceLine& line : plot_.referenceLines()) {
        const QPointF pixel = plot_.toPixel(line.value, line.value);
        const double distance = std::abs(line.upright ? pixel.x() - at.x() : pixel.y() - at.y());
        if (distance <= 3.0 && plot_.plotArea().contains(at) && !line.label.isEmpty()) lines += line.label;
    }
    return lines;
}

void PlotNavigation::showToolTip(const QHelpEvent& event) const
{
    const QPoint at = event.pos();
    QStringList lines;
    for (const EventMark& mark : plot_.eventMarks()) {
        const bool near = std::abs(plot_.toPixel(mark.time, 0.0).x() - at.x()) <= 5.0;
        if (!near || plot_.isPhasePortrait() || !plot_.plotArea().contains(at)) continue;
        if (lines.size() == 6) {
            lines += QStringLiteral("\u2026");
            break;
        }
        lines += tr("%1 at %2 %3").arg(mark.label, plot_.xAxis().number(mark.time), plot_.xAxis().label.unit);
    }
    for (const QString& label : linesAt(at)) lines += label;
    if (lines.isEmpty() && !plot_.toolTip().isEmpty()) lines += plot_.toolTip();
    if (lines.isEmpty())
        QToolTip::hideText();
    else
        QToolTip::showText(event.globalPos(), plainTip(lines.join(u'\n')), &plot_);
}

} // namespace touchdown
