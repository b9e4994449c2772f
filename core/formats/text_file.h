// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small text files, read and written whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>

namespace touchdown {

class PartFile;

/// Why a file cannot be read, in a sentence without its name.
struct FileProblem {
    std::string message;
};

enum class FileContent : std::uint8_t {
    Any,  // also archives
    Text, // without zero bytes, except those of UTF-16 with its mark
};

/// Reads a regular file of at most `largest` bytes; one that is larger, and a file of the system (/proc, /sys), is
/// refused without being read. A file that is to hold text is refused at its first block that holds none.
std::variant<std::string, FileProblem> readTextFile(const std::filesystem::path& file, std::uintmax_t largest,
                                                    FileContent content = FileContent::Any);
/// Why a path is no file that is read, in a sentence without its name: a directory, a FIFO, a device, a file of the
/// system; "" for a regular file. Opens nothing.
std::string notRegularFile(const std::filesystem::path& file);

/// Writes what show() makes appear. Returns the reason why it cannot, or "".
std::string writePart(const PartFile& part, const std::string& text);

/// Writes a file that appears whole or not at all (core/formats/output_file.h). Returns the problem, or "".
std::string writeTextFile(const std::filesystem::path& file, const std::string& text);

} // namespace touchdown
