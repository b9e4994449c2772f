// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plan of the air bearing surface as an editor. A gesture previews the surface that it would make; when it ends,
// `edited` asks the owner to make that one edit of the case, which comes back with setCase.
//
// Mouse: click or drag a rectangle to select, Shift adds; drag a corner, an edge, a rail or a point of interest: Shift
// keeps to x or y, Ctrl lets go of the snap, Esc gives back, a number typed meanwhile is the distance in µm; double
// click on an edge inserts a corner; click on the link of a pair breaks or joins it. The middle button or Space with
// the left one moves the view, the wheel zooms. Keys: arrows move what is selected by 1 µm, with Shift by 10 µm, with
// Alt by 0.1 µm; Del removes; Ctrl+A, Ctrl+D (copy), Shift+M (mirror), L (break or join the pair), Page Up and Down
// (order of overlap), N and B (next and previous rail), E and C (next edge and corner of the rail, with Shift the
// previous one), F (fit); V, R, P, M choose the tool.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <QTimer>

#include "core/physics/slider/surface_check.h"
#include "core/physics/slider/surface_edit.h"
#include "ui/slider/plan_marks.h"
#include "ui/slider/surface_view.h"

namespace touchdown {

class DragField;

class SurfaceEditor : public SurfaceView {
    Q_OBJECT

public:
    enum class Tool { Select, Rectangle, Polygon, Measure };
    Q_ENUM(Tool)

    explicit SurfaceEditor(QWidget* parent = nullptr);

    /// The surface of the case; ends a gesture.
    void setCase(const AirBearingSurface& surface, double length, double width);
    const AirBearingSurface& committed() const { return committed_; }
    /// The grid of the case with a surface; edges shorter than its cells are marked.
    using GridOf = std::function<CellGrid(const AirBearingSurface&)>;
    void setGridOf(GridOf gridOf) { gridOf_ = std::move(gridOf); }
    /// The surface is that of another case: what was begun and broken on the one before is forgotten.
    void open();
    /// Drawn behind, as it was last saved.
    void setGhost(const AirBearingSurface& surface);

    const PartSelection& selection() const { return selection_; }
    void select(const PartSelection& parts);

    Tool tool() const { return tool_; }
    void setTool(Tool tool);
    void setSnapping(bool on) { snapping_ = on; }
    void setPairs(bool on);
    /// Mirror rails that move together; a link that is broken lets both move alone until it is joined again.
    struct PairLink {
        std::size_t rail, image;
        bool broken;
        SurfacePoint from, to; // inside the two rails [m]
        SurfacePoint middle() const { return {0.5 * (from.x + to.x), 0.5 * (from.y + to.y)}; }
    };
    const std::vector<PairLink>& pairLinks() const { return links_; }
    /// Where the symbol of a link is drawn and clicked [px].
    QPointF symbolOf(const PairLink& link) const;
    void togglePair(std::size_t rail);
    /// What holds the place that is dragged or measured: "corner 2 of rail 3", "centre line", "border".
    QStringList snapWords() const;
    /// Distance, its parts along x and y, and its angle to x; empty where nothing is measured.
    QString measureText() const;

