// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plan of the air bearing surface as an editor: the widget that connects the selection with its verbs, the gestures
// and what is drawn of them. A gesture previews the surface that it would make; when it ends, `edited` asks the owner
// to make that one edit of the case, which comes back with setCase.
//
// Mouse: click or drag a rectangle to select, Shift adds; drag a corner, an edge, a rail or a point of interest: Shift
// keeps to x or y, Ctrl lets go of the snap, Esc gives back, a number typed meanwhile is the distance in µm; double
// click on an edge inserts a corner; click on the link of a pair breaks or joins it. The middle button or Space with
// the left one moves the view, the wheel zooms. Keys: arrows move what is selected by 1 µm, with Shift by 10 µm, with
// Alt by 0.1 µm; Del removes; Ctrl+A, Ctrl+D (copy), Shift+M (mirrored copy), K (keep the distance of two parts), L
// (break or join the pair), Page Up and Down (order of overlap), N and B (next and previous rail), E and C (next edge
// and corner of the rail, with Shift the previous one), F (fit); V, R, P, M choose the tool. A picture or a DXF drawing
// that is dropped lies under the plan.
#pragma once

#include <functional>

#include "ui/slider/edit_gestures.h"
#include "ui/slider/underlay.h"

namespace touchdown {

class SurfaceEditor : public SurfaceView {
    Q_OBJECT

public:
    using Tool = EditGestures::Tool;

    explicit SurfaceEditor(QWidget* parent = nullptr);

    /// The surface of the case; ends a gesture.
    void setCase(const AirBearingSurface& surface, double length, double width);
    const AirBearingSurface& committed() const { return selection_.surface(); }
    /// The grid of the case with a surface; edges shorter than its cells are marked.
    using GridOf = std::function<CellGrid(const AirBearingSurface&)>;
    void setGridOf(GridOf gridOf) { gridOf_ = std::move(gridOf); }
    /// The surface is that of another case: what was begun and broken on the one before is forgotten.
    void open();
    /// Drawn behind, as it was last saved.
    void setGhost(const AirBearingSurface& surface);

    SurfaceSelection& verbs() { return selection_; }
    const PartSelection& selection() const { return selection_.parts(); }
    void select(const PartSelection& parts) { selection_.select(parts); }
    void setPairs(bool on) { selection_.setPairs(on); }
    /// The verbs for what is selected, with `insertAt` on an edge [m].
    void popUpMenu(const QPoint& globalPos, const std::optional<SurfacePoint>& insertAt);

    Tool tool() const { return gestures_.tool(); }
    void setTool(Tool tool) { gestures_.setTool(tool); }
    void setSnapping(bool on) { gestures_.setSnapping(on); }
    const GestureMarks& gesture() const { return gestures_.marks(); }
    /// During a drag nothing else may change the case.
    bool dragging() const { return gestures_.dragging(); }

    /// Drawn on the parts; empty: nothing is drawn.
    void setInfluence(const ShownInfluence& influence);
    QString influenceWords() const { return touchdown::influenceWords(influence_); }
    /// Above ambient, of the cells of the grid [Pa]; empty: there is none.
    void setPressure(std::vector<double> pressure);
    /// Drawn under the outlines; pale where it is not that of the surface that is shown.
    void showPressure(bool shown, bool pale);
    bool showsPressure() const;
    Underlay& underlay() { return *underlay_; }
    /// Opens the form of the drawing under the plan, or asks for one.
    void placeUnderlay();
    /// Of the surface that is shown, drawn at their places.
    const std::vector<SurfaceProblem>& problems() const { return problems_; }
    const std::vector<SurfaceProblem>& warnings() const { return warnings_; }

signals:
    /// While the mouse moves; at the end of the gesture, or when it is given up, the committed surface again.
    void previewed(const touchdown::AirBearingSurface& surface);
    /// See SurfaceSelection::edited.
    void edited(const touchdown::AirBearingSurface& surface, const QString& text, int merge);
    void selectionChanged();
    void toolChanged();
    /// Numbers of the selection, its recess, or a new wall are to be typed elsewhere.
    void coordinatesWanted();
    void recessWanted();
    void wallWanted(int wall);

protected:
    void paintContent(QPainter& painter, const PlotTheme& theme) override;
    bool paintTops(QPainter& painter, const PlotTheme& theme) const override;
    void paintKey(QPainter& painter, const QRectF& column, const PlotTheme& theme) override;
    double keyWidth() const override;
    QStringList readingAt(const SurfacePoint& point) const override;
    bool event(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void loadUnderlay(const QString& file);
    void takeRailsOfDrawing();
    ColourScale pressureScale(const PlotTheme& theme) const;
    std::vector<ScaleTick> pressureTicks(const ColourScale& scale, double height) const;
    bool moveByKey(const QKeyEvent& event);
    bool actByKey(const QKeyEvent& event);
    void fillArrangeMenu(QMenu& menu);
    void fillKeepMenu(QMenu& menu);
    void askForArray();
    void showSurface(const AirBearingSurface& surface, double length, double width);
    std::vector<SurfaceProblem> findWarnings(const AirBearingSurface& surface) const;

    SurfaceSelection selection_;
    EditGestures gestures_;
    AirBearingSurface ghost_;
    GridOf gridOf_;
    ShownInfluence influence_;
    Underlay* underlay_;
    std::vector<double> pressure_; // above ambient, of the cells of grid() [Pa]
    bool pressureShown_ = false, pressurePale_ = false;
    /// The width of its key, which costs more than a picture of the plan: for a height and a font; -1: not known.
    mutable struct {
        int height = -1; // [px]
        QFont font;
        double width = 0.0; // [px]
    } pressureKey_;
    std::vector<SurfaceProblem> problems_, warnings_; // of the surface that is shown
    std::vector<SurfaceProblem> ghostWarnings_;
};

} // namespace touchdown
