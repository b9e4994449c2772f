// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace touchdown {

/// Whether teams try if they gain, and stop sharing loops where they do not; so at first. Without, they share every
/// loop: for comparisons of one thread with several, which would else depend on how busy the cores are.
void setTeamTrials(bool on);

} // namespace touchdown
