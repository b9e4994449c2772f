// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON as the command line prints it.
#pragma once

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

namespace touchdown {

/// Keeps the order in which keys are written.
using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity.
inline Json jsonNumber(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Ends with a line break. File names may hold bytes that are no UTF-8: those are replaced.
inline std::string jsonText(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace touchdown
