// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/item_study.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <mutex>
#include <system_error>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/formats/words.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

constexpr double longestSilence = 0.03; // before the first item [s]
constexpr double betweenReports = 0.25; // while rows come, at least [s]
constexpr double reportShare = 0.1;     // of the time that reports of a growing list may take [-]
constexpr double longShare = 0.1;       // of the time of a thread, of an item that begins early
constexpr std::size_t mostNamed = 5;    // items in a sentence
constexpr std::size_t hashDigits = 16, folderDigits = 2;
constexpr const char* fileEnding = ".h5";

/// What is to be done, in the order in which it begins: long items first, so that none is left for the end, then
/// scattered, and last those whose work another one does.
struct ItemOrder {
    std::vector<std::size_t> items;
    std::vector<double> costs;
};

ItemOrder orderOf(const ItemStudy& study, const ItemOptions& options)
{
    std::vector<std::pair<std::size_t, double>> order;
    double all = 0.0;
    for (const std::size_t k : scatteredOrder(options.part.size(study.count))) {
        const std::size_t i = options.part.part - 1 + k * options.part.of;
        order.emplace_back(i, study.cost ? study.cost(i) : 1.0);
        all += order.back().second;
    }
    const double isLong = longShare * all / std::max(options.jobs, 1);
    if (study.cost)
        std::ranges::stable_sort(order, {}, [&](const auto& each) {
            return each.second > isLong ? -each.second : each.second > 0.0 ? 0.0 : 1.0;
        });
    ItemOrder result;
    for (const auto& [i, cost] : order) {
        result.items.push_back(i);
        result.costs.push_back(all > 0.0 ? cost : 1.0);
    }
    return result;
}

class Performance {
public:
    Performance(const ItemStudy& study, const ItemOptions& options, const StudyCallback& callback)
        : Performance(study, options, callback, orderOf(study, options))
    {}

    StudyReport perform()
    {
        if (!prepare()) {
            StudyReport report;
            takeKept();
            finish(report, false);
            return report;
        }
        const auto work = [&](std::size_t k, const GoOn& goOn) {
            const ShareTeller tellShare = work_.teller(k);
            takeOrSolve(
                order_[k], [&] { return goOn() && !halted_; }, tellShare);
            tellShare(1.0);
        };
        const bool whole =
            runParallel(order_.size(), options_.jobs, work, [&](std::size_t done) { return tell(done); }) && !halted_;
        StudyReport report = study_.report(rows_);
        finish(report, whole);
        return report;
    }

private:
    Performance(const ItemStudy& study, const ItemOptions& options, const StudyCallback& callback, ItemOrder order)
        : study_(study),
          options_(options),
          callback_(callback),
          order_(std::move(order.items)),
          work_(std::move(order.costs)),
          rows_(study.count),
          keys_(study.count),
          isKept_(study.count)
    {}

    bool prepare()
    {
        if (!study_.prepare) return true;
        double calledAt = 0.0;
        return study_.prepare([&] {
            const double now = wallClock();
            if (!callback_ || now - calledAt < longestSilence) return true;
            calledAt = now;
            return callback_({0.0, "what the report needs", nullptr});
        });
    }

    /// All that needs no solving, of a study that ends before its items begin.
    void takeKept()
    {
        for (const std::size_t i : order_)
            takeOrSolve(
                i, [] { return false; }, [](double) {});
    }

    /// The row of an earlier call.
    const ItemRow* keptRow(const std::string& key) const
    {
        if (options_.kept == nullptr) return nullptr;
        const auto found = options_.kept->find(key);
        if (found == options_.kept->end() || found->second.size() != study_.width) return nullptr;
        if (!study_.keepsFiles || options_.files.empty() || options_.onlyKept) return &found->second;
        const std::string file = fileOf(key);
        std::error_code error;
        const bool lost = std::ranges::find(found->second, StudyValue(file)) != found->second.end() &&
                          !std::filesystem::exists(options_.files / file, error);
        return lost ? nullptr : &found->second;
    }

