// SPDX-License-Identifier: GPL-3.0-or-later
//
// Samples on the disk that the system has dropped from memory.
#pragma once

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
        ::madvise(const_cast<double*>(stored.get()), numbers.size_bytes(), MADV_PAGEOUT);
        std::vector<unsigned char> present(numbers.size_bytes() / 4096 + 1, 1);
        cold = ::mincore(const_cast<double*>(stored.get()), numbers.size_bytes(), present.data()) == 0 &&
               (present[0] & 1U) == 0;
        data.values().replace(piece, stored);
    }
#endif
    return cold;
}

} // namespace touchdown
