// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/periodic_spline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

namespace touchdown {

namespace {

constexpr int chunk = 128;         // columns whose weights are kept at a time
constexpr double finest = 0x1p-30; // positions are multiples of this or of a larger power of two [cell]

/// Rounding leaves of a position beyond `largest` [m] only multiples of some 2^-52 of it: as a power of two [cell].
double positionQuantum(double largest, double step)
{
    const double lost = 0x1p-49 * largest / step;
    return lost <= finest ? finest : std::exp2(std::ceil(std::log2(lost)));
}

double farthest(double first, double last, double shift)
{
    return std::max({std::abs(first), std::abs(last), std::abs(shift)});
}

/// A position on one axis: point `index` of period `turn`, and the part of a cell beyond it.
struct Place {
    std::int64_t index = 0, turn = 0;
    double cells = 0.0;    // from the origin, rounded [cell]
    double fraction = 0.0; // 0 <= fraction < 1
};

Place placeOf(double position, double shift, double step, int points, double quantum)
{
    Place place;
    place.cells = std::nearbyint((position - shift) / step / quantum) * quantum;
    const double whole = std::floor(place.cells);
    place.fraction = place.cells - whole;
    const auto i = static_cast<std::int64_t>(whole);
    place.turn = i / points - (i % points < 0 ? 1 : 0);
    place.index = i - place.turn * points;
    return place;
}

using Weights = std::array<double, 5>;

/// Cubic B-splines of the coefficients from one point before to two behind (Unser 1999).
std::array<double, 4> cubicWeights(double t)
{
    const double s = 1.0 - t;
    return {s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0, (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0,
            t * t * t / 6.0};
}

/// B'(t - k), k = -2...2, for the spline's value: c_k = S_k - S_(k-1).
Weights valueWeights(double t)
{
    const auto b = cubicWeights(t);
    return {-b[0], b[0] - b[1], b[1] - b[2], b[2] - b[3], b[3]};
}

/// B(t - k), for its integral.
Weights integralWeights(double t)
{
    const auto quartic = [](double s) { return s * s * s * s / 24.0; };
    const auto beside = [](double s) { return (1.0 + s * (4.0 + s * (6.0 + s * (4.0 - 4.0 * s)))) / 24.0; };
    const double before = beside(1.0 - t);
    const double behind = beside(t);
    return {quartic(1.0 - t), before, 1.0 - quartic(1.0 - t) - before - behind - quartic(t), behind, quartic(t)};
}

/// What one axis contributes: five points of the period, and how often the sum of a whole period is added.
struct Taps {
    std::array<std::size_t, 5> index{};
    Weights weight{};
    double turns = 0.0;
    double cells = 0.0;
};

Taps tapsAt(const Place& place, int points, const Weights& weights, std::int64_t firstTurn)
{
    Taps taps;
    taps.weight = weights;
    taps.cells = place.cells;
    for (int k = 0; k < 5; ++k) {
        const std::int64_t i = place.index + k - 2;
        const std::int64_t turn = i / points - (i % points < 0 ? 1 : 0);
        taps.index[static_cast<std::size_t>(k)] = static_cast<std::size_t>(i - turn * points);
        taps.turns += weights[static_cast<std::size_t>(k)] * static_cast<double>(place.turn + turn - firstTurn);
    }
    return taps;
}

Taps valueTaps(double position, double shift, double step, int points, double quantum)
{
    const Place place = placeOf(position, shift, step, points, quantum);
    return tapsAt(place, points, valueWeights(place.fraction), place.turn);
}

Taps integralTaps(double position, double shift, double step, int points, double quantum, std::int64_t firstTurn)
{
    const Place place = placeOf(position, shift, step, points, quantum);
    return tapsAt(place, points, integralWeights(place.fraction), firstTurn);
}

double dot(const double* row, std::size_t last, const Taps& x)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < 5; ++k) sum += x.weight[k] * row[x.index[k]];
    return x.turns == 0.0 ? sum : sum + x.turns * row[last];
}

/// Sum over S_ij of all weights, S continued beyond the period: S(i + nx, j) = S(i, j) + S(nx - 1, j), and so across.
double evaluate(const std::vector<double>& sums, int nx, int ny, const Taps& x, const Taps& y)
{
    const auto columns = static_cast<std::size_t>(nx);
    double sum = 0.0;
    for (std::size_t k = 0; k < 5; ++k) sum += y.weight[k] * dot(&sums[y.index[k] * columns], columns - 1, x);
    if (y.turns == 0.0) return sum;
    return sum + y.turns * dot(&sums[static_cast<std::size_t>(ny - 1) * columns], columns - 1, x);
}

/// From values to coefficients, (c_(k-1) + 4 c_k + c_(k+1))/6 = f_k, periodic: one recursion forwards and one back with the
/// pole z = sqrt(3) - 2 (Unser 1999, box 2). Each k is a run of `width` neighbours; z^40 is below rounding.
void findCoefficients(double* values, int points, std::size_t stride, std::size_t width)
{
    const double z = std::sqrt(3.0) - 2.0;
    const double closed = 1.0 / (1.0 - std::pow(z, points));
    const int reach = std::min(points, 40);
    const auto run = [&](int k) { return values + static_cast<std::size_t>(k) * stride; };
    const auto add = [&](double* to, double ownFactor, const double* from, double factor) {
        for (std::size_t i = 0; i < width; ++i) to[i] = ownFactor * to[i] + factor * from[i];
    };
    double power = z;
    for (int k = 1; k < reach; ++k, power *= z) add(run(0), 1.0, run(points - k), power);
    for (std::size_t i = 0; i < width; ++i) values[i] *= 6.0 * closed;
    for (int k = 1; k < points; ++k) add(run(k), 6.0, run(k - 1), z);
    power = z;
    for (int k = 1; k < reach; ++k, power *= z) add(run(points - 1), 1.0, run(k - 1), power);
    for (std::size_t i = 0; i < width; ++i) run(points - 1)[i] *= -z * closed;
    for (int k = points - 2; k >= 0; --k) add(run(k), -z, run(k + 1), z);
}

} // namespace

