// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that a case, a study or files of the established program name, outside their own folder. A case that comes from
// another person could so read any file of its reader, and show it in messages and results. Such a file is not opened
// unless the person at the computer allows it: by --allow-paths, by an answer in the window, or by giving the path
// (--set, a dialog, a field).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace touchdown {

/// The key of a case that names a file, beside abs.rails.
inline constexpr const char* surfaceFileKey = "disk.surface.file";

enum class OutsidePaths : std::uint8_t { Refused, Allowed };

/// Whether `name`, as it stands in a file of `folder`, leads out of the folder: by an absolute path, by "..", or by a
/// symbolic link. An empty folder is the working one. Opens nothing.
bool leadsOutside(const std::filesystem::path& folder, const std::filesystem::path& name);

/// Why `name` is not read: it lies outside the folder of `what`, "the case". Names the remedies.
std::string outsideProblem(const std::string& name, const std::string& what);

} // namespace touchdown
