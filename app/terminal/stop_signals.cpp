// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/stop_signals.h"

namespace touchdown {

namespace {

volatile std::sig_atomic_t stopSignal = 0; // a signal handler can only reach a global

} // namespace

StopSignals::StopSignals()
{
    stopSignal = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { stopSignal = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigaction(SIGINT, &action, &interrupt_);
    sigaction(SIGTERM, &action, &terminate_);
    sigaction(SIGHUP, nullptr, &hangUp_);
    action.sa_flags = static_cast<int>(SA_RESTART);
    if (hangUp_.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

StopSignals::~StopSignals()
{
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGTERM, &terminate_, nullptr);
    sigaction(SIGHUP, &hangUp_, nullptr);
}

bool stopRequested() { return stopSignal != 0; }

} // namespace touchdown
