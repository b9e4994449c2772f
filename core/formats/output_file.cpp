// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/output_file.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace touchdown {

namespace fs = std::filesystem;

std::string checkOutputFile(const fs::path& file)
{
    const std::string beginning = "cannot write to " + file.string() + ": ";
    if (file.empty() || !file.has_filename()) return beginning + "it names no file";
    std::error_code none;
    const fs::file_status status = fs::status(file, none);
    if (fs::is_directory(status)) return beginning + "it is a directory";
    if (fs::exists(status) && !fs::is_regular_file(status)) return beginning + "it is no regular file";
    if (fs::exists(status) && ::access(file.c_str(), W_OK) != 0) return beginning + "no permission";
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, none)) return beginning + "there is no directory " + folder.string();
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return beginning + "the directory " + folder.string() + " cannot be written to";
    return {};
}

fs::path linkTarget(const fs::path& file)
{
    std::error_code error;
    const fs::path target = fs::weakly_canonical(file, error);
    return error ? file : target;
}

PartFile::PartFile(const fs::path& file) : target_(linkTarget(file)), part_(target_.string() + ".part")
{
    std::error_code none;
    fs::remove(part_, none);
}

PartFile::~PartFile()
{
    std::error_code none;
    if (!part_.empty()) fs::remove(part_, none);
}

void PartFile::show()
{
    struct stat old {};
    const bool replaces = ::stat(target_.c_str(), &old) == 0;
    if ((replaces && ::chmod(part_.c_str(), old.st_mode & 07777u) != 0) ||
        std::rename(part_.c_str(), target_.c_str()) != 0)
        throw std::system_error(errno, std::generic_category());
    part_.clear();
}

} // namespace touchdown
