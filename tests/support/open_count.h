// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often a file is opened, by any process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <sys/inotify.h>
#include <unistd.h>

namespace touchdown::test {

/// Counts from its construction on.
class OpenCount {
public:
    explicit OpenCount(const std::filesystem::path& file) : events_(::inotify_init1(IN_NONBLOCK))
    {
        // Equal events in a row become one; a file that is closed between two openings gives both events.
        ::inotify_add_watch(events_, file.c_str(), IN_OPEN | IN_CLOSE);
    }
    OpenCount(const OpenCount&) = delete;
    OpenCount& operator=(const OpenCount&) = delete;
    ~OpenCount() { ::close(events_); }

    /// Since the last call.
    int taken()
    {
        int opened = 0;
        alignas(inotify_event) char buffer[4096];
        for (ssize_t size = 0; (size = ::read(events_, buffer, sizeof buffer)) > 0;)
            for (const char* at = buffer; at < buffer + size;) {
                const auto* event = reinterpret_cast<const inotify_event*>(at);
                if ((event->mask & IN_OPEN) != 0) ++opened;
                at += sizeof(inotify_event) + event->len;
            }
        return opened;
    }

private:
    int events_ = -1;
};

} // namespace touchdown::test
