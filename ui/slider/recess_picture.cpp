// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/recess_picture.h"

#include <utility>

#include <QCoreApplication>
#include <QEvent>

namespace touchdown {

namespace {

constexpr int coarse = 4; // pixels of the screen across one of the first picture
constexpr auto mailEvent = QEvent::User;

/// A null image when stopped.
QImage draw(const Recess& recess, const ColourScale& scale, const QRectF& part, const QSize& pixels,
            const std::stop_token& stop)
{
    QImage image(pixels, QImage::Format_RGB32);
    for (int row = 0; row < pixels.height(); ++row) {
        if (stop.stop_requested()) return {};
        const double y = part.bottom() - (row + 0.5) / pixels.height() * part.height();
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
        for (int column = 0; column < pixels.width(); ++column)
            line[column] = scale.colour(recess.at(part.left() + (column + 0.5) / pixels.width() * part.width(), y));
    }
    return image;
}

} // namespace

void RecessPicture::request(const Recess& recess, const ColourScale& scale, const QRectF& part, const QSize& pixels)
{
    worker_ = {}; // stops and joins: within a row of pixels
    if (part.isEmpty() || pixels.isEmpty()) return;
    worker_ = std::jthread([this, recess, scale, part, pixels](const std::stop_token& stop) {
        for (const int step : {coarse, 1}) {
            const QSize size((pixels.width() + step - 1) / step, (pixels.height() + step - 1) / step);
            const QImage image = draw(recess, scale, part, size, stop);
            if (image.isNull()) return;
            send(image, part);
        }
    });
}

void RecessPicture::clear()
{
    worker_ = {};
    sentImage_ = {};
    image_ = {};
    emit drawn();
}

void RecessPicture::send(const QImage& image, const QRectF& part)
{
    {
        const std::lock_guard lock(mailbox_);
        sentImage_ = image;
        sentPart_ = part;
    }
    QCoreApplication::postEvent(this, new QEvent(mailEvent));
}

void RecessPicture::customEvent(QEvent* event)
{
    if (event->type() != mailEvent) return;
    {
        const std::lock_guard lock(mailbox_);
        if (sentImage_.isNull()) return;
        image_ = std::exchange(sentImage_, {});
        part_ = sentPart_;
    }
    emit drawn();
}

} // namespace touchdown
