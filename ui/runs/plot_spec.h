// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which quantities of a run stand in which plot: the plots that every window has, and those that the user makes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QJsonArray>
#include <QString>

#include "core/simulation/recording/quantity.h"
#include "ui/plot/min_max_pyramid.h"

namespace touchdown {

struct PlotSpec {
    struct Curve {
        std::string quantity;
        QString name; // in the legend of a plot with several
        bool visible = true;
        int colour = -1;                              // -1: as it comes in the list
        int dash = 0;                                 // added to the dash of the run
        std::optional<Quantity> added = std::nullopt; // by the user
    };
    QString name; // of files and settings
    QString title;
    std::string unit; // displayed
    std::vector<Curve> curves;
    std::optional<Quantity> across = std::nullopt; // instead of the time
    bool atFirst = true;                           // shown for a flying slider until the user changes it
    AxisScale scale = AxisScale::Linear;
    bool choosable = false;   // the user chooses what stands across and up
    bool own = false;         // made by the user, who may remove it
    bool spectrogram = false; // of the quantity that stands up; there is one

    /// The quantity that stands up, and nothing else.
    void setUp(const Quantity& quantity);
    /// What stands across: a quantity, or the time.
    void setAcross(const std::optional<Quantity>& quantity);
    void add(const Quantity& quantity);
    /// A curve that the user added; not the last one.
    void remove(std::string_view quantity);
    bool has(std::string_view quantity) const;
    /// A sentence that says why a quantity cannot stand in this plot; empty: it can.
    QString refusal(const Quantity& quantity) const;
};

/// Those of every window, in their order. A plot with `across` is a phase portrait.
std::vector<PlotSpec> standardPlots();

/// A plot of the user's own.
PlotSpec ownPlot(const QString& name, const Quantity& up, const std::optional<Quantity>& across);

/// Names of plots whose axes are chosen, after what they show; with a number where another plot has the same: "Pitch
/// (2)".
void nameApart(std::vector<PlotSpec>& specs);

/// For the settings: the plots of the user's own, and what the user changed of the standard ones.
QJsonArray changedPlots(const std::vector<PlotSpec>& specs);
/// The reverse: the standard plots with these changes, then the user's own. Leaves out what it cannot read.
std::vector<PlotSpec> plotsWith(const QJsonArray& changed);

} // namespace touchdown
