// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recess_picture.h"

#include <algorithm>

#include <QMetaObject>

namespace touchdown {

namespace {

constexpr int coarse = 4; // pixels of the screen across one of the first picture

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
    const int number = ++number_;
    if (part.isEmpty() || pixels.isEmpty()) return;
    worker_ = std::jthread([this, recess, scale, part, pixels, number](const std::stop_token& stop) {
        for (const int step : {coarse, 1}) {
            const QSize size((pixels.width() + step - 1) / step, (pixels.height() + step - 1) / step);
            const QImage image = draw(recess, scale, part, size, stop);
            if (image.isNull()) return;
            QMetaObject::invokeMethod(this, [this, number, image, part] { take(number, image, part); }, Qt::QueuedConnection);
        }
    });
}

void RecessPicture::clear()
{
    worker_ = {};
    ++number_;
    image_ = {};
    emit drawn();
}

void RecessPicture::take(int number, const QImage& image, const QRectF& part)
{
    if (number != number_) return;
    image_ = image;
    part_ = part;
    emit drawn();
}

} // namespace touchdown
