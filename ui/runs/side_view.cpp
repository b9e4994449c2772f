// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/side_view.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QPainter>

#include "core/formats/units.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/physics/slider/recess.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int columns = 400;          // of the profile
constexpr int rows = 60;              // across the slider, from which each column takes the lowest
constexpr double belowDisk = 0.12;    // of the visible heights
constexpr double headRoom = 1.25;     // above the highest pad
constexpr double ceiling = 0.93;      // of the visible heights: deeper recesses are cut off there
constexpr double stripeLength = 2e-4; // of the marks that move with the disk [m]

} // namespace

SideView::SideView(RunsModel& runs, QWidget* parent) : QWidget(parent), runs_(runs)
{
    setAccessibleName(tr("Side view of slider and disk"));
    height_.label = {tr("Height"), QStringLiteral("nm"), unitFactor("nm"), AxisScale::Linear};
    connect(&runs_, &RunsModel::aboutToRemove, this, [this](int number) {
        if (number == number_) showRun(-1);
    });
}

void SideView::showRun(int number)
{
    number_ = number;
    time_.reset();
    takeRun();
}

void SideView::dataArrived(int number)
{
    if (number != number_ || time_) return;
    takeState();
}

void SideView::showTime(const std::optional<double>& time)
{
    time_ = time;
    takeState();
}

void SideView::takeRun()
{
    profile_.clear();
    const RunRecord* run = runs_.find(number_);
    if (run && run->value.model == ModelKind::Film) {
        const Case& c = run->value;
        length_ = c.slider.length;
        speed_ = diskVelocity(c.disk, c.slider.length, c.slider.width, 0.5 * c.slider.length, 0.5 * c.slider.width).x;
        const Recess recess(c.surface, c.slider.length, c.slider.width);
        for (int i = 0; i <= columns; ++i) {
            double lowest = recess.at(length_ * i / columns, 0.0);
            for (int j = 1; j <= rows; ++j)
                lowest = std::min(lowest, recess.at(length_ * i / columns, c.slider.width * j / rows));
            profile_.push_back(lowest);
        }
    }
    height_.setRange({0.0, 1e-9});
    takeState();
}

void SideView::takeState()
{
    state_.reset();
    const RunRecord* run = runs_.find(number_);
    const MinMaxPyramid* height = run ? run->pyramid("height") : nullptr;
    if (!profile_.empty() && height && !height->empty()) {
        State state;
        state.time = std::clamp(time_.value_or(height->lastTime()), height->time(0), height->lastTime());
        const auto at = [&](const char* quantity) {
            const MinMaxPyramid* column = run->pyramid(quantity);
            return column ? column->valueAt(state.time).value_or(0.0) : 0.0;
        };
        state.pitch = at("pitch");
        state.trailingHeight = at("height") - 0.5 * length_ * state.pitch;
        state.spacing = at("minimum_spacing");
        state.contactForce = at("contact_force");
        state_ = state;
        // One scale for the whole run, so that movement is seen: it grows when it must.
        const double top = headRoom * std::max(heightAt(0.0) - profile_.front(), heightAt(1.0) - profile_.back());
        if (top > height_.range().high) height_.setRange({-belowDisk * 1.2 * top, 1.2 * top});
    }
    update();
}

double SideView::heightAt(double share) const
{
    const auto column = static_cast<std::size_t>(std::lround(share * columns));
    return state_->trailingHeight + state_->pitch * length_ * (1.0 - share) + profile_[column];
}

QRectF SideView::plotArea() const
{
    const double line = fontMetrics().height();
    return QRectF(rect()).adjusted(5.0 * line, 2.7 * line, -1.5 * line, -2.6 * line);
}

double SideView::exaggeration() const
{
    const QRectF area = plotArea();
    return (area.height() / (height_.range().high - height_.range().low)) / (area.width() / length_);
}

QPointF SideView::toPixel(double x, double height) const
{
    const QRectF area = plotArea();
    return {area.left() + area.width() * x / length_, area.bottom() - area.height() * height_.position(height)};
}

void SideView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const PlotTheme theme = plotTheme(palette());
    painter.fillRect(rect(), theme.background);
    if (!state_) {
        painter.setPen(theme.mutedText);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         number_ < 0 ? tr("There is nothing to show yet: run the case.")
                                     : tr("The first samples are not ready yet."));
        return;
    }
    painter.fillRect(plotArea(), theme.plotArea);
    painter.save();
    painter.setClipRect(plotArea());
    paintDisk(painter, theme);
    paintSlider(painter, theme);
    painter.restore();
    paintAxes(painter, theme);
    paintReadings(painter, theme);
}

