// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/output_file.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace touchdown {

namespace fs = std::filesystem;

std::string outputObstacle(const fs::path& file)
{
    if (file.empty() || !file.has_filename()) return "it names no file";
    std::error_code none;
    const fs::file_status status = fs::status(file, none);
    if (fs::is_directory(status)) return "it is a directory";
    if (fs::exists(status) && !fs::is_regular_file(status)) return "it is no regular file";
    if (fs::exists(status) && ::access(file.c_str(), W_OK) != 0) return "no permission";
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, none)) return "there is no directory " + folder.string();
    if (::access(folder.c_str(), W_OK | X_OK) != 0) return "the directory " + folder.string() + " cannot be written to";
    return {};
}

std::string checkOutputFile(const fs::path& file)
{
    const std::string obstacle = outputObstacle(file);
    return obstacle.empty() ? std::string() : "cannot write to " + file.string() + ": " + obstacle;
}

fs::path linkTarget(const fs::path& file)
{
    constexpr int mostLinks = 40; // as the system follows
    fs::path target = file;
    std::error_code error;
    // Links are followed one by one, because the last may name a file that does not exist yet.
    for (int links = 0; links < mostLinks && fs::is_symlink(fs::symlink_status(target, error)); ++links)
        target = target.parent_path() / fs::read_symlink(target, error); // an absolute path replaces the folder
    const fs::path canonical = fs::weakly_canonical(target, error);
    return error ? file : canonical;
}

namespace {

constexpr std::string_view ownMark = ".touchdown.";
constexpr std::string_view partEnding = ".part", lockEnding = "lock";
constexpr std::size_t idLength = 8;                       // hexadecimal digits between them
constexpr std::size_t hashLength = 16;                    // hexadecimal digits in the mark of a long name
constexpr auto patience = std::chrono::milliseconds(300); // with a program that removes leftovers under this lock

/// FNV-1a, the same in every program.
std::uint64_t hashOf(std::string_view name)
{
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return hash;
}

/// The beginning of the names of what stands beside a file while it is written: "run.h5.touchdown.".
std::string markedName(const fs::path& file)
{
    constexpr std::size_t longestName = 255; // [byte], of common file systems
    constexpr std::size_t most = longestName - ownMark.size() - idLength - partEnding.size();
    std::string name = file.filename().string();
    if (name.size() > most) { // names that differ only at their ends stay different
        char end[hashLength + 2];
        std::snprintf(end, sizeof end, "~%016" PRIx64, hashOf(name));
        name.replace(most - (hashLength + 1), std::string::npos, end);
    }
    return name.append(ownMark);
}

std::string newId()
{
    std::random_device random;
    char text[idLength + 1];
    std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(random()));
    return text;
}

fs::path parentOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// The marked beginning of a name that a killed program may have left; "" of any other name.
std::string markOf(const fs::directory_entry& entry)
{
    const std::string name = entry.path().filename().string();
    std::error_code none;
    if (name.find(ownMark) == std::string::npos || entry.symlink_status(none).type() != fs::file_type::regular)
        return {};
    const auto cut = [&](std::string_view ending, std::size_t digits) {
        if (name.size() <= ending.size() + digits || !name.ends_with(ending)) return std::string();
        const std::size_t length = name.size() - ending.size() - digits;
        const bool own = name.find_first_not_of("0123456789abcdef", length) == name.size() - ending.size() &&
                         std::string_view(name).substr(0, length).ends_with(ownMark) && length > ownMark.size();
        return own ? name.substr(0, length) : std::string();
    };
    if (std::string mark = cut(partEnding, idLength); !mark.empty()) return mark;
    return entry.file_size(none) == 0 ? cut(lockEnding, 0) : std::string();
}

/// Opens a lock, or creates it; never through a symbolic link. -1 and errno if that failed.
int openLock(const fs::path& lock)
{
    while (true) {
        // Writable: some network file systems lock no other files.
        int descriptor = ::open(lock.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0 && errno == EACCES)
            descriptor = ::open(lock.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor >= 0 || errno != ENOENT) return descriptor;
        descriptor = ::open(lock.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0 || errno != EEXIST) return descriptor;
    }
}

bool standsAt(const struct stat& held, const fs::path& path)
{
    struct stat found {};
    return ::lstat(path.c_str(), &found) == 0 && found.st_dev == held.st_dev && found.st_ino == held.st_ino;
}

} // namespace

