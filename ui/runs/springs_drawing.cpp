// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/springs_drawing.h"

#include <algorithm>
#include <array>

#include <QPainterPath>

#include "core/case/contact_law.h"
#include "ui/style/quantity_format.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr double overhang = 0.08;                  // at the front, of the distance between the outermost points
constexpr int coils = 7;                           // of a drawn spring
constexpr double coilWidth = 9.0;                  // [px]
constexpr double levelWidth = 16.0;                // of the disk's height under a foot, to each side [px]
constexpr double padMiddle = 0.78, padHalf = 0.15; // of the width of the pad's picture
constexpr double reachesShown = 3.0;               // heights of the pad's picture, in reaches of the contact law

void paintCoils(QPainter& painter, const QPointF& foot, const QPointF& head)
{
    QPainterPath path(foot);
    for (int i = 0; i < 2 * coils; ++i) {
        const double share = (i + 0.5) / (2 * coils);
        path.lineTo(foot + share * (head - foot) + QPointF(i % 2 == 0 ? coilWidth : -coilWidth, 0.0));
    }
    path.lineTo(head);
    painter.drawPath(path);
    painter.drawEllipse(head, 2.5, 2.5);
}

} // namespace

SpringsDrawing::SpringsDrawing(const Case& c)
    : frontDistance_(c.springs.frontDistance),
      rearDistance_(c.springs.rearDistance),
      padDistance_(c.springs.padDistance)
{
    const double ahead = std::max(frontDistance_, -padDistance_), behind = std::max(rearDistance_, padDistance_);
    const double beyond = overhang * std::max(ahead + behind, 1e-6);
    length_ = ahead + behind + beyond; // at the rear it ends with its outermost point: nothing is lower
    centre_ = ahead + beyond;
    if (c.contact == noContact || !contactActs(c)) return;
    characteristic_ = characteristic(c);
    reach_ = reachesShown * std::max(contactLaw(c).reach(c), 1e-10);
}

void SpringsDrawing::paintSprings(QPainter& painter, const PlotTheme& theme, const ProfileDrawing& drawing,
                                  double leading, double trailing, const Disk& disk) const
{
    const double pad = centre_ + padDistance_;
    const std::array<std::array<double, 2>, 2> feet{
        {{centre_ - frontDistance_, disk.front}, {centre_ + rearDistance_, disk.rear}}};
    if (!disk.flat()) {
        painter.setPen(QPen(theme.axis, 3.0));
        const auto level = [&](double along, double height) {
            const QPointF middle = drawing.toPixel(along, height);
            painter.drawLine(middle - QPointF(levelWidth, 0.0), middle + QPointF(levelWidth, 0.0));
        };
        for (const auto& [along, height] : feet) level(along, height);
        level(pad, disk.pad);
    }
    painter.setPen(QPen(theme.text, 1.4));
    painter.setBrush(theme.text);
    for (const auto& [along, height] : feet) {
        const double bottom = leading + (trailing - leading) * along / length_;
        painter.save();
        painter.setBrush(Qt::NoBrush);
        paintCoils(painter, drawing.toPixel(along, height), drawing.toPixel(along, std::max(bottom, height)));
        painter.restore();
    }
    if (reach_ == 0.0) return;
    const double bottom = leading + (trailing - leading) * pad / length_;
    painter.drawRect(QRectF(drawing.toPixel(pad, bottom) - QPointF(7.0, 5.0), QSizeF(14.0, 5.0)));
}

void SpringsDrawing::paintPad(QPainter& painter, const PlotTheme& theme, const QRectF& frame, double separation,
                              bool pressed) const
{
    if (reach_ == 0.0) return;
    const double line = painter.fontMetrics().height();
    painter.fillRect(frame, theme.plotArea);
    const QRectF inner = frame.adjusted(0.0, 1.3 * line, 0.0, 0.0);
    const ProfileDrawing near{inner, 1.0, {-0.15 * reach_, reach_}};
    painter.save();
    painter.setClipRect(inner);
    near.paintDisk(painter, theme);
    double left = inner.left() + 6.0; // beside each other: on a small picture the levels are close
    const auto level = [&](double height, const QString& name, bool above) {
        const double y = near.toPixel(0.0, height).y(), width = painter.fontMetrics().horizontalAdvance(name);
        const QRectF place(left, above ? y - line : y + 1.0, width, line);
        painter.setPen(QPen(theme.mutedText, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(inner.left(), y), QPointF(inner.right(), y));
        painter.fillRect(place, theme.plotArea); // no other line crosses it
        painter.setPen(theme.mutedText);
        painter.drawText(place, Qt::AlignLeft | Qt::AlignBottom, name);
        left += width + 10.0;
    };
    if (characteristic_) {
        const QString down = QStringLiteral("dₛ ") + lengthText(characteristic_->touchDown, 3);
        const QString up = QStringLiteral("dₑ ") + lengthText(characteristic_->takeOff, 3);
        const double wanted = painter.fontMetrics().horizontalAdvance(down + up) + 20.0;
        const bool room = wanted < (padMiddle - padHalf) * inner.width();
        const bool downAbove = characteristic_->touchDown > characteristic_->takeOff;
        level(characteristic_->touchDown, room ? down : QStringLiteral("dₛ"), downAbove);
        level(characteristic_->takeOff, room ? up : QStringLiteral("dₑ"), !downAbove);
    }
    QColor body = theme.mutedText; // of no run
    painter.setPen(QPen(body, 1.5));
    body.setAlphaF(0.4F);
    painter.setBrush(body);
    const QPointF bottom = near.toPixel(padMiddle, separation);
    painter.drawRect(
        QRectF(QPointF(near.toPixel(padMiddle - padHalf, 0.0).x(), inner.top() - 10.0),
               QPointF(near.toPixel(padMiddle + padHalf, 0.0).x(), std::max(bottom.y(), inner.top() - 9.0))));
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(theme.axis);
    painter.drawRect(frame);
    painter.setPen(theme.text);
    painter.drawText(frame.adjusted(6.0, 0.2 * line, -6.0, 0.0), Qt::AlignLeft | Qt::AlignTop,
                     (pressed ? tr("Pad in contact at %1") : tr("Pad at %1")).arg(lengthText(separation, 4)) +
                         (separation > reach_ ? QStringLiteral(" ↑") : QString()));
}

} // namespace touchdown
