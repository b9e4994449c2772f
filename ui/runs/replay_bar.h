// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plays and scrubs through what the plots show of a run. One pass takes ten seconds, whatever time it spans: the time
// that passes in a second stands beside it.
#pragma once

#include <functional>
#include <optional>

#include <QElapsedTimer>
#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "ui/plot/plot_axis.h"

namespace touchdown {

class ReplayBar : public QWidget {
    Q_OBJECT

public:
    static constexpr double passSeconds = 10.0;

    /// `span` is asked for the time to replay [s] whenever it is needed; nothing: there is no run.
    explicit ReplayBar(std::function<std::optional<PlotRange>()> span, QWidget* parent = nullptr);

    /// Where the pictures stand [s]; nothing: at the end.
    void showTime(const std::optional<double>& time);
    /// From the beginning where it stands at the end.
    void setPlaying(bool playing);
    bool playing() const { return timer_.isActive(); }
    /// As much as passes in so many seconds of a replay; stops at the end.
    void advance(double seconds);

    QSlider* slider() const { return slider_; }
    QToolButton* button() const { return button_; }

signals:
    void timeChosen(double time);

protected:
    void changeEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void choose(double share);
    void describe();

    std::function<std::optional<PlotRange>()> span_;
    QTimer timer_;
    QElapsedTimer clock_;
    QToolButton* button_;
    QSlider* slider_;
    QLabel *time_, *speed_;
    double share_ = 1.0; // of the span
};

} // namespace touchdown
