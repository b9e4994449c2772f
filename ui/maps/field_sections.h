// SPDX-License-Identifier: GPL-3.0-or-later
//
// A field along x and along y through a point. Each cell is a step, as the solver has it.
#pragma once

#include <array>
#include <memory>

#include "ui/maps/field_map.h"
#include "ui/plot/plot_group.h"

namespace touchdown {

class FieldSections : public QWidget {
    Q_OBJECT

public:
    explicit FieldSections(QWidget* parent = nullptr);

    /// The sections of `map` through a point; nothing empties the plots.
    void show(const FieldMap& map, const std::optional<SurfacePoint>& point);
    /// Both axes follow the data again.
    void fit();
    /// A fixed range of values; nothing: the range follows the data.
    void setRange(const std::optional<PlotRange>& range);

    PlotWidget* alongX() const { return sections_[0].plot; }
    PlotWidget* alongY() const { return sections_[1].plot; }

signals:
    /// A cursor in a section was moved to another x, or another y.
    void xChosen(double x);
    void yChosen(double y);

private:
    struct Section {
        PlotWidget* plot = nullptr;
        PlotGroup* group = nullptr;
        std::unique_ptr<MinMaxPyramid> steps;
    };
    static void fill(Section& section, const std::vector<double>& lines, const std::vector<double>& values,
                     const FieldLook& look);

    std::array<Section, 2> sections_; // along x, along y
    std::optional<PlotRange> range_;
};

} // namespace touchdown
