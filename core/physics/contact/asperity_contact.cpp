// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/asperity_contact.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/numerics/gauss_legendre.h"
#include "core/physics/contact/asperity_model.h"

namespace touchdown {

namespace {

/// Density of the normal distribution.
double normal(double u) { return std::exp(-0.5 * u * u) / std::sqrt(2.0 * std::numbers::pi); }

/// Its share above t.
double share(double t) { return 0.5 * std::erfc(t / std::numbers::sqrt2); }

/// F_1(t) = int_t^inf (u - t) phi(u) du.
double meanExcess(double t) { return std::max(0.0, normal(t) - t * share(t)); }

/// The polynomial of degree 7 on 0..1 with given value and first three derivatives at both ends.
std::array<double, 8> hermite(const std::array<double, 4>& a, const std::array<double, 4>& b)
{
    std::array<double, 8> c{a[0], a[1], a[2] / 2.0, a[3] / 6.0};
    // What the cubic lacks at 1.
    const double r0 = b[0] - (c[0] + c[1] + c[2] + c[3]);
    const double r1 = b[1] - (c[1] + 2.0 * c[2] + 3.0 * c[3]);
    const double r2 = b[2] - (2.0 * c[2] + 6.0 * c[3]);
    const double r3 = b[3] - 6.0 * c[3];
    c[4] = 35.0 * r0 - 15.0 * r1 + 2.5 * r2 - r3 / 6.0;
    c[5] = -84.0 * r0 + 39.0 * r1 - 7.0 * r2 + r3 / 2.0;
    c[6] = 70.0 * r0 - 34.0 * r1 + 6.5 * r2 - r3 / 2.0;
    c[7] = -20.0 * r0 + 10.0 * r1 - 2.0 * r2 + r3 / 6.0;
    return c;
}

} // namespace

AsperityContact::AsperityContact(const Asperities& asperities, const ElasticPair& pair)
    : sigma_(asperities.heightDeviation),
      inverseSigma_(1.0 / asperities.heightDeviation),
      planeHeight_(asperities.planeHeight),
      density_(asperities.density),
      radius_(asperities.radius),
      criticalInterference_(std::numeric_limits<double>::infinity())
{
    const double modulus = contactModulus(pair);
    assert(sigma_ > 0.0 && density_ > 0.0 && radius_ > 0.0 && modulus > 0.0);
    hertz_ = 4.0 / 3.0 * modulus * std::sqrt(radius_);
    if (asperities.model == AsperityModel::ElasticPlastic) {
        assert(asperities.yieldStrength > 0.0);
        const double hardness = 2.8 * asperities.yieldStrength;                    // H [Pa]
        const double pressure = (0.454 + 0.41 * pair.diskPoissonRatio) * hardness; // K H [Pa]
        flow_ = std::numbers::pi * radius_ * pressure;
        const double root = std::numbers::pi * pressure / (2.0 * modulus);
        criticalInterference_ = root * root * radius_;
    }

    const double width = 1.0 / perDeviation;
    const auto scaled = [&](int node) {
        Derivatives values = integrate(lowerEnd + width * node);
        for (std::size_t k = 1; k < values.size(); ++k) values[k] *= std::pow(width, static_cast<double>(k));
        return values;
    };
    Derivatives left = scaled(0);
    for (int i = 0; i < pieces; ++i) {
        const Derivatives right = scaled(i + 1);
        table_[static_cast<std::size_t>(i)] = hermite(left, right);
        left = right;
    }
}

double AsperityContact::summitForce(double interference) const
{
    const double w = interference;
    return w <= criticalInterference_ ? hertz_ * w * std::sqrt(w) : flow_ * (2.0 * w - criticalInterference_);
}

double AsperityContact::summitEnergy(double interference) const
{
    const double wc = criticalInterference_;
    const double elastic = std::min(interference, wc);
    const double energy = 0.4 * hertz_ * elastic * elastic * std::sqrt(elastic);
    return interference <= wc ? energy : energy + flow_ * interference * (interference - wc);
}

AsperityContact::Derivatives AsperityContact::integrate(double t) const
{
    // With v = u - t = w/sigma_s, W = eta int W_1(sigma_s v) phi(t + v) dv; derivatives to t fall on phi, and the first
    // is taken by parts, so that P stands under the integral. v = x^2 makes P smooth at 0; the panels end at w_c.
    static const GaussLegendre<12> rule;
    constexpr double farthest = 12.0; // |u|, beyond which phi is below 1e-31
    constexpr double panel = 0.25;    // in x: two of phi's deviations at t = -16
    Derivatives sum{};
    const auto add = [&](double x, double weight) {
        const double v = x * x;
        const double u = t + v;
        const double w = sigma_ * v;
        const double mass = weight * 2.0 * x * density_ * normal(u);
        const double force = mass * sigma_ * summitForce(w);
        sum[0] += mass * summitEnergy(w);
        sum[1] -= force;
        sum[2] += force * u;
        sum[3] -= force * (u * u - 1.0);
    };
    const double first = std::sqrt(std::max(0.0, -farthest - t));
    const double last = std::sqrt(std::max(0.0, farthest - t));
    const double flows = std::clamp(std::sqrt(criticalInterference_ * inverseSigma_), first, last);
    const auto integrateOver = [&](double lower, double upper) {
        // du = 2 x dx: phi narrows as x grows.
        const int count = static_cast<int>(std::ceil((upper - lower) / std::min(panel, 2.0 / (upper + 1.0))));
        const double width = (upper - lower) / std::max(1, count);
        for (int i = 0; i < count; ++i) rule.sample(lower + i * width, lower + (i + 1) * width, add);
    };
    integrateOver(first, flows);
    integrateOver(flows, last);
    return sum;
}

AsperityContact::Derivatives AsperityContact::deep(double t) const
{
    const double mean = -t * sigma_; // of w [m]
    const double wc = criticalInterference_;
    const double spread = upperEnd * sigma_;
    if (mean + spread < wc) {
        // E[w^n] = mean^n (1 + sum over even k of binomial(n, k) (k - 1)!! t^-k), asymptotic; error of four
        // terms 1e-11 at t = -16.
        const auto moment = [&](double n) {
            double term = 1.0, sum = 1.0;
            for (int k = 2; k <= 8; k += 2) {
                term *= (n - k + 2.0) * (n - k + 1.0) / (k * t * t);
                sum += term;
            }
            return sum;
        };
        const double root = std::sqrt(mean);
        return {density_ * 0.4 * hertz_ * mean * mean * root * moment(2.5),
                -density_ * sigma_ * hertz_ * mean * root * moment(1.5),
                density_ * sigma_ * sigma_ * 1.5 * hertz_ * root * moment(0.5)};
    }
    if (mean - spread > wc) {
        const double square = mean * mean + sigma_ * sigma_; // E[w^2]
        const double elastic = 0.4 * hertz_ * wc * wc * std::sqrt(wc);
        return {density_ * (elastic + flow_ * (square - wc * mean)), -density_ * sigma_ * flow_ * (2.0 * mean - wc),
                density_ * sigma_ * sigma_ * 2.0 * flow_};
    }
    return integrate(t);
}

double AsperityContact::stiffness(double separation) const
{
    const double t = deviations(separation);
    if (t >= upperEnd) return 0.0;
    const double scale = inverseSigma_ * inverseSigma_;
    if (t < lowerEnd) return deep(t)[2] * scale;
    const auto [c, x] = place(t);
    const double curvature =
        2.0 * c[2] + x * (6.0 * c[3] + x * (12.0 * c[4] + x * (20.0 * c[5] + x * (30.0 * c[6] + x * 42.0 * c[7]))));
    return curvature * perDeviation * perDeviation * scale;
}

double AsperityContact::energy(double separation) const
{
    const double t = deviations(separation);
    if (t >= upperEnd) return 0.0;
    if (t < lowerEnd) return deep(t)[0];
    const auto [c, x] = place(t);
    return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * (c[5] + x * (c[6] + x * c[7]))))));
}

double AsperityContact::contactArea(double separation) const
{
    // A/(pi R) = w up to w_c and w + (w - w_c) beyond.
    const double t = deviations(separation);
    if (t >= upperEnd) return 0.0;
    const double flowing = t + criticalInterference_ * inverseSigma_;
    const double excess = meanExcess(t) + (flowing < upperEnd ? meanExcess(flowing) : 0.0);
    return std::numbers::pi * radius_ * density_ * sigma_ * excess;
}

double AsperityContact::contactDensity(double separation) const
{
    const double t = deviations(separation);
    return t < upperEnd ? density_ * share(t) : 0.0;
}

} // namespace touchdown
