// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/periodic_spline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace touchdown {

namespace {

constexpr int boundBlock = 4;      // cells along each side for which a bound is kept
constexpr int mostBlocks = 24;     // along a side of a rectangle; a larger one has the bound of all
constexpr int chunk = 128;         // columns whose weights are kept at a time
constexpr double finest = 0x1p-30; // positions are multiples of this or of a larger power of two [cell]

/// Rounding leaves of a length `largest` [m] only multiples of some 2^-52 of it: as a power of two [cell].
double quantumOf(double largest, double step)
{
    const double lost = 0x1p-49 * largest / step;
    return lost <= finest ? finest : std::exp2(std::ceil(std::log2(lost)));
}

/// One axis and the displacement of the surface along it. Positions and the shift are rounded separately: a position
/// must not depend on the distance that a surface has moved by whole periods.
struct Axis {
    double step = 0.0;    // [m]
    int points = 0;       // of the period
    double quantum = 0.0; // of positions [cell]
    std::int64_t shift = 0;
    double shiftPart = 0.0; // of a cell beyond it, 0 <= shiftPart < 1

    /// For positions up to +-`largest` [m], of a surface moved by `moved` [m].
    Axis(double cell, int count, double largest, double moved)
        : step(cell), points(count), quantum(quantumOf(largest, cell))
    {
        const double shiftQuantum = quantumOf(std::abs(moved), cell);
        const double cells = std::nearbyint(moved / cell / shiftQuantum) * shiftQuantum;
        shift = static_cast<std::int64_t>(std::floor(cells));
        shiftPart = cells - std::floor(cells);
    }
};

/// A position on an axis: point `index` of period `turn`, and the part of a cell beyond it.
struct Place {
    std::int64_t index = 0, turn = 0;
    double cells = 0.0;    // from the origin, before the surface moved, rounded [cell]
    double fraction = 0.0; // 0 <= fraction < 1
};

Place placeOf(double position, const Axis& axis)
{
    Place place;
    place.cells = std::nearbyint(position / axis.step / axis.quantum) * axis.quantum;
    const double whole = std::floor(place.cells);
    place.fraction = place.cells - whole - axis.shiftPart;
    auto i = static_cast<std::int64_t>(whole) - axis.shift;
    if (place.fraction < 0.0) {
        place.fraction += 1.0;
        --i;
    }
    place.turn = i / axis.points - (i % axis.points < 0 ? 1 : 0);
    place.index = i - place.turn * axis.points;
    return place;
}

double farthest(double first, double last) { return std::max(std::abs(first), std::abs(last)); }

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

/// B''(t - k), for the spline's slope [1/cell].
Weights slopeWeights(double t)
{
    const double s = 1.0 - t;
    const double b0 = -0.5 * s * s, b1 = (1.5 * t - 2.0) * t, b2 = (2.0 - 1.5 * s) * s, b3 = 0.5 * t * t;
    return {-b0, b0 - b1, b1 - b2, b2 - b3, b3};
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

/// Contribution of one axis: five points of the period, and how often the sum of a whole period is added.
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

Taps valueTaps(double position, const Axis& axis)
{
    const Place place = placeOf(position, axis);
    return tapsAt(place, axis.points, valueWeights(place.fraction), place.turn);
}

Taps integralTaps(double position, const Axis& axis, std::int64_t firstTurn)
{
    const Place place = placeOf(position, axis);
    return tapsAt(place, axis.points, integralWeights(place.fraction), firstTurn);
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

/// From values to coefficients, (c_(k-1) + 4 c_k + c_(k+1))/6 = f_k, periodic: one recursion forwards and one back with
/// the pole z = sqrt(3) - 2 (Unser 1999, box 2). Each k is a run of `width` neighbours; z^40 is below rounding.
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
    setBlocks();
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 1; i < columns; ++i) sums_[j * columns + i] += sums_[j * columns + i - 1];
    for (std::size_t k = columns; k < sums_.size(); ++k) sums_[k] += sums_[k - columns];
}

/// From the coefficients. A value between two points has those from one before to one behind them. Its second
/// derivatives are means of second differences among them, with weights of sum 1.
void PeriodicSpline::setBlocks()
{
    blocksX_ = (nx_ + boundBlock - 1) / boundBlock;
    blocksY_ = (ny_ + boundBlock - 1) / boundBlock;
    const auto atLeast = [](double value) {
        return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::max());
    };
    const auto around = [](int index, int count) {
        return static_cast<std::size_t>(((index % count) + count) % count);
    };
    const auto c = [&](int i, int j) { return sums_[around(j, ny_) * static_cast<std::size_t>(nx_) + around(i, nx_)]; };
    for (int q = 0; q < blocksY_; ++q)
        for (int p = 0; p < blocksX_; ++p) {
            const int i0 = p * boundBlock - 1, i1 = std::min((p + 1) * boundBlock, nx_) + 1, j0 = q * boundBlock - 1,
                      j1 = std::min((q + 1) * boundBlock, ny_) + 1;
            double most = lower_, along = 0.0, across = 0.0, mixed = 0.0;
            for (int j = j0; j <= j1; ++j)
                for (int i = i0; i <= i1; ++i) {
                    const double here = c(i, j);
                    most = std::max(most, here);
                    if (i > i0 && i < i1) along = std::max(along, std::abs(c(i - 1, j) - 2.0 * here + c(i + 1, j)));
                    if (j > j0 && j < j1) across = std::max(across, std::abs(c(i, j - 1) - 2.0 * here + c(i, j + 1)));
                    if (i < i1 && j < j1)
                        mixed = std::max(mixed, std::abs(c(i + 1, j + 1) - c(i, j + 1) - c(i + 1, j) + here));
                }
            blockUpper_.push_back(atLeast(most));
            blockCurvatureX_.push_back(atLeast(along / (dx_ * dx_) + mixed / (dx_ * dy_)));
            blockCurvatureY_.push_back(atLeast(across / (dy_ * dy_) + mixed / (dx_ * dy_)));
        }
    mostCurved_ = {std::ranges::max(blockCurvatureX_), std::ranges::max(blockCurvatureY_)};
}

