// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/stability_map.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <utility>

#include "core/formats/decimal.h"
#include "core/studies/runs/case_content.h"
#include "core/studies/runs/expected_cost.h"
#include "core/studies/runs/shared_runs.h"
#include "core/studies/runs/trajectory_error.h"

namespace touchdown {

namespace {

constexpr double mostSamples = 20000; // of a run
constexpr double tenth = 0.1;         // of a setting, which the paper's criterion compares
constexpr std::size_t width = 8;      // of a row

/// With no more samples than a trajectory needs to be told from another.
Case lean(Case c)
{
    c.run.sampleInterval = std::max(c.run.sampleInterval, c.run.duration / mostSamples);
    return c;
}

/// A number that stands for one of `count` kinds; the last of them for any other number.
template <class Kind>
Kind kindAt(const ItemRow& row, std::size_t i, Kind last)
{
    const double value = numberAt(row, i);
    return value >= 0.0 && value < double(last) ? static_cast<Kind>(static_cast<int>(value)) : last;
}

ItemRow rowOf(const ProvenReference& reference)
{
    return {reference.label,
            reference.other,
            ifFinite(reference.apart),
            known(reference.horizon),
            double(reference.endKnown),
            knowledgeOf(reference),
            {},
            {}};
}
void take(const ItemRow& row, StabilityReference& reference)
{
    reference = {.done = true,
                 .label = textAt(row, 0),
                 .other = textAt(row, 1),
                 .knowledge = textAt(row, 5),
                 .apart = numberAt(row, 2),
                 .horizon = std::isfinite(numberAt(row, 3)) ? std::optional(numberAt(row, 3)) : std::nullopt,
                 .endKnown = numberAt(row, 4) > 0.0};
}

ItemRow rowOf(const RunVerdict& verdict, const MeasuredRun& run)
{
    return {double(verdict.kind),
            ifFinite(verdict.apart),
            ifFinite(verdict.imbalance),
            std::string(name(run.end.kind)),
            double(run.summary.steps),
            double(run.summary.evaluations),
            double(run.summary.events.size()),
            verdict.sentence};
}
void take(const ItemRow& row, StabilityCell& cell)
{
    cell.done = true;
    cell.verdict = {kindAt(row, 0, RunClass::Stopped), numberAt(row, 1), numberAt(row, 2), textAt(row, 7)};
    cell.end = textAt(row, 3);
    cell.steps = numberAt(row, 4);
    cell.evaluations = numberAt(row, 5);
    cell.switches = numberAt(row, 6);
}

class StabilityItems {
public:
    explicit StabilityItems(const std::shared_ptr<const StabilityTask>& task)
        : task_(task), references_(task->rows.size())
    {
        for (std::size_t row = 0; row < task->rows.size(); ++row)
            for (std::size_t method = 0; method < task->rows[row].methods.size(); ++method)
                for (std::size_t setting = 0; setting < task->rows[row].methods[method].settings.size(); ++setting)
                    cells_.push_back({row, method, setting});
        for (std::size_t i = 0; i < cells_.size(); ++i)
            if (const auto finer = finerThan(i)) pairs_.push_back({i, *finer});
    }

    std::size_t count() const { return references_.size() + cells_.size() + pairs_.size(); }

    /// Pairs compare runs that the cells have made.
    double cost(std::size_t item) const
    {
        if (item < references_.size()) {
            double sum = 0.0;
            for (const ReferenceCase& each : task_->rows[item].references) sum += expectedCost(each.c);
            return sum;
        }
        return isCell(item) ? expectedCost(caseOf(cells_[item - references_.size()])) : 0.0;
    }

    std::string content(std::size_t item)
    {
        const StabilityCell* cell = cellOf(item);
        std::string text =
            "stability " + decimalText(task_->rule.agreement) + " " + decimalText(task_->rule.energyDrift) + "\n";
        for (const ReferenceCase& each : task_->rows[cell == nullptr ? item : cell->row].references)
            text += contents_.of(each.c);
        if (cell != nullptr) text += "cell\n" + contents_.of(caseOf(*cell));
        if (cell != nullptr && !isCell(item)) text += "finer\n" + contents_.of(caseOf(cells_[pairOf(item).second]));
        return text;
    }

    std::optional<ItemRow> solve(std::size_t item, const GoOn& goOn, const ShareTeller& tell)
    {
        const StabilityCell* cell = cellOf(item);
        if (cell == nullptr) {
            const ProvenReference* reference = referenceOf(item, goOn, tell);
            return reference == nullptr ? std::nullopt : std::optional(rowOf(*reference));
        }
        std::vector<std::size_t> runs{runOf(caseOf(*cell))};
        if (!isCell(item)) runs.push_back(runOf(caseOf(cells_[pairOf(item).second])));
        if (!runs_.make(runs, goOn, tell)) return {};
        const ProvenReference* reference = referenceOf(cell->row, goOn, {});
        if (reference == nullptr) return {};
        const MeasuredRun& own = runs_.run(runs.front());
        if (isCell(item)) return rowOf(classify(caseOf(*cell), own, *reference, task_->rule), own);
        return criterionRow(own, runs_.run(runs.back()), *reference);
    }

    void forget()
    {
        runs_.forget();
        contents_.forget();
        for (RowReference& each : references_) {
            each.proven.reset();
            each.nudged.clear();
            each.endProven = false;
        }
    }

