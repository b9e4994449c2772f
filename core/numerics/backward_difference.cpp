// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/backward_difference.h"

#include <cmath>
#include <complex>
#include <cstddef>
#include <span>

namespace touchdown {

namespace {

using Complex = std::complex<double>;

constexpr double thirdShare = 0.48;                  // of what BDF3 adds to BDF2 (Vatsa, Carpenter & Lockard 2010)
constexpr double mostGrowthForThird = 1.5;           // of a step against the last one
constexpr double leastPhase = 0.02, mostPhase = 1.3; // omega dt

bool canFit(double dt, double h1, double h2, double rate)
{
    const auto alike = [](double a, double b) {
        return a > 0.0 && b > 0.0 && a <= mostChangeForFit * b && b <= mostChangeForFit * a;
    };
    return rate * dt >= leastPhase && rate * dt <= mostPhase && alike(dt, h1) && alike(h1, h2);
}

/// A term of Newton's polynomial: a multiple of the divided difference of the first values.
struct Term {
    std::array<double, 4> weight{}; // of each value
    Complex ofWave{};               // its value for exp(i omega t)
};

Term newtonTerm(double factor, std::span<const double> times, double rate)
{
    Term term;
    for (std::size_t j = 0; j < times.size(); ++j) {
        double weight = factor;
        for (std::size_t i = 0; i < times.size(); ++i)
            if (i != j) weight /= times[j] - times[i];
        term.weight[j] = weight;
        term.ofWave += weight * std::polar(1.0, rate * times[j]);
    }
    return term;
}

/// Weights of the values in `fixed` + a `second` + b `third`, a and b real such that the sum is `wanted` for the wave.
std::array<double, 4> fittedSum(const Term& fixed, const Term& second, const Term& third, Complex wanted)
{
    const auto cross = [](Complex u, Complex v) { return u.real() * v.imag() - u.imag() * v.real(); };
    const Complex rest = wanted - fixed.ofWave;
    const double determinant = cross(second.ofWave, third.ofWave);
    const double a = cross(rest, third.ofWave) / determinant, b = cross(second.ofWave, rest) / determinant;
    std::array<double, 4> sum{};
    for (std::size_t j = 0; j < sum.size(); ++j) sum[j] = fixed.weight[j] + a * second.weight[j] + b * third.weight[j];
    return sum;
}

BackwardDifference fitted(double dt, double h1, double h2, double rate)
{
    const std::array<double, 4> times{0.0, -dt, -dt - h1, -dt - h1 - h2}; // from the end of the step
    const auto term = [&](std::size_t order, double factor) {
        return newtonTerm(factor, std::span(times).first(order + 1), rate);
    };
    const std::array<double, 4> sum = fittedSum(term(1, 1.0), term(2, dt), term(3, dt * (dt + h1)), Complex(0.0, rate));
    return {.perTime = sum[0], .share = {-sum[1], -sum[2], -sum[3]}, .taken = thirdShare, .fitted = true};
}

} // namespace

BackwardDifference backwardDifference(BackwardRule rule, double dt, double h1, double h2, double rate)
{
    if (rule == BackwardRule::Fitted && canFit(dt, h1, h2, rate)) return fitted(dt, h1, h2, rate);
    const bool second = rule != BackwardRule::Euler && h1 > 0.0;
    const bool third = second && rule != BackwardRule::Bdf2 && h2 > 0.0 && dt <= mostGrowthForThird * h1 &&
                       h1 <= mostGrowthForThird * h2;
    const double r = second ? dt / h1 : 0.0; // r = 0 is Euler
    BackwardDifference result;
    result.perTime = (1.0 + 2.0 * r) / (1.0 + r) / dt;
    result.share = {(1.0 + r) / dt, -r * r / (1.0 + r) / dt, 0.0};
    if (third) {
        // Of dt (t - t2) f[t, t1, t2, t3] the parts of m and m1..m3.
        const double factor = thirdShare * dt * (dt + h1), all = dt + h1 + h2;
        result.perTime += factor / (dt * (dt + h1) * all);
        result.share[0] += factor / (dt * h1 * (h1 + h2));
        result.share[1] -= factor / ((dt + h1) * h1 * h2);
        result.share[2] += factor / (all * (h1 + h2) * h2);
        result.taken = thirdShare;
    }
    return result;
}

std::optional<std::array<double, 4>> fittedForecast(double dt, double h1, double h2, double h3, double rate)
{
    if (!canFit(dt, h1, h2, rate) || !canFit(h1, h2, h3, rate)) return std::nullopt;
    const std::array<double, 4> times{-dt, -dt - h1, -dt - h1 - h2, -dt - h1 - h2 - h3};
    const auto term = [&](std::size_t order, double factor) {
        return newtonTerm(factor, std::span(times).first(order + 1), rate);
    };
    Term line = term(0, 1.0);
    const Term slope = term(1, dt);
    for (std::size_t j = 0; j < 2; ++j) line.weight[j] += slope.weight[j];
    line.ofWave += slope.ofWave;
    const double second = dt * (dt + h1);
    return fittedSum(line, term(2, second), term(3, second * (dt + h1 + h2)), 1.0);
}

} // namespace touchdown
