// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/wall_picture.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "core/physics/slider/wall_edit.h"
#include "ui/plot/plot_theme.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr double distanceStep = 0.1e-6, recessStepOfWall = 10e-9; // of an arrow key [m]
constexpr double distanceRaster = 0.01e-6, recessRaster = 1e-9;   // of a drag [m]
constexpr double pointReach = 9.0;                                // [px]

double onRaster(double value, double raster) { return std::round(value / raster) * raster; }

} // namespace

QPixmap wallPixmap(const WallProfile& wall, const QSize& size, const QPalette& palette, double ratio,
                   std::optional<double> fullWidth)
{
    QPixmap picture(size * ratio);
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = QRectF(QPointF(), QSizeF(size)).adjusted(3.0, 3.0, -3.0, -3.0);
    QPolygonF curve{
        area.topLeft(), {area.center().x(), area.top()}, {area.center().x(), area.bottom()}, area.bottomRight()};
    if (wall.distance.size() >= 2 && wall.recess.size() == wall.distance.size()) {
        const double left = wall.distance.front();
        const auto [top, bottom] = std::ranges::minmax(wall.recess);
        const double width = fullWidth.value_or(wall.distance.back() - left), height = bottom - top;
        curve.clear();
        for (std::size_t i = 0; i < wall.distance.size(); ++i)
            curve << QPointF(area.left() + (width > 0.0 ? (wall.distance[i] - left) / width : 0.5) * area.width(),
                             area.top() + (height > 0.0 ? (wall.recess[i] - top) / height : 0.5) * area.height());
    }
    painter.setPen(QPen(palette.color(QPalette::Text), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(curve);
    return picture;
}

WallPicture::WallPicture(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Profile of the wall"));
    const QString help = tr("Drag the points; a double click adds one. N and B choose a point, arrow keys move it by "
                            "0.1 µm or 10 nm, with Shift ten times as far, Insert adds one after it, Del removes it.");
    setAccessibleDescription(help);
    setToolTip(plainTip(help));
}

void WallPicture::setWall(const WallProfile& wall)
{
    dragging_ = false;
    wall_ = wall;
    span_ = spanOf(wall);
    if (point_ && *point_ >= wall.distance.size()) point_.reset();
    update();
}

void WallPicture::setPoint(std::optional<std::size_t> point)
{
    if (point && *point >= wall_.distance.size()) point.reset();
    point_ = point;
    update();
}

WallPicture::Span WallPicture::spanOf(const WallProfile& wall)
{
    if (wall.distance.empty() || wall.recess.empty()) return {};
    const auto [left, right] = std::ranges::minmax(wall.distance);
    const auto [top, bottom] = std::ranges::minmax(wall.recess);
    return {left, right, top, bottom};
}

QRectF WallPicture::area() const
{
    const double text = QFontMetricsF(font()).height();
    return QRectF(rect()).adjusted(12.0, text + 10.0, -12.0, -text - 10.0);
}

QPointF WallPicture::toPixel(double distance, double recess) const
{
    const QRectF a = area();
    const double x = span_.right > span_.left ? (distance - span_.left) / (span_.right - span_.left) : 0.5;
    const double y = span_.bottom > span_.top ? (recess - span_.top) / (span_.bottom - span_.top) : 0.5;
    return {a.left() + x * a.width(), a.top() + y * a.height()};
}

QPointF WallPicture::pixel(std::size_t point) const { return toPixel(wall_.distance[point], wall_.recess[point]); }

std::optional<std::size_t> WallPicture::pointAt(const QPointF& pixel) const
{
    std::optional<std::size_t> nearest;
    double least = pointReach;
    for (std::size_t i = 0; isComplete() && i < wall_.distance.size(); ++i)
        if (const QPointF away = this->pixel(i) - pixel; std::hypot(away.x(), away.y()) < least) {
            least = std::hypot(away.x(), away.y());
            nearest = i;
        }
    return nearest;
}

void WallPicture::choose(std::size_t point)
{
    setPoint(point);
    emit pointChosen(static_cast<int>(point));
}

void WallPicture::moveBy(double distance, double recess)
{
    if (!point_ || dragging_) return;
    const WallProfile moved =
        movedWallPoint(wall_, *point_, wall_.distance[*point_] + distance, wall_.recess[*point_] + recess);
    if (moved != wall_) emit edited(moved, true);
}

void WallPicture::addAt(double distance)
{
    const std::size_t place = placeOfPoint(wall_, distance);
    emit edited(withWallPoint(wall_, distance), false);
    if (place < wall_.distance.size()) choose(place);
}

bool WallPicture::event(QEvent* event)
{
    // Keys of the picture come before actions of the window with the same key.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() == Qt::NoModifier && key->key() != Qt::Key_Tab &&
            (key->key() < Qt::Key_F1 || key->key() > Qt::Key_F35))
            event->accept();
    }
    return QWidget::event(event);
}

