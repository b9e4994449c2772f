// SPDX-License-Identifier: GPL-3.0-or-later
//
// The recess of a part of a slider as a picture, made on a thread of its own: coarse at first, then pixel by pixel. A new
// request ends the one before.
#pragma once

#include <thread>

#include <QImage>
#include <QObject>
#include <QRectF>

#include "core/physics/recess.h"
#include "ui/colour_scale.h"

namespace touchdown {

class RecessPicture : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// `part` in m, its top the smallest y.
    void request(const Recess& recess, const ColourScale& scale, const QRectF& part, const QSize& pixels);
    /// Ends what goes on, and forgets the picture.
    void clear();

    /// The latest picture, the largest y uppermost, and what it shows; null before the first.
    const QImage& image() const { return image_; }
    const QRectF& part() const { return part_; }

signals:
    /// There is a picture, a finer one, or one of another part.
    void drawn();

private:
    void take(int number, const QImage& image, const QRectF& part);

    QImage image_;
    QRectF part_;
    int number_ = 0; // of the latest request
    std::jthread worker_;
};

} // namespace touchdown
