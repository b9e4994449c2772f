// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/stop_signal.h"

namespace touchdown {
namespace {

// A signal handler reaches nothing but a global.
volatile std::sig_atomic_t stopRequested = 0;

void request(int) { stopRequested = 1; }

} // namespace

StopSignal::StopSignal()
{
    stopRequested = 0;
    struct sigaction action {};
    action.sa_handler = request;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigaction(SIGINT, &action, &interrupt_);
    sigaction(SIGTERM, &action, &terminate_);
}

StopSignal::~StopSignal()
{
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGTERM, &terminate_, nullptr);
}

bool StopSignal::requested() const { return stopRequested != 0; }

} // namespace touchdown
