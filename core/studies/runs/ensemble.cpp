// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/ensemble.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <span>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/numerics/moments.h"
#include "core/studies/runs/expected_cost.h"
#include "core/studies/runs/swept_method.h"
#include "core/studies/study/study.h"
#include "core/work/parallel.h"
#include "core/work/work_done.h"

namespace touchdown {

namespace {

EnsembleEnd runStart(const Case& c, const Parameter& key, double value, const GoOn& goOn, const ShareTeller& tell)
{
    Case started = c;
    if (setFromNumber(started, key, value)) return {.state = {}, .failure = RunFailure::Other};
    const MeasuredRun run = measureRun(started, {}, goOn, {}, tell);
    return {run.end, run.summary.failure, workOf(c, run.summary)};
}

struct Place {
    std::size_t ensemble = 0, start = 0;
    double spacing = 0.0, spread = 0.0;
};

/// Neighbours by spacing, where there is no wider gap between them.
void splitBySpacing(std::vector<Place>& places, const std::function<void(std::span<const Place>)>& take)
{
    std::ranges::sort(places, {}, &Place::spacing);
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= places.size(); ++i) {
        if (i < places.size() &&
            places[i].spacing - places[i - 1].spacing <= std::max(sameSpacing, places[i].spread + places[i - 1].spread))
            continue;
        take(std::span(places).subspan(begin, i - begin));
        begin = i;
    }
}

double meanSpacing(std::span<const Place> places)
{
    const double first = places.front().spacing;
    double sum = 0.0;
    for (const Place& place : places) sum += place.spacing - first;
    return first + sum / static_cast<double>(places.size());
}

} // namespace

std::string defaultEnsembleKey(const Case& c)
{
    if (c.model != ModelKind::Film) return EnsembleTask{}.key;
    return c.initial.state == InitialState::Static ? "initial.height_offset" : "initial.nominal_trailing_edge_height";
}

double workOf(const Case& c, const Summary& summary)
{
    for (const RunFigure& figure : summary.figures)
        if (c.model == ModelKind::Film && figure.quantity.name == "film_solves") return figure.value;
    return static_cast<double>(summary.evaluations);
}

std::vector<double> startsOf(const Case& c, const EnsembleTask& task)
{
    const double middle = std::get<double>(findParameter(task.key)->get(c));
    std::mt19937_64 engine(static_cast<std::uint64_t>(task.seed));
    std::vector<double> starts(static_cast<std::size_t>(task.starts));
    for (double& start : starts) // from 53 random bits
        start = middle + task.spread * (2.0 * std::ldexp(static_cast<double>(engine() >> 11), -53) - 1.0);
    std::ranges::sort(starts);
    return starts;
}

bool runEnsembles(std::vector<Ensemble>& ensembles, const EnsembleTask& task, int jobs,
                  const std::function<bool(std::size_t, double)>& poll)
{
    const std::size_t count = std::size_t(task.starts);
    std::vector<std::vector<double>> starts;
    std::vector<double> costs;
    for (Ensemble& ensemble : ensembles) {
        costs.insert(costs.end(), count, expectedCost(ensemble.c));
        ensemble.ends.assign(count, {});
        starts.push_back(startsOf(ensemble.c, task));
    }
    WorkDone work(costs);
    const auto runOne = [&](std::size_t i, const GoOn& goOn) {
        Ensemble& own = ensembles[i / count];
        const double start = starts[i / count][i % count];
        own.ends[i % count] = runStart(own.c, *findParameter(task.key), start, goOn, work.teller(i));
    };
    return runParallel(costs.size(), jobs, runOne, [&](std::size_t done) { return poll(done, work.share()); });
}