    void takeOrSolve(std::size_t i, const GoOn& goOn, const ShareTeller& tellShare)
    {
        std::string key = itemKey(study_.content(i));
        {
            const std::lock_guard lock(mutex_);
            keys_[i] = key;
            const auto [place, isFirst] = firstOf_.emplace(keys_[i], i);
            if (!isFirst) {
                const std::size_t first = place->second;
                if (rows_[first])
                    set(i, *rows_[first], isKept_[first] != 0);
                else
                    waiting_[first].push_back(i);
                return;
            }
        }
        const ItemRow* kept = keptRow(key);
        std::optional<ItemRow> row;
        if (kept != nullptr) {
            row = *kept;
        } else if (!options_.onlyKept && goOn()) {
            ItemCall call{goOn, tellShare};
            if (study_.keepsFiles && !options_.files.empty()) call.file = options_.files / fileOf(key);
            row = study_.solve(i, call);
            if (!call.problem.empty()) return halt(call.problem);
        }
        const std::lock_guard lock(mutex_);
        if (row && kept == nullptr && options_.keep && problem_.empty()) {
            problem_ = options_.keep(key, *row);
            halted_ = !problem_.empty();
        }
        std::vector<std::size_t> alike{i};
        if (const auto waiting = waiting_.find(i); waiting != waiting_.end())
            alike.insert(alike.end(), waiting->second.begin(), waiting->second.end());
        for (const std::size_t each : alike)
            if (row)
                set(each, *row, kept != nullptr);
            else if (options_.onlyKept)
                missing_.push_back(each);
    }

    void set(std::size_t i, const ItemRow& row, bool isKept)
    {
        rows_[i] = row;
        isKept_[i] = isKept ? 1 : 0;
        taken_ += isKept ? 1 : 0;
        ++ready_;
    }

    void halt(const std::string& problem)
    {
        const std::lock_guard lock(mutex_);
        if (problem_.empty()) problem_ = problem;
        halted_ = true;
    }

    bool tell(std::size_t done)
    {
        if (halted_) return false;
        if (!callback_) return true;
        const std::size_t count = order_.size();
        const double share = work_.share(), now = wallClock();
        const std::string doing = std::to_string(std::min(done + 1, count)) + " of " + std::to_string(count);
        std::optional<ItemRows> seen;
        std::vector<std::string> keys;
        if (now >= nextReport_) {
            const std::lock_guard lock(mutex_);
            if (std::exchange(told_, ready_) < ready_) {
                seen = rows_;
                keys = keys_;
            }
        }
        if (!seen) return callback_({share, doing, nullptr});
        StudyReport soFar = study_.report(*seen);
        soFar.findings.clear();
        soFar.status = StudyStatus::Completed; // it may end well yet
        soFar.message.clear();
        addItems(soFar, std::move(keys), std::move(*seen));
        const bool goOn = callback_({share, doing, &soFar});
        const double took = wallClock() - now;
        nextReport_ = now + std::max(betweenReports, took / reportShare);
        return goOn;
    }

    std::string missingText()
    {
        std::ranges::sort(missing_);
        std::vector<std::string> names;
        for (std::size_t i = 0; i < std::min(missing_.size(), mostNamed); ++i)
            names.push_back(std::to_string(missing_[i] + 1));
        if (missing_.size() > mostNamed) names.emplace_back("others");
        return counted(missing_.size(), "item") + " of " + std::to_string(study_.count) +
               " have no row in these files: " + joined(names);
    }

