// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gestures of the mouse on a plan: selecting, dragging with snap and typed numbers, drawing rails, measuring,
// moving the view. A gesture previews the surface that it would make; at its end one verb of the selection is called.
#pragma once

#include <optional>
#include <vector>

#include <QMouseEvent>
#include <QTimer>

#include "ui/slider/edit_painting.h"

namespace touchdown {

class DragField;

class EditGestures : public QObject {
    Q_OBJECT

public:
    enum class Tool { Select, Rectangle, Polygon, Measure };
    Q_ENUM(Tool)

    /// Both must outlive this.
    EditGestures(SurfaceView& plan, SurfaceSelection& selection);

    Tool tool() const { return tool_; }
    void setTool(Tool tool);
    void setSnapping(bool on) { snapping_ = on; }
    /// Corners of a drawing under the plan, which hold a place, too [m].
    void setDrawing(std::vector<SurfacePoint> corners) { marks_.drawing = std::move(corners); }
    bool dragging() const { return marks_.dragging; }
    /// The selection follows the pointer.
    bool moving() const { return gesture_ == Gesture::Move; }
    const GestureMarks& marks() const { return marks_; }

    /// Ends a gesture: another surface is shown.
    void end();
    /// Another case was opened: nothing is measured or drawn.
    void open();
    /// The surface before the gesture is shown again.
    void giveUp();
    /// One step back: out of the gesture, the measure, the tool. False: there was none.
    bool stepBack();
    void finishPolygon();
    /// Fields for the distance by which the selection moves, without a drag.
    void askForShift();
    /// Without a mouse: between two selected corners or points of interest, or along a selected edge.
    void measureSelection();
    void updateCursor();

signals:
    void previewed(const touchdown::AirBearingSurface& surface);
    void toolChanged();

protected:
    /// Sees the events of the plan first.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Gesture { None, Pressed, Move, Band, View, Rectangle, Measure };

    void begin(Gesture gesture);
    /// Space turns the left button into the middle one.
    bool holdSpace(bool held);
    void press(const QMouseEvent& event);
    /// True: the plan has a use for it, too.
    bool move(const QMouseEvent& event);
    bool doubleClick(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void leave();
    /// A number typed during a drag; false: it is none.
    bool type(const QString& text);
    /// `way`: the direction of the pointer, in which numbers are positive.
    void openField(const QString& text, SurfaceShift way);
    void selectAt(const QMouseEvent& event);
    void previewWaiting();
    SurfaceShift wantedShift(const QMouseEvent& event);
    SurfacePoint snappedAt(const QMouseEvent& event);
    SnapGrid snapGrid() const;
    void endMove(SurfaceShift by);
    bool typing() const;
    void previewTyped();
    void takeTyped();
    void stopTyping();
    std::optional<std::size_t> linkAt(const QPointF& pixel) const;
    void addMeasured(const SurfacePoint& at);
    void addPolygonCorner(const SurfacePoint& at);
    void addRail(const std::vector<SurfacePoint>& corners);

    SurfaceView& plan_;
    SurfaceSelection& selection_;
    GestureMarks marks_;
    Tool tool_ = Tool::Select;
    Gesture gesture_ = Gesture::None;
    bool snapping_ = true, spaceHeld_ = false;
    std::optional<SurfaceShift> waiting_; // for the next preview
    QTimer previewTimer_;                 // since the last one
    std::optional<SurfacePart> grabbed_;
    bool addedByPress_ = false; // a click on what is selected already selects it alone
    QPointF pressedAt_;         // [px]
    SurfacePoint pressedPoint_; // [m]
    DragField* field_;
};

} // namespace touchdown
