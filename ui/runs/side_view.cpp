// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/side_view.h"

#include <algorithm>
#include <cmath>

#include <QContextMenuEvent>
#include <QMenu>
#include <QPainter>
#include <QTextStream>

#include "core/formats/units.h"
#include "core/physics/disk/disk_velocity.h"
#include "ui/plot/laid_out_as.h"
#include "ui/plot/picture_menu.h"
#include "ui/plot/plot_frame.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/slider/slider_profile.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr double headRoom = 1.25;     // above the highest pad
constexpr double sideOnPaper = 480.0; // width in which the texts have room [px]

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
    springs_.reset();
    const RunRecord* run = runs_.find(number_);
    if (run && run->value.model == ModelKind::Film) {
        const Case& c = run->value;
        length_ = c.slider.length;
        speed_ = diskVelocity(c.disk, c.slider.length, c.slider.width, 0.5 * c.slider.length, 0.5 * c.slider.width).x;
        centre_ = 0.5 * length_;
        profile_ = SliderProfile(c).fromSide({});
    } else if (run && run->value.model == ModelKind::Springs) {
        springs_.emplace(run->value);
        length_ = springs_->length();
        centre_ = springs_->centre();
        speed_ = 0.0;
        profile_.assign(SliderProfile::along + 1, 0.0);
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
        state.trailingHeight = at("height") - (length_ - centre_) * state.pitch;
        state.separation = at("flying_height");
        state.spacing = at("minimum_spacing");
        state.contactForce = at("contact_force");
        state.disk = {at("front_disk_height"), at("rear_disk_height"), at("disk_height")};
        state_ = state;
        // One scale for the whole run, so that movement is seen: it grows when it must.
        const double top = headRoom * std::max(heightAt(0.0) - profile_.front(), heightAt(1.0) - profile_.back());
        if (top > height_.range().high) height_.setRange({-ProfileDrawing::belowDisk * 1.2 * top, 1.2 * top});
    }
    update();
}

std::optional<PlotRange> SideView::span() const
{
    const RunRecord* run = runs_.find(number_);
    const MinMaxPyramid* height = run && !profile_.empty() ? run->pyramid("height") : nullptr;
    if (!height || height->empty()) return std::nullopt;
    return PlotRange{height->time(0), height->lastTime()};
}

double SideView::heightAt(double share) const
{
    const auto column = static_cast<std::size_t>(std::lround(share * SliderProfile::along));
    return state_->trailingHeight + state_->pitch * length_ * (1.0 - share) + profile_[column];
}

QRectF SideView::plotArea() const
{
    const double line = fontMetrics().height();
    return QRectF(rect()).adjusted(5.0 * line, 2.7 * line, -1.5 * line, -2.6 * line);
}

ProfileDrawing SideView::drawing() const { return {plotArea(), length_, height_.range()}; }

double SideView::exaggeration() const { return drawing().exaggeration(); }

void SideView::contextMenuEvent(QContextMenuEvent* event)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    addPictureActions(*menu, *this);
    menu->popup(event->globalPos());
}

void SideView::writeProfile(QIODevice& device) const
{
    QTextStream out(&device);
    const auto number = [](double value) { return QString::fromStdString(formatNumber(value)); };
    out << "x [m],height of the slider above the mean plane of the disk [m]\n";
    for (int i = 0; i <= SliderProfile::along; ++i) {
        const double share = static_cast<double>(i) / SliderProfile::along;
        out << number(share * length_) << ',' << number(heightAt(share)) << '\n';
    }
}

void SideView::paintInto(QPainter& painter, const QRectF& target, const PlotTheme& theme)
{
    painter.save();
    painter.translate(target.topLeft());
    painter.scale(target.width() / width(), target.height() / height());
    painter.setFont(plotTextFont(font()));
    paint(painter, theme);
    painter.restore();
}

void SideView::paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours)
{
    const double wider = widening(size.width(), sideOnPaper);
    const LaidOutAs laidOut(*this, wider * size, font);
    painter.save();
    painter.scale(1.0 / wider, 1.0 / wider);
    painter.setFont(font);
    paint(painter, paperTheme(colours));
    painter.restore();
}

double SideView::heightOnPaper(double width, const QFont& /*font*/) const { return 0.6 * width; }

std::function<void(QIODevice&)> SideView::dataWriter() const
{
    if (!state_) return {};
    return [this](QIODevice& device) { writeProfile(device); };
}

void SideView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paint(painter, plotTheme(palette()));
}

void SideView::paint(QPainter& painter, const PlotTheme& theme) const
{
    painter.setRenderHint(QPainter::Antialiasing);
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
    drawing().paintDisk(painter, theme);
    if (!springs_) drawing().paintMotion(painter, theme, speed_ * state_->time);
    paintSlider(painter, theme);
    if (springs_) {
        springs_->paintSprings(painter, theme, drawing(), heightAt(0.0), heightAt(1.0), state_->disk);
        springs_->paintPad(painter, theme, plotArea(), state_->separation, state_->contactForce > 0.0);
    }
    painter.restore();
    paintAxes(painter, theme);
    paintReadings(painter, theme);
}

void SideView::paintSlider(QPainter& painter, const PlotTheme& theme) const
{
    const ProfileDrawing drawn = drawing();
    std::vector<double> heights;
    double lowest = 0.0;
    for (int i = 0; i <= SliderProfile::along; ++i) {
        const double share = static_cast<double>(i) / SliderProfile::along;
        heights.push_back(heightAt(share));
        if (heights.back() < heightAt(lowest)) lowest = share;
    }
    drawn.paintSlider(painter, theme, heights);
    if (springs_) return; // their pad has a picture of its own

    const QPointF tip = drawn.toPixel(lowest * length_, heightAt(lowest));
    const QPointF foot = drawn.toPixel(lowest * length_, 0.0);
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
    drawing().paintFrame(painter, theme, tr("Along the slider"),
                         springs_ ? tr(", the leading edge at the left") : tr(", the disk moves from left to right"));
    painter.setPen(theme.text);
    for (const AxisTick& tick : height_.ticks(7)) {
        const double y = drawing().toPixel(0.0, tick.value).y();
        if (!tick.text.isEmpty())
            painter.drawText(QRectF(0.0, y - line / 2, area.left() - 6.0, line), Qt::AlignRight | Qt::AlignVCenter,
                             tick.text);
    }
    painter.drawText(QRectF(0.3 * line, area.top() - 1.4 * line, area.left() + 8.0 * line, line),
                     Qt::AlignLeft | Qt::AlignVCenter, height_.text());
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
