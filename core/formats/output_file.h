// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file that appears whole or not at all, and that one program writes at a time.
#pragma once

#include <filesystem>
#include <string>

#include <sys/types.h>

namespace touchdown {

/// Why a regular file cannot be written, before anything is: "it is a directory"; "" if it can.
std::string outputObstacle(const std::filesystem::path& file);
/// The same with the name: "cannot write to NAME: it is a directory".
std::string checkOutputFile(const std::filesystem::path& file);

/// The file that a symbolic link names, so that the link stays one; any other file as it is.
std::filesystem::path linkTarget(const std::filesystem::path& file);

/// Keeps a file for one writer: while one lives, another for the same file is refused, in this program and in others.
/// NAME.touchdown.lock stands for it; the system unlocks it when the program ends, however it ends.
class OutputLock {
public:
    /// Throws std::exception with the reason: "another run writes to it".
    explicit OutputLock(const std::filesystem::path& file);
    ~OutputLock(); // removes the lock
    OutputLock(const OutputLock&) = delete;
    OutputLock& operator=(const OutputLock&) = delete;

    /// False on a file system without locks.
    bool held() const { return held_; }

private:
    std::filesystem::path lock_;
    int descriptor_ = -1;
    bool held_ = false;
};

/// NAME.touchdown.*.part, which takes the place of NAME when it is whole, with the mode of the file that it replaces.
/// Until then, and after any failure, NAME is as it was. A part that a killed program left is removed by the next one.
class PartFile {
public:
    /// Locks the file. Throws std::exception with the reason.
    explicit PartFile(const std::filesystem::path& file);
    ~PartFile(); // removes the part and unlocks the file
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    /// The file itself, or what a symbolic link of that name leads to.
    const std::filesystem::path& target() const { return target_; }
    /// A new name. To be created, so that nothing that exists is opened or followed, and written and closed by the
    /// caller.
    const std::filesystem::path& path() const { return part_; }
    /// Creates it and returns its descriptor, open for writing; -1 and errno if that failed.
    int create() const;
    /// Gives it the mode of the file that it will replace, if there is one. Throws std::system_error.
    void takeMode() const;
    /// Throws std::system_error. The file stays locked.
    void show() const;

private:
    std::filesystem::path target_;
    OutputLock lock_;
    std::filesystem::path part_;
};

} // namespace touchdown
