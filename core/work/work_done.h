// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much of the work of a study is done: independent tasks, each weighted by its expected cost and counted in part
// while it is under way.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace touchdown {

/// Called by a task with its share that is done, 0..1, as often as it can.
using ShareTeller = std::function<void(double share)>;

class WorkDone {
public:
    /// One cost for each task [any unit].
    explicit WorkDone(std::vector<double> costs);

    /// For the thread of task i alone; valid as long as this.
    ShareTeller teller(std::size_t i);
    /// Of all, 0..1; on any thread.
    double share() const;

private:
    std::vector<double> costs_, done_; // done_[i] belongs to the thread of task i
    double all_ = 0.0;
    std::atomic<double> sum_ = 0.0; // of what is done
};

} // namespace touchdown
