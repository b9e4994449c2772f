// SPDX-License-Identifier: GPL-3.0-or-later
//
// The air bearing surface as it is designed: recess in colours that step through its levels, walls as they slope, rails
// outlined and numbered, points of interest, and on request the solver's grid and the point of minimum spacing.
//
// The colours leave out crown, camber and twist, which would hide the steps of the design; the readout has them.
#pragma once

#include <optional>

#include <QTimer>

#include "core/numerics/cell_grid.h"
#include "core/physics/slider/recess.h"
#include "ui/plot/colour_scale.h"
#include "ui/slider/plan_marks.h"
#include "ui/slider/recess_picture.h"
#include "ui/slider/slider_plan.h"

namespace touchdown {

class SurfaceView : public SliderPlan {
    Q_OBJECT

public:
    explicit SurfaceView(QWidget* parent = nullptr);

    /// A surface that cannot be drawn (a rail with two corners, a wall that does not exist) leaves the slider empty.
    void setSurface(const AirBearingSurface& surface, double length, double width);
    const AirBearingSurface& surface() const { return surface_; }

    void setGrid(const CellGrid& grid);
    const CellGrid& grid() const { return grid_; }
    void setGridShown(bool shown);
    bool gridShown() const { return gridShown_; }

    /// Where the slider is nearest to the disk, and how near [m]; nothing when that is not known.
    void setMinimumSpacing(const std::optional<SurfacePoint>& at, double spacing = 0.0);
    std::optional<SurfacePoint> minimumSpacingAt() const { return minimumAt_; }

    const ColourScale& scale() const { return scale_; }
    /// The picture of the recess has its full resolution.
    bool settled() const;

protected:
    void paintContent(QPainter& painter, const PlotTheme& theme) override;
    void paintKey(QPainter& painter, const QRectF& column, const PlotTheme& theme) override;
    double keyWidth() const override;

private:
    void requestPicture();
    QSize wantedPixels() const;
    void readOut(const std::optional<SurfacePoint>& point);
    std::vector<ScaleTick> levelTicks() const;
    void paintRecess(QPainter& painter) const;
    void paintRails(QPainter& painter) const;
    void paintMarks(QPainter& painter, const PlotTheme& theme, TakenRoom& taken) const;
    void paintNumbers(QPainter& painter, const PlotTheme& theme, TakenRoom& taken) const;

    AirBearingSurface surface_;
    std::optional<Recess> recess_;      // with crown, camber and twist
    std::optional<Recess> drawnRecess_; // without
    ColourScale scale_;
    RecessPicture picture_;
    QTimer pictureTimer_;
    std::vector<SurfacePoint> numberPoints_;
    std::optional<std::size_t> pointedRail_;
    CellGrid grid_;
    bool gridShown_ = false;
    std::optional<SurfacePoint> minimumAt_;
    double minimumSpacing_ = 0.0; // [m]
};

} // namespace touchdown
