// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/statements/statement_runs.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "core/case/parameters.h"
#include "core/formats/decimal.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/numerics/spectrum.h"
#include "core/simulation/recording/run_statistics.h"
#include "core/studies/runs/case_content.h"
#include "core/studies/runs/expected_cost.h"
#include "core/studies/runs/reading.h"
#include "core/studies/runs/sampled_values.h"
#include "core/studies/runs/shared_runs.h"

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

/// Where a reading takes it; nothing for what is no reading.
std::optional<ReadAt> readAtOf(Taken taken)
{
    switch (taken) {
    case Taken::End:
    case Taken::Difference: return ReadAt::Tail;
    case Taken::Swing: return ReadAt::Swing;
    case Taken::Rms: return ReadAt::Rms;
    case Taken::Mean: return ReadAt::Mean;
    case Taken::Least: return ReadAt::Least;
    case Taken::Greatest: return ReadAt::Most;
    case Taken::Peaks:
    case Taken::Case:
    case Taken::Distance:
    case Taken::Likeness:
    case Taken::Peak: break;
    }
    return {};
}

/// NaN where the run has no such value.
double valueOf(const Statement& statement, const SampledRun& run)
{
    const std::string& quantity = statement.quantity.name;
    if (const auto at = readAtOf(statement.taken))
        return valueAt(*at, statement.c, *run.run, quantity,
                       run.column < run.run->columns.size() ? run.samples() : std::span<const double>());
    if (statement.taken == Taken::Peaks) return peaksWithin(statement, run);
    return statement.taken == Taken::Case ? std::get<double>(findParameter(quantity)->get(statement.c)) : NAN;
}

/// Every thing that a statement asks of its runs.
std::string criterionOf(const Statement& statement)
{
    std::string text = joined(statement.ends, ",") + ";" + joined(statement.motions, ",") + ";";
    if (statement.sameAsLike) text += *statement.sameAsLike ? "same" : "other";
    for (const std::string& word :
         {statement.quantity.name, statement.quantity.displayUnit, std::string(name(statement.taken))})
        text += " " + word;
    for (const double bound : {statement.atLeast, statement.atMost, statement.from, statement.to})
        text += " " + (std::isfinite(bound) ? decimalText(bound) : std::string("none"));
    return text;
}

/// What a list of statements does: each statement's own run, then each start of its ensemble.
class StatementItems {
public:
    explicit StatementItems(const StatementTask& task) : task_(task)
    {
        std::set<std::size_t> known;
        for (const Statement& statement : task_.statements) {
            const std::string sampled = sampledBy(statement).value_or("");
            std::vector<std::size_t>& own = runs_.emplace_back();
            own.push_back(shared_.add(statement.c, sampled));
            if (statement.like) own.push_back(shared_.add(*statement.like, sampled));
            double cost = 0.0; // of runs that no statement before it has made
            for (const std::size_t run : own)
                if (known.insert(run).second) cost += expectedCost(run == own[0] ? statement.c : *statement.like);
            items_.push_back({items_.size(), {}, cost});
        }
        for (std::size_t i = 0; i < task_.statements.size(); ++i) {
            const Statement& statement = task_.statements[i];
            if (!statement.ensemble) continue;
            for (const double start : startsOf(statement.c, *statement.ensemble))
                items_.push_back({i, start, expectedCost(statement.c)});
        }
    }

    std::size_t count() const { return items_.size(); }
    double cost(std::size_t item) const { return items_[item].cost; }

    std::string content(std::size_t item)
    {
        const Statement& statement = task_.statements[items_[item].statement];
        const std::optional<double>& start = items_[item].start;
        return "statement " + criterionOf(statement) +
               (start ? " " + statement.ensemble->key + " " + decimalText(*start) : "") + "\n" +
               contents_.of(statement.c) + (statement.like ? "like\n" + contents_.of(*statement.like) : "");
    }

    std::optional<ItemRow> solve(std::size_t item, const GoOn& goOn, const ShareTeller& tell)
    {
        const auto& [i, start, cost] = items_[item];
        const Statement& statement = task_.statements[i];
        const std::string sampled = sampledBy(statement).value_or("");
        const auto at = [&](std::size_t run) { return SampledRun{&shared_.run(run), shared_.columnOf(run, sampled)}; };
        MeasuredRun drawn;
        if (start) {
            Case c = statement.c;
            setFromNumber(c, *findParameter(statement.ensemble->key), *start);
            drawn = measureRun(c, sampled.empty() ? std::vector<std::string>{} : std::vector{sampled}, goOn, {}, tell);
            if (drawn.summary.status == RunStatus::Cancelled) return {};
        }
        const std::span<const std::size_t> needed = std::span(runs_[i]).subspan(start ? 1 : 0);
        if (!shared_.make(needed, goOn, start ? ShareTeller() : tell)) return {};
        const SampledRun like = statement.like ? at(runs_[i][1]) : SampledRun{};
        const StatementFinding finding = judge(statement, start ? SampledRun{&drawn, 0} : at(runs_[i][0]), like);
        return ItemRow{finding.agrees ? 1.0 : 0.0, finding.text};
    }

    void forget()
    {
        shared_.forget();
        contents_.forget();
    }

    CheckedStatements checked(const ItemRows& rows) const
    {
        CheckedStatements result(task_.statements.size());
        std::vector<std::size_t> agree(result.size()), known(result.size());
        for (std::size_t item = 0; item < items_.size(); ++item) {
            if (!rows[item]) continue;
            const std::size_t i = items_[item].statement;
            const StatementFinding finding{numberAt(*rows[item], 0) > 0.0, textAt(*rows[item], 1)};
            if (items_[item].start) {
                ++known[i];
                agree[i] += finding.agrees ? 1 : 0;
            } else {
                result[i].done = true;
                result[i].finding = finding;
            }
        }
        for (std::size_t i = 0; i < result.size(); ++i) {
            if (!task_.statements[i].ensemble) continue;
            const auto starts = std::size_t(task_.statements[i].ensemble->starts);
            result[i].done = result[i].done && known[i] == starts;
            if (result[i].done) result[i].share = shareOf(agree[i], starts);
        }
        return result;
    }

private:
    struct Item {
        std::size_t statement = 0;
        std::optional<double> start{}; // value of the ensemble's key; none: the run of the case itself
        double cost = 0.0;
    };
    const StatementTask task_;
    SharedRuns shared_;
    CaseContent contents_;
    std::vector<Item> items_;
    std::vector<std::vector<std::size_t>> runs_; // of each statement: its own, and that of `like`
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

ItemStudy statementItems(const StatementTask& task, std::function<StudyReport(const CheckedStatements&)> reportOf)
{
    const auto items = std::make_shared<StatementItems>(task);
    return {
        .count = items->count(),
        .width = 2,
        .content = [items](std::size_t i) { return items->content(i); },
        .solve = [items](std::size_t i, ItemCall& call) { return items->solve(i, call.goOn, call.tell); },
        .report = [items,
                   reportOf = std::move(reportOf)](const ItemRows& rows) { return reportOf(items->checked(rows)); },
        .cost = [items](std::size_t i) { return items->cost(i); },
        .end = [items] { items->forget(); },
    };
}

} // namespace touchdown
