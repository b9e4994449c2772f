// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/fourier.h"

namespace touchdown {

std::mutex& fourierPlanner()
{
    static std::mutex mutex;
    return mutex;
}

} // namespace touchdown
