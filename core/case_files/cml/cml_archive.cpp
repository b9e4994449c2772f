// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_archive.h"

#include <zip.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>

#include "core/formats/cml_text.h"
#include "core/formats/quotation.h"

namespace touchdown {

namespace {

constexpr zip_int64_t mostEntries = 10000;

using Source = std::unique_ptr<zip_source_t, void (*)(zip_source_t*)>;
using Archive = std::unique_ptr<zip_t, void (*)(zip_t*)>; // closes without writing
using Member = std::unique_ptr<zip_file_t, int (*)(zip_file_t*)>;

class Error {
public:
    Error() { zip_error_init(&error_); }
    ~Error() { zip_error_fini(&error_); }
    Error(const Error&) = delete;
    Error& operator=(const Error&) = delete;
    zip_error_t* get() { return &error_; }
    std::string text() { return zip_error_strerror(&error_); }

private:
    zip_error_t error_{};
};

/// The name behind the last slash or backslash, in lower case.
std::string baseName(std::string_view name)
{
    std::string base(name.substr(name.find_last_of("/\\") + 1));
    std::ranges::transform(base, base.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return base;
}

std::string_view folderOf(std::string_view name)
{
    const auto slash = name.find_last_of("/\\");
    return slash == std::string_view::npos ? std::string_view() : name.substr(0, slash);
}

/// A name that would lead out of the folder into which an archive is unpacked.
bool leadsOutside(std::string_view name)
{
    if (name.find(':') != std::string_view::npos || name.starts_with('/') || name.starts_with('\\')) return true;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find_first_of("/\\", begin), name.size());
        if (name.substr(begin, end - begin) == "..") return true;
        begin = end + 1;
    }
    return false;
}

struct Entry {
    zip_uint64_t index = 0;
    std::string name; // as in the archive
};

std::variant<std::string, FileProblem> readMember(zip_t* archive, const Entry& entry)
{
    const auto problem = [&](const std::string& message) { return FileProblem{inQuotes(entry.name) + " " + message}; };
    const std::string tooLarge = "is larger than " + std::to_string(maximumCmlFileSize >> 20) + " MiB";
    zip_stat_t status;
    if (zip_stat_index(archive, entry.index, 0, &status) != 0) return problem("cannot be read");
    if ((status.valid & ZIP_STAT_SIZE) != 0 && status.size > maximumCmlFileSize) return problem(tooLarge);
    if ((status.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && status.encryption_method != ZIP_EM_NONE)
        return problem("is encrypted");
    const Member member(zip_fopen_index(archive, entry.index, 0), zip_fclose);
    if (!member) return problem(std::string("cannot be read: ") + zip_strerror(archive));
    std::string text;
    std::array<char, 1 << 16> block{};
    while (true) {
        const zip_int64_t count = zip_fread(member.get(), block.data(), block.size());
        if (count < 0) return problem(std::string("cannot be read: ") + zip_file_strerror(member.get()));
        if (count == 0) return text;
        text.append(block.data(), static_cast<std::size_t>(count));
        if (text.size() > maximumCmlFileSize) return problem(tooLarge); // whatever size it states
    }
}

/// The text files of the folder of the rail.dat that lies highest.
std::variant<std::vector<Entry>, FileProblem> chooseEntries(zip_t* archive, std::vector<std::string>& warnings)
{
    std::vector<Entry> known;
    for (zip_int64_t i = 0; i < zip_get_num_entries(archive, 0); ++i) {
        const auto index = static_cast<zip_uint64_t>(i);
        const char* const name = zip_get_name(archive, index, ZIP_FL_ENC_RAW);
        if (name == nullptr || !isCmlMember(baseName(name))) continue;
        if (leadsOutside(name))
            warnings.push_back(inQuotes(name) + " names a place outside the archive, and is not read");
        else
            known.push_back({index, name});
    }
    const auto depth = [](const Entry& entry) {
        return std::ranges::count_if(entry.name, [](char c) { return c == '/' || c == '\\'; });
    };
    const Entry* rail = nullptr;
    const Entry* other = nullptr; // at the same depth
    for (const Entry& entry : known) {
        if (baseName(entry.name) != "rail.dat") continue;
        if (rail == nullptr || depth(entry) < depth(*rail)) {
            rail = &entry;
            other = nullptr;
        } else if (depth(entry) == depth(*rail)) {
            other = &entry;
        }
    }
    if (rail == nullptr) return FileProblem{"holds no rail.dat"};
    if (other != nullptr)
        return FileProblem{"holds both " + inQuotes(rail->name) + " and " + inQuotes(other->name) +
                           "; which one is meant is not clear"};
    const std::string folder(folderOf(rail->name));
    std::erase_if(known, [&](const Entry& entry) { return folderOf(entry.name) != folder; });
    return known;
}

} // namespace

bool isCmlMember(std::string_view name) { return name == "rail.dat" || name == "run.dat" || name == "dynamics.def"; }

std::variant<CmlArchive, FileProblem> readCmlArchive(std::string_view bytes)
{
    if (bytes.empty()) return FileProblem{"is empty"};
    if (!bytes.starts_with("PK"))
        return FileProblem{
            "is not an archive of version 7 or 8; the binary files of earlier versions are not read, but the "
            "established program can save them anew"};
    Error error;
    Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, error.get()), zip_source_free);
    if (!source) return FileProblem{"cannot be read: " + error.text()};
    const Archive archive(zip_open_from_source(source.get(), ZIP_RDONLY | ZIP_CHECKCONS, error.get()), zip_discard);
    if (!archive) return FileProblem{"is a damaged archive: " + error.text()};
    (void)source.release(); // the archive owns it
    if (zip_get_num_entries(archive.get(), 0) > mostEntries)
        return FileProblem{"holds more than " + std::to_string(mostEntries) + " files"};

    CmlArchive result;
    auto entries = chooseEntries(archive.get(), result.warnings);
    if (auto* problem = std::get_if<FileProblem>(&entries)) return std::move(*problem);
    for (const Entry& entry : std::get<std::vector<Entry>>(entries)) {
        const bool twice =
            std::ranges::find(result.members, baseName(entry.name), &CmlMember::name) != result.members.end();
        if (twice) return FileProblem{"holds " + inQuotes(baseName(entry.name)) + " twice"};
        auto text = readMember(archive.get(), entry);
        if (auto* problem = std::get_if<FileProblem>(&text)) return std::move(*problem);
        result.members.push_back({baseName(entry.name), std::move(std::get<std::string>(text))});
    }
    return result;
}