OutputLock::OutputLock(fs::path target, std::string mark, std::chrono::milliseconds wait)
    : target_(std::move(target)), lock_(parentOf(target_) / (mark + std::string(lockEnding))), mark_(std::move(mark))
{
    constexpr auto pause = std::chrono::milliseconds(10);
    for (auto waited = std::chrono::milliseconds(0); !take(); waited += pause) {
        if (waited >= wait) throw std::runtime_error("another run writes to it");
        std::this_thread::sleep_for(pause);
    }
}

OutputLock::OutputLock(const fs::path& file) : OutputLock(linkTarget(file), markedName(linkTarget(file)), patience)
{
    if (held()) removeLeftovers();
}

void OutputLock::removeLeftovers() const
{
    const fs::path folder = parentOf(target_);
    std::map<std::string, std::vector<fs::path>> left; // parts, by mark
    std::error_code error;
    for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error)) {
        const std::string mark = markOf(*each);
        if (mark.empty()) continue;
        std::vector<fs::path>& parts = left[mark];
        if (each->path().native().ends_with(partEnding)) parts.push_back(each->path());
    }
    for (const auto& [mark, parts] : left) {
        try {
            const std::unique_ptr<OutputLock> lock(
                mark == mark_ ? nullptr : new OutputLock(folder / mark, mark, std::chrono::milliseconds(0)));
            if (lock && !lock->held()) continue;
            for (const fs::path& part : parts) fs::remove(part, error);
        } catch (const std::exception&) { // another program is at work on it
            continue;
        }
    }
}

bool OutputLock::take()
{
    const int descriptor = openLock(lock_);
    if (descriptor < 0 && errno != ELOOP && errno != EISDIR) throw std::system_error(errno, std::generic_category());
    struct stat status {};
    const bool isLock =
        descriptor >= 0 && ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size == 0;
    const int failure = isLock && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 ? errno : 0;
    // The writer before may have removed it meanwhile.
    if (isLock && failure == 0 && standsAt(status, lock_)) {
        file_ = descriptor;
        return true;
    }
    if (descriptor >= 0) ::close(descriptor);
    if (!isLock) throw std::runtime_error(lock_.string() + " is in the way: remove it or rename it");
    if (failure == EWOULDBLOCK || failure == 0) return false;
    ::unlink(lock_.c_str()); // a file system without locks
    return true;
}

OutputLock::~OutputLock()
{
    if (file_ < 0) return;
    ::unlink(lock_.c_str()); // before it is unlocked, so that no other writer loses its own
    ::close(file_);
}

PartFile::PartFile(const fs::path& file, PartName name) : lock_(std::in_place, file), target_(lock_->target())
{
    begin(name);
}

PartFile::PartFile(const OutputLock& lock, PartName name) : target_(lock.target()) { begin(name); }

void PartFile::begin(PartName name)
{
    name_ = part_ = target_.parent_path() / (markedName(target_) + newId() + std::string(partEnding));
    if (name == PartName::Own) return;
    unnamed_ = ::open(parentOf(target_).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    if (unnamed_ < 0) return;
    const std::string path = "/proc/self/fd/" + std::to_string(unnamed_);
    if (::access(path.c_str(), W_OK) == 0)
        part_ = path;
    else
        ::close(std::exchange(unnamed_, -1));
}

PartFile::~PartFile()
{
    if (unnamed_ >= 0)
        ::close(unnamed_);
    else
        ::unlink(part_.c_str());
}

int PartFile::create() const
{
    const int flags = isNamed() ? O_CREAT | O_EXCL : O_TRUNC;
    const int descriptor = ::open(part_.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
    struct stat old {};
    if (descriptor >= 0 && ::stat(target_.c_str(), &old) == 0) ::fchmod(descriptor, old.st_mode & 07777u);
    return descriptor;
}

void PartFile::takeMode() const
{
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0 && ::chmod(part_.c_str(), old.st_mode & 07777u) != 0)
        throw std::system_error(errno, std::generic_category());
}

void PartFile::show() const
{
    takeMode();
    const auto link = [this](const fs::path& name) {
        return ::linkat(AT_FDCWD, part_.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    if (!isNamed()) {
        if (link(target_)) return;
        // Only a name takes the place of another one.
        if (errno != EEXIST || !link(name_)) throw std::system_error(errno, std::generic_category());
    }
    if (std::rename(name_.c_str(), target_.c_str()) == 0) return;
    const int reason = errno;
    if (!isNamed()) ::unlink(name_.c_str());
    throw std::system_error(reason, std::generic_category());
}

} // namespace touchdown
