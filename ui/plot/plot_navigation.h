// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mouse and keys of a plot; see the list in plot_widget.h.
#pragma once

#include "ui/plot/plot_widget.h"

class QHelpEvent;
class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace touchdown {

class PlotNavigation : public QObject {
    Q_OBJECT

public:
    /// Lives as long as `plot`.
    explicit PlotNavigation(PlotWidget* plot);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Drag { None, Box, Move, Cursor };

    bool wheel(const QWheelEvent& event);
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    bool doubleClick(const QMouseEvent& event);
    bool key(const QKeyEvent& event);
    void leave();
    void showToolTip(const QHelpEvent& event) const;
    QStringList linesAt(const QPointF& at) const;

    QPointF inArea(const QPointF& pixel) const; // 0 to 1, y upwards
    std::optional<int> cursorNear(const QPointF& pixel) const;
    void zoom(double factorX, double factorY, const QPointF& about, PlotWidget::Gesture gesture);
    void shift(double partX, double partY, PlotWidget::Gesture gesture);
    void zoomToBox(const QPointF& from, const QPointF& to);
    void click(const QMouseEvent& event);
    double cursorAt(const QMouseEvent& event) const;

    PlotWidget& plot_;
    Drag drag_ = Drag::None;
    bool dragged_ = false; // far enough to be no click
    int draggedCursor_ = 0;
    QPointF pressedAt_;
    PlotView pressedView_;
    PlotRange pressedX_;
    PlotRange pressedY_;
    std::optional<double> cursorBefore_; // the click
    bool pinnedBefore_ = false;
};

} // namespace touchdown
