// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/ensemble.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>

#include "core/case/fields.h"
#include "core/studies/study/few_digits.h"

namespace touchdown {

namespace {

EnsembleEnd runStart(const Case& c, const Field& key, double value, const GoOn& goOn)
{
    Case started = c;
    if (setFromNumber(started, key, value)) return {.state = {}, .failure = RunFailure::Other};
    const MeasuredRun run = measureRun(started, {}, goOn);
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
    double sum = 0.0;
    for (const Place& place : places) sum += place.spacing - places.front().spacing;
    return places.front().spacing + sum / static_cast<double>(places.size());
}

} // namespace

double workOf(const Case& c, const Summary& summary)
{
    if (c.model == ModelKind::Film)
        for (const RunFigure& figure : summary.figures)
            if (figure.quantity.name == "film_solves") return figure.value;
    return static_cast<double>(summary.evaluations);
}

std::vector<double> startsOf(const Case& c, const EnsembleTask& task)
{
    const double middle = std::get<double>(findField(task.key)->get(c));
    std::vector<double> starts;
    for (int i = 0; i < task.starts; ++i)
        starts.push_back(middle + task.spread * ((2.0 * i + 1.0) / task.starts - 1.0));
    return starts;
}

bool runEnsembles(std::vector<Ensemble>& ensembles, const EnsembleTask& task, int jobs,
                  const std::function<bool(std::size_t)>& poll)
{
    const auto count = static_cast<std::size_t>(task.starts);
    const Field& key = *findField(task.key);
    std::vector<std::vector<double>> starts;
    for (Ensemble& ensemble : ensembles) {
        ensemble.ends.assign(count, {});
        starts.push_back(startsOf(ensemble.c, task));
    }
    const auto runOne = [&](std::size_t i, const GoOn& goOn) {
        const std::size_t which = i / count, start = i % count;
        ensembles[which].ends[start] = runStart(ensembles[which].c, key, starts[which][start], goOn);
    };
    return runParallel(count * ensembles.size(), jobs, runOne, poll);
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
            splitBySpacing(places, [&](std::span<const Place> some) {
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

} // namespace touchdown
