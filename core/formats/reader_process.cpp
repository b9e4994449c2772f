// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/reader_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace touchdown {

namespace {

constexpr const char* readerMark = "--read-file-for-parent";
constexpr const char* thisProgram = "/proc/self/exe"; // also after a new version took its place on the disk

std::string systemText(int error) { return std::generic_category().message(error); }

/// Memory that this process has mapped [byte].
std::uintmax_t mappedMemory()
{
    std::uintmax_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uintmax_t>(::sysconf(_SC_PAGESIZE));
}

void limit(auto resource, std::uintmax_t soft, std::uintmax_t hard)
{
    const rlimit value{static_cast<rlim_t>(soft), static_cast<rlim_t>(hard)};
    ::setrlimit(resource, &value);
}

/// How the second process is started: its answer goes into `answer`; it inherits no other open file, and no signal of
/// the terminal reaches it.
class StartOptions {
public:
    explicit StartOptions(int answer)
    {
        ::posix_spawn_file_actions_init(&files);
        ::posix_spawn_file_actions_adddup2(&files, answer, STDOUT_FILENO);
        ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        ::posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
        ::posix_spawnattr_init(&attributes);
        sigset_t none{}, all{};
        ::sigemptyset(&none);
        ::sigfillset(&all);
        ::posix_spawnattr_setsigmask(&attributes, &none);
        ::posix_spawnattr_setsigdefault(&attributes, &all);
        ::posix_spawnattr_setpgroup(&attributes, 0);
        ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
    ~StartOptions()
    {
        ::posix_spawn_file_actions_destroy(&files);
        ::posix_spawnattr_destroy(&attributes);
    }
    StartOptions(const StartOptions&) = delete;
    StartOptions& operator=(const StartOptions&) = delete;

    posix_spawn_file_actions_t files{};
    posix_spawnattr_t attributes{};
};

} // namespace

ReaderLimits readerLimits(std::uintmax_t fileSize)
{
    constexpr std::uintmax_t mebibyte = 1 << 20;
    constexpr std::uintmax_t mostPacked = 1032; // what deflate makes of a byte, at most
    constexpr std::uintmax_t perSecond = 100 * mebibyte;
    fileSize = std::min(fileSize, std::uintmax_t{1} << 44);
    ReaderLimits limits;
    limits.data = mebibyte + std::min(mostPacked * fileSize, 512 * mebibyte + 64 * fileSize);
    limits.memory = 96 * mebibyte + 4 * limits.data;
    limits.seconds = 1 + static_cast<unsigned>(limits.data / perSecond);
    // A busy computer needs longer than the computing time.
    limits.wait = std::chrono::seconds(2 + 4 * limits.seconds);
    return limits;
}

ReaderLimits readerLimits(const std::filesystem::path& file)
{
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    return readerLimits(error ? 0 : size);
}

ReaderProcess::ReaderProcess(const ReaderTask& task)
    : limits_(readerLimits(task.file)), end_(std::chrono::steady_clock::now() + limits_.wait)
{
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
        throw ReaderFailure("cannot be read: no process can be started for it: " + systemText(errno));
    pipe_ = pipe[0];
    std::string file = task.file.string(), reader = task.reader, argument = task.argument;
    std::string name = "touchdown", mark = readerMark;
    char* const words[] = {name.data(), mark.data(), reader.data(), file.data(), argument.data(), nullptr};
    const StartOptions options(pipe[1]);
    const int error = ::posix_spawn(&process_, thisProgram, &options.files, &options.attributes, words, environ);
    ::close(pipe[1]);
    if (error == 0) return;
    ::close(pipe_);
    throw ReaderFailure("cannot be read: no process can be started for it: " + systemText(error));
}

ReaderProcess::~ReaderProcess()
{
    ::close(pipe_);
    if (process_ < 0) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

void ReaderProcess::read(void* bytes, std::size_t count)
{
    char* to = static_cast<char*>(bytes);
    received_ += count;
    if (received_ > 2 * limits_.data) fail(); // no file of this size holds so much
    while (count > 0) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end_ - std::chrono::steady_clock::now());
        pollfd ready{pipe_, POLLIN, 0};
        const int state = ::poll(&ready, 1, static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 1'000'000)));
        if (state < 0 && errno == EINTR) continue;
        late_ = state == 0;
        const ssize_t got = state > 0 ? ::read(pipe_, to, count) : 0;
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) fail();
        to += got;
        count -= static_cast<std::size_t>(got);
    }
}

void ReaderProcess::fail()
{
    if (late_) ::kill(process_, SIGKILL);
    int status = 0;
    pid_t ended = 0;
    while ((ended = ::waitpid(process_, &status, 0)) < 0 && errno == EINTR) {
    }
    process_ = -1;
    const bool slow = late_ || (ended > 0 && WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU);
    throw ReaderFailure(slow ? "is damaged: reading it did not come to an end in the time that a file of its size needs"
                             : "is damaged: the library that reads it fails on it");
}

std::optional<ReaderTask> beginReader(int argc, const char* const* argv)
{
    if (argc != 5 || std::string_view(argv[1]) != readerMark) return {};
    ReaderTask task{argv[2], argv[3], argv[4]};
    ::prctl(PR_SET_PDEATHSIG, SIGKILL); // ends with its parent
    const ReaderLimits limits = readerLimits(task.file);
    const std::uintmax_t memory = mappedMemory() + limits.memory;
    limit(RLIMIT_AS, memory, memory);
    limit(RLIMIT_CPU, limits.seconds, limits.seconds + 1);
    limit(RLIMIT_CORE, 0, 0);
    ::prctl(PR_SET_DUMPABLE, 0); // its crash is no crash of the program, and nobody is to report it
    return task;
}

void sendAnswer(const void* bytes, std::size_t count)
{
    const char* from = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t done = ::write(STDOUT_FILENO, from, count);
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) ::_exit(1);
        from += done;
        count -= static_cast<std::size_t>(done);
    }
}

} // namespace touchdown
