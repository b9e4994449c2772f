// SPDX-License-Identifier: GPL-3.0-or-later
//
// A plot of curves over time (or frequency, or another quantity), drawn by Qt Charts, which no other class of ours
// sees.
//
// Call dataChanged() after the pyramids have grown: the picture follows at most 60 times a second, less often when a
// refresh takes long, and not at all while the plot is hidden. The plot area depends on size, font and labels of
// reference lines only: plots of equal width under each other have equal time axes.
//
// Mouse: wheel zooms x about the pointer, Ctrl + wheel (or over the numbers of y) zooms y, Shift + wheel zooms both;
// a phase portrait always zooms both. Left drag zooms to the box, a flat box in one direction only. Middle or right
// drag moves. Double click fits. Cursor 1 follows the pointer until a click pins it; Shift + click sets cursor 2;
// Escape takes both away. In a phase portrait a click sets them to the time of the nearest point. In a plot over
// frequency both go to the nearest peak, unless Ctrl is held. Right click: menu. Keys: arrows move, + and - zoom x,
// Ctrl with + and - zoom y, Home fits, Backspace or Alt + Left and Alt + Right walk through the zoom history, Shift +
// Left and Shift + Right move cursor 1 by a pixel, L switches y between linear and logarithmic.
//
// A plot does not keep the zoom history: the PlotGroup does (a lone plot gets a group of its own).
#pragma once

#include "ui/plot/curve_picture.h"
#include "ui/plot/phase_picture.h"
#include "ui/plot/plot_axis.h"
#include "ui/plot/plot_curve.h"
#include "ui/plot/plot_export.h"
#include "ui/plot/plot_frame.h"

#include <array>
#include <functional>
#include <vector>

#include <QTimer>
#include <QWidget>

namespace touchdown {

class PlotCanvas;
struct PaperSheet;

class PlotWidget : public QWidget, public PagePart {
    Q_OBJECT

public:
    /// Actions of the user on the view: consecutive gestures of one kind are one step of the history.
    enum class Gesture { WheelIn, WheelOut, Box, Move, Fit, Key };
    Q_ENUM(Gesture)

    explicit PlotWidget(QWidget* parent = nullptr);

    void setTitle(const QString& title);
    QString title() const override { return title_; }
    void setXLabel(const AxisLabel& label); // as made: "Time", "s"
    void setYLabel(const AxisLabel& label);
    void setYScale(AxisScale scale);
    const PlotAxis& xAxis() const { return x_; }
    const PlotAxis& yAxis() const { return y_; }
    /// Only the lowest of stacked plots needs numbers and title below.
    void setXNumbersVisible(bool visible);
    bool xNumbersVisible() const { return xNumbersVisible_; }

    /// A curve with the same id is replaced in its place. The view, the cursors and the other curves stay.
    void addCurve(const PlotCurve& curve);
    void removeCurve(const QString& id);
    void clearCurves();
    /// All of them at once.
    void setCurves(std::vector<PlotCurve> curves);
    /// Changes how curves are shown; not their data.
    void updateCurves(const std::function<void(PlotCurve&)>& change);
    void setCurveVisible(const QString& id, bool visible);
    const std::vector<PlotCurve>& curves() const { return curves_; }
    /// Whether visible curves stand behind others.
    bool hasPaleCurves() const;
    /// The pale curves that stand still, as they were drawn last.
    const CurvePicture& stillPicture() const { return stillPicture_; }
    /// All curves of a phase portrait of many samples.
    const PhasePicture& phasePicture() const { return phasePicture_; }

    void setReferenceLines(std::vector<ReferenceLine> lines);
    void setEventMarks(std::vector<EventMark> marks);
    void setPointMarks(std::vector<PointMark> marks);
    void setShadedAreas(std::vector<ShadedArea> areas);
    const std::vector<ReferenceLine>& referenceLines() const { return referenceLines_; }
    /// What their labels and the colour bar of a backdrop need in the font of the window or of paper, whether or not
    /// the axes show the lines.
    LabelRoom labelRoom(const QFont& font) const;
    /// Plots with one axis of time leave as much room at the right as the plot with the widest labels [px].
    void setLeastLabelWidth(double width);
    const std::vector<EventMark>& eventMarks() const { return eventMarks_; }
    const std::vector<PointMark>& pointMarks() const { return pointMarks_; }
    const std::vector<ShadedArea>& shadedAreas() const { return shadedAreas_; }
    /// Nothing takes it away.
    void setBackdrop(std::optional<PlotBackdrop> backdrop);
    const std::optional<PlotBackdrop>& backdrop() const { return backdrop_; }

    /// The data behind the curves or what is shown of them changed: refresh soon.
    void dataChanged();
    /// At once, as before a picture is taken.
    void refreshNow();
    long long refreshes() const { return refreshes_; }

    /// Shows this; emits nothing.
    void setView(const PlotView& view);
    const PlotView& view() const { return view_; }
    /// Range of the visible curves that lead, or of all visible ones (see setEverything); none without samples. In a
    /// phase portrait the range of x, not of time.
    std::optional<PlotRange> dataRangeX() const;
    /// Automatic ranges are those of all visible curves, not only of those that lead.
    void setEverything(bool everything);
    /// The automatic ranges are those of all visible curves, not of the curves that lead alone.
    void setAllDecide(bool all);
    /// The part of the history that a phase portrait shows; everything when nothing.
    void setTimeWindow(std::optional<PlotRange> window);
    const std::optional<PlotRange>& timeWindow() const { return timeWindow_; }
    /// Whether a quantity stands across instead of the time: as set, or as a curve says.
    bool isPhasePortrait() const;
    /// From the beginning, before the first curve comes. Its view begins anew.
    void setPhasePortrait(bool phase);
    /// What the automatic x range of a phase portrait leaves out, as a fall from afar: it ends at `most` where there
    /// are data below.
    void setMostX(std::optional<double> most);

