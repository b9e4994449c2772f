// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study.h"

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

std::string_view name(PointKind kind)
{
    switch (kind) {
    case PointKind::Good: return "good";
    case PointKind::WrongState: return "wrong-state";
    case PointKind::Failed: return "failed";
    }
    return {};
}

std::string_view name(ChartLine line)
{
    switch (line) {
    case ChartLine::None: return "none";
    case ChartLine::Solid: return "solid";
    case ChartLine::Dashed: return "dashed";
    case ChartLine::Steps: return "steps";
    }
    return {};
}

} // namespace touchdown
