// SPDX-License-Identifier: GPL-3.0-or-later
//
// A field on the cells of a grid, drawn cell by cell without smoothing, as it was solved.
#pragma once

#include <optional>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "ui/plot/colour_scale.h"
#include "ui/slider/slider_plan.h"

namespace touchdown {

/// How a field is shown.
struct FieldLook {
    QString title;       // "Pressure above ambient"
    QString unit;        // the display unit, "kPa"
    double factor = 1.0; // of the display unit in SI
    ColourScale scale;
};

class FieldMap : public SliderPlan {
    Q_OBJECT

public:
    explicit FieldMap(QWidget* parent = nullptr);

    /// One value for each cell [SI], x fastest. An empty field leaves the slider empty.
    void setField(const CellGrid& grid, std::vector<double> values);
    void setLook(const FieldLook& look);
    const FieldLook& look() const { return look_; }
    const CellGrid& grid() const { return grid_; }
    bool empty() const { return values_.empty(); }

    /// The cell that holds a point of the slider; nothing outside the grid.
    std::optional<std::size_t> cellAt(const SurfacePoint& point) const;
    double value(std::size_t cell) const { return values_[cell]; }
    std::size_t smallestCell() const { return smallest_; } // of a field that is not empty
    std::size_t largestCell() const { return largest_; }
    SurfacePoint centre(std::size_t cell) const;

    void setGridShown(bool shown);
    /// Where the sections cross; nothing: no sections.
    void setSectionPoint(const std::optional<SurfacePoint>& point);

protected:
    void paintContent(QPainter& painter, const PlotTheme& theme) override;
    void paintKey(QPainter& painter, const QRectF& column, const PlotTheme& theme) override;
    double keyWidth() const override;

private:
    void paintCells(QPainter& painter) const;
    void paintExtremes(QPainter& painter, const PlotTheme& theme) const;
    std::vector<ScaleTick> keyTicks() const;
    void readOut(const std::optional<SurfacePoint>& point);

    CellGrid grid_;
    std::vector<double> values_;
    FieldLook look_;
    std::size_t smallest_ = 0, largest_ = 0;
    bool oneSmallest_ = true, oneLargest_ = true; // and no other cell has that value
    bool gridShown_ = false;
    std::optional<SurfacePoint> sectionPoint_;
};

/// The column or row of a grid that holds `at`; -1 outside. `lines` are the borders, ascending.
int cellIndex(const std::vector<double>& lines, double at);

/// A number of a field as the maps print it: "12.34 kPa".
QString fieldText(double value, const FieldLook& look);

} // namespace touchdown
