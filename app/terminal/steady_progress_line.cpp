// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/steady_progress_line.h"

#include "app/terminal/progress_line.h"

namespace touchdown {

void SteadyProgressLine::show(const SteadyProgress& progress)
{
    if (!line_.shown()) return;
    last_ = progress;
    line_.show([this] { return text(); });
}

void SteadyProgressLine::end()
{
    line_.end([this] { return text(); });
}

std::string SteadyProgressLine::text() const
{
    std::string line;
    if (states_ > 1) line = "state " + std::to_string(state_ + 1) + " of " + std::to_string(states_) + ", ";
    line += last_.stage + ", iteration " + std::to_string(last_.iteration);
    line += ", residual " + displayed(last_.residual, "", 2) + ", load error " + displayed(last_.loadError, "", 2);
    return line + ", " + displayed(last_.attitude.height, "nm") + ", " + displayed(last_.attitude.pitch, "urad") +
           ", " + displayed(last_.attitude.roll, "urad");
}

} // namespace touchdown
