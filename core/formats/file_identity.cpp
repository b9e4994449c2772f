// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/file_identity.h"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <fstream>

#include <sys/stat.h>

#include "core/formats/text_file.h"

namespace touchdown {

namespace {

constexpr std::uint64_t largestHashed = std::uint64_t(1) << 30; // [byte]
constexpr std::uint64_t smallFile = std::uint64_t(1) << 22;     // [byte]

/// Words of eight bytes, each mixed with all before it (Vigna's finaliser splitmix64, in part). Any change of one word
/// changes the hash.
class ByteHash {
public:
    /// All blocks but the last have a multiple of eight bytes.
    void add(std::string_view block)
    {
        for (; block.size() >= sizeof(std::uint64_t); block.remove_prefix(sizeof(std::uint64_t))) addWord(block);
        if (!block.empty()) addWord(block);
    }
    std::uint64_t value() const { return value_; }

private:
    void addWord(std::string_view bytes)
    {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data(), std::min(bytes.size(), sizeof word));
        value_ = (value_ ^ word) * 0xbf58476d1ce4e5b9U;
        value_ ^= value_ >> 32;
    }
    std::uint64_t value_ = 0x9e3779b97f4a7c15U;
};

std::optional<std::uint64_t> hashOf(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::array<char, 1 << 16> block{};
    ByteHash hash;
    while (in) {
        in.read(block.data(), block.size());
        hash.add({block.data(), static_cast<std::size_t>(in.gcount())});
    }
    return in.eof() ? std::optional(hash.value()) : std::nullopt;
}

FileNow nothingToRead(const std::filesystem::path& file)
{
    std::error_code error;
    return std::filesystem::status(file, error).type() == std::filesystem::file_type::not_found ? FileNow::Gone
                                                                                                : FileNow::Unreadable;
}

} // namespace

std::string FileIdentity::text() const
{
    std::array<char, 128> line{};
    std::snprintf(line.data(), line.size(), "%" PRIx64 ":%" PRIx64 ":%" PRIx64 ":%" PRIx64 ":%" PRIx64, device, inode,
                  size, static_cast<std::uint64_t>(changed), hash);
    return line.data();
}

std::optional<FileIdentity> identityFromText(std::string_view text)
{
    FileIdentity identity;
    std::uint64_t changed = 0;
    if (std::sscanf(std::string(text).c_str(), "%" SCNx64 ":%" SCNx64 ":%" SCNx64 ":%" SCNx64 ":%" SCNx64,
                    &identity.device, &identity.inode, &identity.size, &changed, &identity.hash) != 5)
        return std::nullopt;
    identity.changed = static_cast<std::int64_t>(changed);
    return identity.text() == text ? std::optional(identity) : std::nullopt;
}

std::optional<FileIdentity> marksOf(const std::filesystem::path& file)
{
    struct stat status {};
    if (!notRegularFile(file).empty() || ::stat(file.c_str(), &status) != 0) return std::nullopt;
    FileIdentity marks;
    marks.device = status.st_dev;
    marks.inode = status.st_ino;
    marks.size = static_cast<std::uint64_t>(status.st_size);
    marks.changed = std::int64_t{status.st_ctim.tv_sec} * 1'000'000'000 + status.st_ctim.tv_nsec;
    return marks;
}

std::optional<FileIdentity> identityOf(const std::filesystem::path& file)
{
    std::optional<FileIdentity> identity = marksOf(file);
    if (!identity || identity->size > largestHashed) return identity;
    const std::optional<std::uint64_t> hash = hashOf(file);
    if (!hash) return std::nullopt;
    identity->hash = *hash;
    return identity;
}

FileIdentity identityOfBytes(std::string_view bytes)
{
    ByteHash hash;
    hash.add(bytes);
    FileIdentity identity;
    identity.size = bytes.size();
    identity.hash = hash.value();
    return identity;
}

FileNow fileNow(const std::filesystem::path& file, const FileIdentity& read)
{
    std::optional<FileIdentity> now = marksOf(file);
    if (!now) return nothingToRead(file);
    now->hash = read.hash;
    // Two changes within a few milliseconds have the same time.
    if (*now == read && read.size > smallFile) return FileNow::Same;
    if (now->size != read.size || read.size > largestHashed) return FileNow::Other;
    const std::optional<std::uint64_t> hash = hashOf(file);
    if (!hash) return FileNow::Unreadable;
    return *hash == read.hash ? FileNow::Same : FileNow::Other;
}

} // namespace touchdown
