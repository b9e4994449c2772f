// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static states over radius, skew, speed or altitude: spacing, height, pitch and roll in plots with one axis. A dot is
// a state that was solved; the lines between them are drawn for the eye, and none passes a state that was not found.
// The stated error of the grid is a band.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/simulation/static_state/steady.h"
#include "ui/plot/plot_group.h"

namespace touchdown {

/// A state of a series, without its fields.
struct SeriesState {
    SteadySeriesPoint point;
    SteadyResult result;
};

class SeriesPlots : public QWidget {
    Q_OBJECT

public:
    explicit SeriesPlots(QWidget* parent = nullptr);
    ~SeriesPlots() override;

    /// `points` of the whole series, and its states as far as they are solved.
    void setStates(const std::vector<SteadySeriesPoint>& points, const std::vector<SeriesState>& states);
    /// Held at a given attitude, the net force is of interest, not the height.
    void setHeld(bool held);
    /// The axes follow the data again.
    void fit() { group_->fit(); }
    /// A cursor at a state.
    void point(const SteadySeriesPoint& at);

    /// Minimum spacing; trailing edge height, or net force; pitch; roll.
    const std::array<PlotWidget*, 4>& plots() const { return plots_; }

private:
    void clear();
    const MinMaxPyramid* keep(const std::vector<double>& x, const std::vector<double>& y);
    void addCurve(std::size_t plot, int curve, const QString& name, const std::vector<const SeriesState*>& states);
    /// About `curve`, of x, value and error.
    void addBand(PlotWidget* plot, const PlotCurve& curve, const std::vector<std::array<double, 3>>& piece,
                 std::vector<ShadedArea>& areas);

    std::array<PlotWidget*, 4> plots_{};
    PlotGroup* group_;
    bool held_ = false;
    std::vector<SteadySeriesPoint> points_;
    std::vector<std::unique_ptr<MinMaxPyramid>> data_;
};

} // namespace touchdown