PeriodicSpline::PeriodicSpline(int nx, int ny, double dx, double dy, std::vector<double> values)
    : nx_(nx), ny_(ny), dx_(dx), dy_(dy), sums_(std::move(values))
{
    assert(nx > 0 && ny > 0 && dx > 0.0 && dy > 0.0);
    const auto columns = static_cast<std::size_t>(nx), rows = static_cast<std::size_t>(ny);
    assert(sums_.size() == columns * rows);
    for (std::size_t j = 0; j < rows; ++j) findCoefficients(&sums_[j * columns], nx, 1, 1);
    findCoefficients(sums_.data(), ny, columns, columns);
    const auto [lowest, highest] = std::ranges::minmax_element(sums_);
    lower_ = *lowest;
    upper_ = *highest;
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 1; i < columns; ++i) sums_[j * columns + i] += sums_[j * columns + i - 1];
    for (std::size_t k = columns; k < sums_.size(); ++k) sums_[k] += sums_[k - columns];
}

double PeriodicSpline::value(double x, double y) const
{
    const Taps across = valueTaps(y, 0.0, dy_, ny_, positionQuantum(std::abs(y), dy_));
    return evaluate(sums_, nx_, ny_, valueTaps(x, 0.0, dx_, nx_, positionQuantum(std::abs(x), dx_)), across);
}

void PeriodicSpline::addValues(const UniformGrid& grid, double shiftX, double shiftY, std::span<double> out) const
{
    assert(out.size() == grid.cells());
    if (out.empty()) return;
    const double quantumX = positionQuantum(farthest(grid.x(0), grid.x(grid.nx - 1), shiftX), dx_);
    const double quantumY = positionQuantum(farthest(grid.y(0), grid.y(grid.ny - 1), shiftY), dy_);
    std::array<Taps, chunk> along;
    for (int begin = 0; begin < grid.nx; begin += chunk) {
        const int count = std::min(chunk, grid.nx - begin);
        for (int i = 0; i < count; ++i)
            along[static_cast<std::size_t>(i)] = valueTaps(grid.x(begin + i), shiftX, dx_, nx_, quantumX);
        for (int j = 0; j < grid.ny; ++j) {
            const Taps across = valueTaps(grid.y(j), shiftY, dy_, ny_, quantumY);
            double* row = &out[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nx)] + begin;
            for (int i = 0; i < count; ++i)
                row[i] += evaluate(sums_, nx_, ny_, along[static_cast<std::size_t>(i)], across);
        }
    }
}

void PeriodicSpline::addMeans(const CellGrid& grid, double shiftX, double shiftY, std::span<double> out) const
{
    assert(out.size() == grid.cells());
    if (out.empty()) return;
    const double quantumX = positionQuantum(farthest(grid.x.front(), grid.x.back(), shiftX), dx_);
    const double quantumY = positionQuantum(farthest(grid.y.front(), grid.y.back(), shiftY), dy_);
    // Turns count from the first line, so that a surface that has come round returns the same bits.
    const std::int64_t turnX = placeOf(grid.x.front(), shiftX, dx_, nx_, quantumX).turn;
    const std::int64_t turnY = placeOf(grid.y.front(), shiftY, dy_, ny_, quantumY).turn;
    const auto acrossAt = [&](int j) {
        return integralTaps(grid.y[static_cast<std::size_t>(j)], shiftY, dy_, ny_, quantumY, turnY);
    };
    std::array<Taps, chunk + 1> along;
    std::array<double, chunk + 1> below;
    for (int begin = 0; begin < grid.nx(); begin += chunk) {
        const int count = std::min(chunk, grid.nx() - begin);
        Taps across = acrossAt(0);
        for (int i = 0; i <= count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            along[k] = integralTaps(grid.x[static_cast<std::size_t>(begin + i)], shiftX, dx_, nx_, quantumX, turnX);
            below[k] = evaluate(sums_, nx_, ny_, along[k], across);
        }
        for (int j = 0; j < grid.ny(); ++j) {
            const double inner = across.cells;
            across = acrossAt(j + 1);
            double* row = &out[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nx())] + begin;
            double left = 0.0; // the integral up to the left line, between the two lines of the row
            for (int i = 0; i <= count; ++i) {
                const auto k = static_cast<std::size_t>(i);
                const double above = evaluate(sums_, nx_, ny_, along[k], across);
                const double right = above - below[k];
                below[k] = above;
                if (i > 0)
                    row[i - 1] += (right - left) / ((along[k].cells - along[k - 1].cells) * (across.cells - inner));
                left = right;
            }
        }
    }
}

} // namespace touchdown
