// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/text_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <exception>
#include <system_error>
#include <utility>

#include "core/formats/output_file.h"

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

std::string writePart(const PartFile& part, const std::string& text)
{
    Descriptor descriptor(part.create());
    if (descriptor.number() < 0 || !writeAll(descriptor.number(), text) || !descriptor.close())
        return "cannot be written: " + lastError();
    return {};
}

std::string writeTextFile(const fs::path& file, const std::string& text)
{
    std::error_code none;
    if (fs::is_directory(file, none)) return "is a directory, not a file";
    if (fs::exists(file, none) && ::access(file.c_str(), W_OK) != 0) return "cannot be written: " + lastError();
    try {
        const PartFile part(file);
        if (const std::string problem = writePart(part, text); !problem.empty()) return problem;
        part.show();
    } catch (const std::exception& failure) {
        return std::string("cannot be written: ") + failure.what();
    }
    return {};
}

} // namespace touchdown
