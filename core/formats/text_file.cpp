// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/text_file.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <exception>
#include <string_view>
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

/// Files that the system makes up while they are read look like regular ones of size 0.
bool isMadeBySystem(const fs::path& file)
{
    constexpr auto kinds = std::to_array<long>({PROC_SUPER_MAGIC, SYSFS_MAGIC, DEBUGFS_MAGIC, TRACEFS_MAGIC,
                                                SECURITYFS_MAGIC, CGROUP_SUPER_MAGIC, CGROUP2_SUPER_MAGIC});
    struct statfs system {};
    return ::statfs(file.c_str(), &system) == 0 && std::ranges::find(kinds, long{system.f_type}) != kinds.end();
}

/// Whether bytes of a text file are those of a text: in UTF-16, of which a block holds whole letters, no letter is 0.
bool isText(std::string_view block, bool utf16)
{
    if (!utf16) return block.find('\0') == std::string_view::npos;
    for (std::size_t i = 0; i + 1 < block.size(); i += 2)
        if (block[i] == '\0' && block[i + 1] == '\0') return false;
    return true;
}

} // namespace

std::string notRegularFile(const fs::path& file)
{
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) return "does not exist";
    if (status.type() == fs::file_type::none || status.type() == fs::file_type::unknown)
        return "cannot be read: " + error.message();
    if (fs::is_directory(status)) return "is a directory, not a file";
    return !fs::is_regular_file(status) || isMadeBySystem(file) ? "is not a regular file" : "";
}

std::variant<std::string, FileProblem> readTextFile(const fs::path& file, std::uintmax_t largest, FileContent content)
{
    std::error_code error;
    if (std::string problem = notRegularFile(file); !problem.empty()) return FileProblem{std::move(problem)};
    const std::string tooLarge =
        content == FileContent::Text
            ? "is larger than " + std::to_string(largest >> 20) + " MiB, the most that is read"
            : "is larger than " + std::to_string(largest >> 10) + " KiB, so it is not a case file";
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
        const std::size_t begin = text.size() & ~std::size_t{1};
        text.append(block.data(), static_cast<std::size_t>(count));
        const bool utf16 = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
        if (content == FileContent::Text && !isText(std::string_view(text).substr(begin), utf16))
            return FileProblem{"holds bytes that no text holds; it may be a binary file"};
        if (text.size() > largest) return FileProblem{tooLarge}; // it grew, or lied about its size
    }
    return text;
}

std::string writePart(const PartFile& part, const std::string& text)
{
    Descriptor descriptor(part.create());
    if (descriptor.number() < 0 || !writeAll(descriptor.number(), text) || !descriptor.close()) return lastError();
    return {};
}

std::string writeTextFile(const fs::path& file, const std::string& text)
{
    std::error_code none;
    if (fs::is_directory(file, none)) return "is a directory, not a file";
    if (fs::exists(file, none) && ::access(file.c_str(), W_OK) != 0) return "cannot be written: " + lastError();
    try {
        const PartFile part(file);
        if (const std::string reason = writePart(part, text); !reason.empty()) return "cannot be written: " + reason;
        part.show();
    } catch (const std::exception& failure) {
        return std::string("cannot be written: ") + failure.what();
    }
    return {};
}

} // namespace touchdown
