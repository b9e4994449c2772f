// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/statements/statement_runs.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/case/parameters.h"
#include "core/case_files/case_text.h"
#include "core/formats/units.h"
#include "core/numerics/moments.h"
#include "core/studies/runs/parallel.h"

namespace touchdown {

namespace {

/// To a thousandth of the larger bound or a little less: what is finer is round-off as often as not.
std::string shown(double value, const Statement& statement)
{
    double scale = 0.0;
    for (const double bound : {statement.atLeast, statement.atMost})
        if (std::isfinite(bound)) scale = std::max(scale, std::abs(bound));
    const std::string& unit = statement.quantity.displayUnit;
    const double factor = unitFactor(unit);
    if (scale > 0.0) {
        const double step = std::pow(10.0, std::floor(std::log10(1e-3 * scale / factor) + 1e-9));
        value = std::round(value / factor / step) * step * factor;
    }
    return fewDigits(value == 0.0 ? 0.0 : value, unit, 6);
}

bool within(const Statement& statement, double value)
{
    return value >= statement.atLeast && value <= statement.atMost;
}

StatementFinding judgeEnd(const Statement& statement, const MeasuredRun& run)
{
    const auto isExpected = [&](std::string_view end) {
        return std::ranges::find(statement.ends, end) != statement.ends.end();
    };
    return {isExpected(run.valid() ? name(run.end.kind) : name(run.summary.failure)), outcomeText(run)};
}

/// The peak within the bounds, else the largest one.
StatementFinding judgePeak(const Statement& statement, const MeasuredRun& run)
{
    const std::vector<Peak>& peaks = run.summary.peaks;
    if (peaks.empty()) return {false, "no peaks"};
    const auto inside =
        std::ranges::find_if(peaks, [&](const Peak& peak) { return within(statement, peak.frequency); });
    const bool found = inside != peaks.end();
    return {found, shown((found ? *inside : peaks.front()).frequency, statement)};
}

/// Of the samples over the last tenth of the run.
Moments tailOf(const MeasuredRun& run)
{
    const double begin = (1.0 - tailShare) * run.time.back();
    const auto first = std::size_t(std::ranges::lower_bound(run.time, begin) - run.time.begin());
    return momentsOf(std::span(run.columns.front()).subspan(first));
}

/// Over the samples that both have.
double largestDistance(const MeasuredRun& a, const MeasuredRun& b)
{
    const std::vector<double>&first = a.columns.front(), &second = b.columns.front();
    double most = 0.0;
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
        most = std::max(most, std::abs(first[i] - second[i]));
    return most;
}

double valueOf(const Statement& statement, const MeasuredRun& run, const MeasuredRun* like)
{
    switch (statement.taken) {
    case Taken::End: return tailOf(run).mean;
    case Taken::Swing: return tailOf(run).deviation;
    case Taken::Least: return std::ranges::min(run.columns.front());
    case Taken::Greatest: return std::ranges::max(run.columns.front());
    case Taken::Difference: return tailOf(run).mean - tailOf(*like).mean;
    case Taken::Distance: return largestDistance(run, *like);
    case Taken::Peak: break;
    }
    return 0.0;
}

struct Work {
    Case c;
    std::vector<std::string> sampled{};
    MeasuredRun run{};
};

/// The distinct runs of cases as they are.
class SharedRuns {
public:
    std::size_t add(const Case& c, const std::vector<std::string>& sampled)
    {
        std::string key = formatCase(c) + '\n' + c.folder.string();
        for (const std::string& each : sampled) key += '\n' + each;
        const auto [place, isNew] = index_.emplace(std::move(key), all.size());
        if (isNew) all.push_back({c, sampled});
        return place->second;
    }
    std::vector<Work> all{};

private:
    std::map<std::string, std::size_t> index_{};
};

} // namespace

std::vector<std::string> sampledBy(const Statement& statement)
{
    if (!statement.ends.empty() || statement.taken == Taken::Peak) return {};
    return {statement.quantity.name};
}

StatementFinding judge(const Statement& statement, const MeasuredRun& run, const MeasuredRun* like)
{
    if (!statement.ends.empty()) return judgeEnd(statement, run);
    const bool extreme = statement.taken == Taken::Least || statement.taken == Taken::Greatest;
    if (!run.valid() && !extreme) return {false, outcomeText(run)};
    if (like != nullptr && !like->valid()) return {false, "what it is compared with " + outcomeText(*like)};
    if (statement.taken == Taken::Peak) return judgePeak(statement, run);
    if (run.columns.empty() || run.columns.front().empty()) return {false, outcomeText(run)};
    const double value = valueOf(statement, run, like);
    return {within(statement, value), shown(value, statement)};
}

CheckedStatements checkStatements(const StatementTask& task, int jobs, const StudyCallback& callback)
{
    const std::size_t count = task.statements.size();
    SharedRuns shared;
    std::vector<std::size_t> own(count), like(count);
    struct Drawn {
        std::size_t statement = 0;
        double start = 0.0; // value of the ensemble's key
        bool done = false, agrees = false;
    };
    std::vector<Drawn> drawn;
    for (std::size_t i = 0; i < count; ++i) {
        const Statement& statement = task.statements[i];
        own[i] = shared.add(statement.c, sampledBy(statement));
        like[i] = statement.like ? shared.add(*statement.like, sampledBy(statement)) : own[i];
        if (!statement.ensemble) continue;
        for (const double start : startsOf(statement.c, *statement.ensemble)) drawn.push_back({i, start});
    }
    std::vector<char> made(shared.all.size(), 0);
    const auto runShared = [&](std::size_t i, const GoOn& goOn) {
        Work& work = shared.all[i];
        work.run = measureRun(work.c, work.sampled, goOn);
        made[i] = work.run.summary.status != RunStatus::Cancelled;
    };
    const auto runDrawn = [&](Drawn& each, const GoOn& goOn) {
        const Statement& statement = task.statements[each.statement];
        Case c = statement.c;
        setFromNumber(c, *findParameter(statement.ensemble->key), each.start);
        const MeasuredRun run = measureRun(c, sampledBy(statement), goOn);
        const MeasuredRun* other = statement.like ? &shared.all[like[each.statement]].run : nullptr;
        each.agrees = judge(statement, run, other).agrees;
        each.done = run.summary.status != RunStatus::Cancelled;
    };
    const std::size_t total = shared.all.size() + drawn.size();
    const auto tell = [&](std::size_t done) {
        const std::string doing = "run " + std::to_string(std::min(done + 1, total)) + " of " + std::to_string(total);
        return !callback || callback({.share = double(done) / double(total), .doing = doing, .soFar = nullptr});
    };
    // Ensembles may compare with runs of the cases themselves, which end first.
    CheckedStatements result;
    const bool whole = runParallel(shared.all.size(), jobs, runShared, tell) &&
                       runParallel(
                           drawn.size(), jobs, [&](std::size_t i, const GoOn& goOn) { runDrawn(drawn[i], goOn); },
                           [&](std::size_t done) { return tell(shared.all.size() + done); });
    if (!whole) result.status = StudyStatus::Cancelled;
    for (std::size_t i = 0; i < count; ++i) {
        const Statement& statement = task.statements[i];
        CheckedStatement& checked = result.all.emplace_back();
        if (!made[own[i]] || !made[like[i]]) continue;
        checked.finding = judge(statement, shared.all[own[i]].run, statement.like ? &shared.all[like[i]].run : nullptr);
        checked.done = true;
        if (!statement.ensemble) continue;
        const auto isOf = [&](const Drawn& each) { return each.statement == i; };
        const auto agrees = std::ranges::count_if(drawn, [&](const Drawn& each) { return isOf(each) && each.agrees; });
        checked.done = std::ranges::all_of(drawn, [&](const Drawn& each) { return !isOf(each) || each.done; });
        if (checked.done) checked.share = shareOf(std::size_t(agrees), std::size_t(statement.ensemble->starts));
    }
    return result;
}

} // namespace touchdown
