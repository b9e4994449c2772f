// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of the side view of the model springs: the two air springs under their pressure centres, the height of an
// uneven disk under these and under the pad, the heights at which the contact law switches, and the pad near the disk
// in a picture of its own, in which nanometres are seen.
#pragma once

#include <optional>

#include "core/case/case.h"
#include "ui/slider/profile_drawing.h"

namespace touchdown {

class SpringsDrawing {
public:
    explicit SpringsDrawing(const Case& c);

    /// Length of the slider as it is drawn [m]; at the front it reaches a little beyond its outermost point.
    double length() const { return length_; }
    /// Distance of the mass centre from the leading end [m].
    double centre() const { return centre_; }

    /// Heights of the disk above its mean plane [m].
    struct Disk {
        double front = 0.0, rear = 0.0, pad = 0.0;
        bool flat() const { return front == 0.0 && rear == 0.0 && pad == 0.0; }
    };
    /// Two springs between the disk and the slider, whose bottom has these heights at its leading and trailing end [m].
    void paintSprings(QPainter& painter, const PlotTheme& theme, const ProfileDrawing& drawing, double leading,
                      double trailing, const Disk& disk) const;
    /// The pad in `frame`, at this separation [m]; `pressed`: it touches. Nothing without contact.
    void paintPad(QPainter& painter, const PlotTheme& theme, const QRectF& frame, double separation,
                  bool pressed) const;
    /// Heights up to which the pad's own picture reaches [m]; 0 without contact.
    double padReach() const { return reach_; }

private:
    double frontDistance_, rearDistance_, padDistance_; // from the mass centre [m]
    double length_, centre_;
    std::optional<OnoYamane> characteristic_; // its levels are shown
    double reach_ = 0.0;
};

} // namespace touchdown
