// SPDX-License-Identifier: GPL-3.0-or-later
//
// A second process of this program that reads one file of another person.
//
// The HDF5 library (1.10) trusts a file: a single wrong byte can make it read outside its memory, loop for ever or ask
// for gigabytes; so does the library of DXF drawings. So a second process opens the file, with limits of memory and
// computing time that grow with the size of the file. It sends what it read as plain values. Where it crashes or
// reaches a limit, the file is damaged, and the program continues.
//
// The second process is this program again, with arguments that no person gives. Each program that reads such files
// begins with runReader (core/studies/reader_program.h).
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/formats/passed_values.h"

namespace touchdown {

/// What reading a file may take, by its size.
struct ReaderLimits {
    std::uintmax_t data = 0;           // in the file, unpacked [byte]
    std::uintmax_t memory = 0;         // of the process, beyond what it has when it begins [byte]
    unsigned seconds = 0;              // of computing time [s]
    std::chrono::milliseconds wait{0}; // until the last value comes
};
/// `fileSize` in byte.
ReaderLimits readerLimits(std::uintmax_t fileSize);
/// For a file; its size is 0 where it cannot be found.
ReaderLimits readerLimits(const std::filesystem::path& file);

/// Why there is no answer, in a sentence without the name of the file: "is damaged: ...".
class ReaderFailure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct ReaderTask {
    std::string reader; // "surface", "run", "drawing", ...
    std::filesystem::path file;
    std::string argument; // of the reader
};

/// The second process, as the program sees it. Several threads may have one each.
class ReaderProcess {
public:
    /// Starts it. Throws ReaderFailure.
    explicit ReaderProcess(const ReaderTask& task);
    /// Ends it.
    ~ReaderProcess();
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;

    /// The next bytes of its answer. Throws ReaderFailure where it ended before, or a limit is reached.
    void read(void* bytes, std::size_t count);

private:
    [[noreturn]] void fail();

    ReaderLimits limits_;
    std::chrono::steady_clock::time_point end_;
    std::uintmax_t received_ = 0; // [byte]
    int pipe_ = -1;
    pid_t process_ = -1;
    bool late_ = false;
};

/// Lets a second process read a file and takes the values of its answer. Throws ReaderFailure.
template <class... Values>
void readAnswer(const ReaderTask& task, Values&... values)
{
    ReaderProcess process(task);
    PassedIn in([&](void* bytes, std::size_t count) { process.read(bytes, count); });
    in(values...);
}

/// The task of this process, if it is a second process; then its limits hold from now on.
std::optional<ReaderTask> beginReader(int argc, const char* const* argv);
/// Sends bytes of the answer of this second process; ends it where nobody waits for them.
void sendAnswer(const void* bytes, std::size_t count);

} // namespace touchdown
