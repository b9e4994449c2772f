// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/engine/shell.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchdown {

namespace {

int codeOf(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : -1; }

} // namespace

std::string shellWord(const std::string& text)
{
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
    return word + "'";
}

ShellAnswer askShell(const std::string& command)
{
    ShellAnswer answer;
    // In a session of its own, so that Ctrl+C for this program does not end a command half-way.
    std::FILE* const pipe = ::popen(("setsid -w sh -c " + shellWord(command) + " 2>&1").c_str(), "re");
    if (pipe == nullptr) return answer;
    std::array<char, 4096> block{};
    for (std::size_t count = 0; (count = std::fread(block.data(), 1, block.size(), pipe)) > 0;)
        answer.output.append(block.data(), count);
    answer.code = codeOf(::pclose(pipe));
    return answer;
}

ShellProcess::ShellProcess(const std::string& command)
{
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawnattr_init(&attributes);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &all);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    std::string shell = "sh", option = "-c", text = command;
    std::array<char*, 4> arguments{shell.data(), option.data(), text.data(), nullptr};
    const int error = ::posix_spawn(&id_, "/bin/sh", &files, &attributes, arguments.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&files);
    if (error != 0) throw std::system_error(error, std::generic_category(), "cannot start a shell");
}

ShellProcess::~ShellProcess()
{
    if (ended()) return;
    ::kill(-id_, SIGTERM);
    while (::waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

std::optional<int> ShellProcess::ended()
{
    if (code_) return code_;
    int status = 0;
    if (::waitpid(id_, &status, WNOHANG) == id_) code_ = codeOf(status);
    return code_;
}

} // namespace touchdown
