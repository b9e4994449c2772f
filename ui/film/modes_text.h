// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modes as a part of the window's state (JSON), and as a table.
#pragma once

#include <optional>

#include <QByteArray>
#include <QJsonObject>

#include "core/simulation/static_state/steady.h"

namespace touchdown {

/// Modes that were sought, and the case that they are of.
struct FoundModes {
    Case value;
    ModesResult result; // of its static state only the attitude is kept in the text
};

QJsonObject toJson(const FoundModes& modes);
/// Nothing where the object is not what toJson() makes.
std::optional<FoundModes> modesFromJson(const QJsonObject& json);
/// Comma-separated values, in SI; an error that is not known is an empty cell.
QByteArray csvOf(const ModesResult& result);

} // namespace touchdown
