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

/// Reads a regular file of at most `largest` bytes; one that is larger is refused without being read.
std::variant<std::string, FileProblem> readTextFile(const std::filesystem::path& file, std::uintmax_t largest);

/// Writes what show() makes appear. Returns the problem, or "".
std::string writePart(const PartFile& part, const std::string& text);

/// Writes a file that appears whole or not at all (core/formats/output_file.h). Returns the problem, or "".
std::string writeTextFile(const std::filesystem::path& file, const std::string& text);

} // namespace touchdown
