// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study.h"

namespace touchdown {

std::string_view name(StudyStatus status)
{
    switch (status) {
    case StudyStatus::Completed: return "completed";
    case StudyStatus::Cancelled: return "cancelled";
    case StudyStatus::Failed: return "failed";
    }
    return {};
}

} // namespace touchdown
