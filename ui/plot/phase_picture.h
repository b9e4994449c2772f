// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves of a phase portrait with many samples, drawn on another thread: a refresh of the plot asks for the picture
// of its view. Until it is there, the picture of an earlier view stands moved and scaled at its place. The picture that
// comes is the one that the thread of the window would draw: the lines of phasePath() (ui/plot/plot_path.h).
//
// While one is drawn, only the newest view waits. Nothing is shown of curves that were removed.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QImage>
#include <QPainter>

#include "ui/calculation/task_queue.h"
#include "ui/plot/plot_axis.h"
#include "ui/plot/plot_curve.h"
#include "ui/plot/plot_theme.h"

namespace touchdown {

class PlotWidget;

class PhasePicture {
public:
    /// Of all visible curves together; fewer are drawn at once.
    static constexpr std::size_t manySamples = 200'000;
    static bool isFor(const PlotWidget& plot);

    /// `plot` outlives it. `arrived`: there is another picture.
    PhasePicture(const PlotWidget& plot, std::function<void()> arrived);
    ~PhasePicture();

    void update();
    /// The plot has no such curves any more.
    void forget();
    /// At the plot area, as the axes are now.
    void paint(QPainter& painter) const;
    /// Whether a picture is being drawn; another one may wait for it.
    bool busy() const { return busy_; }
    const QImage& image() const { return image_; }

private:
    struct Line {
        PlotCurve curve;
        std::weak_ptr<const SampleTimes> times;    // of its data
        std::shared_ptr<const MinMaxPyramid> x, y; // twins of them
    };
    struct Job {
        PlotAxis x, y;
        std::optional<PlotRange> time;
        QSizeF size;
        double pixelRatio = 1.0;
        PlotTheme theme;
        bool wide = false; // beside pale curves
        std::vector<Line> lines;
    };
    static QImage draw(const Job& job);
    Job jobOf() const;
    /// A curve in the image. The times tell it from another one at the same addresses.
    struct Drawn {
        const MinMaxPyramid* x;
        const MinMaxPyramid* y;
        std::weak_ptr<const SampleTimes> times;
    };
    bool showsOnlyCurvesOf(const PlotWidget& plot) const;

    const PlotWidget& plot_;
    std::function<void()> arrived_;
    std::unique_ptr<TaskQueue> queue_; // from the first picture on
    bool busy_ = false;
    bool again_ = false;
    int generation_ = 0; // what was begun before forget() is not shown
    QImage image_;
    QString problem_; // why the last picture could not be drawn
    PlotAxis x_, y_;  // of the image
    std::vector<Drawn> drawn_;
};

} // namespace touchdown
