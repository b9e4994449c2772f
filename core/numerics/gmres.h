// SPDX-License-Identifier: GPL-3.0-or-later
//
// Generalised minimal residuals (Saad & Schultz 1986) with preconditioning from the right, restarted as long as
// the iterations allowed may do; for real and complex unknowns. The preconditioned vectors are kept (Saad 1993).
// Entries of the vectors that are no unknowns, as the rings of padded arrays, must stay zero.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/numerics/vector_clones.h"
#include "core/work/block_sums.h"

namespace touchdown {

struct GmresOptions {
    double tolerance = 1e-3; // of the residual's norm, against that of the right-hand side [-]
    int maximumIterations = 60;
    std::function<bool()> goOn{}; // asked at each iteration; false ends the solution
};
struct GmresResult {
    int iterations = 0;
    double residual = 0.0; // reached [-]
    bool converged = false;
};

template <typename T>
class Gmres {
public:
    /// `size` of the vectors; restarts after `restart` iterations.
    explicit Gmres(std::size_t size, int restart = 20)
        : size_(size),
          restart_(restart),
          basis_(static_cast<std::size_t>(restart) + 1),
          preconditioned_(basis_.size() - 1)
    {
        // Not initialised: the system provides memory only when it is first written.
        for (auto* vectors : {&basis_, &preconditioned_})
            for (auto& vector : *vectors) vector = std::make_unique_for_overwrite<T[]>(size);
        const std::size_t m = static_cast<std::size_t>(restart);
        hessenberg_.resize(m * (m + 1));
        for (auto* column : {&cosine_, &sine_}) column->resize(m);
        right_.resize(m + 1);
    }

    /// Solves A x = b from the guess x. `apply(v, out)`: out = A v; `precondition(v, out)`: out = about A^-1 v.
    template <typename Apply, typename Precondition>
    GmresResult solve(Apply&& apply, Precondition&& precondition, std::span<const T> b, std::span<T> x,
                      const GmresOptions& options)
    {
        const std::size_t n = size_;
        const double scale = norm(b);
        GmresResult result;
        if (!(scale > 0.0)) {
            std::fill(x.begin(), x.end(), T{});
            result.converged = true;
            return result;
        }
        const bool guess = std::any_of(x.begin(), x.end(), [](const T& value) { return value != T{}; });
        bool first = !guess, stopped = false, isWholeCycle = false;
        double last = 0.0; // residual before the last cycle
        while (true) {
            const std::span<T> v0 = basis(0);
            if (first)
                inBlocks(n, [&](std::size_t k, std::size_t count) { std::copy_n(&b[k], count, &v0[k]); });
            else {
                apply(std::span<const T>(x.data(), n), v0);
                inBlocks(n, [&](std::size_t k, std::size_t count) {
                    for (std::size_t i = k; i < k + count; ++i) v0[i] = b[i] - v0[i];
                });
            }
            first = false;
            const double start = norm(v0);
            result.residual = start / scale;
            result.converged = result.residual <= options.tolerance;
            if (result.converged || stopped || result.iterations >= options.maximumIterations || !std::isfinite(start))
                return result;
            // At the rate of the last cycle the iterations left would not do.
            const int cyclesLeft = (options.maximumIterations - result.iterations + restart_ - 1) / restart_;
            if (isWholeCycle && start * std::pow(start / last, cyclesLeft) > options.tolerance * scale) return result;
            last = start;
            scaleBy(v0, 1.0 / start);
            const std::size_t used = expand(apply, precondition, start, scale, options, result, stopped);
            combine(used, x);
            isWholeCycle = used == static_cast<std::size_t>(restart_);
            if (used == 0) return result;
        }
    }

private:
    std::span<T> basis(std::size_t k)
    {
        const auto clear = [this](T* v) {
            inBlocks(size_, [v](std::size_t first, std::size_t count) { std::fill_n(v + first, count, T{}); });
        };
        for (; cleared_ <= k; ++cleared_) {
            clear(basis_[cleared_].get());
            if (cleared_ < preconditioned_.size()) clear(preconditioned_[cleared_].get());
        }
        return {basis_[k].get(), size_};
    }

