// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops over long vectors on a team. Sums are formed in blocks of a fixed length, added in order, so that the result
// does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/work/team.h"

namespace touchdown {

/// Sum of sum(first, number) over blocks.
template <typename Sum>
auto sumOfBlocks(std::size_t count, const Sum& sum) -> decltype(sum(count, count))
{
    constexpr std::size_t least = 4096, most = 512;
    const std::size_t length = std::max(least, (count / most / 64 + 1) * 64);
    std::array<decltype(sum(count, count)), most> part;
    const int blocks = static_cast<int>((count + length - 1) / length);
    if (blocks <= 1) return sum(0, count);
    Team::mine().items(blocks, 2, 1, [&](int begin, int end, int) {
        for (std::size_t b = static_cast<std::size_t>(begin); b < static_cast<std::size_t>(end); ++b)
            part[b] = sum(b * length, std::min(length, count - b * length));
    });
    auto total = part[0];
    for (int b = 1; b < blocks; ++b) total += part[static_cast<std::size_t>(b)];
    return total;
}

/// work(first, number) on blocks of numbers. Each number must be found in the same way wherever its block begins.
template <typename Work>
void inBlocks(std::size_t count, const Work& work)
{
    Team::mine().items(static_cast<int>(count), 8192, 64, [&](int first, int end, int) {
        work(static_cast<std::size_t>(first), static_cast<std::size_t>(end - first));
    });
}

} // namespace touchdown