void SideView::paintDisk(QPainter& painter, const PlotTheme& theme) const
{
    const QRectF area = plotArea();
    const double surface = toPixel(0.0, 0.0).y();
    painter.fillRect(QRectF(QPointF(area.left(), surface), area.bottomRight()), theme.grid);
    const double shift = std::fmod(speed_ * state_->time, stripeLength);
    painter.setPen(QPen(theme.mutedText, 1.0));
    for (double x = shift - stripeLength; x < length_; x += stripeLength) {
        const double pixel = toPixel(x, 0.0).x();
        painter.drawLine(QPointF(pixel, surface + 3.0), QPointF(pixel - 6.0, area.bottom()));
    }
    painter.setPen(QPen(theme.axis, 1.5));
    painter.drawLine(QPointF(area.left(), surface), QPointF(area.right(), surface));
}

void SideView::paintSlider(QPainter& painter, const PlotTheme& theme) const
{
    const double cut = ceiling * height_.range().high;
    QPolygonF outline;
    outline << toPixel(0.0, 2.0 * height_.range().high);
    for (int i = 0; i <= columns; ++i) {
        const double share = static_cast<double>(i) / columns;
        outline << toPixel(length_ * share, std::min(heightAt(share), cut));
    }
    outline << toPixel(length_, 2.0 * height_.range().high);
    QColor body = theme.curves[0];
    painter.setPen(QPen(body, 1.5));
    body.setAlphaF(0.4F);
    painter.setBrush(body);
    painter.drawPolygon(outline);

    double lowest = 0.0;
    for (int i = 1; i <= columns; ++i)
        if (heightAt(static_cast<double>(i) / columns) < heightAt(lowest)) lowest = static_cast<double>(i) / columns;
    const QPointF tip = toPixel(lowest * length_, heightAt(lowest));
    const QPointF foot = toPixel(lowest * length_, 0.0);
    const QColor mark = state_->contactForce > 0.0 ? theme.curves[1] : theme.text;
    painter.setPen(QPen(mark, 2.0));
    painter.drawLine(tip, foot);
    painter.setBrush(mark);
    painter.drawEllipse(foot, 3.5, 3.5);
}

void SideView::paintAxes(QPainter& painter, const PlotTheme& theme) const
{
    const QRectF area = plotArea();
    const double line = fontMetrics().height();
    painter.setPen(theme.axis);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area);
    painter.setPen(theme.text);
    for (const AxisTick& tick : height_.ticks(7)) {
        const double y = toPixel(0.0, tick.value).y();
        if (!tick.text.isEmpty())
            painter.drawText(QRectF(0.0, y - line / 2, area.left() - 6.0, line), Qt::AlignRight | Qt::AlignVCenter,
                             tick.text);
    }
    painter.drawText(QRectF(0.3 * line, area.top() - 1.4 * line, area.left() + 8.0 * line, line),
                     Qt::AlignLeft | Qt::AlignVCenter, height_.text());
    PlotAxis along;
    along.label = {tr("Along the slider"), QStringLiteral("mm"), unitFactor("mm"), AxisScale::Linear};
    along.setRange({0.0, length_});
    for (const AxisTick& tick : along.ticks(8))
        if (!tick.text.isEmpty())
            painter.drawText(QRectF(toPixel(tick.value, 0.0).x() - 40.0, area.bottom() + 3.0, 80.0, line),
                             Qt::AlignHCenter | Qt::AlignTop, tick.text);
    painter.drawText(QRectF(area.left(), area.bottom() + 1.2 * line, area.width(), line),
                     Qt::AlignHCenter | Qt::AlignTop, tr("%1, the disk moves from left to right").arg(along.text()));
}

void SideView::paintReadings(QPainter& painter, const PlotTheme& theme) const
{
    const QRectF area = plotArea();
    const QStringList attitude{timeText(state_->time), tr("minimum spacing %1").arg(readout(state_->spacing, "nm", 3)),
                               tr("pitch %1").arg(readout(state_->pitch, "urad", 2))};
    QStringList rest{tr("heights × %L1").arg(std::round(exaggeration()), 0, 'f', 0)};
    if (state_->contactForce > 0.0) rest.prepend(tr("contact %1").arg(forceText(state_->contactForce)));
    painter.setPen(theme.text);
    const double line = fontMetrics().height();
    double top = 0.2 * line;
    for (const QStringList& parts : {attitude, rest}) {
        painter.drawText(QRectF(0.0, top, area.right(), line), Qt::AlignRight | Qt::AlignVCenter,
                         parts.join(QStringLiteral("   ·   ")).replace(QLatin1Char('-'), QChar(0x2212)));
        top += line;
    }
}

void SideView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) update();
}

} // namespace touchdown
