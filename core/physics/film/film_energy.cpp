// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_energy.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/gas_film.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

/// ln(x) of positive normal numbers, absolute error below 1e-15, without branches or calls. x = 2^k m, m from sqrt(1/2)
/// to sqrt(2), ln(m) = 2 artanh(s), s = (m - 1)/(m + 1), by its series.
inline double logarithm(double x)
{
    constexpr std::uint64_t low = std::bit_cast<std::uint64_t>(0.70710678118654757), bias = 1023;
    constexpr double log2 = 0.69314718055994531, integers = 0x1p52;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t biased = (bits - low + (bias << 52)) >> 52; // k + bias
    const double k =
        std::bit_cast<double>(biased | std::bit_cast<std::uint64_t>(integers)) - (integers + static_cast<double>(bias));
    const double m = std::bit_cast<double>(bits - (biased << 52) + (bias << 52));
    const double s = (m - 1.0) / (m + 1.0), z = s * s;
    const double series =
        1.0 / 3 +
        z * (1.0 / 5 +
             z * (1.0 / 7 +
                  z * (1.0 / 9 + z * (1.0 / 11 + z * (1.0 / 13 + z * (1.0 / 15 + z * (1.0 / 17 + z * (1.0 / 19))))))));
    return k * log2 + 2.0 * (s + s * z * series);
}

TOUCHDOWN_VECTOR_CLONES void setLogs(std::size_t count, const double* p, double ambient, double* log, double* inverse)
{
    const double perAmbient = 1.0 / ambient;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        log[k] = logarithm(p[k] * perAmbient);
        inverse[k] = ambient / p[k];
    }
}

TOUCHDOWN_VECTOR_CLONES double storedEnergy(std::size_t count, const double* p, const double* log, const double* volume,
                                            double ambient)
{
    return sumInLanes(count, [=](std::size_t k) { return volume[k] * (p[k] * log[k] - p[k] + ambient); });
}

/// Of what the cells store, with ln(p/p0).
TOUCHDOWN_VECTOR_CLONES double storedPower(std::size_t count, const double* p, const double* log, const double* volume,
                                           const double* history, double perTime)
{
    return sumInLanes(count, [=](std::size_t k) { return log[k] * (perTime * volume[k] * p[k] - history[k]); });
}

/// Of a row of faces, `step` cells from the ones below to the ones above.
TOUCHDOWN_VECTOR_CLONES double dissipation(std::size_t count, std::size_t step, const double* flow,
                                           const double* inflow, const double* speed, const double* p,
                                           const double* log, const double* inverse, double ambient)
{
    const double perAmbient = 1.0 / ambient;
    return sumInLanes(count, [=](std::size_t k) {
        const double *p2 = p + k, *p1 = p2 - step, *log2 = log + k, *inverse2 = inverse + k;
        const double ratio = perAmbient * *p1 * *inverse2, reciprocal = perAmbient * *p2 * *(inverse2 - step),
                     x = *(log2 - step) - *log2;
        const bool against = speed[k] < 0.0;
        const double lower = against ? inflow[k] + flow[k] : inflow[k],
                     upper = against ? inflow[k] : inflow[k] - flow[k]; // A p1, B p2
        return lower * std::max(0.0, x - 1.0 + reciprocal) + upper * std::max(0.0, ratio - 1.0 - x);
    });
}

TOUCHDOWN_VECTOR_CLONES double work(std::size_t count, const double* p1, const double* p2, const double* from,
                                    const double* to, const double* area, double ambient)
{
    return sumInLanes(count,
                      [=](std::size_t k) { return (0.5 * (p1[k] + p2[k]) - ambient) * area[k] * (to[k] - from[k]); });
}
TOUCHDOWN_VECTOR_CLONES double work(std::size_t count, const double* p1, const double* p2, const double* from,
                                    const double* to, double ambient)
{
    return sumInLanes(count, [=](std::size_t k) { return (0.5 * (p1[k] + p2[k]) - ambient) * (from[k] - to[k]); });
}

} // namespace

FilmEnergy::FilmEnergy(const GasFilm& film)
    : film_(film),
      log_(film.pad().size(), 0.0),
      inverse_(film.pad().size(), 1.0),
      rowSums_(2 * (static_cast<std::size_t>(film.pad().ny) + 1), 0.0)
{}

FilmEnergyState FilmEnergy::at(std::span<const double> p)
{
    const PaddedGrid& pad = film_.pad();
    const double ambient = film_.ambient();
    const std::vector<double>& volume = film_.volumes();
    const std::span<const double> history = film_.storageHistory();
    const double perTime = film_.storagePerTime();
    FilmEnergyState state;
    double brought = 0.0; // by flows
    const std::size_t nx = static_cast<std::size_t>(pad.nx);
    Team& team = Team::mine();
    const std::size_t rows = static_cast<std::size_t>(pad.ny) + 1;
    double *one = rowSums_.data(), *other = one + rows;
    team.items(pad.ny, 24, 1, [&](int begin, int end, int) {
        for (int j = begin; j < end; ++j) {
            const std::size_t first = pad.at(0, j);
            setLogs(nx, &p[first], ambient, &log_[first], &inverse_[first]);
            one[j] = storedEnergy(nx, &p[first], &log_[first], &volume[first], ambient);
            if (perTime != 0.0)
                other[j] = storedPower(nx, &p[first], &log_[first], &volume[first], &history[first], perTime);
        }
    });
    for (int j = 0; j < pad.ny; ++j) {
        state.stored += one[j];
        if (perTime != 0.0) brought += other[j];
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const FilmFaces& faces = film_.faces()[axis];
        const std::span<const double> speed = film_.axes()[axis].speed;
        const int lines = pad.ny + (axis == 1);
        team.items(lines, 24, 1, [&](int begin, int end, int) {
            for (int j = begin; j < end; ++j) {
                const std::size_t first = pad.at(0, j);
                one[j] = dissipation(nx + (axis == 0), pad.step(static_cast<int>(axis)), &faces.flow[first],
                                     &faces.inflow[first], &speed[first], &p[first], &log_[first], &inverse_[first],
                                     ambient);
            }
        });
        for (int j = 0; j < lines; ++j) state.dissipation += one[j];
    }
    state.input = brought + state.dissipation;
    return state;
}

double FilmEnergy::surfaceWork(std::span<const double> p1, std::span<const double> p2, std::span<const double> height1,
                               std::span<const double> height2) const
{
    const PaddedGrid& pad = film_.pad();
    double result = 0.0;
    for (int j = 0; j < pad.ny; ++j) {
        const std::size_t first = pad.at(0, j);
        result += work(static_cast<std::size_t>(pad.nx), &p1[first], &p2[first], &height1[first], &height2[first],
                       &film_.areas()[first], film_.ambient());
    }
    return result;
}

double FilmEnergy::volumeWork(std::span<const double> p1, std::span<const double> p2, std::span<const double> volume1,
                              std::span<const double> volume2) const
{
    const PaddedGrid& pad = film_.pad();
    double result = 0.0;
    for (int j = 0; j < pad.ny; ++j) {
        const std::size_t first = pad.at(0, j);
        result += work(static_cast<std::size_t>(pad.nx), &p1[first], &p2[first], &volume1[first], &volume2[first],
                       film_.ambient());
    }
    return result;
}

} // namespace touchdown
