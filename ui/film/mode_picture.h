// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mode as an animation: the slider over the disk from the side and from the rear, lengths to scale, heights
// exaggerated, the static state dashed. A mode has no size of its own: the motion is drawn as large as the picture
// allows, and the slider as much higher as it needs to stay above the disk.
//
// Space plays and pauses; Left and Right turn the phase by a 24th of a cycle; the right button copies and saves. A
// hidden picture rests.
#pragma once

#include <optional>

#include <QElapsedTimer>
#include <QTimer>

#include "core/simulation/static_state/steady.h"
#include "ui/plot/picture_widget.h"
#include "ui/slider/profile_drawing.h"
#include "ui/slider/slider_profile.h"

namespace touchdown {

class ModePicture : public PictureWidget {
    Q_OBJECT

public:
    explicit ModePicture(QWidget* parent = nullptr);

    /// The slider and the attitude about which it moves; no mode is shown then.
    void setState(const Case& c, const Attitude& attitude);
    void setMode(const std::optional<AirBearingMode>& mode, const QString& title);
    const std::optional<AirBearingMode>& mode() const { return mode_; }

    void setPlaying(bool playing);
    bool playing() const { return playing_; }
    /// Whether the picture moves now: it plays, has a mode and is seen.
    bool moving() const { return timer_.isActive(); }
    void setPeriod(double seconds) { period_ = seconds; } // of a cycle on the screen
    void setPhase(double phase);                          // [rad]
    double phase() const { return phase_; }

    /// As drawn: the largest motion of a corner, and how much higher the slider is than in its static state [m].
    double amplitude() const { return amplitude_; }
    double lift() const { return lift_; }
    /// The drawn attitude.
    Attitude shownAttitude() const;
    ProfileDrawing side() const;
    ProfileDrawing rear() const;

    QString title() const override { return title_; }

    QSize sizeHint() const override { return {640, 300}; }
    QSize minimumSizeHint() const override { return {240, 160}; }

signals:
    void playingChanged(bool playing);

protected:
    void paint(QPainter& painter, const PlotTheme& theme) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void advance();
    void updateTimer();
    ProfileDrawing drawing(double left, double size) const;
    void paintStill(QPainter& painter, const PlotTheme& theme, const ProfileDrawing& drawn,
                    const std::vector<double>& heights) const;
    void paintLeastMotion(QPainter& painter, const PlotTheme& theme) const;

    SliderProfile profile_;
    SliderCase slider_;
    Attitude still_; // static state, with the lift [m]
    std::vector<double> stillSide_, stillRear_;
    double amplitude_ = 0.0, lift_ = 0.0;
    PlotRange heights_;
    std::optional<AirBearingMode> mode_;
    QString title_;
    bool playing_ = true;
    double period_ = 2.0; // [s]
    double phase_ = 0.0;  // [rad]
    QTimer timer_;
    QElapsedTimer sinceFrame_;
};

} // namespace touchdown