    /// The rows that are there; behind them kept rows that this list has no use for, or has not reached.
    void addItems(StudyReport& report, std::vector<std::string> keys, ItemRows rows) const
    {
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i]) report.items.push_back({std::move(keys[i]), std::move(*rows[i])});
        if (options_.kept == nullptr || options_.onlyKept || !options_.addsUnused) return;
        std::unordered_set<std::string> used;
        for (const StudyItem& item : report.items) used.insert(item.key);
        std::vector<std::string> others;
        for (const auto& [key, row] : *options_.kept)
            if (!used.contains(key)) others.push_back(key);
        std::ranges::sort(others);
        for (const std::string& key : others) {
            const ItemRow& row = options_.kept->at(key);
            report.items.push_back({key, row});
        }
    }

    void finish(StudyReport& report, bool whole)
    {
        addItems(report, std::move(keys_), std::move(rows_));
        const std::size_t ready = ready_;
        if (options_.taken != nullptr) *options_.taken = taken_;
        if (!problem_.empty()) {
            report.status = StudyStatus::Failed;
            report.message = problem_;
        } else if (!missing_.empty()) {
            report.status = StudyStatus::Failed;
            report.message = missingText();
        } else if (!whole) {
            report.status = StudyStatus::Cancelled;
            report.message = "stopped after " + std::to_string(ready) + " of " + counted(order_.size(), "item");
        }
        if (report.status != StudyStatus::Completed || !options_.part.isWhole()) report.findings.clear();
        if (!options_.part.isWhole() && report.status == StudyStatus::Completed)
            report.warnings.insert(report.warnings.begin(),
                                   "This is part " + std::to_string(options_.part.part) + " of " +
                                       std::to_string(options_.part.of) + ": " + std::to_string(ready) + " of " +
                                       counted(study_.count, "item") + ". Join all parts for the findings.");
    }

    const ItemStudy& study_;
    const ItemOptions& options_;
    const StudyCallback& callback_;
    std::vector<std::size_t> order_; // of the items of the part
    WorkDone work_;                  // in this order
    std::mutex mutex_;               // of all before halted_
    ItemRows rows_;
    std::vector<std::string> keys_;
    std::vector<char> isKept_;
    std::unordered_map<std::string_view, std::size_t> firstOf_;         // by key: the item that is solved for all alike
    std::unordered_map<std::size_t, std::vector<std::size_t>> waiting_; // by that item: the others
    std::vector<std::size_t> missing_;
    std::size_t ready_ = 0, taken_ = 0;
    std::string problem_; // why a row or a file could not be kept
    std::atomic<bool> halted_ = false;
    std::size_t told_ = 0; // rows of the last report
    double nextReport_ = 0.0;
};

} // namespace

std::string hashText(std::string_view text, std::uint64_t start)
{
    for (const char c : text) start = (start ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(start));
    return digits.data();
}

std::string itemKey(const std::string& content)
{
    constexpr std::uint64_t other = 0x84222325cbf29ce4ULL;
    const std::string all = TOUCHDOWN_VERSION "\n" + content;
    return hashText(all) + hashText(all, other);
}

double numberAt(const ItemRow& row, std::size_t i)
{
    const auto* value = std::get_if<double>(&row[i]);
    return value == nullptr ? std::numeric_limits<double>::quiet_NaN() : *value;
}

std::string textAt(const ItemRow& row, std::size_t i)
{
    const auto* text = std::get_if<std::string>(&row[i]);
    return text == nullptr ? std::string() : *text;
}

bool isWhole(const ItemRows& rows) { return std::ranges::all_of(rows, &std::optional<ItemRow>::has_value); }

std::string fileOf(const std::string& key) { return key.substr(0, folderDigits) + "/" + key + fileEnding; }

bool isItemFile(std::string_view text)
{
    const std::size_t slash = text.find('/');
    if (slash != folderDigits || !text.ends_with(fileEnding)) return false;
    const std::string_view key = text.substr(slash + 1, text.size() - slash - 1 - std::string_view(fileEnding).size());
    constexpr std::string_view digits = "0123456789abcdef";
    return key.size() == 2 * hashDigits && key.find_first_not_of(digits) == std::string_view::npos &&
           key.starts_with(text.substr(0, slash));
}

StudyReport performItems(const ItemStudy& study, const ItemOptions& options, const StudyCallback& callback)
{
    struct End {
        const ItemStudy& study;
        ~End()
        {
            if (study.end) study.end();
        }
    } const end{study};
    return Performance(study, options, callback).perform();
}

} // namespace touchdown
