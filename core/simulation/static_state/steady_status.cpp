// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/steady.h"

namespace touchdown {

std::string_view name(SteadyStatus status)
{
    switch (status) {
    case SteadyStatus::Converged: return "converged";
    case SteadyStatus::NotConverged: return "not converged";
    case SteadyStatus::Cancelled: return "cancelled";
    case SteadyStatus::Failed: return "failed";
    }
    return {};
}

} // namespace touchdown
