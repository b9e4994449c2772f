// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/bumps.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace touchdown {

namespace {

/// A gaussian ends at nine standard deviations, where it is below 1e-17 of its height.
constexpr double gaussianBumpReach = 3.0;
/// Sample points across the base for means, and the fewest across the part of a bump in a cell.
constexpr double pointsAcrossBase = 16.0;
constexpr int fewestPoints = 4;

int pointsAcross(double extent, double base)
{
    return std::max(fewestPoints, static_cast<int>(std::ceil(pointsAcrossBase * extent / base)));
}

/// Distance of two places on a circle.
double apart(double a, double b, double period) { return std::abs(std::remainder(a - b, period)); }

} // namespace

Bumps::Bumps(const DiskSurface& surface)
    : shape_(surface.bumpShape),
      reach_(surface.bumpShape == BumpShape::Gaussian ? gaussianBumpReach : 1.0),
      track_(surface.track),
      trackWidth_(surface.trackWidth)
{
    const auto& widths = surface.bumpWidths.empty() ? surface.bumpLengths : surface.bumpWidths;
    for (std::size_t i = 0; i < surface.bumpHeights.size(); ++i)
        bumps_.push_back({surface.bumpHeights[i], 0.5 * surface.bumpLengths[i], 0.5 * widths[i], surface.bumpX[i],
                          surface.bumpY[i]});
    // Bound: the sum of the heights that overlap one of them. A bump longer than half the track overlaps its copies.
    const auto copies = [&](const Bump& b) {
        return std::ceil(2.0 * reach_ * b.halfLength / track_) * std::ceil(2.0 * reach_ * b.halfWidth / trackWidth_);
    };
    for (const Bump& one : bumps_) {
        double most = 0.0, least = 0.0;
        for (const Bump& other : bumps_) {
            const bool meet = apart(one.x, other.x, track_) < reach_ * (one.halfLength + other.halfLength) &&
                              apart(one.y, other.y, trackWidth_) < reach_ * (one.halfWidth + other.halfWidth);
            if (!meet) continue;
            (other.height > 0.0 ? most : least) += other.height * copies(other);
        }
        highest_ = std::max(highest_, most);
        lowest_ = std::min(lowest_, least);
    }
}

double Bumps::shape(double rr) const
{
    if (rr >= reach_ * reach_) return 0.0;
    switch (shape_) {
    case BumpShape::Ellipsoid: return std::sqrt(1.0 - rr);
    case BumpShape::Cosine: return 0.5 * (1.0 + std::cos(std::numbers::pi * std::sqrt(rr)));
    case BumpShape::Gaussian: return std::exp(-4.5 * rr);
    }
    return 0.0;
}

double Bumps::shapeRate(double rr) const
{
    if (rr >= reach_ * reach_) return 0.0;
    switch (shape_) {
    case BumpShape::Ellipsoid: return -0.5 / std::sqrt(1.0 - rr);
    case BumpShape::Cosine: {
        const double turn = std::numbers::pi * std::sqrt(rr);
        const double sinc = turn < 1e-4 ? 1.0 - turn * turn / 6.0 : std::sin(turn) / turn;
        return -0.25 * std::numbers::pi * std::numbers::pi * sinc;
    }
    case BumpShape::Gaussian: return -4.5 * std::exp(-4.5 * rr);
    }
    return 0.0;
}

template <typename Visit>
void Bumps::forCopies(double left, double right, double inner, double outer, const Visit& visit) const
{
    for (const Bump& b : bumps_) {
        const double alongReach = reach_ * b.halfLength, acrossReach = reach_ * b.halfWidth;
        const double lastX = std::floor((right + alongReach - b.x) / track_);
        const double lastY = std::floor((outer + acrossReach - b.y) / trackWidth_);
        for (double m = std::ceil((left - alongReach - b.x) / track_); m <= lastX; m += 1.0)
            for (double n = std::ceil((inner - acrossReach - b.y) / trackWidth_); n <= lastY; n += 1.0)
                visit(b, b.x + m * track_, b.y + n * trackWidth_);
    }
}

double Bumps::upperBound(double x0, double x1, double y0, double y1) const
{
    double sum = 0.0;
    forCopies(x0, x1, y0, y1, [&](const Bump& b, double cx, double cy) {
        const double u = (std::clamp(cx, x0, x1) - cx) / b.halfLength, v = (std::clamp(cy, y0, y1) - cy) / b.halfWidth;
        sum += std::max(b.height, 0.0) * shape(u * u + v * v);
    });
    return sum;
}

CurvatureBound Bumps::curvature(double x0, double x1, double y0, double y1) const
{
    const auto squares = [](double u, double v) { return u * u + v * v; };
    const auto mostBent = [&](double rr) { // by r, up to there
        switch (shape_) {
        case BumpShape::Ellipsoid: break;
        case BumpShape::Cosine: return 0.5 * std::numbers::pi * std::numbers::pi;
        case BumpShape::Gaussian: return 9.0;
        }
        return rr < 1.0 ? std::pow(1.0 - rr, -1.5) : std::numeric_limits<double>::infinity();
    };
    double sum = 0.0;
    forCopies(x0, x1, y0, y1, [&](const Bump& b, double cx, double cy) {
        const double near =
            squares((std::clamp(cx, x0, x1) - cx) / b.halfLength, (std::clamp(cy, y0, y1) - cy) / b.halfWidth);
        if (near >= reach_ * reach_ || b.height == 0.0) return;
        const double far = squares(std::max(cx - x0, x1 - cx) / b.halfLength, std::max(cy - y0, y1 - cy) / b.halfWidth),
                     half = std::min(b.halfLength, b.halfWidth);
        sum += std::abs(b.height) * mostBent(far) / (half * half);
    });
    return {sum, sum};
}

