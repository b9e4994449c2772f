// SPDX-License-Identifier: GPL-3.0-or-later
//
// Commands of the shell, in a process of their own.
#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

namespace touchdown {

/// 'a word' for a shell, whatever it holds.
std::string shellWord(const std::string& text);

struct ShellAnswer {
    int code = -1;      // of its end; -1: it did not start, or a signal ended it
    std::string output; // standard output and standard error
};
/// Waits for it.
ShellAnswer askShell(const std::string& command);

/// A command that goes on beside this program, without a terminal.
class ShellProcess {
public:
    /// Throws std::system_error.
    explicit ShellProcess(const std::string& command);
    /// Ends it with all that it started.
    ~ShellProcess();
    ShellProcess(const ShellProcess&) = delete;
    ShellProcess& operator=(const ShellProcess&) = delete;

    /// Its code, once it has ended; -1 after a signal.
    std::optional<int> ended();

private:
    pid_t id_ = -1;
    std::optional<int> code_;
};

} // namespace touchdown
