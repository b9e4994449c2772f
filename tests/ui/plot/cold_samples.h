// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples on the disk that the system has dropped from memory.
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include <sys/mman.h>

#include <QTemporaryDir>

#include "ui/plot/min_max_pyramid.h"
#include "ui/style/unnamed_file.h"

namespace touchdown {

/// Moves the values to the disk. False if this system does not drop them from memory.
inline bool makeCold(MinMaxPyramid& data)
{
    bool cold = false;
#ifdef MADV_PAGEOUT
    const QTemporaryDir folder;
    for (std::size_t piece = 0; piece < data.values().pieces(); ++piece) {
        QString problem;
        const std::span<const double> numbers = data.values().piece(piece);
        const auto stored = toUnnamedFile(folder.path(), {numbers}, problem);
        if (!stored) return false;
        // A page must be mapped to be dropped.
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (stored[i] != numbers[i]) return false;
        std::vector<unsigned char> present(numbers.size_bytes() / 4096 + 1, 1);
        const auto dropped = [&] {
            return ::mincore(const_cast<double*>(stored.get()), numbers.size_bytes(), present.data()) == 0 &&
                   std::ranges::any_of(present, [](unsigned char each) { return (each & 1U) == 0; });
        };
        for (int attempt = 0; attempt < 20 && !dropped(); ++attempt) {
            ::madvise(const_cast<double*>(stored.get()), numbers.size_bytes(), MADV_PAGEOUT);
            if (!dropped()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        cold = dropped() || cold;
        data.values().replace(piece, stored);
    }
#endif
    return cold;
}

} // namespace touchdown
