// SPDX-License-Identifier: GPL-3.0-or-later
//
// The recess of a part of a slider as a picture, made on its own thread: coarse at first, then pixel by pixel. A
// new request ends the one before. Pictures cross the thread border by value under a mutex; only the news that there is
// one goes through Qt's queue.
#pragma once

#include <mutex>
#include <thread>

#include <QImage>
#include <QObject>
#include <QRectF>

#include "core/physics/slider/recess.h"
#include "ui/plot/colour_scale.h"

namespace touchdown {

class RecessPicture : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// `part` in m, its top the smallest y.
    void request(const Recess& recess, const ColourScale& scale, const QRectF& part, const QSize& pixels);
    /// Stops the calculation and discards the picture.
    void clear();

    /// The latest picture, the largest y uppermost, and what it shows; null before the first.
    const QImage& image() const { return image_; }
    const QRectF& part() const { return part_; }

signals:
    /// There is a picture, a finer one, or one of another part.
    void drawn();

protected:
    void customEvent(QEvent* event) override;

private:
    void send(const QImage& image, const QRectF& part);

    QImage image_;
    QRectF part_;
    std::mutex mailbox_;
    QImage sentImage_; // null: nothing new
    QRectF sentPart_;
    std::jthread worker_; // last, so that it ends before what it uses
};

} // namespace touchdown