EndClasses classifyEnds(const std::vector<Ensemble>& ensembles)
{
    EndClasses result;
    std::map<EndKind, std::vector<Place>> byKind;
    std::map<RunFailure, std::vector<Place>> byFailure;
    for (std::size_t e = 0; e < ensembles.size(); ++e) {
        result.of.emplace_back(ensembles[e].ends.size());
        for (std::size_t s = 0; s < ensembles[e].ends.size(); ++s) {
            const EnsembleEnd& end = ensembles[e].ends[s];
            if (end.state.kind == EndKind::Failed)
                byFailure[end.failure].push_back({e, s, 0.0, 0.0});
            else
                byKind[end.state.kind].push_back({e, s, end.state.spacing, end.state.spread});
        }
    }

    std::vector<EndClass> found;
    std::vector<std::vector<Place>> members;
    const auto add = [&](EndClass end, std::span<const Place> places) {
        found.push_back(std::move(end));
        members.emplace_back(places.begin(), places.end());
    };
    for (auto& [kind, places] : byKind) {
        // A pad that goes in and out has no spacing of its own.
        if (kind == EndKind::Intermittent)
            add({std::string(name(kind)), kind}, places);
        else
            splitBySpacing(places, [&, kind = kind](std::span<const Place> some) {
                add({(kind == EndKind::Flying ? "flying at " : "in contact at ") +
                         fewDigits(std::round(meanSpacing(some) * 1e11) / 1e11, "nm", 6),
                     kind},
                    some);
            });
    }
    for (const auto& [failure, places] : byFailure)
        add({"failed: " + std::string(name(failure)), EndKind::Failed}, places);

    std::vector<std::size_t> order(found.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return members[i].size(); });
    for (const std::size_t i : order) {
        for (const Place& place : members[i]) result.of[place.ensemble][place.start] = result.classes.size();
        result.classes.push_back(found[i]);
    }
    return result;
}

Share shareOf(std::size_t count, std::size_t total)
{
    constexpr double z = 1.96;
    const double n = static_cast<double>(total), p = static_cast<double>(count) / n;
    const double middle = p + z * z / (2.0 * n), scale = 1.0 + z * z / n;
    const double half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
    return {count, p, std::max(0.0, (middle - half) / scale), std::min(1.0, (middle + half) / scale)};
}

ShareDifference shareDifference(const std::vector<std::size_t>& first, const std::vector<std::size_t>& second,
                                std::size_t end)
{
    double b = 0.0, c = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        b += first[i] == end && second[i] != end;
        c += first[i] != end && second[i] == end;
    }
    const double n = static_cast<double>(first.size());
    return {(b - c) / n, std::sqrt(b + c) / n, std::abs(b - c) - 1.0 > 2.0 * std::sqrt(b + c)};
}

std::size_t otherwise(const std::vector<std::size_t>& first, const std::vector<std::size_t>& second)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < first.size(); ++i) count += first[i] != second[i];
    return count;
}

namespace {

constexpr std::size_t mostPanels = 3;
constexpr std::size_t mostEndsTold = 4;

std::string labelOf(const Ensemble& ensemble) { return nameOf(ensemble.method, ensemble.setting); }

double meanWork(const Ensemble& ensemble)
{
    double sum = 0.0;
    for (const EnsembleEnd& end : ensemble.ends) sum += end.work;
    return sum / static_cast<double>(ensemble.ends.size());
}

/// To a tenth of a percent.
std::string percentOf(double share) { return percent(std::round(1000.0 * share) / 1000.0, 4); }

/// "31.3 % (26.3 % to 36.8 %)"
std::string shareText(const Share& share)
{
    return percentOf(share.share) + " (" + percentOf(share.lower) + " to " + percentOf(share.upper) + ")";
}

/// What `take` tells of the starts.
template <class Take>
std::vector<double> valuesOf(const Ensemble& ensemble, Take take)
{
    std::vector<double> values;
    for (std::size_t s = 0; s < ensemble.ends.size(); ++s)
        if (const std::optional<double> value = take(s)) values.push_back(*value);
    return values;
}
StudyValue momentOf(const std::vector<double>& values, double Moments::*moment)
{
    return values.empty() ? StudyValue() : StudyValue(momentsOf(values).*moment);
}

/// "300 random starts with FH(0) within 0.5 nm of 250 nm".
std::string describeStarts(const Case& c, const EnsembleTask& task)
{
    const Parameter& parameter = *findParameter(task.key);
    return std::to_string(task.starts) + " random starts with " + parameter.label + " within " +
           fewDigits(task.spread, parameter.displayUnit, 6) + " of " + toText(c, parameter);
}

class Teller {
public:
    Teller(const Case& c, const EnsembleTask& task, const std::vector<Ensemble>& all)
        : starts_(describeStarts(c, task)),
          work_(c.model == ModelKind::Film ? "Film solves per run" : "Right-hand sides per run"),
          all_(all),
          ends_(classifyEnds(all))
    {}

