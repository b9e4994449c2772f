// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

namespace touchdown {

/// FFTW executes plans on any thread, but makes and destroys them on one at a time: hold this around both.
inline std::mutex& fourierPlanner()
{
    static std::mutex mutex;
    return mutex;
}

} // namespace touchdown