    StabilityMap mapOf(const ItemRows& rows) const
    {
        StabilityMap map;
        map.references.resize(references_.size());
        map.cells = cells_;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (!rows[i]) continue;
            const ItemRow& row = *rows[i];
            if (i < references_.size()) {
                take(row, map.references[i]);
            } else if (isCell(i)) {
                take(row, map.cells[i - references_.size()]);
            } else {
                const auto& [coarse, finer] = pairOf(i);
                const StabilityCell& cell = cells_[finer];
                map.cells[coarse].criterion = {task_->rows[cell.row].methods[cell.method].settings[cell.setting].label,
                                               numberAt(row, 0) > 0.0, numberAt(row, 1),
                                               kindAt(row, 2, CriterionVerdict::NotDetermined)};
            }
        }
        return map;
    }

private:
    /// The reference of a row, as far as it is known.
    struct RowReference {
        std::mutex mutex{};
        std::optional<ProvenReference> proven{};
        std::vector<std::size_t> nudged{}; // runs from starts that hardly differ
        bool endProven = false;
    };
    using Pair = std::pair<std::size_t, std::size_t>; // cells

    bool isCell(std::size_t item) const { return item - references_.size() < cells_.size(); }
    const Pair& pairOf(std::size_t item) const { return pairs_[item - references_.size() - cells_.size()]; }
    /// Of a pair, the one with the longer step; nullptr for a reference.
    const StabilityCell* cellOf(std::size_t item) const
    {
        if (item < references_.size()) return nullptr;
        return &cells_[isCell(item) ? item - references_.size() : pairOf(item).first];
    }
    const Case& caseOf(const StabilityCell& cell) const
    {
        return task_->rows[cell.row].methods[cell.method].settings[cell.setting].c;
    }
    std::size_t runOf(const Case& c) { return runs_.add(lean(c), std::string(spacingOf(c))); }

    /// The cell of the same row and method whose step is a tenth.
    std::optional<std::size_t> finerThan(std::size_t i) const
    {
        const StabilityCell& cell = cells_[i];
        const SweptMethod& method = task_->rows[cell.row].methods[cell.method];
        if (method.key != "run.step") return {};
        const double wanted = tenth * method.settings[cell.setting].value;
        for (std::size_t k = 0; k < method.settings.size(); ++k)
            if (std::abs(method.settings[k].value - wanted) <= 1e-6 * wanted) return i - cell.setting + k;
        return {};
    }

    std::vector<MeasuredRun> copiesOf(const std::vector<std::size_t>& runs) const
    {
        std::vector<MeasuredRun> copies;
        for (const std::size_t i : runs) copies.push_back(runs_.run(i));
        return copies;
    }

    /// nullptr where it was told to end.
    const ProvenReference* referenceOf(std::size_t row, const GoOn& goOn, const ShareTeller& tell)
    {
        const std::vector<ReferenceCase>& cases = task_->rows[row].references;
        RowReference& reference = references_[row];
        std::vector<std::size_t> runs;
        for (const ReferenceCase& each : cases) runs.push_back(runOf(each.c));
        if (!runs_.make(runs, goOn, tell)) return nullptr;
        {
            const std::lock_guard lock(reference.mutex);
            if (!reference.proven) {
                reference.proven = proveReference(cases, copiesOf(runs), task_->rule.agreement);
                if (reference.proven->horizon && reference.proven->endKnown)
                    for (const Case& c : nudgedStarts(cases[reference.proven->which].c))
                        reference.nudged.push_back(runOf(c));
            }
        }
        if (!runs_.make(reference.nudged, goOn)) return nullptr;
        const std::lock_guard lock(reference.mutex);
        if (!std::exchange(reference.endProven, true)) proveEnd(*reference.proven, copiesOf(reference.nudged));
        return &*reference.proven;
    }

    static ItemRow criterionRow(const MeasuredRun& run, const MeasuredRun& finer, const ProvenReference& reference)
    {
        const bool endChanges = !sameOutcome(run, finer);
        const bool right = reference.endKnown && sameOutcome(run, reference.run);
        CriterionVerdict verdict = CriterionVerdict::Right;
        if (!reference.endKnown)
            verdict = CriterionVerdict::NotDetermined;
        else if (right == endChanges)
            verdict = right ? CriterionVerdict::FalseAlarm : CriterionVerdict::Fooled;
        const double change = trajectoryError(run, finer, 0).at(ErrorMeasure::Worst).value_or(0.0);
        ItemRow row{double(endChanges), ifFinite(change), double(verdict)};
        row.resize(width);
        return row;
    }

    const std::shared_ptr<const StabilityTask> task_;
    std::deque<RowReference> references_;
    std::vector<StabilityCell> cells_;
    std::vector<Pair> pairs_;
    SharedRuns runs_{{.energyBalance = true}};
    CaseContent contents_;
};

} // namespace

ItemStudy stabilityItems(const std::shared_ptr<const StabilityTask>& task,
                         std::function<StudyReport(const StabilityMap&, bool whole)> reportOf)
{
    const auto items = std::make_shared<StabilityItems>(task);
    return {
        .count = items->count(),
        .width = width,
        .content = [items](std::size_t i) { return items->content(i); },
        .solve = [items](std::size_t i, ItemCall& call) { return items->solve(i, call.goOn, call.tell); },
        .report = [items, reportOf = std::move(reportOf)](
                      const ItemRows& rows) { return reportOf(items->mapOf(rows), isWhole(rows)); },
        .cost = [items](std::size_t i) { return items->cost(i); },
        .end = [items] { items->forget(); },
    };
}

} // namespace touchdown
