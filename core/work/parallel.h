// SPDX-License-Identifier: GPL-3.0-or-later
//
// Independent solutions of a study, several at a time. What each of them writes is its own, so that the outcome does
// not depend on the number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace touchdown {

/// Asked by a task as often as it can; false: end soon.
using GoOn = std::function<bool()>;

/// Calls task(0) .. task(count - 1), each once, on up to `jobs` threads, in rising order of their start. `poll` is
/// called on the calling thread at least every 50 ms with the number of tasks that have ended; where it returns false
/// no further task begins, and those under way are told by `goOn`. Returns whether all tasks ran to their end without
/// that. Threads are joined before it returns. Each task may use its part of the calling thread's cores
/// (core/work/team.h): all of them where one task runs at a time. What a task throws ends all others, too, and is
/// thrown on.
bool runParallel(std::size_t count, int jobs, const std::function<void(std::size_t, const GoOn& goOn)>& task,
                 const std::function<bool(std::size_t done)>& poll);

/// 0 .. count - 1, each once, so that any part of the list is spread evenly over all: what the first tasks take tells
/// what all of them take, and a map that is made in this order shows its whole early.
std::vector<std::size_t> scatteredOrder(std::size_t count);

} // namespace touchdown
