// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/item_journal.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <variant>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/formats/decimal.h"
#include "core/formats/text_file.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

constexpr std::string_view heading = "touchdown-items 1";
constexpr std::uintmax_t largestJournal = std::uintmax_t{1} << 31; // [byte]

std::string valueText(const StudyValue& value)
{
    if (const double* number = std::get_if<double>(&value)) return std::isfinite(*number) ? decimalText(*number) : "";
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) return {};
    std::string escaped = "\"";
    for (const char c : *text)
        escaped += c == '\n' ? "\\n" : c == '\t' ? "\\t" : c == '\\' ? "\\\\" : std::string(1, c);
    return escaped;
}

std::optional<StudyValue> readValue(std::string_view text)
{
    if (text.empty()) return StudyValue();
    if (text.front() != '"') {
        double number = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool whole = error == std::errc() && end == text.data() + text.size();
        return whole && std::isfinite(number) ? std::optional<StudyValue>(number) : std::nullopt;
    }
    std::string plain;
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] != '\\') {
            plain += text[i];
            continue;
        }
        if (++i == text.size()) return {};
        plain += text[i] == 'n' ? '\n' : text[i] == 't' ? '\t' : text[i];
    }
    return StudyValue(std::move(plain));
}

/// The row of a line, with its key.
void readLine(std::string_view line, KeptRows& kept)
{
    const std::size_t last = line.rfind('\t'), first = line.find('\t');
    if (last == std::string_view::npos || first == last || hashText(line.substr(0, last)) != line.substr(last + 1))
        return;
    if (auto row = readRow(line.substr(first + 1, last - first - 1)))
        kept.emplace(std::string(line.substr(0, first)), std::move(*row));
}

std::string reasonNow() { return std::generic_category().message(errno); }

} // namespace

std::string rowText(const ItemRow& row)
{
    std::string text;
    for (std::size_t i = 0; i < row.size(); ++i) text += (i == 0 ? "" : "\t") + valueText(row[i]);
    return text;
}

std::optional<ItemRow> readRow(std::string_view text)
{
    ItemRow row;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\t', begin), text.size());
        auto value = readValue(text.substr(begin, end - begin));
        if (!value) return {};
        row.push_back(std::move(*value));
        begin = end + 1;
    }
    return row;
}

ItemJournal::~ItemJournal() { close(); }

std::filesystem::path ItemJournal::besides(const std::filesystem::path& studyFile)
{
    return std::filesystem::path(studyFile.string() + ".items");
}

std::string ItemJournal::open(const std::filesystem::path& studyFile, bool goOn, KeptRows& kept)
{
    close();
    file_ = besides(studyFile);
    std::error_code error;
    std::string before;
    if (std::filesystem::exists(std::filesystem::symlink_status(file_, error))) {
        auto content = readTextFile(file_, largestJournal);
        if (const auto* problem = std::get_if<FileProblem>(&content))
            return "cannot read " + file_.string() + ": " + problem->message;
        before = std::move(std::get<std::string>(content));
        const std::string_view first = std::string_view(before).substr(0, before.find('\n'));
        const bool begun = before.find('\n') == std::string::npos && heading.starts_with(first);
        if (first != heading && !begun) return file_.string() + " is in the way: it does not hold rows of a study";
    }
    KeptRows rows;
    for (std::size_t begin = 0; begin < before.size();) {
        const std::size_t end = std::min(before.find('\n', begin), before.size());
        readLine(std::string_view(before).substr(begin, end - begin), rows);
        begin = end + 1;
    }
    if (!goOn && !rows.empty())
        return file_.string() + " holds " + counted(rows.size(), "row") +
               " of a study that was interrupted; go on with --resume, or remove that file";
    kept.merge(rows);
    descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor_ < 0) return "cannot write to " + file_.string() + ": " + reasonNow();
    if (before.find('\n') == std::string::npos) { // new, or its program was killed at its first line
        if (::ftruncate(descriptor_, 0) != 0) return "cannot write to " + file_.string() + ": " + reasonNow();
        return append(std::string(heading));
    }
    return before.ends_with('\n') ? std::string() : append(""); // ends a line that was cut short
}

std::string ItemJournal::keep(const std::string& key, const ItemRow& row)
{
    if (descriptor_ < 0) return "no file of a study's rows is open";
    std::string line = key + '\t' + rowText(row);
    return append(line + '\t' + hashText(line));
}

std::string ItemJournal::append(std::string line)
{
    line += '\n';
    struct stat before {};
    const bool known = fstat(descriptor_, &before) == 0;
    std::size_t done = 0;
    while (done < line.size()) {
        const ssize_t count = ::write(descriptor_, line.data() + done, line.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count > 0) {
            done += static_cast<std::size_t>(count);
            continue;
        }
        std::string problem = "cannot write to " + file_.string() + ": " + reasonNow();
        // A part of a line is passed over, so that it does no harm where it stays.
        if (known && done > 0 && ftruncate(descriptor_, before.st_size) != 0) problem += "; its last line is cut short";
        return problem;
    }
    return {};
}

void ItemJournal::remove()
{
    close();
    std::error_code error;
    if (!file_.empty()) std::filesystem::remove(file_, error);
    file_.clear();
}

void ItemJournal::close()
{
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
}

} // namespace touchdown
