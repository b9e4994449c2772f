// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIGINT and SIGTERM ask a run to end in good order; the second signal ends the program at once.
#pragma once

#include <csignal>

namespace touchdown {

class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    bool requested() const;

private:
    struct sigaction interrupt_ {};
    struct sigaction terminate_ {};
};

} // namespace touchdown
