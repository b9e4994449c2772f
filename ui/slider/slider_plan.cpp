// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/slider_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>

#include "core/formats/units.h"
#include "ui/plot/plot_frame.h"
#include "ui/slider/plan_marks.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr double wheelStep = 1.25;    // for one notch
constexpr double keyMove = 40.0;      // [px]
constexpr double farthest = 0.3;      // of the fitted scale
constexpr double nearest = 2e9;       // [px/m]: 2 px a nanometre
constexpr double smallest = 0.3e-3;   // area with scales in mm [m]
constexpr double planOnPaper = 420.0; // width in which names, marks and scale have room [px]
constexpr double gap = PlotFrame::gap;

} // namespace

SliderPlan::SliderPlan(QWidget* parent) : PictureWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleDescription(tr("Arrow keys move, plus and minus zoom, Home shows everything."));
    connect(this, &SliderPlan::pointed, this, [this](const std::optional<SurfacePoint>& point) {
        if (!point) return setReading({});
        const QStringList place{tr("x %1   y %2").arg(placeText(point->x), placeText(point->y))};
        setReading((place + readingAt(*point)).join(QStringLiteral("   ·   ")));
    });
}

void SliderPlan::setSlider(double length, double width) { setArea({0.0, 0.0, length, width}, true); }

void SliderPlan::setPiece(const QRectF& area) { setArea(area, false); }

void SliderPlan::setArea(const QRectF& area, bool slider)
{
    if (area == area_ && slider == slider_) return;
    area_ = area;
    slider_ = slider;
    fit();
}

std::string_view SliderPlan::lengthUnit() const
{
    return std::max(area_.width(), area_.height()) < smallest ? "um" : "mm";
}

QString SliderPlan::placeText(double at) const { return readout(at, lengthUnit(), lengthUnit() == "mm" ? 4 : 2); }

AxisLabel SliderPlan::axisLabel(const QString& name) const
{
    return {name, unitText(lengthUnit()), unitFactor(lengthUnit()), AxisScale::Linear};
}

void SliderPlan::setSkew(double skew)
{
    skew_ = skew;
    update();
}

void SliderPlan::setTitle(const QString& title)
{
    title_ = title;
    setAccessibleName(title);
    update();
}

void SliderPlan::setReading(const QString& text)
{
    if (text == reading_) return;
    reading_ = text;
    update(0, 0, width(), static_cast<int>(planArea().top()));
}

void SliderPlan::setRestingReading(const QString& text)
{
    resting_ = text;
    update(0, 0, width(), static_cast<int>(planArea().top()));
}

void SliderPlan::setGrid(const CellGrid& grid)
{
    grid_ = grid;
    update();
}

void SliderPlan::setGridShown(bool shown)
{
    gridShown_ = shown;
    update();
}

void SliderPlan::fit()
{
    fitted_ = true;
    applyFit();
}

SliderPlan::Margins SliderPlan::margins(const QFont& font, bool above) const
{
    if (!slider_) return {2.0 * gap, 2.0 * gap, 4.0 * gap};
    const double text = QFontMetricsF(plotNumberFont(font)).height();
    const double name = text + 2.0 * gap;
    return {above ? name : arrowLength + 3.0 * gap + text, above ? name : text + 3.0 * gap, 2.0 * name};
}

void SliderPlan::applyFit()
{
    const QRectF area = planArea();
    const auto [left, right, ends] = margins(font(), airAbove());
    scale_ =
        std::max(1.0, std::min((area.width() - left - right) / area_.width(), (area.height() - ends) / area_.height()));
    centre_ = {area_.center().x() + 0.5 * (right - left) / scale_, area_.center().y()};
    update();
    emit viewChanged();
}

QRectF SliderPlan::view() const
{
    const QRectF area = planArea();
    const SurfacePoint corner = toSlider(area.bottomLeft());
    return {corner.x, corner.y, area.width() / scale_, area.height() / scale_};
}

void SliderPlan::zoom(double factor, const QPointF& aboutPixel)
{
    const SurfacePoint still = toSlider(aboutPixel);
    const QRectF area = planArea();
    const double whole = std::min(area.width() / area_.width(), area.height() / area_.height());
    const double scale = std::clamp(scale_ * factor, farthest * whole, nearest);
    if (scale == scale_) return;
    fitted_ = false;
    scale_ = scale;
    const QPointF away = aboutPixel - area.center();
    centre_ = {still.x - away.x() / scale_, still.y + away.y() / scale_};
    update();
    emit viewChanged();
}

void SliderPlan::pan(const QPointF& byPixels)
{
    // Some part of the slider stays in sight.
    fitted_ = false;
    centre_.x = std::clamp(centre_.x - byPixels.x() / scale_, area_.left(), area_.right());
    centre_.y = std::clamp(centre_.y + byPixels.y() / scale_, area_.top(), area_.bottom());
    update();
    emit viewChanged();
}

QRectF SliderPlan::planArea() const
{
    if (size() != laidOutSize_ || font() != laidOutFont_) {
        laidOutSize_ = size();
        laidOutFont_ = font();
        planArea_ = PlotFrame::areaWithin(size(), font(), QStringLiteral("0.0000"), keyWidth() + gap);
    }
    return planArea_;
}