double PeriodicSpline::upperBound(double x0, double x1, double y0, double y1) const
{
    return mostOf(blockUpper_, upper_, x0, x1, y0, y1);
}

CurvatureBound PeriodicSpline::curvature(double x0, double x1, double y0, double y1) const
{
    return {mostOf(blockCurvatureX_, mostCurved_.x, x0, x1, y0, y1),
            mostOf(blockCurvatureY_, mostCurved_.y, x0, x1, y0, y1)};
}

double PeriodicSpline::mostOf(const std::vector<float>& blocks, double all, double x0, double x1, double y0,
                              double y1) const
{
    constexpr double slack = 1e-6; // of a cell, for rounding
    const auto cellOf = [](double cells) { return static_cast<std::int64_t>(std::floor(cells)); };
    const std::int64_t i0 = cellOf(x0 / dx_ - slack), i1 = cellOf(x1 / dx_ + slack), j0 = cellOf(y0 / dy_ - slack),
                       j1 = cellOf(y1 / dy_ + slack);
    if (i1 - i0 > mostBlocks * boundBlock || j1 - j0 > mostBlocks * boundBlock) return all;
    float most = std::numeric_limits<float>::lowest();
    // From a cell to the first one of the next block.
    const auto next = [](std::int64_t index, int count) {
        const std::int64_t in = ((index % count) + count) % count;
        return index + std::min<std::int64_t>(boundBlock - in % boundBlock, count - in);
    };
    for (std::int64_t j = j0; j <= j1; j = next(j, ny_))
        for (std::int64_t i = i0; i <= i1; i = next(i, nx_)) {
            const std::int64_t q = (((j % ny_) + ny_) % ny_) / boundBlock, p = (((i % nx_) + nx_) % nx_) / boundBlock;
            most = std::max(most, blocks[static_cast<std::size_t>(q * blocksX_ + p)]);
        }
    return most;
}

double PeriodicSpline::value(double x, double y) const
{
    const Taps across = valueTaps(y, Axis(dy_, ny_, std::abs(y), 0.0));
    return evaluate(sums_, nx_, ny_, valueTaps(x, Axis(dx_, nx_, std::abs(x), 0.0)), across);
}

PeriodicSpline::Tangent PeriodicSpline::tangent(double x, double y) const
{
    const auto placeOn = [](double position, double step, int points) {
        const double cells = position / step, whole = std::floor(cells);
        Place place{.index = 0, .turn = 0, .cells = cells, .fraction = cells - whole};
        const auto i = static_cast<std::int64_t>(whole);
        place.turn = i / points - (i % points < 0 ? 1 : 0);
        place.index = i - place.turn * points;
        return place;
    };
    const Place atX = placeOn(x, dx_, nx_), atY = placeOn(y, dy_, ny_);
    const Taps along = tapsAt(atX, nx_, valueWeights(atX.fraction), atX.turn);
    const Taps across = tapsAt(atY, ny_, valueWeights(atY.fraction), atY.turn);
    const Taps slopeAlong = tapsAt(atX, nx_, slopeWeights(atX.fraction), atX.turn);
    const Taps slopeAcross = tapsAt(atY, ny_, slopeWeights(atY.fraction), atY.turn);
    return {evaluate(sums_, nx_, ny_, along, across), evaluate(sums_, nx_, ny_, slopeAlong, across) / dx_,
            evaluate(sums_, nx_, ny_, along, slopeAcross) / dy_};
}

