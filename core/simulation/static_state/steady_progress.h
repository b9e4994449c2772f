// SPDX-License-Identifier: GPL-3.0-or-later
//
// Progress of a static solution. How many iterations it takes is not known beforehand, so there is no share.
#pragma once

#include "core/simulation/recording/progress.h"
#include "core/simulation/static_state/steady.h"

namespace touchdown {

inline Progress progressOf(const SteadyProgress& update)
{
    return {{},
            update.stage,
            {{"iteration", static_cast<double>(update.iteration), "", 10},
             {"residual", update.residual, "", 2},
             {"load error", update.loadError, "", 2},
             {"height", update.attitude.height, "nm", 4},
             {"pitch", update.attitude.pitch, "urad", 4},
             {"roll", update.attitude.roll, "urad", 4}}};
}

} // namespace touchdown
