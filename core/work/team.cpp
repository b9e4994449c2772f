// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/work/team.h"

#include <bit>
#include <new>
#include <system_error>
#include <utility>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace touchdown {

namespace {

// Pauses, some 40 ns each. A thread that yields to another program is away for milliseconds.
constexpr int longestWait = 50000; // for a block that another has begun, before the calling thread yields
constexpr int longestIdle = 10000; // of a worker, before it sleeps
/// Before the calling thread takes a block of a worker's share that was there for the last loop: some 3 us. A block
/// done elsewhere costs more than that, as its numbers then lie in the wrong cache.
constexpr int patience = 60;
constexpr int loopsPerLook = 64; // at the time

thread_local Team* ownTeam = nullptr;
thread_local int ownShare = 0; // 0: all cores
thread_local int ownLimit = Team::mostThreads;

void pauseBriefly()
{
#if defined(__x86_64__)
    _mm_pause();
#endif
}

/// The first block from `first` on, or from none on, that none has taken.
int nextOf(std::uint64_t state, int first)
{
    const std::uint32_t left = static_cast<std::uint32_t>(state), own = left >> first << first;
    return std::countr_zero(own != 0 ? own : left);
}
bool hasBlocks(std::uint64_t state) { return static_cast<std::uint32_t>(state) != 0; }

} // namespace

Team::Team(int size) : size_(std::clamp(size, 1, mostThreads)), gain_(TeamGain::now())
{
    const int wanted = size_;
    threads_.reserve(static_cast<std::size_t>(wanted));
    try {
        for (int k = 1; k < wanted; ++k) threads_.emplace_back([this, k] { serve(k); });
    } catch (const std::system_error&) { // no more threads: those that are there take all blocks
        if (threads_.empty()) size_ = 1;
    } catch (const std::bad_alloc&) {
        if (threads_.empty()) size_ = 1;
    }
}

Team::~Team()
{
    stop_ = true;
    bell_.fetch_add(1);
    bell_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

Team& Team::mine()
{
    static Team alone(1); // its loops change nothing in it
    return ownTeam ? *ownTeam : alone;
}

void Team::share(int blocks, Call call, const void* what)
{
    inside_ = true;
    begin(blocks, call, what);
    for (int b = take(blocks); b >= 0; b = take(blocks)) perform(call, what, b, 0);
    end(blocks);
    inside_ = false;
    if (!failed_.load(std::memory_order_relaxed)) return;
    failed_ = false;
    std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Team::perform(Call call, const void* what, int block, int thread)
{
    try {
        call(what, block, thread);
    } catch (...) {
        if (!failed_.exchange(true)) failure_ = std::current_exception();
    }
    done_.fetch_add(1, std::memory_order_release); // the calling thread sees all of it
}

void Team::begin(int blocks, Call call, const void* what)
{
    call_.store(call, std::memory_order_relaxed);
    what_.store(what, std::memory_order_relaxed);
    done_.store(0, std::memory_order_relaxed);
    const std::uint64_t loop = (state_.load(std::memory_order_relaxed) >> 32) + 1;
    blocks_.store(blocks, std::memory_order_relaxed);
    state_.store(loop << 32 | (~std::uint64_t{0} >> (64 - blocks))); // in one order with sleepers_
    if (sleepers_.load() == 0) return;
    bell_.fetch_add(1);
    bell_.notify_all();
}

int Team::take(int blocks)
{
    std::uint64_t state = state_.load(std::memory_order_relaxed);
    const int own = (blocks + size_ - 1) / size_;
    if (hasBlocks(state) && nextOf(state, 0) >= own && present_.load(std::memory_order_relaxed)) {
        for (int k = 0; k < patience && hasBlocks(state); ++k) {
            pauseBriefly();
            state = state_.load(std::memory_order_relaxed);
        }
        if (hasBlocks(state)) present_.store(false, std::memory_order_relaxed);
    }
    while (hasBlocks(state)) {
        const int block = nextOf(state, 0);
        if (state_.compare_exchange_weak(state, state & ~(std::uint64_t{1} << block), std::memory_order_relaxed))
            return block;
    }
    return -1;
}

void Team::end(int blocks)
{
    for (int k = 0; done_.load(std::memory_order_acquire) != blocks; ++k)
        if (k < longestWait)
            pauseBriefly();
        else
            std::this_thread::yield();
}

void Team::countLoop()
{
    if (!gain_.measures() && ++untimed_ < loopsPerLook) return;
    untimed_ = 0;
    gain_.look(TeamGain::now());
    together_ = gain_.together();
}

void Team::serve(int index)
{
    for (int idle = 0; !stop_.load(std::memory_order_relaxed);) {
        std::uint64_t state = state_.load(std::memory_order_acquire);
        if (hasBlocks(state)) {
            const Call call = call_.load(std::memory_order_relaxed);
            const void* what = what_.load(std::memory_order_relaxed);
            const int block = nextOf(state, index * blocks_.load(std::memory_order_relaxed) / size_ & 31);
            // Fails where another was faster, or where the loop has ended since.
            if (state_.compare_exchange_weak(state, state & ~(std::uint64_t{1} << block), std::memory_order_acq_rel)) {
                present_.store(true, std::memory_order_relaxed);
                perform(call, what, block, index);
            }
            idle = 0;
        } else if (++idle < longestIdle) {
            pauseBriefly();
        } else {
            const unsigned rung = bell_.load();
            sleepers_.fetch_add(1);
            state = state_.load();
            if (!hasBlocks(state) && !stop_.load()) bell_.wait(rung);
            sleepers_.fetch_sub(1);
            idle = 0;
        }
    }
}

TeamScope::TeamScope(int threads)
{
    if (ownTeam || threads <= 1) return;
    team_.emplace(threads);
    ownTeam = &*team_;
}

TeamScope::~TeamScope()
{
    if (team_) ownTeam = nullptr;
}

int threadShare()
{
    return ownShare > 0 ? ownShare : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int threadLimit() { return ownLimit; }

void setThreadShare(int threads, int limit)
{
    ownShare = std::max(1, threads);
    ownLimit = std::max(1, limit);
}

} // namespace touchdown
