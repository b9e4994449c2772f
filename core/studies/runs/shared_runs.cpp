// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/shared_runs.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/case_files/case_text.h"

namespace touchdown {

std::size_t SharedRuns::add(const Case& c, const std::string& sampled)
{
    std::string text = formatCase(c) + '\n' + c.folder.string();
    const std::lock_guard lock(mutex_);
    const auto [place, isNew] = index_.emplace(std::move(text), all_.size());
    if (isNew) all_.push_back({.c = c});
    std::vector<std::string>& names = all_[place->second].sampled;
    if (!sampled.empty() && std::ranges::find(names, sampled) == names.end()) names.push_back(sampled);
    return place->second;
}

bool SharedRuns::make(std::span<const std::size_t> wanted, const GoOn& goOn, const ShareTeller& tell)
{
    constexpr std::chrono::milliseconds patience(20); // of a thread that waits, to hear that it is to end
    std::unique_lock lock(mutex_);
    const auto is = [this](State state) { return [this, state](std::size_t i) { return all_[i].state == state; }; };
    while (!std::ranges::all_of(wanted, is(State::Made))) {
        if (const auto open = std::ranges::find_if(wanted, is(State::Open)); open != wanted.end()) {
            Shared& mine = all_[*open];
            mine.state = State::UnderWay;
            const auto before = double(std::ranges::count_if(wanted, is(State::Made)));
            lock.unlock();
            const auto tellPart = [&](double share) { tell((before + share) / double(wanted.size())); };
            try {
                mine.run =
                    measureRun(mine.c, mine.sampled, goOn, options_, tell ? ShareTeller(tellPart) : ShareTeller());
            } catch (...) {
                lock.lock();
                mine.state = State::Open; // for those that wait
                ended_.notify_all();
                throw;
            }
            lock.lock();
            mine.state = mine.run.summary.status == RunStatus::Cancelled ? State::Open : State::Made;
            ended_.notify_all();
        } else {
            ended_.wait_for(lock, patience);
        }
        if (goOn && !goOn()) return false;
    }
    return true;
}

void SharedRuns::forget()
{
    const std::lock_guard lock(mutex_);
    for (Shared& each : all_) {
        each.run = {};
        each.state = State::Open;
    }
}

std::size_t SharedRuns::columnOf(std::size_t i, const std::string& sampled) const
{
    const std::vector<std::string>& names = at(i).sampled;
    return std::size_t(std::ranges::find(names, sampled) - names.begin());
}

const SharedRuns::Shared& SharedRuns::at(std::size_t i) const
{
    const std::lock_guard lock(mutex_);
    return all_[i];
}

} // namespace touchdown
