// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace touchdown {

/// What a clock on the wall shows, that never goes back [s].
inline double wallClock()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace touchdown
