// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_step_vectors.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/film_newton.h"
#include "core/work/block_sums.h"

namespace touchdown {

namespace {

TOUCHDOWN_VECTOR_CLONES double productPart(std::size_t count, const double* a, const double* b)
{
    return sumInLanes(count, [&](std::size_t k) { return a[k] * b[k]; });
}

TOUCHDOWN_VECTOR_CLONES double unforeseenPart(std::size_t count, const double* change, const double* p,
                                              const double* content, const double* volume)
{
    return sumInLanes(count, [&](std::size_t k) {
        const double value = volume[k] > 0.0 ? p[k] + change[k] - content[k] / volume[k] : 0.0;
        return value * value;
    });
}

TOUCHDOWN_VECTOR_CLONES void followPart(std::size_t count, const std::array<const double*, 3>& responses,
                                        const std::array<double, 3>& dq, double* change)
{
    const auto [r0, r1, r2] = responses;
    const auto [q0, q1, q2] = dq;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) change[k] = -(r0[k] * q0 + r1[k] * q1 + r2[k] * q2);
}

TOUCHDOWN_VECTOR_CLONES void historiesPart(std::size_t count, const std::array<double, 3>& share, const double* volume,
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

TOUCHDOWN_VECTOR_CLONES void extrapolatePart(std::size_t count, const std::array<double, 3>& parabola,
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

TOUCHDOWN_VECTOR_CLONES long long contentsPart(std::size_t count, const double* volume, const double* p,
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

TOUCHDOWN_VECTOR_CLONES void scalePart(std::size_t count, const double* before, const double* now, double* change)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const double shrunk = std::sqrt(before[k] / (now[k] > 0.0 ? now[k] : before[k]));
        const double least = shrunk > 0.5 ? shrunk : 0.5;
        change[k] *= before[k] > 0.0 ? (least < 2.0 ? least : 2.0) : 1.0;
    }
}

TOUCHDOWN_VECTOR_CLONES void subtractPart(std::size_t count, double part, const double* from, double* to)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) to[i] -= part * from[i];
}

TOUCHDOWN_VECTOR_CLONES void negatePart(std::size_t count, const double* from, double* to)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) to[i] = -from[i];
}

TOUCHDOWN_VECTOR_CLONES void leavePart(std::size_t count, const double* residual, double* image)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) image[i] = -residual[i] - image[i];
}

TOUCHDOWN_VECTOR_CLONES void boundedPart(std::size_t count, const double* step, double* p)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const double value = p[i] + step[i], least = p[i] / 3.0, most = 3.0 * p[i];
        p[i] = value < least ? least : (most < value ? most : value);
    }
}

} // namespace

double product(std::span<const double> a, std::span<const double> b)
{
    return sumOfBlocks(a.size(), [&](std::size_t at, std::size_t n) { return productPart(n, &a[at], &b[at]); });
}

double unforeseenSquares(std::span<const double> change, std::span<const double> p, std::span<const double> content,
                         std::span<const double> volume)
{
    return sumOfBlocks(p.size(), [&](std::size_t at, std::size_t n) {
        return unforeseenPart(n, &change[at], &p[at], &content[at], &volume[at]);
    });
}

void setChange(const std::array<const double*, 3>& responses, const std::array<double, 3>& dq, std::span<double> change)
{
    inBlocks(change.size(), [&](std::size_t at, std::size_t n) {
        followPart(n, {responses[0] + at, responses[1] + at, responses[2] + at}, dq, &change[at]);
    });
}

void clearAll(std::span<double> v)
{
    inBlocks(v.size(), [&](std::size_t at, std::size_t n) { std::fill_n(&v[at], n, 0.0); });
}

void copyAll(std::span<const double> from, std::span<double> to)
{
    inBlocks(from.size(), [&](std::size_t at, std::size_t n) { std::copy_n(&from[at], n, &to[at]); });
}

void setHistories(std::size_t count, const std::array<double, 3>& share, const double* volume, const double* content1,
                  const double* content2, const double* content3, double* history)
{
    inBlocks(count, [&](std::size_t at, std::size_t n) {
        historiesPart(n, share, volume + at, content1 + at, content2 + at, content3 + at, history + at);
    });
}

void extrapolate(std::size_t count, const std::array<double, 3>& parabola, const std::array<double, 4>& third,
                 const std::array<const double*, 4>& content, const double* last, const double* volume, double* p,
                 double* foreseen)
{
    inBlocks(count, [&](std::size_t at, std::size_t n) {
        extrapolatePart(n, parabola, third, {content[0] + at, content[1] + at, content[2] + at, content[3] + at},
                        last + at, volume + at, p + at, foreseen + at);
    });
}

long long setContents(std::size_t count, const double* volume, const double* p, const double* before, double* pressure,
                      double* content)
{
    std::atomic<long long> closed{0};
    inBlocks(count, [&](std::size_t at, std::size_t n) {
        closed += contentsPart(n, volume + at, p + at, before + at, pressure + at, content + at);
    });
    return closed;
}

void scaleToVolumes(std::size_t count, const double* before, const double* now, double* change)
{
    inBlocks(count, [&](std::size_t at, std::size_t n) { scalePart(n, before + at, now + at, change + at); });
}

void subtract(double part, const std::vector<double>& v, std::vector<double>& out)
{
    inBlocks(v.size(), [&](std::size_t at, std::size_t n) { subtractPart(n, part, v.data() + at, out.data() + at); });
}

void setNegative(std::span<const double> v, std::span<double> out)
{
    inBlocks(v.size(), [&](std::size_t at, std::size_t n) { negatePart(n, v.data() + at, out.data() + at); });
}

void setLeft(std::span<const double> residual, std::span<double> image)
{
    inBlocks(residual.size(),
             [&](std::size_t at, std::size_t n) { leavePart(n, residual.data() + at, image.data() + at); });
}

void addBounded(std::span<double> p, std::span<const double> step)
{
    inBlocks(p.size(), [&](std::size_t at, std::size_t n) { boundedPart(n, step.data() + at, p.data() + at); });
}

} // namespace touchdown
