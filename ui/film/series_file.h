// SPDX-License-Identifier: GPL-3.0-or-later
//
// A series of static states on disk, as `touchdown steady` writes it (core/results/steady_writer.h), without fields.
#pragma once

#include <vector>

#include <QByteArray>
#include <QString>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

struct SeriesState;

struct StoredSeries {
    Case value; // which lists the points (seriesOf)
    std::vector<SteadyResult> results;
    QString problem; // empty: it was read
};

/// The case that lists these points, which differ in one quantity, or in radius and skew, or as the case lists them.
Case listing(const Case& c, const std::vector<SteadySeriesPoint>& points);
/// The states that are known, from the first point on. "" or the problem in a sentence.
QString writeSeries(const QString& file, const StoredSeries& series);
StoredSeries readSeries(const QString& file);
/// All numbers of the states, in display units, as comma-separated values; empty cells where there is no state.
QByteArray csvOf(const std::vector<SeriesState>& states);

} // namespace touchdown
