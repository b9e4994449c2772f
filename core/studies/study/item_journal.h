// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of a list study as they come, in a text file beside that of the study: FILE.h5.items. A row is in the file
// as soon as its item is solved, so that nothing is solved twice after the program was killed. A line that was cut
// short or damaged is passed over.
//
//   touchdown-items 1
//   KEY <tab> VALUE <tab> ... <tab> CHECK
//
// A value is a number with all its digits, a text after a quotation mark, with \n, \t, \\ in it, or nothing: not known.
// CHECK is FNV-1a of what stands before it, 16 hexadecimal digits.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/studies/study/item_study.h"

namespace touchdown {

/// The row as one line of text without KEY and CHECK, and back; nothing for a text that is no row.
std::string rowText(const ItemRow& row);
std::optional<ItemRow> readRow(std::string_view text);

class ItemJournal {
public:
    ItemJournal() = default;
    ~ItemJournal();
    ItemJournal(const ItemJournal&) = delete;
    ItemJournal& operator=(const ItemJournal&) = delete;

    /// Where the rows of a study stand while its file is under way.
    static std::filesystem::path besides(const std::filesystem::path& studyFile);

    /// The caller has locked the study's file. With `goOn` the rows that are there are added to `kept`; else rows that
    /// are there are refused, so that nobody's work is lost. Returns "" or the problem in one sentence.
    std::string open(const std::filesystem::path& studyFile, bool goOn, KeptRows& kept);
    /// "" or the problem; then the file holds what it held before.
    std::string keep(const std::string& key, const ItemRow& row);
    /// Once the study's file holds all rows.
    void remove();

private:
    std::string append(std::string line);
    void close();

    std::filesystem::path file_;
    int descriptor_ = -1;
};

} // namespace touchdown
