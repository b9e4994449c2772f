// SPDX-License-Identifier: GPL-3.0-or-later
//
// A number of a case that a design study may change: a key of its file, or a length of a rail [m]
//
//   abs.rail[2].recess   a ramp keeps its slopes
//   abs.rail[2].x, y     middle of the rectangle around it, from the leading and from the inner edge; the rail is moved
//   abs.rail[2].length, width   of that rectangle along x and y; the rail is stretched about its middle
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/case/case.h"
#include "core/numerics/interval.h"

namespace touchdown {

struct DesignKey {
    std::string key;         // "abs.rail[2].width"
    std::string unit;        // SI
    std::string displayUnit; // "mm"
    std::function<double(const Case&)> get{};
    /// Returns what is wrong with the value, in a sentence without the key, and leaves the case alone then.
    std::function<std::optional<std::string>(Case&, double)> set{};
};

/// The key in a valid case, or why it is none that can be changed, in a sentence without it.
std::variant<DesignKey, std::string> designKey(const Case& c, std::string_view key);
/// The same, but a key of the computation (run., spectrum.) is none of the scene.
std::variant<DesignKey, std::string> sceneKey(const Case& c, std::string_view key);
/// Between which its value lies, whatever the others are [its unit]; of a rail's lengths nothing is known.
Interval allowedValues(std::string_view key);

} // namespace touchdown
