// SPDX-License-Identifier: GPL-3.0-or-later
//
// What all users of FFTW's plans share.
#pragma once

#include <mutex>

namespace touchdown {

/// FFTW executes plans on any thread, but makes and destroys them on one at a time: hold this around both.
std::mutex& fourierPlanner();

} // namespace touchdown