    void tell(StudyReport& report) const
    {
        tellReference(report);
        for (std::size_t e = 1; e < all_.size(); ++e) tellOne(e, report);
        report.charts.push_back(chart());
        report.tables.push_back(shares());
        report.tables.push_back(ensembles());
    }

private:
    std::size_t starts() const { return all_.front().ends.size(); }
    Share shareIn(std::size_t ensemble, std::size_t end) const
    {
        return shareOf(static_cast<std::size_t>(std::ranges::count(ends_.of[ensemble], end)), starts());
    }
    ShareDifference differenceIn(std::size_t ensemble, std::size_t end) const
    {
        return shareDifference(ends_.of[ensemble], ends_.of[0], end);
    }

    void tellReference(StudyReport& report) const
    {
        std::string text;
        for (std::size_t k = 0, told = 0; k < ends_.classes.size(); ++k) {
            const Share share = shareIn(0, k);
            if (share.count == 0 || told++ >= mostEndsTold) continue;
            text += (text.empty() ? "" : "; ") + ends_.classes[k].name + ", " + shareText(share);
        }
        report.findings.push_back("The reference (" + all_[0].setting + ") of " + starts_ + " ends in: " + text +
                                  ". In brackets: 95 % intervals.");
    }

    void tellOne(std::size_t e, StudyReport& report) const
    {
        const std::size_t changed = otherwise(ends_.of[e], ends_.of[0]);
        std::string text = labelOf(all_[e]) + " leads " + std::to_string(changed) + " of " + std::to_string(starts()) +
                           " starts to another end than the reference";
        std::string differences;
        for (std::size_t k = 0; k < ends_.classes.size(); ++k) {
            const ShareDifference difference = differenceIn(e, k);
            if (!difference.significant) continue;
            differences += (differences.empty() ? "" : "; ") + ends_.classes[k].name + " " + shareText(shareIn(e, k)) +
                           " instead of " + percentOf(shareIn(0, k).share) + ", " +
                           fewDigits(std::abs(difference.difference) / difference.error, "") + " standard errors apart";
        }
        if (!differences.empty())
            text += ", and its shares differ by more than their uncertainty: " + differences;
        else if (changed > 0)
            text += ", but its shares are the same within their uncertainty";
        report.findings.push_back(text + ".");
    }

    StudyChart chart() const
    {
        StudyChart chart{
            "Where " + starts_ + " end",
            "Each point is one way to run the same starts; bars and the shaded band of the reference: 95 % intervals "
            "(Wilson). "
            "As the starts are the same, a difference can be certain although the bars overlap: see the table of "
            "shares. Each is tested for itself: of twenty, one exceeds its uncertainty by chance."};
        for (std::size_t k = 0; k < std::min(mostPanels, ends_.classes.size()); ++k) chart.panels.push_back(panel(k));
        return chart;
    }

    ChartPanel panel(std::size_t end) const
    {
        ChartPanel panel{{"Share: " + ends_.classes[end].name}, {work_, "", "", true}};
        for (std::size_t e = 0; e < all_.size(); ++e) {
            const std::string name = e == 0 ? "reference: " + all_[0].setting : all_[e].method;
            auto series = std::ranges::find(panel.series, name, &ChartSeries::name);
            if (series == panel.series.end()) series = panel.series.insert(series, {name, {}, ChartLine::None});
            const Share share = shareIn(e, end);
            if (!(meanWork(all_[e]) > 0.0)) continue;
            series->points.push_back({.x = share.share,
                                      .y = meanWork(all_[e]),
                                      .label = e == 0 ? std::string() : all_[e].setting,
                                      .xError = std::max(share.upper - share.share, share.share - share.lower)});
        }
        const Share reference = shareIn(0, end);
        panel.bands.push_back({true, reference.lower, reference.upper, "reference"});
        return panel;
    }

