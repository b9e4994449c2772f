// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers with derivatives side by side, part by part, as loops on vectors need them.
#pragma once

#include <cstddef>

#include "core/numerics/dual.h"

namespace touchdown {

template <typename Number>
inline constexpr std::size_t derivatives = 0;
template <std::size_t N>
inline constexpr std::size_t derivatives<Dual<N>> = N;

/// Numbers side by side, part by part.
template <typename Number>
struct Lanes {
    static constexpr std::size_t parts = 1 + derivatives<Number>;
    double* part[parts];

    Lanes(double* first, std::size_t apart)
    {
        for (std::size_t n = 0; n < parts; ++n) part[n] = first + n * apart;
    }
    Number get(std::size_t k) const
    {
        Number number(part[0][k]);
        if constexpr (parts > 1)
            for (std::size_t n = 1; n < parts; ++n) number.by[n - 1] = part[n][k];
        return number;
    }
    void set(std::size_t k, const Number& number) const
    {
        part[0][k] = valueOf(number);
        if constexpr (parts > 1)
            for (std::size_t n = 1; n < parts; ++n) part[n][k] = number.by[n - 1];
    }
};

} // namespace touchdown
