// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/live_line.h"

#include <cstdio>

#include <unistd.h>

namespace touchdown {
namespace {

constexpr std::chrono::milliseconds redrawInterval(100);
constexpr std::chrono::seconds lineInterval(1);

} // namespace

LiveLine::LiveLine(bool always)
    : terminal_(::isatty(STDERR_FILENO) == 1), shown_(terminal_ || always), next_(Clock::now() + redrawInterval)
{}

void LiveLine::show(const std::function<std::string()>& text)
{
    if (!shown_) return;
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + (terminal_ ? Clock::duration(redrawInterval) : Clock::duration(lineInterval));
    std::fprintf(stderr, terminal_ ? "\r%s\x1b[K" : "%s\n", text().c_str());
    std::fflush(stderr);
    drawn_ = true;
}

void LiveLine::end(const std::function<std::string()>& text)
{
    if (terminal_ && drawn_) std::fputs("\r\x1b[K", stderr);
    if (!terminal_ && shown_) std::fprintf(stderr, "%s\n", text().c_str());
}

} // namespace touchdown
