// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/run_failure.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace touchdown {

namespace {

/// Of the place where "<word> 12.3 us" begins.
std::size_t findWhen(std::string_view message, std::string_view word)
{
    for (std::size_t at = message.find(word); at != std::string_view::npos; at = message.find(word, at + 1)) {
        const std::size_t next = at + word.size();
        if (next < message.size() && (std::isdigit(static_cast<unsigned char>(message[next])) || message[next] == '-')) return at;
    }
    return std::string_view::npos;
}

} // namespace

std::string failureOf(const Summary& summary)
{
    if (summary.status == RunStatus::Completed) return {};
    const std::string_view message = summary.message;
    const std::size_t end = std::min({findWhen(message, " at "), findWhen(message, " since "), message.find_first_of(":;")});
    const std::string_view what = message.substr(0, end);
    return what.empty() ? std::string(name(summary.status)) : std::string(what);
}

} // namespace touchdown
