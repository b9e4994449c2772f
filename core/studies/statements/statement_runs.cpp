// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/statements/statement_runs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include "core/case/parameters.h"
#include "core/case_files/case_text.h"
#include "core/formats/units.h"
#include "core/numerics/moments.h"
#include "core/numerics/spectrum.h"
#include "core/simulation/recording/run_statistics.h"
#include "core/studies/runs/sampled_values.h"
#include "core/studies/runs/work_done.h"
#include "core/studies/study/growing_report.h"
#include "core/work/parallel.h"

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

StatementFinding judgeEnd(const Statement& statement, const MeasuredRun& run, const MeasuredRun* like)
{
    const auto isOneOf = [](const std::vector<std::string>& expected, std::string_view found) {
        return expected.empty() || std::ranges::find(expected, found) != expected.end();
    };
    const bool ends = isOneOf(statement.ends, run.valid() ? name(run.end.kind) : name(run.summary.failure));
    const bool moves = isOneOf(statement.motions, run.valid() ? name(run.end.motion) : std::string_view("failed"));
    const bool same = !statement.sameAsLike || sameOutcome(run, *like) == *statement.sameAsLike;
    std::string text = outcomeText(run);
    if (!statement.motions.empty() && run.valid() && !namesMotion(run.end))
        text += ": " + std::string(name(run.end.motion));
    if (statement.sameAsLike) text += "; the other one " + outcomeText(*like);
    return {ends && moves && same, text};
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

Spectrum spectrumOf(const Case& c, const SampledRun& run)
{
    return welch(evenSamples(c, *run.run, run.samples(), c.spectrum.start), c.run.sampleInterval,
                 welchOptions(c.spectrum, c.run.sampleInterval));
}

/// Peaks within the band that have at least a tenth of the largest amplitude at any frequency.
double peaksWithin(const Statement& statement, const SampledRun& run)
{
    constexpr double smallestShare = 0.1;
    const Spectrum spectrum = spectrumOf(statement.c, run);
    const std::vector<double>& power = spectrum.power;
    if (power.size() < 3) return 0.0;
    const double least = smallestShare * smallestShare * *std::max_element(power.begin() + 1, power.end());
    double count = 0.0;
    for (std::size_t i = 1; i + 1 < power.size(); ++i) {
        const double frequency = spectrum.frequency[i];
        if (frequency < statement.from || frequency > statement.to) continue;
        count += power[i] >= least && power[i] > power[i - 1] && power[i] >= power[i + 1] ? 1.0 : 0.0;
    }
    return count;
}

/// Bhattacharyya's coefficient of two power spectra: 1 for the same shape, 0 where no frequency is in both.
double likenessOf(const Statement& statement, const SampledRun& run, const SampledRun& like)
{
    const Spectrum a = spectrumOf(statement.c, run), b = spectrumOf(statement.c, like);
    double both = 0.0, first = 0.0, second = 0.0;
    for (std::size_t i = 1; i < std::min(a.power.size(), b.power.size()); ++i) {
        both += std::sqrt(a.power[i] * b.power[i]);
        first += a.power[i];
        second += b.power[i];
    }
    return both / std::sqrt(first * second);
}

/// At the times of the samples that are the same in both.
double largestDistance(const SampledRun& a, const SampledRun& b)
{
    const std::span<const double> x = a.samples(), y = b.samples();
    double most = 0.0;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
        if (a.run->time[i] == b.run->time[i]) most = std::max(most, std::abs(x[i] - y[i]));
    return most;
}

Extremes extremesOf(const Statement& statement, const MeasuredRun& run)
{
    return valueOr(run.summary.extremes, statement.quantity.name, {NAN, NAN});
}

/// NaN where the run has no such value.
double valueOf(const Statement& statement, const SampledRun& run)
{
    switch (statement.taken) {
    case Taken::End:
    case Taken::Difference: return momentsOf(tailSamples(statement.c, *run.run, run.samples())).mean;
    case Taken::Swing: return tailSwing(statement.c, *run.run, statement.quantity.name, run.samples());
    case Taken::Rms: return momentsOf(tailSamples(statement.c, *run.run, run.samples())).deviation;
    case Taken::Mean: return momentsOf(evenSamples(statement.c, *run.run, run.samples(), 0.0)).mean;
    case Taken::Least: return extremesOf(statement, *run.run).least;
    case Taken::Greatest: return extremesOf(statement, *run.run).most;
    case Taken::Peaks: return peaksWithin(statement, run);
    case Taken::Case: return std::get<double>(findParameter(statement.quantity.name)->get(statement.c));
    case Taken::Distance:
    case Taken::Likeness:
    case Taken::Peak: break;
    }
    return NAN;
}

struct Work {
    Case c;
    std::vector<std::string> sampled{};
    MeasuredRun run{};
};

/// The distinct runs of cases as they are; each keeps the samples of all quantities that somebody asks for.
class SharedRuns {
public:
    std::size_t add(const Case& c, const std::optional<std::string>& sampled)
    {
        const auto [place, isNew] = index_.emplace(formatCase(c) + '\n' + c.folder.string(), all.size());
        if (isNew) all.push_back({.c = c});
        std::vector<std::string>& names = all[place->second].sampled;
        if (sampled && std::ranges::find(names, *sampled) == names.end()) names.push_back(*sampled);
        return place->second;
    }
    SampledRun at(std::size_t i, const std::optional<std::string>& sampled) const
    {
        const std::vector<std::string>& names = all[i].sampled;
        return {&all[i].run, sampled ? std::size_t(std::ranges::find(names, *sampled) - names.begin()) : 0};
    }
    std::vector<Work> all{};

private:
    std::map<std::string, std::size_t> index_{};
};

} // namespace

