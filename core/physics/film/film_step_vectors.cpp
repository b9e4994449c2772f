// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_step_vectors.h"

#include <cmath>

#include "core/numerics/vector_clones.h"

namespace touchdown {

TOUCHDOWN_VECTOR_CLONES double product(std::span<const double> a, std::span<const double> b)
{
    return sumInLanes(a.size(), [&](std::size_t k) { return a[k] * b[k]; });
}

TOUCHDOWN_VECTOR_CLONES double unforeseenSquares(std::span<const double> change, std::span<const double> p,
                                                 std::span<const double> content, std::span<const double> volume)
{
    return sumInLanes(p.size(), [&](std::size_t k) {
        const double value = volume[k] > 0.0 ? p[k] + change[k] - content[k] / volume[k] : 0.0;
        return value * value;
    });
}

TOUCHDOWN_VECTOR_CLONES void setHistories(std::size_t count, const std::array<double, 3>& share, const double* volume,
                                          const double* content1, const double* content2, const double* content3,
                                          double* history)
{
    const auto [last, before, beforeThat] = share;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const double stored = last * content1[k] + before * content2[k] + beforeThat * content3[k];
        history[k] = volume[k] > 0.0 ? stored : 0.0;
    }
}

TOUCHDOWN_VECTOR_CLONES void extrapolate(std::size_t count, const std::array<double, 3>& parabola,
                                         const std::array<double, 4>& third,
                                         const std::array<const double*, 4>& content, const double* last,
                                         const double* volume, double* p, double* foreseen)
{
    const auto [m1, m2, m3, m4] = content;
    const auto [a1, a2, a3] = parabola;
    const auto [b1, b2, b3, b4] = third;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const double open = volume[k] > 0.0 ? 1.0 / volume[k] : 0.0;
        const double even = a1 * m1[k] + a2 * m2[k] + a3 * m3[k];
        const double guess = (even + (b1 * m1[k] + b2 * m2[k] + b3 * m3[k] + b4 * m4[k])) * open;
        const double least = 0.5 * last[k], most = 2.0 * last[k];
        const double raised = guess < least ? least : guess;
        p[k] = open > 0.0 ? (raised > most ? most : raised) : last[k];
        foreseen[k] = even;
    }
}

TOUCHDOWN_VECTOR_CLONES long long setContents(std::size_t count, const double* volume, const double* p,
                                              const double* before, double* pressure, double* content)
{
    long long closed = 0;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        pressure[k] = p[k];
        content[k] = volume[k] * p[k];
        closed += content[k] == 0.0 && before[k] > 0.0 ? 1 : 0;
    }
    return closed;
}

TOUCHDOWN_VECTOR_CLONES void scaleToVolumes(std::size_t count, const double* before, const double* now, double* change)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const double shrunk = std::sqrt(before[k] / (now[k] > 0.0 ? now[k] : before[k]));
        const double least = shrunk > 0.5 ? shrunk : 0.5;
        change[k] *= before[k] > 0.0 ? (least < 2.0 ? least : 2.0) : 1.0;
    }
}

TOUCHDOWN_VECTOR_CLONES void subtract(double part, const std::vector<double>& v, std::vector<double>& out)
{
    const double* from = v.data();
    double* to = out.data();
#pragma GCC ivdep
    for (std::size_t i = 0; i < v.size(); ++i) to[i] -= part * from[i];
}

} // namespace touchdown
