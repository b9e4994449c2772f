// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/item_study.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <mutex>
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
        result.costs.push_back(cost);
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
          keys_(study.count)
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

    void takeOrSolve(std::size_t i, const GoOn& goOn, const ShareTeller& tellShare)
    {
        std::string key = itemKey(study_.content(i));
        std::optional<ItemRow> row;
        bool isNew = false;
        if (options_.kept != nullptr)
            if (const auto found = options_.kept->find(key);
                found != options_.kept->end() && found->second.size() == study_.width)
                row = found->second;
        if (!row && !options_.onlyKept && goOn()) {
            ItemCall call{goOn, tellShare};
            if (study_.keepsFiles && !options_.files.empty()) call.file = options_.files / (key + ".h5");
            row = study_.solve(i, call);
            if (!call.problem.empty()) return halt(call.problem);
            isNew = row.has_value();
        }
        const std::lock_guard lock(mutex_);
        if (!row) {
            if (options_.onlyKept) missing_.push_back(i);
            return;
        }
        if (isNew && options_.keep && problem_.empty()) {
            problem_ = options_.keep(key, *row);
            halted_ = !problem_.empty();
        }
        if (!isNew) ++taken_;
        keys_[i] = std::move(key);
        rows_[i] = std::move(row);
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
        if (options_.kept == nullptr || options_.onlyKept) return;
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
            report.message = "stopped after " + std::to_string(ready) + " of " + counted(study_.count, "item");
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
    std::mutex mutex_;               // of the next five
    ItemRows rows_;
    std::vector<std::string> keys_;
    std::vector<std::size_t> missing_;
    std::size_t ready_ = 0, taken_ = 0;
    std::string problem_; // why a row could not be kept
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

StudyReport performItems(const ItemStudy& study, const ItemOptions& options, const StudyCallback& callback)
{
    return Performance(study, options, callback).perform();
}

} // namespace touchdown
