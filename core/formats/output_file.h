// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file that appears whole or not at all, and that one program writes at a time. What a killed program leaves beside
// it, an empty lock and perhaps a part, is removed by the next program that writes into the folder.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace touchdown {

/// Why a regular file cannot be written, before anything is: "it is a directory"; "" if it can.
std::string outputObstacle(const std::filesystem::path& file);
/// The same with the name: "cannot write to NAME: it is a directory".
std::string checkOutputFile(const std::filesystem::path& file);

/// The file that a symbolic link names, so that the link stays one; any other file as it is.
std::filesystem::path linkTarget(const std::filesystem::path& file);

/// Keeps a file for one writer: while one lives, another for the same file is refused, in this program and in others.
/// NAME.touchdown.lock stands for it, which the system unlocks when the program ends, however it ends: also programs of
/// other containers and computers see it. Removes what killed programs have left in the folder.
class OutputLock {
public:
    /// Throws std::exception with the reason: "another run writes to it".
    explicit OutputLock(const std::filesystem::path& file);
    ~OutputLock(); // removes the lock
    OutputLock(const OutputLock&) = delete;
    OutputLock& operator=(const OutputLock&) = delete;

    /// The file itself, or what a symbolic link of that name leads to.
    const std::filesystem::path& target() const { return target_; }
    /// False on a file system without locks.
    bool held() const { return file_ >= 0; }

private:
    /// Waits for another that holds the lock, then throws.
    OutputLock(std::filesystem::path target, std::string mark, std::chrono::milliseconds wait);
    /// False while another holds it. Throws what the constructor throws.
    bool take();
    /// Of killed programs: parts and locks that no program holds.
    void removeLeftovers() const;

    std::filesystem::path target_, lock_;
    std::string mark_; // the beginning of the names beside the file: "run.h5.touchdown."
    int file_ = -1;    // descriptor of the lock
};

/// Whether a new file has a name before it takes the place of another one. HDF5 opens files by a name only.
enum class PartName : bool { None, Own };

/// A new file, which takes the place of NAME when it is whole, with the mode of the file that it replaces. Until then,
/// and after any failure, NAME is as it was. PartName::None: the system removes it when the program ends, where the
/// file system has files without a name. Else, NAME.touchdown.*.part stays until the next program that writes into the
/// folder.
class PartFile {
public:
    /// Locks the file. Throws std::exception with the reason.
    explicit PartFile(const std::filesystem::path& file, PartName name = PartName::None);
    /// Of a file that the caller has locked; the lock must last.
    explicit PartFile(const OutputLock& lock, PartName name = PartName::None);
    ~PartFile(); // removes the part and unlocks the file
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    /// The file itself, or what a symbolic link of that name leads to.
    const std::filesystem::path& target() const { return target_; }
    /// To be created, so that nothing that exists is opened or followed, or, of a part without a name, emptied; and to
    /// be written and closed by the caller.
    const std::filesystem::path& path() const { return part_; }
    bool isNamed() const { return unnamed_ < 0; }
    /// Creates it and returns a descriptor of it, open for writing; -1 and errno if that failed.
    int create() const;
    /// Gives it the mode of the file that it will replace, if there is one. Throws std::system_error.
    void takeMode() const;
    /// Throws std::system_error. The file stays locked.
    void show() const;

private:
    void begin(PartName name);

    std::optional<OutputLock> lock_; // none: it is the caller's
    std::filesystem::path target_;
    std::filesystem::path name_; // of a part that has or needs one
    int unnamed_ = -1;           // its descriptor; -1: it has a name
    std::filesystem::path part_;
};

} // namespace touchdown
