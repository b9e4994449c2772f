// SPDX-License-Identifier: GPL-3.0-or-later
//
// A field along x and along y through a point. Each cell is a step, as the solver has it. A field that is known at each
// point is drawn from points, several in each cell, and passes through the value at the point itself.
#pragma once

#include <array>
#include <memory>

#include "ui/maps/field_cursor_table.h"
#include "ui/maps/field_map.h"
#include "ui/plot/plot_group.h"

namespace touchdown {

/// The same field of another state, on its own grid.
struct OtherField {
    QString name;
    CurveStyle style;
    CellGrid grid;
    std::vector<double> values;
    FieldAtPoints points{};
};

class FieldSections : public QWidget {
    Q_OBJECT

public:
    explicit FieldSections(QWidget* parent = nullptr);

    /// The sections of `map` through cursor 1; nothing empties the plots. Cursor 2 is shown in a section that passes
    /// through its cell.
    void show(const FieldMap& map, const FieldCursors& cursors);
    /// Drawn with the field of the map at the next `show`, which is then called `name` and looks so.
    void setOthers(const QString& name, const CurveStyle& style, std::vector<OtherField> others);
    /// Both axes follow the data again.
    void fit();
    /// A fixed range of values; nothing: the range follows the data.
    void setRange(const std::optional<PlotRange>& range);

    PlotWidget* alongX() const { return sections_[0].plot; }
    PlotWidget* alongY() const { return sections_[1].plot; }

signals:
    /// Cursor 0 or 1 in a section was moved to another x, or another y.
    void xChosen(int which, double x);
    void yChosen(int which, double y);
    /// Cursor 1 was taken away.
    void secondRemoved();

private:
    struct Section {
        PlotWidget* plot = nullptr;
        PlotGroup* group = nullptr;
        std::vector<std::unique_ptr<MinMaxPyramid>> steps; // of the field of the map, then of others
    };
    void fill(int axis, const FieldMap& map, const SurfacePoint& point);

    std::array<Section, 2> sections_; // along x, along y
    std::optional<PlotRange> range_;
    QString name_;
    CurveStyle style_{0, 0};
    std::vector<OtherField> others_;
};

} // namespace touchdown
