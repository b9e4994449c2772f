// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page on which a slider is shaped: tools, the plan as an editor, and above it how the slider flies. The list of
// its parts has a place elsewhere in the window.
#pragma once

#include <optional>
#include <vector>

#include <QCheckBox>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "core/case/case.h"
#include "core/simulation/static_state/sensitivity.h"
#include "ui/film/shape_panel.h"
#include "ui/slider/surface_editor.h"

namespace touchdown {

class SurfacePage : public QWidget {
    Q_OBJECT

public:
    explicit SurfacePage(QWidget* parent = nullptr);

    /// The case as it is edited.
    void setCase(const Case& c);
    /// Another case was opened: it is the one to compare with.
    void open(const Case& c);

    SurfaceEditor* editor() const { return editor_; }
    /// The switch of the grid lines, at the end of the row of tools.
    void addGridSwitch(QCheckBox& box);
    /// Hidden until the window gives it a place.
    ShapePanel* panel() const { return panel_; }
    bool follows() const { return follow_->isChecked(); }
    bool showsInfluence() const { return influence_->isChecked(); }
    /// Of the solution that is shown, above ambient, on the cells of the editor's grid [Pa]; empty: there is none.
    void setPressure(std::vector<double> pressure);
    /// It is that of another shape.
    void setPressureStale(bool stale);
    /// What was found; empty: nothing, as the slider does not fly or its attitude is held.
    void showInfluence(const std::vector<PartInfluence>& influence);
    /// All rails and all edges; of many edges those of the selected rails.
    PartSelection influencingParts() const;

    /// The state of the shape as it is, and how it differs from `reference`. `preview`: on a coarse grid.
    void showFlight(const SteadyResult& state, const std::optional<SteadyResult>& reference, bool preview);
    /// Why there is none; the state before stays, pale.
    void showObstacle(const QString& reason);
    /// The shape flies, or may: the reason is taken away.
    void clearObstacle();
    /// The last state that was not a preview, pale.
    void showConfirmed();
    /// What is shown is of the case before.
    void setStale(bool stale);
    /// Nothing is known of how it flies.
    void clearFlight();
    /// What stands above the plan, also where it is cut.
    const QString& flightText() const { return said_; }

signals:
    /// Numbers are to be typed in the panel, which may be hidden.
    void panelWanted();
    /// Shown or hidden, or of other parts.
    void influenceWanted();
    void previewed(const touchdown::AirBearingSurface& surface);
    void edited(const touchdown::AirBearingSurface& surface, const QString& text, int merge);

protected:
    /// S, Y, I, U, D and G are the keys of the switches.
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildTools();
    /// `shown`: as much of it as there is room for; empty: all.
    void say(const QString& text, const QString& shown = {});
    bool manyEdges() const;
    void fit();

    SurfaceEditor* editor_;
    ShapePanel* panel_;
    QCheckBox *follow_, *influence_, *pressure_, *drawing_;
    bool pressureStale_ = false;
    QCheckBox *snap_ = nullptr, *pairs_ = nullptr, *grid_ = nullptr;
    PartSelection influencing_; // as it was last asked for
    QLabel* flight_;
    QWidget* toolRow_ = nullptr;
    std::vector<QToolButton*> tools_;
    QString flightParts_, confirmedParts_; // the last state, and the last that was not a preview
    QString said_;                         // in the line above the plan
    QString confirmedShort_;               // of confirmedParts_: the minimum spacing
    QString shortPart_;                    // of the last state: its minimum spacing
    bool obstacle_ = false;                // stands before flightParts_
    QString reason_;                       // of the obstacle
};

} // namespace touchdown