    /// Cursor 0 or 1 ("1" and "2" on the screen); an empty value removes it. Emits nothing.
    void setPlotCursor(int which, std::optional<double> x);
    std::optional<double> plotCursor(int which) const { return cursors_[static_cast<std::size_t>(which)]; }

    /// A pinned cursor 1 does not follow the pointer. Emits nothing.
    void setCursorPinned(bool pinned) { cursorPinned_ = pinned; }
    bool cursorPinned() const { return cursorPinned_; }
    /// A cursor that the mouse sets goes to the nearest peak (ui/plot/cursor_place.h), unless Ctrl is held.
    void setCursorsSnap(bool snap) { cursorsSnap_ = snap; }
    bool cursorsSnap() const { return cursorsSnap_; }

    /// Where the curves are, in pixels of this widget.
    QRectF plotArea() const;
    QPointF toPixel(double x, double y) const;

    /// The whole plot as vectors and text into `target`, in the colours of `theme`, without cursors. The proportions
    /// of the screen stay.
    void paintInto(QPainter& painter, const QRectF& target, const PlotTheme& theme) override;
    double heightOnPaper(double width, const QFont& font) const override;
    void paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours) override;
    /// With the styles that curves have in the whole figure.
    void paintOnSheet(QPainter& painter, const PaperSheet& sheet);
    std::function<void(QIODevice&)> dataWriter() const override;
    /// The visible curves as drawn, in the same order as curves(), in parts of the plot area (0 to 1, y upwards).
    std::vector<std::vector<QPointF>> curvePaths() const;
    std::vector<QPointF> curvePath(const PlotCurve& curve, bool* waits = nullptr) const;
    /// With the details that an area of that size can show [px].
    std::vector<QPointF> curvePath(const PlotCurve& curve, const QSizeF& size, bool* waits = nullptr) const;
    /// The same for the screen, with fewer points.
    std::vector<QPointF> drawnPath(const PlotCurve& curve) const;
    /// Those of a phase portrait as they were drawn last, without those of pictures of curves.
    const std::vector<std::vector<QPointF>>& phasePaths() const { return phasePaths_; }
    const PlotTheme& theme() const { return theme_; }

    QSize sizeHint() const override { return {640, 220}; }
    /// Title, numbers and curves can be read.
    QSize minimumSizeHint() const override;

signals:
    /// The user changed the view, which is already shown.
    void viewChanged(const touchdown::PlotView& view, touchdown::PlotWidget::Gesture gesture);
    /// The user asks for the view one step back (-1) or forth (+1).
    void historyRequested(int step);
    /// The user moved (or took away: valid false) cursor 0 or 1. It is already shown.
    void cursorMoved(int which, bool valid, double x);
    void cursorPinnedChanged(bool pinned);
    /// The pointer came to the entry of this curve in the legend, or left it: empty.
    void legendHovered(const QString& curve);
    /// Other labels of reference lines, or the plot is shown or hidden with them.
    void labelsChanged();
    /// Right click at this place of the screen.
    void menuRequested(const QPoint& at);

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    friend class PlotNavigation;

    void moveArea();
    void refreshWithin(int milliseconds);
    void refreshLines();
    void refreshRanges();
    void userView(const PlotView& view, Gesture gesture);
    void userCursor(int which, std::optional<double> x);
    void userPin(bool pinned);
    void repaintCursor(int which);
    void showSelection(std::optional<QRectF> box);
    std::optional<PlotRange> dataRangeY() const;
    bool anyLeads() const;
    bool decides(const PlotCurve& curve, bool anyLeads) const;
    bool hasData() const;
    void hoverLegend(const QPointF& pixel);

    QString title_;
    PlotAxis x_;
    PlotAxis y_;
    PlotView view_;
    PlotTheme theme_;
    bool xNumbersVisible_ = true;
    std::vector<PlotCurve> curves_;
    std::vector<std::vector<QPointF>> phasePaths_;
    CurvePicture stillPicture_;
    PhasePicture phasePicture_;
    QString hovered_; // id of the curve whose entry of the legend is under the pointer
    std::vector<ReferenceLine> referenceLines_;
    double leastLabelWidth_ = 0.0;
    std::vector<EventMark> eventMarks_;
    std::vector<PointMark> pointMarks_;
    std::vector<ShadedArea> shadedAreas_;
    std::optional<PlotBackdrop> backdrop_;
    std::array<std::optional<double>, 2> cursors_;
    bool cursorPinned_ = false;
    bool cursorsSnap_ = false;
    std::optional<PlotRange> timeWindow_;
    std::optional<double> mostX_;
    PlotCanvas* canvas_ = nullptr; // owned by Qt as a child
    QTimer refreshTimer_;
    bool stale_ = true;
    bool everything_ = false;
    bool allDecide_ = false;
    bool phase_ = false;
    bool tightY_ = true;          // the next automatic y range takes no account of the present one
    mutable bool waits_ = false;  // a curve is drawn coarsely until its samples are read from the disk
    double refreshSeconds_ = 0.0; // the last refresh took
    long long refreshes_ = 0;
};

} // namespace touchdown
