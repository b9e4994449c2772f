// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIGINT, SIGTERM or SIGHUP (the terminal is closed) asks a calculation to stop; a second SIGINT or SIGTERM ends the
// program at once. SIGHUP may come twice, from the terminal and from its shell, and stays ignored where it was (nohup).
#pragma once

#include <csignal>

namespace touchdown {

/// While one lives, the first signal is only noted. It begins before the input is read, so that a signal at that time
/// stops the calculation at its first step. One at a time.
class StopSignals {
public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

private:
    struct sigaction interrupt_ {}; // the actions before
    struct sigaction terminate_ {};
    struct sigaction hangUp_ {};
};

/// Whether a signal has come since the last StopSignals began.
bool stopRequested();

} // namespace touchdown
