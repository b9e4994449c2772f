// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs that several items of a list need. Each is made once, by the thread that asks for it first; a thread that needs
// several makes those that nobody makes, then waits for the others.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/simulation/run.h"
#include "core/studies/runs/measured_run.h"

namespace touchdown {

class SharedRuns {
public:
    explicit SharedRuns(RunOptions options = {}) : options_(std::move(options)) {}

    /// The number of the run of this case, the same for the same case. It keeps the samples of this quantity beside
    /// those of earlier calls, "" for none; all quantities of a run are named before it is made.
    std::size_t add(const Case& c, const std::string& sampled = {});
    /// False where it was told to end.
    bool make(std::span<const std::size_t> wanted, const GoOn& goOn, const ShareTeller& tell = {});
    /// Lets go of all that was made, while no thread makes any.
    void forget();

    /// Of a run that is made.
    const MeasuredRun& run(std::size_t i) const { return at(i).run; }
    /// The column of a quantity that was asked for.
    std::size_t columnOf(std::size_t i, const std::string& sampled) const;

private:
    enum class State : std::uint8_t { Open, UnderWay, Made };
    struct Shared {
        Case c;
        std::vector<std::string> sampled{};
        MeasuredRun run{};
        State state = State::Open;
    };
    const Shared& at(std::size_t i) const;

    RunOptions options_;
    mutable std::mutex mutex_; // of the states, and of the two lists; a run belongs to the thread that makes it
    std::condition_variable ended_;
    std::deque<Shared> all_{}; // its elements stay where they are
    std::map<std::string, std::size_t> index_{};
};

} // namespace touchdown