void WallPicture::keyPressEvent(QKeyEvent* event)
{
    if (!isComplete()) return QWidget::keyPressEvent(event);
    const double times = event->modifiers().testFlag(Qt::ShiftModifier) ? 10.0 : 1.0;
    const std::size_t count = wall_.distance.size();
    switch (event->key()) {
    case Qt::Key_N: choose(point_ ? (*point_ + 1) % count : 0); break;
    case Qt::Key_B: choose(point_ ? (*point_ + count - 1) % count : count - 1); break;
    case Qt::Key_Left: moveBy(-times * distanceStep, 0.0); break;
    case Qt::Key_Right: moveBy(times * distanceStep, 0.0); break;
    case Qt::Key_Up: moveBy(0.0, -times * recessStepOfWall); break;
    case Qt::Key_Down: moveBy(0.0, times * recessStepOfWall); break;
    case Qt::Key_Insert:
    case Qt::Key_Plus: addAt(distanceAfter(wall_, point_.value_or(count - 1))); break;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        if (point_ && count > 2) emit edited(withoutWallPoint(wall_, *point_), false);
        break;
    case Qt::Key_Escape:
        if (!dragging_) return QWidget::keyPressEvent(event);
        setWall(before_);
        break;
    default: QWidget::keyPressEvent(event);
    }
}

void WallPicture::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) return;
    const std::optional<std::size_t> point = pointAt(event->position());
    if (!point) return setPoint(std::nullopt);
    choose(*point);
    before_ = wall_;
    dragging_ = true;
}

void WallPicture::mouseMoveEvent(QMouseEvent* event)
{
    if (!dragging_ || !point_) {
        setCursor(pointAt(event->position()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
        return;
    }
    // Up to the border of the picture: further in another drag, on a new scale.
    const QPointF at(std::clamp(event->position().x(), 0.0, width() - 1.0),
                     std::clamp(event->position().y(), 0.0, height() - 1.0));
    const QPointF way = at - toPixel(before_.distance[*point_], before_.recess[*point_]);
    const QRectF a = area();
    // Where all points have one distance, or one recess, a span of 10 um or of 1 um fills the picture.
    const double wide = span_.right > span_.left ? span_.right - span_.left : 10e-6;
    const double high = span_.bottom > span_.top ? span_.bottom - span_.top : 1e-6;
    const double distance = before_.distance[*point_] + way.x() / a.width() * wide;
    const double recess = before_.recess[*point_] + way.y() / a.height() * high;
    wall_ = movedWallPoint(before_, *point_, onRaster(distance, distanceRaster), onRaster(recess, recessRaster));
    update();
}

void WallPicture::mouseReleaseEvent(QMouseEvent*)
{
    if (!std::exchange(dragging_, false)) return;
    if (wall_ != before_) emit edited(wall_, false);
}

void WallPicture::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (!isComplete() || pointAt(event->position()) || !(span_.right > span_.left)) return;
    const double share = (event->position().x() - area().left()) / area().width();
    addAt(onRaster(span_.left + share * (span_.right - span_.left), distanceRaster));
}

void WallPicture::focusInEvent(QFocusEvent* event)
{
    if (!point_ && isComplete()) setPoint(0);
    QWidget::focusInEvent(event);
    update();
}

void WallPicture::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

void WallPicture::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const PlotTheme theme = plotTheme(palette());
    painter.fillRect(rect(), theme.background);
    if (!isComplete()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    if (span_.left < 0.0 && span_.right > 0.0) {
        const double x = toPixel(0.0, span_.top).x();
        painter.setPen(QPen(theme.grid, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(x, area().top()), QPointF(x, area().bottom()));
    }
    QPolygonF curve;
    for (std::size_t i = 0; i < wall_.distance.size(); ++i) curve << pixel(i);
    painter.setPen(QPen(theme.colour({}), 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(curve);
    for (std::size_t i = 0; i < wall_.distance.size(); ++i) {
        const bool chosen = point_ == i;
        painter.setBrush(chosen ? theme.selection : theme.background);
        painter.setPen(QPen(chosen ? theme.selection : theme.colour({}), 2.0));
        painter.drawEllipse(pixel(i), chosen ? 4.5 : 3.5, chosen ? 4.5 : 3.5);
    }
    paintScale(painter);
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

void WallPicture::paintScale(QPainter& painter) const
{
    const double height = QFontMetricsF(font()).height();
    const QRectF a = area();
    painter.setPen(plotTheme(palette()).mutedText);
    const auto text = [&](double y, Qt::Alignment how, const QString& words) {
        painter.drawText(QRectF(a.left(), y, a.width(), height), int(how | Qt::TextDontClip), words);
    };
    const double below = rect().bottom() - height - 1.0;
    if (point_) {
        text(2.0, Qt::AlignLeft,
             tr("recess %1 at %2").arg(lengthText(wall_.recess[*point_], 4), lengthText(wall_.distance[*point_], 4)));
        return text(below, Qt::AlignLeft, tr("point %1 of %2").arg(*point_ + 1).arg(wall_.distance.size()));
    }
    text(2.0, Qt::AlignLeft, tr("recess %1").arg(lengthText(span_.top, 4)));
    text(below, Qt::AlignRight, tr("%1 at %2").arg(lengthText(span_.bottom, 4), lengthText(span_.right, 4)));
    text(below, Qt::AlignLeft, lengthText(span_.left, 4));
}

} // namespace touchdown
