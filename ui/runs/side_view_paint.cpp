// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the side view draws.
#include "ui/runs/side_view.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/runs/disk_profile.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/slider/slider_profile.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

void SideView::paint(QPainter& painter, const PlotTheme& theme)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme.background);
    if (!first_.state) {
        painter.setPen(theme.mutedText);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         first_.number < 0 ? tr("There is nothing to show yet: run the case.")
                                           : tr("The first samples are not ready yet."));
        return;
    }
    painter.fillRect(plotArea(), theme.plotArea);
    painter.save();
    painter.setClipRect(plotArea());
    const State& state = *first_.state;
    if (disk_->empty())
        drawing().paintDisk(painter, theme);
    else
        drawing().paintDisk(painter, theme, disk_->at(state.time));
    if (!first_.springs) drawing().paintMotion(painter, theme, first_.speed * state.time);
    if (second_.state) drawing().paintOutline(painter, penOf(second_, theme), second_.length, second_.heights());
    paintSlider(painter, theme);
    if (first_.springs)
        first_.springs->paintSprings(painter, theme, drawing(), heightAt(0.0), heightAt(1.0), state.disk);
    painter.restore();
    if (first_.springs) first_.springs->paintPad(painter, theme, padArea(), state.separation, state.contactForce > 0.0);
    paintAxes(painter, theme);
    paintReadings(painter, theme);
    paintLegend(painter, theme);
    paintRemark(painter, theme);
}

void SideView::paintSlider(QPainter& painter, const PlotTheme& theme) const
{
    const ProfileDrawing drawn = drawing();
    const std::vector<double> heights = first_.heights();
    drawn.paintSlider(painter, penOf(first_, theme).color(), heights);
    if (first_.springs) return; // their pad has a picture of its own

    const bool uneven = disk_->state() == DiskProfile::State::Uneven;
    const auto diskAt = [&](int column) {
        return uneven ? disk_->heightAt(column * first_.length / SliderProfile::along, first_.state->time) : 0.0;
    };
    int lowest = 0;
    for (int i = 1; i <= SliderProfile::along; ++i)
        if (heights[static_cast<std::size_t>(i)] - diskAt(i) <
            heights[static_cast<std::size_t>(lowest)] - diskAt(lowest))
            lowest = i;
    const double x = lowest * first_.length / SliderProfile::along;
    const QPointF tip = drawn.toPixel(x, heights[static_cast<std::size_t>(lowest)]);
    const QPointF foot = drawn.toPixel(x, diskAt(lowest));
    const QColor mark = first_.state->contactForce > 0.0 ? theme.curves[1] : theme.text;
    painter.setPen(QPen(mark, 2.0));
    painter.drawLine(tip, foot);
    painter.setBrush(mark);
    painter.drawEllipse(foot, 3.5, 3.5);
}

/// The shown run is drawn through, the second one dashed.
QPen SideView::penOf(const Seen& seen, const PlotTheme& theme) const
{
    const RunRecord* run = runs_.find(seen.number);
    QPen pen(run ? theme.colour(RunsModel::style(*run)) : theme.axis, 1.5);
    if (&seen == &second_) pen.setDashPattern({5.0, 3.0});
    return pen;
}

/// Name and spacing of both runs; one alone needs no name.
void SideView::paintLegend(QPainter& painter, const PlotTheme& theme) const
{
    if (!second_.state) return;
    constexpr double sample = 22.0, gap = 6.0; // [px]
    const double line = painter.fontMetrics().height();
    QRectF row(plotArea().topLeft() + QPointF(gap, gap), QSizeF(0.0, line));
    for (const Seen* seen : {&first_, &second_}) {
        const RunRecord* run = runs_.find(seen->number);
        const QString spacing = readout(seen->state->spacing, "nm", 3);
        const QString text =
            painter.fontMetrics().elidedText(tr("%1: minimum spacing %2").arg(run->label, spacing), Qt::ElideMiddle,
                                             static_cast<int>(plotArea().width() - sample - 4.0 * gap));
        row.setWidth(sample + 2.0 * gap + painter.fontMetrics().horizontalAdvance(text));
        QColor paper = theme.plotArea;
        paper.setAlphaF(0.85F);
        painter.fillRect(row, paper);
        painter.setPen(penOf(*seen, theme));
        painter.drawLine(QPointF(row.left() + 2.0, row.center().y()), QPointF(row.left() + sample, row.center().y()));
        painter.setPen(theme.text);
        painter.drawText(row.adjusted(sample + gap, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter, text);
        row.moveTop(row.bottom());
    }
}

/// Why an uneven disk is drawn flat.
void SideView::paintRemark(QPainter& painter, const PlotTheme& theme) const
{
    QString text;
    if (disk_->state() == DiskProfile::State::BeingMade) text = tr("The surface of the disk is being made.");
    if (disk_->state() == DiskProfile::State::Failed)
        text = tr("The surface of the disk is not drawn: %1").arg(disk_->problem());
    if (text.isEmpty()) return;
    const QRectF room = plotArea().adjusted(6.0, 6.0, -6.0, -6.0);
    const int flags = Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap;
    painter.fillRect(painter.boundingRect(room, flags, text), theme.plotArea);
    painter.setPen(theme.text);
    painter.drawText(room, flags, text);
}

void SideView::paintAxes(QPainter& painter, const PlotTheme& theme) const
{
    const QRectF area = plotArea();
    const double line = fontMetrics().height();
    drawing().paintFrame(painter, theme, tr("Along the slider"),
                         first_.springs ? tr(", the leading edge at the left")
                                        : tr(", the disk moves from left to right"));
    painter.setPen(theme.text);
    const int most = std::clamp(static_cast<int>(area.height() / (1.6 * line)), 2, 7);
    for (const AxisTick& tick : height_.ticks(most)) {
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
    const double right = width() - 1.5 * fontMetrics().height();
    const State& state = *first_.state;
    const QString spacing = state.aboveDisk ? tr("minimum gap above the disk %1") : tr("minimum spacing %1");
    const QStringList attitude{timeText(state.time), spacing.arg(readout(state.spacing, "nm", 3)),
                               tr("pitch %1").arg(readout(state.pitch, "urad", 2))};
    QStringList rest{tr("heights × %L1").arg(std::round(exaggeration()), 0, 'f', 0)};
    if (state.contactForce > 0.0) rest.prepend(tr("contact %1").arg(forceText(state.contactForce)));
    painter.setPen(theme.text);
    const double line = fontMetrics().height();
    double top = 0.2 * line;
    for (const QStringList& parts : {attitude, rest}) {
        painter.drawText(QRectF(0.0, top, right, line), Qt::AlignRight | Qt::AlignVCenter,
                         parts.join(QStringLiteral("   ·   ")));
        top += line;
    }
}

} // namespace touchdown
