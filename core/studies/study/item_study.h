// SPDX-License-Identifier: GPL-3.0-or-later
//
// A study that is a list of items: each gives a row of numbers and texts, on which the report alone depends. So the
// items may be solved in any order, on any number of threads, in parts on several computers, and rows that are there
// already are taken as they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "core/studies/study/study.h"
#include "core/work/parallel.h"
#include "core/work/work_done.h"

namespace touchdown {

/// What came of one item; its numbers are finite.
using ItemRow = std::vector<StudyValue>;
/// By the number of the item, from 0; nothing where it is not there yet.
using ItemRows = std::vector<std::optional<ItemRow>>;
/// Rows by the keys of their items.
using KeptRows = std::unordered_map<std::string, ItemRow>;

/// A number of a row, NaN where it is not known; a text, "" where there is none.
double numberAt(const ItemRow& row, std::size_t i);
std::string textAt(const ItemRow& row, std::size_t i);
/// Whether all are there.
bool isWhole(const ItemRows& rows);

/// What an item is told when it is solved, and what it may say.
struct ItemCall {
    const GoOn& goOn;
    const ShareTeller& tell;      // its share that is done
    std::filesystem::path file{}; // for its whole results; empty: they are not kept
    bool wrote = false;           // set by the item: the file is there
    std::string problem{};        // set by the item: why it could not be written, which ends the study
};

struct ItemStudy {
    std::size_t count = 0;
    std::size_t width = 0; // of each row
    /// All on which the row of an item depends: its case, how it is solved, what is read off. Any text.
    std::function<std::string(std::size_t)> content;
    /// Called on several threads; nothing where it was told to end. Failures of numerics are part of the row.
    std::function<std::optional<ItemRow>(std::size_t, ItemCall& call)> solve;
    /// Of the rows that are there; findings only where all are.
    std::function<StudyReport(const ItemRows&)> report;
    /// The case of an item, which is a row of the first table; not set where rows are no cases.
    std::function<Case(std::size_t)> caseOf{};
    /// The expected time of an item relative to others, 0 where another one has done its work; not set: all alike.
    std::function<double(std::size_t)> cost{};
    /// Makes what the report needs beside the rows, before it is asked for; false where it was told to end.
    std::function<bool(const GoOn& goOn)> prepare{};
    /// Lets go of what was made for its items, when a call of performItems ends.
    std::function<void()> end{};
    bool keepsFiles = false; // whole results of its items; a row that names its file counts only with that
};

/// A study that is ready: a list, or something else that can be performed.
using StudyWork = std::variant<StudyPerformance, ItemStudy>;

/// Items `part`, `part` + `of`, `part` + 2 `of`, ... of a list, counted from 1.
struct ItemPart {
    std::size_t part = 1, of = 1;
    bool isWhole() const { return of == 1; }
    /// How many of `count` items it has.
    std::size_t size(std::size_t count) const { return (count + of - part) / of; }
};

struct ItemOptions {
    int jobs = 1; // threads
    ItemPart part{};
    /// Where whole results go, of a study that keeps them: a file for each item, named by fileOf().
    std::filesystem::path files{};
    const KeptRows* kept = nullptr; // rows of an earlier call, of this study or of another one
    bool addsUnused = true;         // rows that this study has no use for stay in its report
    bool onlyKept = false;          // nothing is solved: an item without a row makes the study fail
    std::size_t* taken = nullptr;   // receives how many rows were there already
    /// Receives each row that was solved as soon as it is there, from any thread, one at a time. Returns "", or why it
    /// could not be kept, which ends the study.
    std::function<std::string(const std::string& key, const ItemRow& row)> keep{};
};

/// FNV-1a of 64 bits (Fowler, Noll & Vo 1991), 16 hexadecimal digits: tells damage, not a forger.
std::string hashText(std::string_view text, std::uint64_t start = 0xcbf29ce484222325ULL);

/// The key of a row: the same only for the same content and the same version of this program. 32 hexadecimal digits.
std::string itemKey(const std::string& content);

/// The file of whole results of an item, in one of 256 folders: "3f/3f81....h5".
std::string fileOf(const std::string& key);
bool isItemFile(std::string_view text);

/// Solves the items that have no row yet; items of one key are solved once. The report has their rows as `items`, which
/// a file of the study keeps; behind them all other kept rows, so that none is lost.
StudyReport performItems(const ItemStudy& study, const ItemOptions& options, const StudyCallback& callback);

} // namespace touchdown