QPointF SliderPlan::toPixel(const SurfacePoint& point) const
{
    const QPointF middle = planArea().center();
    return {middle.x() + (point.x - centre_.x) * scale_, middle.y() - (point.y - centre_.y) * scale_};
}

SurfacePoint SliderPlan::toSlider(const QPointF& pixel) const
{
    const QPointF away = pixel - planArea().center();
    return {centre_.x + away.x() / scale_, centre_.y - away.y() / scale_};
}

bool SliderPlan::onSlider(const SurfacePoint& point) const
{
    return point.x >= area_.left() && point.x <= area_.right() && point.y >= area_.top() && point.y <= area_.bottom();
}

void SliderPlan::changeEvent(QEvent* event)
{
    PictureWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange && fitted_) applyFit();
}

void SliderPlan::resizeEvent(QResizeEvent*)
{
    if (fitted_)
        applyFit();
    else
        emit viewChanged();
}

void SliderPlan::wheelEvent(QWheelEvent* event)
{
    const int turned = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    if (turned != 0) zoom(std::pow(wheelStep, turned / 120.0), event->position());
    event->accept();
}

void SliderPlan::mousePressEvent(QMouseEvent* event)
{
    pressedAt_ = event->position();
    draggedTo_ = event->position();
    dragged_ = false;
}

void SliderPlan::mouseMoveEvent(QMouseEvent* event)
{
    if (pressedAt_) {
        const QPointF way = event->position() - *pressedAt_;
        if (!dragged_ && way.manhattanLength() < QApplication::startDragDistance()) return;
        if (!dragged_) setCursor(Qt::ClosedHandCursor);
        dragged_ = true;
        pan(event->position() - draggedTo_);
        draggedTo_ = event->position();
        return;
    }
    const SurfacePoint point = toSlider(event->position());
    const bool seen = planArea().contains(event->position()) && onSlider(point);
    emit pointed(seen ? std::optional(point) : std::nullopt);
}

void SliderPlan::mouseReleaseEvent(QMouseEvent* event)
{
    const bool clicked = pressedAt_ && !dragged_ && event->button() == Qt::LeftButton;
    pressedAt_.reset();
    unsetCursor();
    const SurfacePoint point = toSlider(event->position());
    if (!clicked || !planArea().contains(event->position()) || !onSlider(point)) return;
    event->modifiers().testFlag(Qt::ShiftModifier) ? secondChosen(point) : chosen(point);
}

void SliderPlan::mouseDoubleClickEvent(QMouseEvent*)
{
    pressedAt_.reset();
    fit();
}

void SliderPlan::leaveEvent(QEvent*) { emit pointed(std::nullopt); }

void SliderPlan::keyPressEvent(QKeyEvent* event)
{
    if (event->modifiers().testFlag(Qt::ShiftModifier) && event->key() != Qt::Key_Plus) {
        event->ignore(); // the derived class has other uses for arrow keys with Shift
        return;
    }
    switch (event->key()) {
    case Qt::Key_Left: pan({keyMove, 0.0}); break;
    case Qt::Key_Right: pan({-keyMove, 0.0}); break;
    case Qt::Key_Up: pan({0.0, keyMove}); break;
    case Qt::Key_Down: pan({0.0, -keyMove}); break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoom(wheelStep, planArea().center()); break;
    case Qt::Key_Minus: zoom(1.0 / wheelStep, planArea().center()); break;
    case Qt::Key_Home: fit(); break;
    default: QWidget::keyPressEvent(event);
    }
}

void SliderPlan::paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours)
{
    const QSignalBlocker quiet(this); // the view on the screen stays
    const QString reading = std::exchange(reading_, {});
    const QSizeF before = planArea().size();
    const double scale = scale_;
    const SurfacePoint centre = centre_;
    {
        paper_ = true;
        const double wider = widening(size.width(), planOnPaper);
        const LaidOutAs laidOut(*this, wider * size, font);
        const QSizeF now = planArea().size();
        if (fitted_)
            applyFit();
        else
            scale_ *= std::min(now.width() / before.width(), now.height() / before.height());
        painter.save();
        painter.scale(1.0 / wider, 1.0 / wider);
        paint(painter, paperTheme(colours));
        painter.restore();
        paper_ = false;
    }
    scale_ = scale;
    centre_ = centre;
    reading_ = reading;
}

double SliderPlan::heightOnPaper(double onPaper, const QFont& font) const
{
    const double wider = widening(onPaper, planOnPaper), width = wider * onPaper;
    const QRectF area = PlotFrame::areaWithin({width, width}, font, QStringLiteral("0.0000"), keyWidth() + gap);
    const auto [left, right, ends] = margins(font, true);
    const double plan = area_.height() / area_.width() * (area.width() - left - right) + ends;
    return std::clamp(width - area.height() + plan, 0.4 * width, 1.4 * width) / wider;
}

void SliderPlan::fillMenu(QMenu& menu)
{
    menu.addAction(tr("&Fit all"), QKeySequence(Qt::Key_Home), this, &SliderPlan::fit);
}

} // namespace touchdown
