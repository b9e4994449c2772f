// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves of a plot behind the wide ones, which stand still, drawn once: as long as the view does not change, a
// refresh only adds the curves that are new. So earlier runs cost nothing while a later one goes.
#pragma once

#include <vector>

#include <QImage>

#include "ui/plot/plot_curve.h"

namespace touchdown {

class PlotWidget;

class CurvePicture {
public:
    /// Whether it draws this curve, always pale.
    static bool holds(const PlotCurve& curve) { return curve.visible && curve.still && !curve.leads; }

    void update(const PlotWidget& plot);
    /// The next update draws all anew: for other data at the same place.
    void forget() { drawn_.clear(), image_ = {}; }
    /// The next update draws all anew; until then the picture stays.
    void expire() { view_ = {}; }
    /// At the plot area.
    void paint(QPainter& painter, const QRectF& area) const;
    /// Lines drawn since the beginning: does not grow while nothing changes.
    long long linesDrawn() const { return linesDrawn_; }

private:
    /// All that decides where a line is and how it looks.
    struct View {
        PlotRange x, y;
        AxisScale xScale = AxisScale::Linear, yScale = AxisScale::Linear;
        std::optional<PlotRange> time;
        QSizeF size;
        double pixelRatio = 0.0;
        QList<QColor> colours;
        QColor paper;
        bool operator==(const View&) const = default;
    };
    struct Line {
        QString id;
        const MinMaxPyramid* data;
        const MinMaxPyramid* xData;
        std::size_t samples;
        CurveStyle style;
        bool operator==(const Line&) const = default;
    };

    QImage image_; // null: nothing to draw
    View view_;
    std::vector<Line> drawn_;
    long long linesDrawn_ = 0;
};

} // namespace touchdown
