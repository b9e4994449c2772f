// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sample_points.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

#include <boost/random/sobol.hpp>

namespace touchdown {

namespace {

using Points = std::vector<std::vector<double>>;

/// Even in [0, 1). The distributions of the standard library differ from one library to another.
double uniform(std::mt19937_64& random) { return double(random() >> 11) * 0x1p-53; }

Points latinHypercube(std::size_t dimensions, std::size_t count, std::mt19937_64& random)
{
    Points points(count, std::vector<double>(dimensions));
    std::vector<std::size_t> slices(count);
    for (std::size_t d = 0; d < dimensions; ++d) {
        std::iota(slices.begin(), slices.end(), std::size_t{0});
        for (std::size_t i = count; i > 1; --i)
            std::swap(slices[i - 1], slices[static_cast<std::size_t>(uniform(random) * double(i))]);
        for (std::size_t i = 0; i < count; ++i) points[i][d] = (double(slices[i]) + uniform(random)) / double(count);
    }
    return points;
}

Points sobol(std::size_t dimensions, std::size_t count, std::mt19937_64& random)
{
    boost::random::sobol generator(dimensions);
    std::vector<double> shift(dimensions);
    for (double& each : shift) each = uniform(random);
    Points points(count, std::vector<double>(dimensions));
    for (std::vector<double>& point : points)
        for (std::size_t d = 0; d < dimensions; ++d) {
            const double value = double(generator() >> 11) * 0x1p-53 + shift[d];
            point[d] = value < 1.0 ? value : value - 1.0;
        }
    return points;
}

} // namespace

Points samplePoints(SampleMethod method, std::size_t dimensions, std::size_t count, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    if (method == SampleMethod::LatinHypercube) return latinHypercube(dimensions, count, random);
    if (method == SampleMethod::Sobol) return sobol(dimensions, count, random);
    Points points(count, std::vector<double>(dimensions));
    for (std::vector<double>& point : points)
        for (double& value : point) value = uniform(random);
    return points;
}

double normalQuantile(double probability)
{
    double low = -40.0, high = 40.0;
    while (high - low > 1e-15 * (1.0 + std::abs(low))) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;
        (0.5 * std::erfc(-middle / std::numbers::sqrt2) < probability ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace touchdown
