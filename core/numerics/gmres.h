// SPDX-License-Identifier: GPL-3.0-or-later
//
// Generalised minimal residuals (Saad & Schultz 1986) with preconditioning from the right, restarted; for real and complex
// unknowns. Vectors of any storage: what is outside the unknowns must stay zero.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace touchdown {

struct GmresOptions {
    double tolerance = 1e-3; // of the residual's norm, against that of the right-hand side [-]
    int maximumIterations = 60;
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
        : restart_(restart), basis_(static_cast<std::size_t>(restart) + 1, std::vector<T>(size)), work_(size), step_(size)
    {
    }

    /// Solves A x = b. `apply(v, out)`: out = A v; `precondition(v, out)`: out = approximately A^-1 v. x holds the first guess.
    template <typename Apply, typename Precondition>
    GmresResult solve(Apply&& apply, Precondition&& precondition, std::span<const T> b, std::span<T> x,
                      const GmresOptions& options)
    {
        const std::size_t n = work_.size();
        const double scale = norm(b);
        GmresResult result;
        if (!(scale > 0.0)) {
            std::fill(x.begin(), x.end(), T{});
            result.converged = true;
            return result;
        }
        const bool guess = std::any_of(x.begin(), x.end(), [](const T& value) { return value != T{}; });
        bool first = !guess;
        while (true) {
            std::vector<T>& v0 = basis_[0];
            if (first) std::copy(b.begin(), b.end(), v0.begin());
            else {
                apply(std::span<const T>(x.data(), n), std::span<T>(v0));
                for (std::size_t i = 0; i < n; ++i) v0[i] = b[i] - v0[i];
            }
            first = false;
            const double start = norm(v0);
            result.residual = start / scale;
            result.converged = result.residual <= options.tolerance;
            if (result.converged || result.iterations >= options.maximumIterations || !std::isfinite(start)) return result;
            for (T& value : v0) value /= start;
            const std::size_t used = expand(apply, precondition, start, scale, options, result);
            combine(precondition, used, x);
            if (used == 0) return result;
        }
    }

private:
    static double norm(std::span<const T> v)
    {
        double sum = 0.0;
        for (const T& value : v) sum += std::norm(value);
        return std::sqrt(sum);
    }
    static T conjugate(const T& value)
    {
        if constexpr (std::is_same_v<T, double>) return value;
        else return std::conj(value);
    }

    /// Arnoldi with Givens rotations, until the residual is small; the number of basis vectors used.
    template <typename Apply, typename Precondition>
    std::size_t expand(Apply& apply, Precondition& precondition, double start, double scale, const GmresOptions& options,
                       GmresResult& result)
    {
        const std::size_t m = static_cast<std::size_t>(restart_);
        hessenberg_.assign(m * (m + 1), T{});
        cosine_.assign(m, T{});
        sine_.assign(m, T{});
        right_.assign(m + 1, T{});
        right_[0] = start;
        std::size_t k = 0;
        while (k < m && result.iterations < options.maximumIterations) {
            precondition(std::span<const T>(basis_[k]), std::span<T>(work_));
            std::vector<T>& next = basis_[k + 1];
            apply(std::span<const T>(work_), std::span<T>(next));
            ++result.iterations;
            const auto h = [&](std::size_t row) -> T& { return hessenberg_[k * (m + 1) + row]; };
            for (std::size_t j = 0; j <= k; ++j) {
                T product{};
                for (std::size_t i = 0; i < next.size(); ++i) product += conjugate(basis_[j][i]) * next[i];
                h(j) = product;
                for (std::size_t i = 0; i < next.size(); ++i) next[i] -= product * basis_[j][i];
            }
            const double length = norm(next);
            h(k + 1) = length;
            if (length > 0.0)
                for (T& value : next) value /= length;
            for (std::size_t j = 0; j < k; ++j) rotate(j, h(j), h(j + 1));
            const double size = std::sqrt(std::norm(h(k)) + length * length);
            if (!(size > 0.0)) return k;
            cosine_[k] = h(k) / size;
            sine_[k] = length / size;
            h(k) = size;
            right_[k + 1] = -sine_[k] * right_[k];
            right_[k] = conjugate(cosine_[k]) * right_[k];
            ++k;
            if (std::abs(right_[k]) <= options.tolerance * scale || length == 0.0) break;
        }
        return k;
    }

    void rotate(std::size_t j, T& above, T& below) const
    {
        const T old = above;
        above = conjugate(cosine_[j]) * old + sine_[j] * below;
        below = -sine_[j] * old + cosine_[j] * below;
    }

    /// x += M^-1 (basis times the least-squares solution).
    template <typename Precondition>
    void combine(Precondition& precondition, std::size_t used, std::span<T> x)
    {
        if (used == 0) return;
        const std::size_t m = static_cast<std::size_t>(restart_);
        std::fill(step_.begin(), step_.end(), T{});
        for (std::size_t k = used; k-- > 0;) {
            T value = right_[k];
            for (std::size_t j = k + 1; j < used; ++j) value -= hessenberg_[j * (m + 1) + k] * right_[j];
            right_[k] = value / hessenberg_[k * (m + 1) + k];
        }
        for (std::size_t k = 0; k < used; ++k)
            for (std::size_t i = 0; i < step_.size(); ++i) step_[i] += right_[k] * basis_[k][i];
        precondition(std::span<const T>(step_), std::span<T>(work_));
        for (std::size_t i = 0; i < work_.size(); ++i) x[i] += work_[i];
    }

    int restart_;
    std::vector<std::vector<T>> basis_;
    std::vector<T> work_, step_, hessenberg_, cosine_, sine_, right_;
};

} // namespace touchdown
