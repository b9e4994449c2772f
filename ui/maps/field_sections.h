// SPDX-License-Identifier: GPL-3.0-or-later
//
// A field along x and along y through a point, cell by cell: each cell is a step, as it is solved for.
#pragma once

#include <memory>

#include <QWidget>

#include "ui/maps/field_map.h"
#include "ui/plot/plot_group.h"

namespace touchdown {

class FieldSections : public QWidget {
    Q_OBJECT

public:
    explicit FieldSections(QWidget* parent = nullptr);
    ~FieldSections() override;

    /// The sections of `map` through a point; nothing empties the plots.
    void show(const FieldMap& map, const std::optional<SurfacePoint>& point);
    /// Both axes follow the data again.
    void fit();
    /// The same values up the sections whatever they show; nothing: they follow what they show.
    void setRange(const std::optional<PlotRange>& range);

    PlotWidget* alongX() const { return alongX_.plot; }
    PlotWidget* alongY() const { return alongY_.plot; }

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
    Section makeSection();
    void fill(Section& section, const std::vector<double>& lines, const std::vector<double>& values,
              const FieldLook& look);

    Section alongX_, alongY_;
    std::optional<PlotRange> range_;
};

} // namespace touchdown
