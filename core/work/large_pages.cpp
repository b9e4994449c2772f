// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/work/large_pages.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#if defined(__GLIBC__) && defined(__linux__)
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace touchdown {

void preferLargePages([[maybe_unused]] std::size_t bytes)
{
#if defined(__GLIBC__) && defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::size_t page = std::size_t{2} << 20, most = std::size_t{1} << 30;
    constexpr int largestInHeap = 32 << 20; // the most that the library allows [B]
    if (bytes < page) return;
    bytes = std::min(bytes, most);
    // Fields come from the heap and stay in it. The heap grows at once by what will be needed.
    mallopt(M_MMAP_THRESHOLD, largestInHeap);
    mallopt(M_TRIM_THRESHOLD, static_cast<int>(most));
    mallopt(M_TOP_PAD, static_cast<int>(bytes));
    const auto heapEnd = [] { return reinterpret_cast<std::uintptr_t>(sbrk(0)); };
    const std::uintptr_t before = heapEnd();
    void* volatile grown = std::malloc(page); // more than what is left of the heap at the start of a program
    if (heapEnd() > before) {
        const std::uintptr_t first = (before + page - 1) / page * page, end = heapEnd() / page * page;
        if (end > first) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
    }
    std::free(grown);
    mallopt(M_TOP_PAD, 128 << 10); // as before
#endif
}

} // namespace touchdown
