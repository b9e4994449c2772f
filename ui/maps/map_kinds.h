// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names and colours of the fields that a run records.
#pragma once

#include "core/simulation/recording/field_snapshot.h"
#include "ui/maps/fields_view.h"

#include <QString>

#include <vector>

namespace touchdown {

/// A logarithmic scale shows a smaller difference from the ambient pressure as zero [Pa].
inline constexpr double nearAmbient = 1e3;

/// Of a pressure above ambient, p0.
inline QString aboveAmbientSymbol() { return QStringLiteral("p \u2212 p\u2080"); }

/// One field of one set.
struct RunField {
    std::size_t set = 0;
    std::size_t field = 0;
    QString name; // on the tab; the map itself has the whole name
    QString longName;
    MapKind kind;
    bool aboveAmbient = false; // recorded as an absolute pressure of the air, shown above ambient
};

/// All fields of all sets, in their order.
std::vector<RunField> runFields(const std::vector<RecordedFields>& sets);

} // namespace touchdown
