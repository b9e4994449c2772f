// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/mode_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QKeyEvent>

#include "ui/film/mode_motion.h"

namespace touchdown {

namespace {

constexpr int frameInterval = 33;    // [ms]
constexpr double motionShare = 0.22; // largest motion of a corner, of the height of the highest corner
constexpr double clearance = 0.15;   // of the largest motion, that stays above the disk
constexpr double headRoom = 1.1;     // above the highest corner
constexpr double fullCycle = 2.0 * std::numbers::pi;
constexpr double keyStep = fullCycle / 24.0;

/// Of the zero plane at the four corners [m].
double highestCorner(const Attitude& a, const SliderCase& slider)
{
    return a.height + std::max(0.0, a.pitch * slider.length) + 0.5 * std::abs(a.roll) * slider.width;
}

} // namespace

ModePicture::ModePicture(QWidget* parent) : PictureWidget(parent, 520.0, 0.55)
{
    setAccessibleName(tr("Picture of the mode"));
    setFocusPolicy(Qt::StrongFocus);
    setToolTip(tr("Space plays and pauses, Left and Right turn the phase"));
    timer_.setInterval(frameInterval);
    connect(&timer_, &QTimer::timeout, this, &ModePicture::advance);
}

void ModePicture::setState(const Case& c, const Attitude& attitude)
{
    profile_ = SliderProfile(c);
    slider_ = c.slider;
    const std::vector<double> seen = profile_.fromSide(attitude);
    const double top = std::max(highestCorner(attitude, slider_), 1e-9);
    amplitude_ = motionShare * top;
    lift_ = std::max(0.0, (1.0 + clearance) * amplitude_ - *std::ranges::min_element(seen));
    const double high = headRoom * (top + lift_ + amplitude_);
    heights_ = {-ProfileDrawing::belowDisk * high, high};
    still_ = attitude;
    still_.height += lift_;
    stillSide_ = profile_.fromSide(still_);
    stillRear_ = profile_.fromRear(still_);
    setMode(std::nullopt, {});
}

void ModePicture::setMode(const std::optional<AirBearingMode>& mode, const QString& title)
{
    mode_ = mode;
    title_ = title;
    updateTimer();
    update();
}

void ModePicture::setPlaying(bool playing)
{
    if (playing == playing_) return;
    playing_ = playing;
    updateTimer();
    emit playingChanged(playing);
}

void ModePicture::setPhase(double phase)
{
    phase_ = std::fmod(phase + fullCycle, fullCycle);
    update();
}

void ModePicture::updateTimer()
{
    const bool moves = playing_ && mode_ && isVisible();
    if (moves == timer_.isActive()) return;
    if (!moves) return timer_.stop();
    sinceFrame_.start();
    timer_.start();
}

void ModePicture::advance()
{
    setPhase(phase_ + fullCycle * static_cast<double>(sinceFrame_.restart()) / 1e3 / period_);
}

Attitude ModePicture::shownAttitude() const
{
    Attitude shown = still_;
    if (!mode_) return shown;
    const Attitude change = changeAt(*mode_, slider_, phase_);
    shown.height += amplitude_ * change.height;
    shown.pitch += amplitude_ * change.pitch;
    shown.roll += amplitude_ * change.roll;
    return shown;
}

/// Both views have one scale along the slider and one of heights.
ProfileDrawing ModePicture::drawing(double left, double size) const
{
    const double line = fontMetrics().height();
    const double margin = 1.2 * line, between = 2.0 * line;
    const double scale = (width() - 2.0 * margin - between) / (slider_.length + slider_.width);
    const double x = margin + (left > 0.0 ? left * scale + between : 0.0);
    return {QRectF(x, 2.8 * line, size * scale, height() - 5.6 * line), size, heights_};
}

ProfileDrawing ModePicture::side() const { return drawing(0.0, slider_.length); }
ProfileDrawing ModePicture::rear() const { return drawing(slider_.length, slider_.width); }

void ModePicture::paint(QPainter& painter, const PlotTheme& theme)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme.background);
    if (!mode_ || profile_.empty()) return;
    const Attitude shown = shownAttitude();
    const auto one = [&](const ProfileDrawing& drawn, const std::vector<double>& still,
                         const std::vector<double>& now) {
        painter.fillRect(drawn.area, theme.plotArea);
        painter.save();
        painter.setClipRect(drawn.area, Qt::IntersectClip);
        drawn.paintDisk(painter, theme);
        drawn.paintSlider(painter, theme.curves[0], now);
        paintStill(painter, theme, drawn, still);
        painter.restore();
    };
    const ProfileDrawing side = this->side(), rear = this->rear();
    one(side, stillSide_, profile_.fromSide(shown));
    one(rear, stillRear_, profile_.fromRear(shown));
    paintLeastMotion(painter, theme);
    side.paintFrame(painter, theme, tr("x, to the trailing edge"));
    rear.paintFrame(painter, theme, tr("y, to the outer edge"));

    const double line = fontMetrics().height();
    painter.setPen(theme.text);
    const auto above = [&](const ProfileDrawing& drawn, const QString& text) {
        const QRectF row(drawn.area.left(), drawn.area.top() - 1.3 * line, drawn.area.width(), line);
        painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(row.width())));
    };
    above(side, tr("From the side, heights × %L1").arg(std::round(side.exaggeration()), 0, 'f', 0));
    above(rear, tr("From the rear"));
    const QRectF head(side.area.left(), 0.2 * line, rear.area.right() - side.area.left(), line);
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(title_, Qt::ElideRight, static_cast<int>(head.width())));
}

void ModePicture::paintStill(QPainter& painter, const PlotTheme& theme, const ProfileDrawing& drawn,
                             const std::vector<double>& heights) const
{
    QPen pen(theme.text, 1.0);
    pen.setDashPattern({4.0, 4.0});
    painter.setPen(pen);
    painter.drawPolyline(drawn.line(heights));
}

/// A dotted line across the picture where the slider moves least, and a dot where it meets the zero plane at rest.
void ModePicture::paintLeastMotion(QPainter& painter, const PlotTheme& theme) const
{
    const auto least = leastMotion(*mode_, slider_);
    const bool roll = mode_->kind == "roll";
    const ProfileDrawing drawn = roll ? rear() : side();
    if (!least || least->at < 0.0 || least->at > drawn.size) return;
    const double height =
        roll ? still_.height + 0.5 * still_.pitch * slider_.length - still_.roll * (least->at - 0.5 * slider_.width)
             : still_.height + still_.pitch * (slider_.length - least->at);
    QPen pen(theme.curves[1], 1.5);
    pen.setDashPattern({1.5, 3.0});
    painter.setPen(pen);
    painter.drawLine(drawn.toPixel(least->at, heights_.high), drawn.toPixel(least->at, heights_.low));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.curves[1]);
    painter.drawEllipse(drawn.toPixel(least->at, height), 4.0, 4.0);
    painter.setBrush(Qt::NoBrush);
}

void ModePicture::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    updateTimer();
}

void ModePicture::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    updateTimer();
}

void ModePicture::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Space: return setPlaying(!playing_);
    case Qt::Key_Left: return setPhase(phase_ - keyStep);
    case Qt::Key_Right: return setPhase(phase_ + keyStep);
    default: QWidget::keyPressEvent(event);
    }
}

} // namespace touchdown
