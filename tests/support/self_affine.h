// SPDX-License-Identifier: GPL-3.0-or-later
//
// A random self-affine surface that repeats: Gaussian, power spectrum flat up to the roll-off, falling as k^-(2 + 2 H)
// up to the cut-off, zero beyond; isotropic.
#pragma once

#include <fftw3.h>

#include <cmath>
#include <mutex>
#include <numbers>
#include <random>
#include <vector>

#include "core/numerics/fourier.h"

namespace touchdown::test {

struct SelfAffine {
    int n = 0;            // n x n values on a square of side 1
    double rollOff = 4.0; // cycles on the side
    double cutOff = 0.0;  // cycles on the side
    double hurst = 0.8;
    double slope = 1.0; // RMS of |grad|
    unsigned seed = 1;
};

inline std::vector<double> selfAffineHeights(const SelfAffine& surface)
{
    const int n = surface.n;
    const int half = n / 2 + 1;
    std::vector<double> heights(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    fftw_complex* modes = fftw_alloc_complex(static_cast<std::size_t>(n) * static_cast<std::size_t>(half));
    std::mt19937_64 random(surface.seed);
    const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
    double slopeSquared = 0.0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < half; ++i) {
            const double cycles = std::hypot(i, j <= n / 2 ? j : j - n);
            const double size = std::sqrt(-2.0 * std::log(uniform()));
            const double phase = 2.0 * std::numbers::pi * uniform();
            // Column 0 holds both a mode and its conjugate: half of it is left out.
            const bool held = cycles > 0.0 && cycles <= surface.cutOff && 2 * i < n && (i > 0 || 2 * j < n);
            const double amplitude =
                held ? size * std::pow(std::max(cycles, surface.rollOff), -1.0 - surface.hurst) : 0.0;
            fftw_complex& mode = modes[j * half + i];
            mode[0] = amplitude * std::cos(phase);
            mode[1] = amplitude * std::sin(phase);
            const double k = 2.0 * std::numbers::pi * cycles;
            slopeSquared += 2.0 * k * k * amplitude * amplitude;
            if (i == 0 && j > n / 2) {
                mode[0] = modes[(n - j) * half][0];
                mode[1] = -modes[(n - j) * half][1];
            }
        }
    {
        const std::lock_guard lock(fourierPlanner());
        fftw_plan plan = fftw_plan_dft_c2r_2d(n, n, modes, heights.data(), FFTW_ESTIMATE);
        fftw_execute(plan);
        fftw_destroy_plan(plan);
        fftw_free(modes);
    }
    for (double& height : heights) height *= surface.slope / std::sqrt(slopeSquared);
    return heights;
}

} // namespace touchdown::test
