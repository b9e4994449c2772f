// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <variant>

#include "core/case_files/case_text.h"
#include "core/formats/text_file.h"
#include "core/studies/sweep/sweep_report.h"

namespace touchdown {

namespace {

/// What the files of measured surfaces held when they were asked for first.
class SurfaceFiles {
public:
    std::string contentOf(const Case& c)
    {
        if (c.diskSurface.file.empty()) return {};
        constexpr std::uintmax_t largest = std::uintmax_t{1} << 32; // [byte]
        const std::string file = (c.folder / c.diskSurface.file).string();
        const std::lock_guard lock(mutex_);
        const auto [place, isNew] = keys_.emplace(file, "");
        if (isNew) {
            const auto content = readTextFile(file, largest, FileContent::Any);
            const auto* text = std::get_if<std::string>(&content);
            place->second = text == nullptr ? file : itemKey(*text);
        }
        return place->second;
    }

private:
    std::mutex mutex_;
    std::map<std::string, std::string> keys_; // by file
};

std::string contentOf(const SweepTask& task, std::size_t item, SurfaceFiles& files)
{
    const Case c = task.caseOf(item);
    std::string text = "sweep " + std::string(name(task.calculate));
    for (const Reading& reading : task.readings) text += " " + reading.column().name;
    return text + "\n" + formatCase(c) + files.contentOf(c);
}

std::optional<ItemRow> solve(const SweepTask& task, std::size_t item, const GoOn& goOn)
{
    auto found = readCase(task.caseOf(item), task.calculate, task.readings, goOn);
    if (!found) return {};
    ItemRow row = std::move(found->values);
    row.emplace_back(std::move(found->problem));
    return row;
}

} // namespace

StudyWork planSweep(StudyReader& reader)
{
    const auto task = std::make_shared<const SweepTask>(readSweep(reader));
    const auto files = std::make_shared<SurfaceFiles>();
    const bool averages = std::ranges::any_of(task->axes, &SweepAxis::average);
    return ItemStudy{
        .count = task->count(),
        .width = task->readings.size() + 1,
        .content = [task, files](std::size_t item) { return contentOf(*task, item, *files); },
        .solve = [task](std::size_t item, const GoOn& goOn) { return solve(*task, item, goOn); },
        .report = [task](const ItemRows& rows) { return sweepReport(*task, rows); },
        .caseOf =
            averages ? std::function<Case(std::size_t)>() : [task](std::size_t item) { return task->caseOf(item); },
    };
}

} // namespace touchdown
