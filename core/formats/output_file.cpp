// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/output_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <random>
#include <stdexcept>
#include <string_view>
#include <system_error>

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
    std::error_code error;
    const fs::path target = fs::weakly_canonical(file, error);
    return error ? file : target;
}

namespace {

constexpr std::string_view ownMark = ".touchdown.";
constexpr std::string_view partEnding = ".part";
constexpr std::size_t idLength = 8; // hexadecimal digits between them

/// The beginning of the names of what stands beside a file while it is written: "run.h5.touchdown.".
std::string markedName(const fs::path& file)
{
    constexpr std::size_t longestName = 255; // [byte], of common file systems
    std::string name = file.filename().string();
    name.resize(std::min(name.size(), longestName - ownMark.size() - idLength - partEnding.size()));
    return name.append(ownMark);
}

std::string newId()
{
    std::random_device random;
    char text[idLength + 1];
    std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(random()));
    return text;
}

bool isPart(const std::string& name, const std::string& beginning)
{
    return name.size() == beginning.size() + idLength + partEnding.size() && name.starts_with(beginning) &&
           name.ends_with(partEnding) &&
           name.find_first_not_of("0123456789abcdef", beginning.size()) == name.size() - partEnding.size();
}

/// Those of killed programs. The caller holds the lock, so that no other program is at work on one.
void removeParts(const fs::path& file)
{
    const std::string beginning = markedName(file);
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    std::error_code error;
    for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error)) {
        std::error_code none;
        if (isPart(each->path().filename().string(), beginning) &&
            each->symlink_status(none).type() == fs::file_type::regular)
            fs::remove(each->path(), none);
    }
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

OutputLock::OutputLock(const fs::path& file) : lock_(file.parent_path() / (markedName(file) + "lock"))
{
    while (!held_) {
        const int descriptor = openLock(lock_);
        if (descriptor < 0 && errno != ELOOP && errno != EISDIR)
            throw std::system_error(errno, std::generic_category());
        struct stat status {};
        const bool isLock =
            descriptor >= 0 && ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size == 0;
        const int failure = isLock && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 ? errno : 0;
        // The writer before may have removed it meanwhile.
        held_ = isLock && failure == 0 && standsAt(status, lock_);
        if (held_) {
            descriptor_ = descriptor;
            return;
        }
        if (descriptor >= 0) ::close(descriptor);
        if (!isLock) throw std::runtime_error(lock_.string() + " is in the way: remove it or rename it");
        if (failure == EWOULDBLOCK) throw std::runtime_error("another run writes to it");
        if (failure != 0) { // a file system without locks
            ::unlink(lock_.c_str());
            return;
        }
    }
}

OutputLock::~OutputLock()
{
    if (!held_) return;
    ::unlink(lock_.c_str()); // before it is unlocked, so that no other writer loses its own
    ::close(descriptor_);
}

PartFile::PartFile(const fs::path& file)
    : target_(linkTarget(file)),
      lock_(target_),
      part_(target_.parent_path() / (markedName(target_) + newId() + std::string(partEnding)))
{
    if (lock_.held()) removeParts(target_);
}

PartFile::~PartFile() { ::unlink(part_.c_str()); }

int PartFile::create() const
{
    const int descriptor = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
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
    if (std::rename(part_.c_str(), target_.c_str()) != 0) throw std::system_error(errno, std::generic_category());
}

} // namespace touchdown
