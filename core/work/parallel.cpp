// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/work/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <numeric>
#include <system_error>
#include <thread>
#include <vector>

#include "core/work/team.h"

namespace touchdown {

bool runParallel(std::size_t count, int jobs, const std::function<void(std::size_t, const GoOn& goOn)>& task,
                 const std::function<bool(std::size_t done)>& poll)
{
    std::mutex mutex;
    std::condition_variable ended;
    std::size_t next = 0, done = 0;
    std::atomic<bool> stopped = false;
    std::exception_ptr failure; // the first one
    const GoOn goOn = [&] { return !stopped; };
    const std::size_t side = std::clamp<std::size_t>(count, 1, static_cast<std::size_t>(std::max(jobs, 1)));
    const int share = std::max(1, threadShare() / static_cast<int>(side)); // of a task
    const auto work = [&] {
        setThreadShare(share, share);
        std::unique_lock lock(mutex);
        while (next < count && !stopped) {
            const std::size_t mine = next++;
            lock.unlock();
            std::exception_ptr its;
            try {
                task(mine, goOn);
            } catch (...) {
                its = std::current_exception();
            }
            lock.lock();
            if (its && !failure) {
                failure = its;
                stopped = true;
            }
            ++done;
            ended.notify_one();
        }
    };

    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < std::min(count, side); ++i) {
        try {
            threads.emplace_back(work);
        } catch (const std::system_error&) { // no memory for one more
            if (threads.empty()) throw;
            break;
        }
    }
    std::unique_lock lock(mutex);
    while (done < count && !failure) {
        ended.wait_for(lock, std::chrono::milliseconds(50));
        const std::size_t now = done;
        lock.unlock();
        if (!poll(now)) {
            stopped = true;
            break; // the threads end before they are joined
        }
        lock.lock();
    }
    if (lock.owns_lock()) lock.unlock();
    threads.clear();
    if (failure) std::rethrow_exception(failure);
    return !stopped;
}

std::vector<std::size_t> scatteredOrder(std::size_t count)
{
    // By steps of the golden section, which leave no large gap whatever their number; coprime, so that all are met.
    auto step = static_cast<std::size_t>(0.6180339887498949 * static_cast<double>(count));
    step = std::max<std::size_t>(step, 1);
    while (std::gcd(step, count) > 1) ++step;
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i) order[i] = i * step % count;
    return order;
}

} // namespace touchdown
