// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/text_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace touchdown {

namespace fs = std::filesystem;

namespace {

std::string lastError() { return std::generic_category().message(errno); }

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor()
    {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

bool writeAll(int descriptor, const std::string& text)
{
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        done += static_cast<std::size_t>(count);
    }
    return ::fsync(descriptor) == 0;
}

/// The mode of the file that is replaced, or of a new one.
mode_t modeFor(const fs::path& file)
{
    struct stat old {};
    if (::stat(file.c_str(), &old) == 0) return old.st_mode & 07777u;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666u & ~mask;
}

} // namespace

std::variant<std::string, FileProblem> readTextFile(const fs::path& file, std::uintmax_t largest)
{
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) return FileProblem{"does not exist"};
    if (status.type() == fs::file_type::none || status.type() == fs::file_type::unknown)
        return FileProblem{"cannot be read: " + error.message()};
    if (fs::is_directory(status)) return FileProblem{"is a directory, not a file"};
    if (!fs::is_regular_file(status)) return FileProblem{"is not a regular file"};
    const std::string tooLarge = "is larger than " + std::to_string(largest >> 10) + " KiB, so it is not a case file";
    if (const auto size = fs::file_size(file, error); !error && size > largest) return FileProblem{tooLarge};

    const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (descriptor.number() < 0) return FileProblem{"cannot be read: " + lastError()};
    std::string text;
    std::array<char, 1 << 16> block{};
    while (true) {
        const ssize_t count = ::read(descriptor.number(), block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return FileProblem{"cannot be read: " + lastError()};
        if (count == 0) break;
        text.append(block.data(), static_cast<std::size_t>(count));
        if (text.size() > largest) return FileProblem{tooLarge}; // it grew, or lied about its size
    }
    return text;
}

std::string writeTextFile(const fs::path& file, const std::string& text)
{
    std::error_code error;
    // A link stays a link: its target is replaced.
    const fs::path target = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    if (fs::is_directory(target, error)) return "is a directory, not a file";
    if (fs::exists(target, error) && ::access(target.c_str(), W_OK) != 0) return "cannot be written: " + lastError();

    std::string temporary = target.string() + ".XXXXXX";
    Descriptor descriptor(::mkstemp(temporary.data()));
    if (descriptor.number() < 0) return "cannot be written: " + lastError();
    const bool written = writeAll(descriptor.number(), text) && ::fchmod(descriptor.number(), modeFor(target)) == 0 &&
                         descriptor.close() && ::rename(temporary.c_str(), target.c_str()) == 0;
    if (written) return {};
    const std::string problem = "cannot be written: " + lastError();
    ::unlink(temporary.c_str());
    return problem;
}

} // namespace touchdown