double Bumps::height(double x, double y) const
{
    double sum = 0.0;
    forCopies(x, x, y, y, [&](const Bump& b, double cx, double cy) {
        const double u = (x - cx) / b.halfLength, v = (y - cy) / b.halfWidth;
        sum += b.height * shape(u * u + v * v);
    });
    return sum;
}

void Bumps::addPoint(double x, double y, DiskPoint& to) const
{
    forCopies(x, x, y, y, [&](const Bump& b, double cx, double cy) {
        const double u = (x - cx) / b.halfLength, v = (y - cy) / b.halfWidth, rr = u * u + v * v;
        to.height += b.height * shape(rr);
        const double rate = 2.0 * b.height * shapeRate(rr);
        to.slopeX += rate * u / b.halfLength;
        to.slopeY += rate * v / b.halfWidth;
    });
}

void Bumps::addHeights(const UniformGrid& grid, double shiftX, double shiftY, std::span<double> out) const
{
    assert(out.size() == grid.cells());
    if (out.empty()) return;
    const auto firstAt = [](double from, double origin, double step, int count) { // centre at or behind `from`
        return static_cast<int>(std::clamp(std::ceil((from - origin) / step - 0.5), 0.0, static_cast<double>(count)));
    };
    forCopies(grid.x(0) - shiftX, grid.x(grid.nx - 1) - shiftX, grid.y(0) - shiftY, grid.y(grid.ny - 1) - shiftY,
              [&](const Bump& b, double diskX, double diskY) {
                  const double cx = diskX + shiftX, cy = diskY + shiftY;
                  const double rx = reach_ * b.halfLength, ry = reach_ * b.halfWidth;
                  const int iEnd = firstAt(cx + rx, grid.x0, grid.dx, grid.nx);
                  const int jEnd = firstAt(cy + ry, grid.y0, grid.dy, grid.ny);
                  for (int j = firstAt(cy - ry, grid.y0, grid.dy, grid.ny); j < jEnd; ++j) {
                      const double v = (grid.y(j) - cy) / b.halfWidth;
                      double* row = &out[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nx)];
                      for (int i = firstAt(cx - rx, grid.x0, grid.dx, grid.nx); i < iEnd; ++i) {
                          const double u = (grid.x(i) - cx) / b.halfLength;
                          row[i] += b.height * shape(u * u + v * v);
                      }
                  }
              });
}

void Bumps::addMeans(const CellGrid& grid, double shiftX, double shiftY, std::span<double> out) const
{
    assert(out.size() == grid.cells());
    if (out.empty()) return;
    const auto cellAt = [](const std::vector<double>& lines, double place) { // that holds it, or the nearest one
        const auto behind = std::upper_bound(lines.begin(), lines.end(), place) - lines.begin();
        return std::clamp<std::ptrdiff_t>(behind - 1, 0, std::ssize(lines) - 2);
    };
    forCopies(grid.x.front() - shiftX, grid.x.back() - shiftX, grid.y.front() - shiftY, grid.y.back() - shiftY,
              [&](const Bump& b, double diskX, double diskY) {
                  const double cx = diskX + shiftX, cy = diskY + shiftY;
                  const double rx = reach_ * b.halfLength, ry = reach_ * b.halfWidth;
                  const auto iEnd = cellAt(grid.x, cx + rx) + 1, jEnd = cellAt(grid.y, cy + ry) + 1;
                  for (auto j = cellAt(grid.y, cy - ry); j < jEnd; ++j) {
                      const auto row = static_cast<std::size_t>(j);
                      const double inner = std::max(grid.y[row], cy - ry), outer = std::min(grid.y[row + 1], cy + ry);
                      if (outer <= inner) continue;
                      const int ny = pointsAcross(outer - inner, 2.0 * b.halfWidth);
                      for (auto i = cellAt(grid.x, cx - rx); i < iEnd; ++i) {
                          const auto column = static_cast<std::size_t>(i);
                          const double left = std::max(grid.x[column], cx - rx),
                                       right = std::min(grid.x[column + 1], cx + rx);
                          if (right <= left) continue;
                          const int nx = pointsAcross(right - left, 2.0 * b.halfLength);
                          double sum = 0.0;
                          for (int l = 0; l < ny; ++l) {
                              const double v = (inner + (l + 0.5) / ny * (outer - inner) - cy) / b.halfWidth;
                              for (int k = 0; k < nx; ++k) {
                                  const double u = (left + (k + 0.5) / nx * (right - left) - cx) / b.halfLength;
                                  sum += shape(u * u + v * v);
                              }
                          }
                          const double covered = (right - left) * (outer - inner) /
                                                 (grid.widthX(static_cast<int>(i)) * grid.widthY(static_cast<int>(j)));
                          out[row * static_cast<std::size_t>(grid.nx()) + column] +=
                              b.height * covered * sum / (nx * ny);
                      }
                  }
              });
}

} // namespace touchdown
