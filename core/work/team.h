// SPDX-License-Identifier: GPL-3.0-or-later
//
// A few threads that share loops of ten to some hundred microseconds. A loop is cut into blocks. Each thread takes the
// blocks of its own share first, so that it reads what it wrote in the loop before from its own cache, then those that
// no other thread has begun. The calling thread never waits for a thread that is not there, only for blocks that others
// have begun. Between loops workers spin for 0.4 ms, then they sleep.
//
// A block writes only what is its own. Numbers of one item must not depend on the borders of its block, and sums are
// formed by item, or by blocks of a fixed length (core/work/block_sums.h), and added in order. So results depend
// neither on the number of threads nor on who did what. Blocks must not wait for each other. What one throws is thrown
// on when all that were begun have ended.
//
//   const TeamScope scope(4);         // this thread has a team of four until the end of the scope
//   Team::mine().items(rows, 24, 1, [&](int first, int end, int thread) { ... });
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <thread>
#include <vector>

#include "core/work/team_gain.h"

namespace touchdown {

/// Items first to end - 1.
struct Block {
    int first, end;
};

class Team {
public:
    /// A system without memory for all threads gives fewer.
    explicit Team(int size);
    Team(const Team&) = delete;
    ~Team();

    /// That of the calling thread's TeamScope; without one, a team of one thread.
    static Team& mine();

    static constexpr int mostThreads = 32;
    int size() const { return size_; }
    /// Number of blocks of at least so many items at present; `perThread` for each thread at most.
    int blocksOf(int count, int least, int perThread = 1) const
    {
        return together_ ? largestBlocksOf(count, least, perThread) : 1;
    }
    /// The same for work space that holds as long as the team.
    int largestBlocksOf(int count, int least, int perThread = 1) const
    {
        return size_ == 1 ? 1 : std::clamp(count / std::max(1, least), 1, std::min(mostBlocks, size_ * perThread));
    }
    /// The items of a block; borders are multiples of `multiple`.
    static Block block(int count, int index, int blocks, int multiple = 1)
    {
        const int groups = (count + multiple - 1) / multiple;
        return {std::min(count, groups * index / blocks * multiple),
                std::min(count, groups * (index + 1) / blocks * multiple)};
    }

    static constexpr int mostBlocks = 32;
    /// Calls work(block, thread) for each block, at most so many, thread < size(), and waits for all. A loop within a
    /// block is done by the thread of the block. `items`: length of the loop, to compare like with like.
    template <typename Work>
    void run(int blocks, const Work& work, int items = 0)
    {
        if (size_ == 1 || inside_) {
            for (int b = 0; b < blocks; ++b) work(b, 0);
            return;
        }
        const Call call = [](const void* what, int block, int thread) {
            (*static_cast<const Work*>(what))(block, thread);
        };
        const bool shared = together_ && blocks > 1, timed = gain_.measures() && (shared || !together_);
        const double start = timed ? TeamGain::now() : 0.0;
        if (shared)
            share(blocks, call, &work);
        else
            for (int b = 0; b < blocks; ++b) work(b, 0);
        if (timed)
            gain_.note(reinterpret_cast<std::uintptr_t>(call) + (static_cast<std::uintptr_t>(items) << 48),
                       TeamGain::now() - start);
        countLoop();
    }
    /// work(first, end, thread) for blocks of items.
    template <typename Work>
    void items(int count, int least, int multiple, const Work& work)
    {
        const int blocks = blocksOf(count, least);
        run(
            blocks,
            [&](int b, int thread) {
                const Block own = block(count, b, blocks, multiple);
                if (own.end > own.first) work(own.first, own.end, thread);
            },
            count);
    }

private:
    using Call = void (*)(const void*, int, int);
    void share(int blocks, Call call, const void* what);
    void begin(int blocks, Call call, const void* what);
    void end(int blocks);
    /// The next block of the present loop, for the thread that began it; -1: none left.
    int take(int blocks);
    void serve(int index);
    void perform(Call call, const void* what, int block, int thread);
    void countLoop();

    int size_;
    // Of the thread that owns the team.
    bool together_ = true; // loops are shared at present
    bool inside_ = false;  // within a block
    int untimed_ = 0;      // loops since the time was last looked at
    TeamGain gain_;

    // Number of the loop, and a bit for each block that none has taken: 32, 32 bits. Who takes one knows that the loop
    // is under way.
    alignas(64) std::atomic<std::uint64_t> state_{0};
    alignas(64) std::atomic<int> done_{0};
    alignas(64) std::atomic<Call> call_{nullptr};
    std::atomic<const void*> what_{nullptr};
    std::atomic<int> blocks_{0};
    std::atomic<unsigned> bell_{0};
    std::atomic<int> sleepers_{0};
    std::atomic<bool> present_{false}; // a worker was there for the last loop
    std::atomic<bool> stop_{false};
    std::atomic<bool> failed_{false};  // a block of the present loop
    std::exception_ptr failure_;       // the first one's
    std::vector<std::thread> threads_; // last
};

/// Gives the calling thread a team as long as it exists; within another scope of the thread, that one's team is kept.
/// What films allocate by thread has the size of the team at their construction; used with a larger team, their loops
/// run on one thread.
class TeamScope {
public:
    explicit TeamScope(int threads);
    TeamScope(const TeamScope&) = delete;
    ~TeamScope();

private:
    std::optional<Team> team_;
};

/// work(j) for the rows of a grid, each by itself.
template <typename Work>
void forEachRow(int rows, const Work& work)
{
    Team::mine().items(rows, 24, 1, [&](int first, int end, int) {
        for (int j = first; j < end; ++j) work(j);
    });
}

/// How many threads a calculation that the calling thread begins takes by itself: all cores, or what setThreadShare()
/// gave this thread, as others compute beside it; and how many it may take where it is asked for more.
int threadShare();
int threadLimit();
void setThreadShare(int threads, int limit = Team::mostThreads);

} // namespace touchdown