    static void scaleBy(std::span<T> v, double factor)
    {
        inBlocks(v.size(), [&](std::size_t first, std::size_t count) {
            for (T& value : v.subspan(first, count)) value *= factor;
        });
    }
    static double norm(std::span<const T> v) { return std::sqrt(std::abs(product(v, v))); }
    /// Scalar product of the conjugate of a with b.
    static T product(std::span<const T> a, std::span<const T> b)
    {
        return sumOfBlocks(a.size(), [&](std::size_t first, std::size_t count) {
            return sumInLanes(count, [&](std::size_t i) { return conjugate(a[first + i]) * b[first + i]; });
        });
    }
    static T conjugate(const T& value)
    {
        if constexpr (std::is_same_v<T, double>)
            return value;
        else
            return std::conj(value);
    }

    /// Arnoldi with Givens rotations, until the residual is small; the number of basis vectors used.
    template <typename Apply, typename Precondition>
    std::size_t expand(Apply& apply, Precondition& precondition, double start, double scale,
                       const GmresOptions& options, GmresResult& result, bool& stopped)
    {
        const std::size_t m = static_cast<std::size_t>(restart_);
        for (auto* field : {&hessenberg_, &cosine_, &sine_, &right_}) std::fill(field->begin(), field->end(), T{});
        right_[0] = start;
        std::size_t k = 0;
        while (k < m && result.iterations < options.maximumIterations && !stopped) {
            const std::span<T> next = basis(k + 1), direction(preconditioned_[k].get(), size_);
            precondition(std::span<const T>(basis(k)), direction);
            apply(std::span<const T>(direction), next);
            ++result.iterations;
            const auto h = [&](std::size_t row) -> T& { return hessenberg_[k * (m + 1) + row]; };
            for (std::size_t j = 0; j <= k; ++j) {
                const T part = h(j) = product(basis(j), next);
                const T* old = basis_[j].get();
                inBlocks(next.size(), [&](std::size_t first, std::size_t count) {
                    for (std::size_t i = first; i < first + count; ++i) next[i] -= part * old[i];
                });
            }
            const double length = norm(next);
            h(k + 1) = length;
            double column = length * length; // |A M^-1 v|^2
            for (std::size_t j = 0; j <= k; ++j) column += std::norm(h(j));
            for (std::size_t j = 0; j < k; ++j) rotate(j, h(j), h(j + 1));
            const double size = std::sqrt(std::norm(h(k)) + length * length);
            if (!(size > 1e-14 * std::sqrt(column))) return k; // singular, but for rounding
            cosine_[k] = h(k) / size;
            sine_[k] = length / size;
            h(k) = size;
            right_[k + 1] = -sine_[k] * right_[k];
            right_[k] = conjugate(cosine_[k]) * right_[k];
            ++k;
            if (std::abs(right_[k]) <= options.tolerance * scale || length == 0.0) break;
            stopped = options.goOn && !options.goOn();
            scaleBy(next, 1.0 / length);
        }
        return k;
    }

    void rotate(std::size_t j, T& above, T& below) const
    {
        const T old = above;
        above = conjugate(cosine_[j]) * old + sine_[j] * below;
        below = -sine_[j] * old + cosine_[j] * below;
    }

    /// x += preconditioned basis times the least-squares solution.
    void combine(std::size_t used, std::span<T> x)
    {
        const std::size_t m = static_cast<std::size_t>(restart_);
        for (std::size_t k = used; k-- > 0;) {
            T value = right_[k];
            for (std::size_t j = k + 1; j < used; ++j) value -= hessenberg_[j * (m + 1) + k] * right_[j];
            right_[k] = value / hessenberg_[k * (m + 1) + k];
        }
        for (std::size_t k = 0; k < used; ++k) {
            const T part = right_[k];
            const T* direction = preconditioned_[k].get();
            inBlocks(size_, [&](std::size_t first, std::size_t count) {
                for (std::size_t i = first; i < first + count; ++i) x[i] += part * direction[i];
            });
        }
    }

    std::size_t size_;
    int restart_;
    std::vector<std::unique_ptr<T[]>> basis_, preconditioned_;
    std::size_t cleared_ = 0; // vectors of the basis that have been set to zero once
    std::vector<T> hessenberg_, cosine_, sine_, right_;
};

} // namespace touchdown
