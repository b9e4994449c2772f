// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/waves.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace touchdown {

namespace {

constexpr int chunk = 256; // columns whose sines are kept at a time

double entry(const std::vector<double>& list, std::size_t i) { return list.empty() ? 0.0 : list[i]; }

/// sin(u)/u; its series where the quotient would lose digits.
double sinc(double u) { return std::abs(u) < 1e-4 ? 1.0 - u * u / 6.0 : std::sin(u) / u; }

struct Turn {
    double sine, cosine;
};
Turn turnOf(double phase, double factor = 1.0) { return {factor * std::sin(phase), factor * std::cos(phase)}; }

/// Adds a sin(phase of column + phase of row) to each cell.
template <typename Column, typename Row>
void addTensor(int nx, int ny, const Column& column, const Row& row, std::span<double> out)
{
    std::array<Turn, chunk> along;
    for (int begin = 0; begin < nx; begin += chunk) {
        const int count = std::min(chunk, nx - begin);
        for (int i = 0; i < count; ++i) along[static_cast<std::size_t>(i)] = column(begin + i);
        for (int j = 0; j < ny; ++j) {
            const Turn across = row(j);
            double* cells = &out[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx)] + begin;
            for (int i = 0; i < count; ++i) {
                const Turn& a = along[static_cast<std::size_t>(i)];
                cells[i] += a.sine * across.cosine + a.cosine * across.sine;
            }
        }
    }
}

} // namespace

Waves::Waves(const DiskSurface& surface)
{
    waves_.reserve(surface.waveAmplitudes.size());
    for (std::size_t i = 0; i < surface.waveAmplitudes.size(); ++i) {
        const double k = 2.0 * std::numbers::pi / surface.waveLengths[i];
        const double angle = entry(surface.waveAngles, i);
        waves_.push_back(
            {surface.waveAmplitudes[i], k * std::cos(angle), k * std::sin(angle), entry(surface.wavePhases, i)});
    }
}

double Waves::upperBound(double x0, double x1, double y0, double y1) const
{
    constexpr double pi = std::numbers::pi;
    double sum = 0.0;
    for (const Wave& wave : waves_) {
        const double middle = 0.5 * (wave.kx * (x0 + x1) + wave.ky * (y0 + y1)) + wave.phase;
        const double half = 0.5 * (std::abs(wave.kx) * (x1 - x0) + std::abs(wave.ky) * (y1 - y0));
        // From the phase in the middle to the nearest crest.
        const double crest = wave.amplitude > 0.0 ? 0.5 * pi : -0.5 * pi;
        const double away = std::max(std::abs(std::remainder(middle - crest, 2.0 * pi)) - half, 0.0);
        sum += std::abs(wave.amplitude) * std::cos(away);
    }
    return sum;
}

CurvatureBound Waves::curvature() const
{
    CurvatureBound sum;
    for (const Wave& w : waves_) {
        const double kx = std::abs(w.kx), ky = std::abs(w.ky), height = std::abs(w.amplitude);
        sum += {height * kx * (kx + ky), height * ky * (kx + ky)};
    }
    return sum;
}

double Waves::height(double x, double y) const
{
    double sum = 0.0;
    for (const Wave& w : waves_) sum += w.amplitude * std::sin(w.kx * x + w.ky * y + w.phase);
    return sum;
}

void Waves::addPoint(double x, double y, DiskPoint& to) const
{
    for (const Wave& w : waves_) {
        const Turn turn = turnOf(w.kx * x + w.ky * y + w.phase, w.amplitude);
        to.height += turn.sine;
        to.slopeX += w.kx * turn.cosine;
        to.slopeY += w.ky * turn.cosine;
    }
}

void Waves::addHeights(const UniformGrid& grid, double shiftX, double shiftY, std::span<double> out) const
{
    assert(out.size() == grid.cells());
    for (const Wave& w : waves_)
        addTensor(
            grid.nx, grid.ny, [&](int i) { return turnOf(w.kx * (grid.x(i) - shiftX) + w.phase); },
            [&](int j) { return turnOf(w.ky * (grid.y(j) - shiftY), w.amplitude); }, out);
}

void Waves::addMeans(const CellGrid& grid, double shiftX, double shiftY, std::span<double> out) const
{
    assert(out.size() == grid.cells());
    for (const Wave& w : waves_)
        addTensor(
            grid.nx(), grid.ny(),
            [&](int i) {
                return turnOf(w.kx * (grid.centreX(i) - shiftX) + w.phase, sinc(0.5 * w.kx * grid.widthX(i)));
            },
            [&](int j) {
                return turnOf(w.ky * (grid.centreY(j) - shiftY), w.amplitude * sinc(0.5 * w.ky * grid.widthY(j)));
            },
            out);
}

double Waves::amplitude() const
{
    double sum = 0.0;
    for (const Wave& w : waves_) sum += std::abs(w.amplitude);
    return sum;
}

} // namespace touchdown
