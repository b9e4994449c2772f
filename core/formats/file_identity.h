// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a file was when it was read. A path names whatever lies there now: another program may have written, replaced or
// removed the file since.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace touchdown {

struct FileIdentity {
    std::uint64_t device = 0;
    std::uint64_t inode = 0;
    std::uint64_t size = 0;   // [byte]
    std::int64_t changed = 0; // the bytes or the mode, by the system's clock [ns since 1970]
    std::uint64_t hash = 0;   // of all bytes; against accidents, not against forgery. 0: more than 1 GiB

    bool operator==(const FileIdentity&) const = default;
    /// One word, for files of the program.
    std::string text() const;
};

/// What text() wrote; nothing for any other text.
std::optional<FileIdentity> identityFromText(std::string_view text);

/// Reads the whole file at the path. Nothing where no regular file can be read. To be called before the file is read
/// for use: a change in between then makes the file another one.
std::optional<FileIdentity> identityOf(const std::filesystem::path& file);
/// The same without the hash: the file is not read.
std::optional<FileIdentity> marksOf(const std::filesystem::path& file);
/// Of a file that holds these bytes, wherever it lies.
FileIdentity identityOfBytes(std::string_view bytes);

enum class FileNow : std::uint8_t {
    Same,  // the same bytes, also with another time or in another file under this name
    Other, // a file with other bytes
    Gone,
    Unreadable, // a directory, a device, a file without permission
};
/// What lies now at the path of a file that was read. The bytes of a small file are always compared; those of a file
/// above 4 MiB if device, inode, size or time differ, and never above 1 GiB, where such a difference is a change.
FileNow fileNow(const std::filesystem::path& file, const FileIdentity& read);

} // namespace touchdown