    void nudge(SurfaceShift by);
    void removeSelected();
    void copySelected();
    void mirrorSelected();
    /// Rails of the selection get mirror images where they have none.
    void makeSymmetric();
    /// The wall of the selected edges and rails; one more than there are: a new one.
    void chooseWall(int wall);
    /// The verbs for what is selected, with `insertAt` on an edge [m].
    void popUpMenu(const QPoint& globalPos, const std::optional<SurfacePoint>& insertAt);
    /// In the order of overlap: 1 forward, -1 backward.
    void moveInOrder(int places);
    void insertCorner(std::size_t rail, std::size_t edge, SurfacePoint at);
    /// What parts do to the minimum spacing, drawn on them [m/m]; empty: nothing is drawn.
    void setInfluence(const std::vector<std::pair<SurfacePart, double>>& influence);
    /// What its colours and arrows mean.
    QString influenceWords() const;
    /// Of the surface that is shown, drawn at their places.
    const std::vector<SurfaceProblem>& problems() const { return problems_; }
    const std::vector<SurfaceProblem>& warnings() const { return warnings_; }
    /// During a drag nothing else may change the case.
    bool dragging() const { return gesture_ != Gesture::None; }

signals:
    /// While the mouse moves; at the end of the gesture, or when it is given up, the committed surface again.
    void previewed(const touchdown::AirBearingSurface& surface);
    /// `merge`: edits with the same number in a row are one for undo; 0: none.
    void edited(const touchdown::AirBearingSurface& surface, const QString& text, int merge);
    void selectionChanged();
    void toolChanged();
    /// Numbers of the selection, its recess, or a new wall are to be typed elsewhere.
    void coordinatesWanted();
    void recessWanted();
    void wallWanted(int wall);

protected:
    void paintContent(QPainter& painter, const PlotTheme& theme) override;
    QStringList readingAt(const SurfacePoint& point) const override;
    bool event(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    static constexpr double pairReach = 0.1e-6; // within which rails are mirror images [m]
    enum class Gesture { None, Pressed, Move, Band, View, Rectangle, Measure };

    bool moveByKey(const QKeyEvent& event);
    bool actByKey(const QKeyEvent& event);
    void giveUp();
    void commit(const AirBearingSurface& surface, const QString& text, int merge = 0);
    void preview(const AirBearingSurface& surface);
    void previewWaiting();
    AirBearingSurface movedSelection(SurfaceShift by) const;
    SurfaceShift wantedShift(const QMouseEvent& event);
    SurfacePoint snappedAt(const QPointF& pixel, Qt::KeyboardModifiers modifiers);
    void endMove(SurfaceShift by);
    void beginTyping(const QString& typed);
    std::optional<SurfaceShift> typedShift() const;
    bool typing() const { return !typed_.empty(); }
    void stopTyping();
    void findLinks();
    std::optional<std::size_t> linkAt(const QPointF& pixel) const;
    void chooseMeasure();
    void addMeasured(const SurfacePoint& at);
    SnapGrid snapGrid() const;
    void press(const QMouseEvent& event);
    void addOutline(const std::vector<SurfacePoint>& corners);
    void addPolygonCorner(const SurfacePoint& at);
    void finishPolygon();
    void updateCursor();
    void paintOutline(QPainter& painter, const Rail& rail, const QPen& pen) const;
    void paintSelection(QPainter& painter, const PlotTheme& theme) const;
    void paintGesture(QPainter& painter, const PlotTheme& theme) const;
    void paintInfluence(QPainter& painter, const PlotTheme& theme) const;
    void paintSnap(QPainter& painter, const PlotTheme& theme) const;
    void paintLinks(QPainter& painter, const PlotTheme& theme) const;
    void paintMeasure(QPainter& painter, const PlotTheme& theme) const;
    void paintProblems(QPainter& painter, const PlotTheme& theme) const;
    void paintRings(QPainter& painter, const SurfaceProblem& problem, double radius, const QColor& colour,
                    const PlotTheme& theme) const;
    void paintSentence(QPainter& painter, const SurfaceProblem& problem, const PlotTheme& theme,
                       TakenRoom& taken) const;
    bool isTold(const SurfaceProblem& warning) const;
    std::vector<SurfaceProblem> findWarnings(const AirBearingSurface& surface) const;
    void showSurface(const AirBearingSurface& surface, double length, double width);

    AirBearingSurface committed_, ghost_;
    GridOf gridOf_;
    std::vector<std::pair<SurfacePart, double>> influence_;
    std::vector<SurfaceProblem> problems_, warnings_; // of the surface that is shown
    std::vector<SurfaceProblem> ghostWarnings_;
    PartSelection selection_;
    std::optional<SurfacePart> hovered_;
    Tool tool_ = Tool::Select;
    bool snapping_ = true, pairs_ = false, spaceHeld_ = false;

    Gesture gesture_ = Gesture::None;
    std::optional<SurfaceShift> waiting_; // for the next preview
    QTimer previewTimer_;                 // since the last one
    std::optional<SurfacePart> grabbed_;
    bool addedByPress_ = false;          // a click on what is selected already selects it alone
    QPointF pressedAt_, pointer_;        // [px]
    SurfacePoint pressedPoint_;          // [m]
    std::vector<SurfacePoint> polygon_;  // under way [m]
    int nudges_ = 0;                     // number of the row of nudges
    std::optional<SnappedPlace> snap_;   // of the gesture
    std::vector<SurfacePoint> measured_; // one place or two [m]
    std::set<std::size_t> single_;       // rails whose pairs are broken
    std::vector<PairLink> links_;        // where pairs move together
    bool noPairs_ = false;               // pairs are to move together, but there are none
    DragField* field_;
    std::vector<SurfaceShift> typed_; // the directions of its numbers [-]
};

} // namespace touchdown