    StudyTable shares() const
    {
        StudyTable table{"shares",
                         {{.name = "method", .longName = "Method"},
                          {.name = "setting", .longName = "Setting"},
                          {.name = "end", .longName = "End"},
                          {.name = "count", .longName = "Starts"},
                          {.name = "share", .longName = "Share"},
                          {.name = "lower", .longName = "Lower end of its 95 % interval"},
                          {.name = "upper", .longName = "Upper end"},
                          {.name = "difference", .longName = "Share less that of the reference"},
                          {.name = "difference_error", .longName = "Its standard error, start by start"},
                          {.name = "differs", .longName = "Differs by more than chance"},
                          {"spacing", "m", "nm", "Mean spacing over the last tenth"},
                          {"spacing_deviation", "m", "nm", "Its deviation among starts"},
                          {"spread", "m", "nm", "Standard deviation over the last tenth, mean of the starts"}}};
        for (std::size_t e = 0; e < all_.size(); ++e)
            for (std::size_t k = 0; k < ends_.classes.size(); ++k) table.rows.push_back(row(e, k));
        return table;
    }

    std::vector<StudyValue> row(std::size_t e, std::size_t k) const
    {
        const Share share = shareIn(e, k);
        const ShareDifference difference = differenceIn(e, k);
        const auto among = [&](double EndState::*member) {
            return valuesOf(all_[e], [&, member](std::size_t s) {
                const EndState& state = all_[e].ends[s].state;
                return ends_.of[e][s] == k && state.kind != EndKind::Failed ? std::optional(state.*member)
                                                                            : std::nullopt;
            });
        };
        const std::vector<double> spacing = among(&EndState::spacing);
        return {all_[e].method,
                all_[e].setting,
                ends_.classes[k].name,
                static_cast<double>(share.count),
                share.share,
                share.lower,
                share.upper,
                difference.difference,
                difference.error,
                std::string(e > 0 && difference.significant ? "yes" : ""),
                momentOf(spacing, &Moments::mean),
                momentOf(spacing, &Moments::deviation),
                momentOf(among(&EndState::spread), &Moments::mean)};
    }

    StudyTable ensembles() const
    {
        StudyTable table{"ensembles",
                         {{.name = "method", .longName = "Method"},
                          {.name = "setting", .longName = "Setting"},
                          {.name = "starts", .longName = "Starts"},
                          {.name = "otherwise", .longName = "Starts with another end than in the reference"},
                          {.name = "failed", .longName = "Without a valid end"},
                          {"spacing", "m", "nm", "Mean spacing over the last tenth, mean of the valid starts"},
                          {"spacing_deviation", "m", "nm", "Its deviation among starts"},
                          {.name = "work", .longName = work_}}};
        for (std::size_t e = 0; e < all_.size(); ++e) {
            const std::vector<double> spacing = valuesOf(all_[e], [&](std::size_t s) {
                const EndState& state = all_[e].ends[s].state;
                return state.kind != EndKind::Failed ? std::optional(state.spacing) : std::nullopt;
            });
            table.rows.push_back({all_[e].method, all_[e].setting, static_cast<double>(starts()),
                                  static_cast<double>(otherwise(ends_.of[e], ends_.of[0])),
                                  static_cast<double>(starts() - spacing.size()), momentOf(spacing, &Moments::mean),
                                  momentOf(spacing, &Moments::deviation), meanWork(all_[e])});
        }
        return table;
    }

    std::string starts_, work_;
    const std::vector<Ensemble>& all_;
    EndClasses ends_;
};

} // namespace

void reportEnsembles(const Case& c, const EnsembleTask& task, const std::vector<Ensemble>& all, StudyReport& report)
{
    Teller(c, task, all).tell(report);
}

} // namespace touchdown
