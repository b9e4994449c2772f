// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file that appears whole or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace touchdown {

/// Why a regular file cannot be written, before anything is: "cannot write to NAME: it is a directory"; "" if it can.
std::string checkOutputFile(const std::filesystem::path& file);

/// The file that a symbolic link names, so that the link stays one; any other file as it is.
std::filesystem::path linkTarget(const std::filesystem::path& file);

/// NAME.part, which takes the place of NAME when it is whole, with the mode of the file that it replaces. Until then,
/// and after any failure, NAME is as it was.
class PartFile {
public:
    /// Removes what an interrupted program may have left at NAME.part.
    explicit PartFile(const std::filesystem::path& file);
    ~PartFile(); // removes NAME.part
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    /// To be created, written and closed by the caller.
    const std::filesystem::path& path() const { return part_; }
    /// Throws std::system_error.
    void show();

private:
    std::filesystem::path target_, part_;
};

} // namespace touchdown
