// SPDX-License-Identifier: GPL-3.0-or-later
//
// A field on the cells of a grid, drawn cell by cell without smoothing, as it was solved.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/case/case.h"
#include "core/physics/slider/attitude.h"
#include "core/physics/slider/minimum_spacing.h"
#include "ui/plot/colour_scale.h"
#include "ui/slider/cell_painting.h"
#include "ui/slider/plan_marks.h"
#include "ui/slider/slider_plan.h"

namespace touchdown {

/// How a field is shown.
struct FieldLook {
    QString title;       // "Pressure above ambient"
    QString unit;        // the display unit, "kPa"
    double factor = 1.0; // of the display unit in SI
    ColourScale scale;
    QString symbol{};   // on the axes of sections
    QString remark{};   // behind the title: ", beyond the scale up to 54 kPa"
    double error = 0.0; // estimated, of the values: digits beyond it are not shown [SI]; 0: not known
};

/// What is known of a field beside its means over the cells.
struct FieldAtPoints {
    std::function<double(const SurfacePoint&)> value{}; // [SI]; empty: what the cell has
    struct Least {
        SurfacePoint at;
        double value; // [SI]
    };
    std::optional<Least> least{}; // the smallest value; nothing: that of the cells
    double error = 0.0;           // see FieldLook

    /// Nothing: what the cell has. At the place of the smallest value it is that value: the place is on the border of a
    /// rail, and by rounding beside it.
    std::optional<double> at(const SurfacePoint& point) const;
};

/// The gap of a film to the disk's mean plane, at an attitude with that minimum spacing.
FieldAtPoints gapAtPoints(const Case& c, const Recess& recess, const Attitude& attitude,
                          const MinimumSpacing::Place& least);

/// The minimum spacing of a run at a time: recorded as a number, its place follows from pitch and roll.
class GapInTime {
public:
    explicit GapInTime(const Case& c);
    FieldAtPoints at(double minimumSpacing, double pitch, double roll) const; // [m], [rad]

private:
    Case case_;
    Recess recess_;
    MinimumSpacing spacing_;
};

class FieldMap : public SliderPlan {
    Q_OBJECT

public:
    using SliderPlan::SliderPlan;

    /// One value for each cell [SI], x fastest. An empty field leaves the slider empty.
    void setField(const CellGrid& grid, std::vector<double> values, FieldAtPoints points = {});
    void setLook(const FieldLook& look);
    const FieldLook& look() const { return look_; }
    bool empty() const { return values_.empty(); }

    /// The cell that holds a point of the slider; nothing outside the grid.
    std::optional<std::size_t> cellAt(const SurfacePoint& point) const;
    double value(std::size_t cell) const { return values_[cell]; }
    /// Nothing outside the grid.
    std::optional<double> valueAt(const SurfacePoint& point) const;
    const FieldAtPoints& atPoints() const { return points_; }
    SurfacePoint centre(std::size_t cell) const;

    /// The numbers at the marks of the smallest and the largest value.
    QStringList marks() const;

    /// Their outlines are drawn over the field.
    void setRails(std::vector<Rail> rails);

    /// Cursor 1, where the sections cross, and cursor 2; nothing: it is not there.
    void setCursors(const std::optional<SurfacePoint>& first, const std::optional<SurfacePoint>& second);

    /// The centre of each cell [m] and its value, in the display unit.
    std::function<void(QIODevice&)> dataWriter() const override;
    /// In colours for white paper, without cursors.
    void paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours) override;

protected:
    void paintContent(QPainter& painter, const PlotTheme& theme) override;
    void paintKey(QPainter& painter, const QRectF& column, const PlotTheme& theme) override;
    double keyWidth() const override;
    QStringList readingAt(const SurfacePoint& point) const override;

private:
    void paintCursors(QPainter& painter, const PlotTheme& theme) const;
    std::vector<PlanMark> extremes() const;
    void paintExtremes(QPainter& painter, const PlotTheme& theme) const;
    std::vector<ScaleTick> keyTicks() const;

    void paintRails(QPainter& painter, const PlotTheme& theme) const;

    std::vector<double> values_;
    FieldAtPoints points_;
    std::vector<Rail> rails_;
    FieldLook look_;
    std::optional<std::size_t> smallest_, largest_; // cells; nothing where several cells have that value
    std::optional<SurfacePoint> first_, second_;
};

/// A number of a field as the maps print it: "12.34 kPa"; and without its unit.
QString fieldText(double value, const FieldLook& look);
QString fieldNumber(double value, const FieldLook& look);

} // namespace touchdown
