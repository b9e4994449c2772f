// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_differences.h"

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"

namespace touchdown {

namespace {

constexpr int together = 100;                             // [ms]
constexpr std::size_t atOnce = SampleColumn::pieceSize;   // samples between two looks at the stop
constexpr std::size_t bytesOfSample = 2 * sizeof(double); // with its time

} // namespace

MinMaxPyramid difference(const MinMaxPyramid& run, const MinMaxPyramid& baseline, const std::stop_token& stop)
{
    MinMaxPyramid made;
    std::vector<double> times, values;
    std::size_t before = 0; // the last sample of the baseline that is not later
    for (std::size_t begin = 0; begin < run.size() && !baseline.empty() && !stop.stop_requested(); begin += atOnce) {
        times.clear();
        values.clear();
        for (std::size_t k = begin; k < std::min(run.size(), begin + atOnce); ++k) {
            const double time = run.time(k);
            if (time < baseline.firstTime() || time > baseline.lastTime()) continue;
            while (before + 1 < baseline.size() && baseline.time(before + 1) <= time) ++before;
            double other = baseline.value(before);
            if (before + 1 < baseline.size()) {
                const double start = baseline.time(before);
                const double part = (time - start) / (baseline.time(before + 1) - start);
                other = std::lerp(other, baseline.value(before + 1), part);
            }
            times.push_back(time);
            values.push_back(run.value(k) - other);
        }
        made.append(times, values);
    }
    made.times()->shrink();
    made.shrink();
    return made;
}

RunDifferences::RunDifferences(RunsModel& runs, QObject* parent) : QObject(parent), runs_(runs)
{
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &RunDifferences::made);
    connect(&runs_, &RunsModel::aboutToRemove, this, [this](int number) {
        std::erase_if(begun_, [number](const auto& each) {
            if (each.first.first != number) return false;
            each.second.request_stop();
            return true;
        });
        std::erase_if(problems_, [number](const auto& each) { return each.first.first == number; });
    });
}

RunDifferences::~RunDifferences()
{
    for (auto& [key, stop] : begun_) stop.request_stop();
}

const MinMaxPyramid* RunDifferences::of(const RunRecord& run, const std::string& quantity)
{
    if (const auto found = run.differences.find(quantity); found != run.differences.end()) return &found->second;
    if (!isBegun(run.number, quantity) && problem(run.number, quantity).isEmpty()) begin(run, quantity);
    return nullptr;
}

QString RunDifferences::problem(int run, const std::string& quantity) const
{
    const auto found = problems_.find({run, quantity});
    return found == problems_.end() ? QString() : found->second;
}

void RunDifferences::begin(const RunRecord& run, const std::string& quantity)
{
    const RunRecord* baseline = runs_.find(runs_.baseline());
    const MinMaxPyramid* own = run.pyramid(quantity);
    const MinMaxPyramid* other = baseline ? baseline->pyramid(quantity) : nullptr;
    if (!own || !other || baseline == &run || !run.finished() || !baseline->finished()) return;
    const Key key{run.number, quantity};
    const std::stop_source stop;
    begun_.emplace(key, stop);
    auto result = std::make_shared<MinMaxPyramid>();
    queue_.post(
        [result, from = own->twin(), minus = other->twin(), token = stop.get_token()] {
            *result = difference(*from, *minus, token);
            return QString();
        },
        [this, key, result, token = stop.get_token()](const QString& problem) {
            RunRecord* record = runs_.find(key.first);
            if (token.stop_requested() || !record) return;
            begun_.erase(key);
            if (problem.isEmpty()) {
                // The times of the run, unless the baseline begins later.
                const MinMaxPyramid* full = record->pyramid(key.second);
                if (!result->empty() && full->time(0) == result->time(0) &&
                    full->time(result->size() - 1) == result->lastTime())
                    result->shareTimes(full->times());
                record->differences.insert_or_assign(key.second, std::move(*result));
            } else {
                problems_.insert_or_assign(key, problem);
            }
            if (begun_.empty())
                soon_.start(0);
            else if (!soon_.isActive())
                soon_.start(together);
        },
        bytesOfSample * own->size());
}

void RunDifferences::keepOnly(const std::set<Key>& wanted)
{
    std::erase_if(begun_, [&wanted](const auto& each) {
        if (wanted.contains(each.first)) return false;
        each.second.request_stop();
        return true;
    });
    std::erase_if(problems_, [&wanted](const auto& each) { return !wanted.contains(each.first); });
    for (int row = 0; row < runs_.count(); ++row) {
        RunRecord& run = *runs_.find(runs_.record(row).number);
        std::erase_if(run.differences, [&](const auto& each) { return !wanted.contains(Key(run.number, each.first)); });
    }
}

} // namespace touchdown
