// SPDX-License-Identifier: GPL-3.0-or-later
//
// The profile of a wall as a curve: the recess downwards, as it lies on the slider seen from its side, against the
// distance from the edge.
#pragma once

#include <QWidget>

#include "core/physics/slider/air_bearing_surface.h"

namespace touchdown {

class WallPicture : public QWidget {
    Q_OBJECT

public:
    explicit WallPicture(QWidget* parent = nullptr);

    void setWall(const WallProfile& wall);
    QSize sizeHint() const override { return {200, 150}; }
    QSize minimumSizeHint() const override { return {120, 80}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    WallProfile wall_;
};

} // namespace touchdown