void PeriodicSpline::addValues(const UniformGrid& grid, double shiftX, double shiftY, std::span<double> out) const
{
    assert(out.size() == grid.cells());
    if (out.empty()) return;
    const Axis axisX(dx_, nx_, farthest(grid.x(0), grid.x(grid.nx - 1)), shiftX);
    const Axis axisY(dy_, ny_, farthest(grid.y(0), grid.y(grid.ny - 1)), shiftY);
    std::array<Taps, chunk> along;
    for (int begin = 0; begin < grid.nx; begin += chunk) {
        const int count = std::min(chunk, grid.nx - begin);
        for (int i = 0; i < count; ++i) along[static_cast<std::size_t>(i)] = valueTaps(grid.x(begin + i), axisX);
        for (int j = 0; j < grid.ny; ++j) {
            const Taps across = valueTaps(grid.y(j), axisY);
            double* row = &out[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nx)] + begin;
            for (int i = 0; i < count; ++i)
                row[i] += evaluate(sums_, nx_, ny_, along[static_cast<std::size_t>(i)], across);
        }
    }
}

// First along each row of the map, from line to line of the columns, then across the rows: rows are used several times
// where the map is narrower than the grid.
void PeriodicSpline::addMeans(const CellGrid& grid, double shiftX, double shiftY, std::span<double> out,
                              std::vector<double>& work) const
{
    assert(out.size() == grid.cells());
    if (out.empty()) return;
    const Axis axisX(dx_, nx_, farthest(grid.x.front(), grid.x.back()), shiftX);
    const Axis axisY(dy_, ny_, farthest(grid.y.front(), grid.y.back()), shiftY);
    // Turns count from the first line, so that a surface that has moved by whole periods returns the same bits.
    const std::int64_t turnX = placeOf(grid.x.front(), axisX).turn;
    const std::int64_t turnY = placeOf(grid.y.front(), axisY).turn;
    const auto columns = static_cast<std::size_t>(nx_), rows = static_cast<std::size_t>(ny_);
    work.resize(std::max(work.size(), rows * chunk));
    std::array<Taps, chunk + 1> along;
    std::array<double, chunk> perWidth, inner, outer;
    for (int begin = 0; begin < grid.nx(); begin += chunk) {
        const auto count = static_cast<std::size_t>(std::min(chunk, grid.nx() - begin));
        for (std::size_t i = 0; i <= count; ++i) {
            along[i] = integralTaps(grid.x[static_cast<std::size_t>(begin) + i], axisX, turnX);
            if (i > 0) perWidth[i - 1] = 1.0 / (along[i].cells - along[i - 1].cells);
        }
        for (std::size_t l = 0; l < rows; ++l)
            work[l * chunk] = std::numeric_limits<double>::quiet_NaN(); // not yet known
        const auto rowOf = [&](std::size_t l) {
            double* row = &work[l * chunk];
            if (!std::isnan(row[0])) return row;
            const double* sums = &sums_[l * columns];
            double left = dot(sums, columns - 1, along[0]);
            for (std::size_t i = 0; i < count; ++i) {
                const double right = dot(sums, columns - 1, along[i + 1]);
                row[i] = (right - left) * perWidth[i];
                left = right;
            }
            return row;
        };
        const auto acrossAt = [&](int j, std::array<double, chunk>& sum) {
            const Taps taps = integralTaps(grid.y[static_cast<std::size_t>(j)], axisY, turnY);
            std::array<const double*, 5> row;
            for (std::size_t k = 0; k < 5; ++k) row[k] = rowOf(taps.index[k]);
            const Weights& w = taps.weight;
            for (std::size_t i = 0; i < count; ++i)
                sum[i] = w[0] * row[0][i] + w[1] * row[1][i] + w[2] * row[2][i] + w[3] * row[3][i] + w[4] * row[4][i];
            if (taps.turns != 0.0) {
                const double* last = rowOf(rows - 1);
                for (std::size_t i = 0; i < count; ++i) sum[i] += taps.turns * last[i];
            }
            return taps.cells;
        };
        double before = acrossAt(0, inner);
        for (int j = 0; j < grid.ny(); ++j) {
            const double behind = acrossAt(j + 1, outer), perHeight = 1.0 / (behind - before);
            double* row = &out[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nx())] + begin;
            for (std::size_t i = 0; i < count; ++i) row[i] += (outer[i] - inner[i]) * perHeight;
            std::swap(inner, outer);
            before = behind;
        }
    }
}

} // namespace touchdown
