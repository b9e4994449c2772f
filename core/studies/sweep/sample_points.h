// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points that fill a unit cube of a few dimensions, the same for the same seed on any machine.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace touchdown {

enum class SampleMethod : std::uint8_t {
    Random,         // independent
    LatinHypercube, // each of `count` equal slices of each axis holds one point (McKay, Beckman & Conover 1979)
    Sobol           // of low discrepancy (Sobol 1967), shifted at random modulo 1 (Cranley & Patterson 1976)
};
inline std::string_view name(SampleMethod method)
{
    constexpr std::array<std::string_view, 3> names{"random", "latin-hypercube", "sobol"};
    return names[static_cast<std::size_t>(method)];
}

/// `count` points of `dimensions` coordinates each, in [0, 1). Those of Random and Sobol are the first ones of a longer
/// list with the same seed.
std::vector<std::vector<double>> samplePoints(SampleMethod method, std::size_t dimensions, std::size_t count,
                                              std::uint64_t seed);

/// The value below which a normally distributed number of mean 0 and standard deviation 1 lies with this probability,
/// which is in (0, 1).
double normalQuantile(double probability);

} // namespace touchdown
