// SPDX-License-Identifier: GPL-3.0-or-later
//
// A full disk without one: while it lives, no file of this process and of those that it starts grows beyond the limit.
#pragma once

#include <csignal>

#include <sys/resource.h>

namespace touchdown::test {

class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t most) // [byte]
    {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{most, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN); // the write fails with EFBIG instead
    }
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

} // namespace touchdown::test
