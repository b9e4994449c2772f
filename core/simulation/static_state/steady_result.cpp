// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/steady_result.h"

namespace touchdown {

void SteadyResult::note(const std::string& sentence)
{
    if (!sentence.empty()) message += (message.empty() ? "" : "; ") + sentence;
}

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

void SteadyResult::dropFields()
{
    pressure = {};
    gap = {};
    recess = {};
    gaps = {};
}

} // namespace touchdown