std::variant<std::string, FileProblem> formatCmlArchive(const std::vector<CmlMember>& members)
{
    Error error;
    const auto refuse = [](const std::string& why) { return FileProblem{"cannot be written: " + why}; };
    const Source source(zip_source_buffer_create(nullptr, 0, 0, error.get()), zip_source_free);
    if (!source) return refuse(error.text());
    Archive archive(zip_open_from_source(source.get(), ZIP_TRUNCATE, error.get()), zip_discard);
    if (!archive) return refuse(error.text());
    zip_source_keep(source.get()); // one for the archive, one for reading what it has written
    for (const CmlMember& member : members) {
        Source text(zip_source_buffer(archive.get(), member.text.data(), member.text.size(), 0), zip_source_free);
        if (!text || zip_file_add(archive.get(), member.name.c_str(), text.get(), ZIP_FL_ENC_UTF_8) < 0)
            return refuse(zip_strerror(archive.get()));
        (void)text.release();
    }
    if (zip_close(archive.get()) != 0) return refuse(zip_strerror(archive.get()));
    (void)archive.release();

    zip_stat_t status;
    if (zip_source_open(source.get()) != 0 || zip_source_stat(source.get(), &status) != 0)
        return refuse(zip_error_strerror(zip_source_error(source.get())));
    std::string bytes(static_cast<std::size_t>(status.size), '\0');
    const zip_int64_t count = zip_source_read(source.get(), bytes.data(), bytes.size());
    zip_source_close(source.get());
    if (count != static_cast<zip_int64_t>(bytes.size())) return refuse("the archive came out short");
    return bytes;
}

} // namespace touchdown
