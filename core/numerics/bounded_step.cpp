// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/bounded_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace touchdown {

namespace {

using Values = std::vector<double>;

double product(const Values& a, const Values& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

/// Solves A x = b by Cholesky's factors; A symmetric and positive, row by row, is overwritten.
Values solvePositive(std::vector<Values>& a, Values b)
{
    const std::size_t n = b.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = a[i][j];
            for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
            a[i][j] = i == j ? std::sqrt(std::max(sum, std::numeric_limits<double>::min())) : sum / a[j][j];
        }
        for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) b[i] -= a[k][i] * b[k];
        b[i] /= a[i][i];
    }
    return b;
}

} // namespace

std::vector<double> boundedStep(const std::vector<std::vector<double>>& slopes, std::span<const double> residual,
                                double lambda, std::span<const double> low, std::span<const double> high)
{
    const std::size_t count = slopes.size();
    Values step(count, 0.0);
    Values right(residual.begin(), residual.end()); // r + J du of the held parameters
    std::vector<std::size_t> loose(count);
    std::iota(loose.begin(), loose.end(), std::size_t{0});
    // A parameter without effect is not changed.
    std::erase_if(loose, [&](std::size_t k) { return product(slopes[k], slopes[k]) == 0.0; });
    while (!loose.empty()) {
        std::vector<Values> normal;
        Values b;
        for (const std::size_t i : loose) {
            Values row;
            for (const std::size_t k : loose)
                row.push_back(product(slopes[i], slopes[k]) * (i == k ? 1.0 + lambda : 1.0));
            normal.push_back(std::move(row));
            b.push_back(-product(slopes[i], right));
        }
        const Values change = solvePositive(normal, std::move(b));
        std::vector<std::size_t> within;
        for (std::size_t k = 0; k < loose.size(); ++k) {
            const std::size_t i = loose[k];
            step[i] = std::clamp(change[k], low[i], high[i]);
            if (step[i] == change[k]) {
                within.push_back(i);
                continue;
            }
            for (std::size_t row = 0; row < right.size(); ++row) right[row] += slopes[i][row] * step[i];
        }
        if (within.size() == loose.size()) break;
        loose = std::move(within);
    }
    return step;
}

} // namespace touchdown