std::optional<std::string> sampledBy(const Statement& statement)
{
    using enum Taken;
    const bool none = statement.taken == Least || statement.taken == Greatest || statement.taken == Peak ||
                      statement.taken == Taken::Case;
    if (statement.aboutEnd() || none) return {};
    return statement.quantity.name;
}

StatementFinding judge(const Statement& statement, SampledRun run, SampledRun like)
{
    if (statement.aboutEnd()) return judgeEnd(statement, *run.run, like.run);
    const bool anyEnd =
        statement.taken == Taken::Least || statement.taken == Taken::Greatest || statement.taken == Taken::Case;
    if (!run.run->valid() && !anyEnd) return {false, outcomeText(*run.run)};
    if (like.run != nullptr && !like.run->valid()) return {false, "what it is compared with " + outcomeText(*like.run)};
    if (statement.taken == Taken::Peak) return judgePeak(statement, *run.run);
    const double value = statement.taken == Taken::Distance ? largestDistance(run, like)
                         : statement.taken == Taken::Likeness
                             ? likenessOf(statement, run, like)
                             : valueOf(statement, run) - (like.run != nullptr ? valueOf(statement, like) : 0.0);
    if (!std::isfinite(value)) return {false, outcomeText(*run.run)};
    return {within(statement, value), shown(value, statement)};
}

CheckedStatements checkStatements(const StatementTask& task, int jobs, const StudyCallback& callback,
                                  const std::function<StudyReport(const CheckedStatements&)>& reportOf)
{
    const std::size_t count = task.statements.size();
    SharedRuns shared;
    std::vector<std::size_t> own(count), like(count);
    struct Drawn {
        std::size_t statement = 0;
        double start = 0.0; // value of the ensemble's key
        bool done = false, agrees = false;
    };
    std::mutex mutex; // guards `made`, and `drawn` once its runs have begun
    std::vector<Drawn> drawn;
    for (std::size_t i = 0; i < count; ++i) {
        const Statement& statement = task.statements[i];
        own[i] = shared.add(statement.c, sampledBy(statement));
        like[i] = statement.like ? shared.add(*statement.like, sampledBy(statement)) : own[i];
        if (!statement.ensemble) continue;
        for (const double start : startsOf(statement.c, *statement.ensemble)) drawn.push_back({i, start});
    }
    const auto likeOf = [&](std::size_t i) {
        return task.statements[i].like ? shared.at(like[i], sampledBy(task.statements[i])) : SampledRun{};
    };
    std::vector<char> made(shared.all.size(), 0);
    std::vector<double> costs;
    for (const Work& work : shared.all) costs.push_back(expectedCost(work.c));
    for (const Drawn& each : drawn) costs.push_back(expectedCost(task.statements[each.statement].c));
    WorkDone done(std::move(costs));
    const auto runShared = [&](std::size_t i, const GoOn& goOn) {
        Work& work = shared.all[i];
        work.run = measureRun(work.c, work.sampled, goOn, {}, done.teller(i));
        const std::lock_guard lock(mutex);
        made[i] = work.run.summary.status != RunStatus::Cancelled;
    };
    const auto runDrawn = [&](std::size_t i, const GoOn& goOn) {
        Drawn& each = drawn[i];
        const Statement& statement = task.statements[each.statement];
        Case c = statement.c;
        setFromNumber(c, *findParameter(statement.ensemble->key), each.start);
        const std::optional<std::string> sampled = sampledBy(statement);
        const std::vector<std::string> names = sampled ? std::vector{*sampled} : std::vector<std::string>{};
        const MeasuredRun run = measureRun(c, names, goOn, {}, done.teller(shared.all.size() + i));
        const bool agrees = judge(statement, {&run, 0}, likeOf(each.statement)).agrees;
        const std::lock_guard lock(mutex);
        each.agrees = agrees;
        each.done = run.summary.status != RunStatus::Cancelled;
    };
    const auto checkAll = [&] {
        CheckedStatements result;
        for (std::size_t i = 0; i < count; ++i) {
            const Statement& statement = task.statements[i];
            CheckedStatement& checked = result.all.emplace_back();
            if (!made[own[i]] || !made[like[i]]) continue;
            checked.finding = judge(statement, shared.at(own[i], sampledBy(statement)), likeOf(i));
            checked.done = true;
            if (!statement.ensemble) continue;
            const auto isOf = [&](const Drawn& each) { return each.statement == i; };
            const auto agrees =
                std::ranges::count_if(drawn, [&](const Drawn& each) { return isOf(each) && each.agrees; });
            checked.done = std::ranges::all_of(drawn, [&](const Drawn& each) { return !isOf(each) || each.done; });
            if (checked.done) checked.share = shareOf(std::size_t(agrees), std::size_t(statement.ensemble->starts));
        }
        return result;
    };
    const std::size_t total = shared.all.size() + drawn.size();
    std::size_t told = 0;
    const auto tell = [&](std::size_t ended) {
        const std::string doing = "run " + std::to_string(std::min(ended + 1, total)) + " of " + std::to_string(total);
        return tellProgress(callback, {done.share(), doing}, reportOf && std::exchange(told, ended) < ended, [&] {
            const std::lock_guard lock(mutex);
            return reportOf(checkAll());
        });
    };
    // Ensembles may compare with runs of the cases themselves, which end first.
    const bool whole =
        runParallel(shared.all.size(), jobs, runShared, tell) &&
        runParallel(drawn.size(), jobs, runDrawn, [&](std::size_t ended) { return tell(shared.all.size() + ended); });
    CheckedStatements result = checkAll();
    if (!whole) result.status = StudyStatus::Cancelled;
    return result;
}

} // namespace touchdown
