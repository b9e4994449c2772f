// SPDX-License-Identifier: GPL-3.0-or-later
//
// A number with its derivatives by N variables, carried along by the chain rule (forward automatic differentiation).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace touchdown {

template <std::size_t N>
struct Dual {
    double value = 0.0;
    std::array<double, N> by{};

    Dual() = default;
    Dual(double constant) : value(constant) {}
    /// The variable number `index`.
    static Dual variable(double value, std::size_t index)
    {
        Dual result(value);
        result.by[index] = 1.0;
        return result;
    }
    /// f(*this) from f and f' at `value`.
    Dual chain(double f, double slope) const
    {
        Dual result(f);
        for (std::size_t k = 0; k < N; ++k) result.by[k] = slope * by[k];
        return result;
    }

    Dual& operator+=(const Dual& b)
    {
        value += b.value;
        for (std::size_t k = 0; k < N; ++k) by[k] += b.by[k];
        return *this;
    }
    friend Dual operator+(Dual a, const Dual& b) { return a += b; }
    friend Dual operator-(const Dual& a) { return a.chain(-a.value, -1.0); }
    friend Dual operator-(Dual a, const Dual& b)
    {
        a.value -= b.value;
        for (std::size_t k = 0; k < N; ++k) a.by[k] -= b.by[k];
        return a;
    }
    friend Dual operator*(const Dual& a, const Dual& b)
    {
        Dual result(a.value * b.value);
        for (std::size_t k = 0; k < N; ++k) result.by[k] = a.by[k] * b.value + a.value * b.by[k];
        return result;
    }
    friend Dual operator*(double a, const Dual& b) { return b.chain(a * b.value, a); }
    friend Dual operator/(double a, const Dual& b)
    {
        const double inverse = 1.0 / b.value, value = a * inverse;
        return b.chain(value, -value * inverse);
    }
    friend Dual operator/(const Dual& a, const Dual& b)
    {
        const double inverse = 1.0 / b.value;
        Dual result(a.value * inverse);
        for (std::size_t k = 0; k < N; ++k) result.by[k] = (a.by[k] - result.value * b.by[k]) * inverse;
        return result;
    }
    friend Dual exp(const Dual& a)
    {
        const double e = std::exp(a.value);
        return a.chain(e, e);
    }
};

inline double valueOf(double number) { return number; }
template <std::size_t N>
double valueOf(const Dual<N>& number)
{
    return number.value;
}

/// condition ? a : b for the value and each derivative, so that loops with it run on vectors.
inline double select(bool condition, double a, double b) { return condition ? a : b; }
template <std::size_t N>
Dual<N> select(bool condition, const Dual<N>& a, const Dual<N>& b)
{
    Dual<N> result(condition ? a.value : b.value);
    for (std::size_t k = 0; k < N; ++k) result.by[k] = condition ? a.by[k] : b.by[k];
    return result;
}

template <typename Number>
inline constexpr std::size_t derivatives = 0;
template <std::size_t N>
inline constexpr std::size_t derivatives<Dual<N>> = N;

/// Numbers side by side, part by part, as loops on vectors need them.
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
