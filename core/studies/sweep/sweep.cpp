// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep.h"

#include <algorithm>
#include <utility>

#include "core/studies/runs/case_content.h"
#include "core/studies/sweep/sweep_report.h"

namespace touchdown {

namespace {

std::string contentOf(const SweepTask& task, std::size_t item, CaseContent& cases)
{
    std::string text = "sweep " + std::string(name(task.calculate)) + (task.keepsRuns ? " kept" : "");
    for (const Reading& reading : task.readings) text += " " + reading.column().name;
    return text + "\n" + cases.of(task.caseOf(item));
}

std::optional<ItemRow> solve(const SweepTask& task, std::size_t item, ItemCall& call)
{
    auto found = readCase(task.caseOf(item), task.calculate, task.readings, call);
    if (!found) return {};
    ItemRow row = std::move(found->values);
    if (task.keepsRuns)
        row.emplace_back(call.wrote ? (call.file.parent_path().filename() / call.file.filename()).string() : "");
    row.emplace_back(std::move(found->problem));
    return row;
}

} // namespace

ItemStudy sweepItems(const std::shared_ptr<const SweepTask>& task)
{
    const auto cases = std::make_shared<CaseContent>();
    const bool averages = std::ranges::any_of(task->axes, &SweepAxis::average);
    return {
        .count = task->count(),
        .width = task->readings.size() + (task->keepsRuns ? 2 : 1),
        .content = [task, cases](std::size_t item) { return contentOf(*task, item, *cases); },
        .solve = [task](std::size_t item, ItemCall& call) { return solve(*task, item, call); },
        .report = [task](const ItemRows& rows) { return sweepReport(*task, rows); },
        .caseOf =
            averages ? std::function<Case(std::size_t)>() : [task](std::size_t item) { return task->caseOf(item); },
        .end = [cases] { cases->forget(); },
        .keepsFiles = task->keepsRuns,
    };
}

StudyWork planSweep(StudyReader& reader) { return sweepItems(std::make_shared<const SweepTask>(readSweep(reader))); }

} // namespace touchdown
