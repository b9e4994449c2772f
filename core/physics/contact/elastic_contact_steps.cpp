// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the pressure of an elastic contact changes from one choice of cells to the next.
#include <algorithm>
#include <cmath>

#include "core/numerics/vector_clones.h"
#include "core/physics/contact/elastic_contact.h"

namespace touchdown {
namespace {

constexpr double gapShare = 0.2; // to which conjugate gradients reduce the gap before the cells are chosen anew
constexpr int mostSteps = 8;     // that they take for it
constexpr int mostRises = 12;    // of the energy that are let pass, before it must fall

TOUCHDOWN_VECTOR_CLONES void addTo(std::span<double> to, double factor, std::span<const double> from)
{
    double* a = to.data();
    const double* b = from.data();
#pragma GCC ivdep
    for (std::size_t i = 0; i < to.size(); ++i) a[i] += factor * b[i];
}

TOUCHDOWN_VECTOR_CLONES void mix(std::span<double> to, double part, std::span<const double> from)
{
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = part * to[i] + (1.0 - part) * from[i];
}

} // namespace

// Along p + t dp, dp the last change, the energy is least at t = -(s + u).dp/(dp.du). Pressures may leave the bounds.
void ElasticContact::extrapolate(std::span<const double> separation, bool follows)
{
    double part = 0.0;
    if (follows) {
        double slope = 0.0, curvature = 0.0;
        for (std::size_t i = 0; i < pressure_.size(); ++i) {
            const double change = pressure_[i] - lastPressure_[i];
            slope += (separation[i] + displacement_[i]) * change;
            curvature += (displacement_[i] - lastDisplacement_[i]) * change;
        }
        if (curvature > 0.0) part = std::clamp(-slope / curvature, -2.0, 2.0);
    }
    pressure_.swap(lastPressure_);
    displacement_.swap(lastDisplacement_);
    if (part == 0.0) {
        pressure_ = lastPressure_;
        displacement_ = lastDisplacement_;
    } else {
        mix(pressure_, -part, lastPressure_);
        mix(displacement_, -part, lastDisplacement_);
    }
}

// Preconditioned conjugate gradients for g = 0 on the cells without bounds: r = -g, z = M r. Returns whether all
// numbers are finite.
bool ElasticContact::step(int mostIterations)
{
    std::fill(residual_.begin(), residual_.end(), 0.0);
    std::fill(direction_.begin(), direction_.end(), 0.0);
    double* r = residual_.data() + cells_.margin();
    double* z = change_.data();
    double* d = direction_.data();
    const double hardness = largestPressure();
    cells_.forEach([&](std::size_t i) { r[i] = -gap_[i]; });
    const auto isBounded = [&] {
        bool bounded = true;
        cells_.forEach([&](std::size_t i) { bounded = bounded && pressure_[i] >= 0.0 && pressure_[i] <= hardness; });
        return bounded;
    };
    const double enough = 0.8 * wrongGap_;
    double goal = 0.0, before = 0.0;
    for (int k = 0; k < mostIterations; ++k) {
        stopped_ = options_.goOn && !options_.goOn();
        if (stopped_) break;
        cells_.precondition(r, z);
        const double left = cells_.largest(r);
        if (k == 0) goal = std::max(gapShare * left, enough);
        if (k > 0 && (left <= goal || k % mostSteps == 0)) {
            if (left <= enough || !isBounded()) break;
            goal = std::max(gapShare * left, enough);
        }
        const double rz = cells_.product(r, z);
        cells_.scaleAndAdd(k > 0 ? rz / before : 0.0, z, d);
        before = rz;
        space_.displace(direction_, image_);
        ++iterations_;
        const double curvature = cells_.product(d, image_.data());
        if (!std::isfinite(curvature)) return false;
        if (curvature <= 0.0) {
            // Periodic: the mean displaces nothing, and nothing but the hardness bounds it.
            if (std::isfinite(hardness)) cells_.add(2.0 * hardness / cells_.largest(d), d, pressure_.data());
            break;
        }
        const double length = rz / curvature;
        cells_.add(length, d, pressure_.data());
        cells_.add(-length, image_.data(), r);
        addTo(displacement_, length, image_);
    }
    return true;
}

// The nearest pressure on the cells between the bounds. Returns whether it is another.
bool ElasticContact::project()
{
    const double hardness = largestPressure();
    bool changed = false;
    cells_.forEach([&](std::size_t i) {
        const double p = pressure_[i];
        const double bounded = std::clamp(p, 0.0, hardness);
        changed = changed || bounded != p;
        pressure_[i] = bounded;
    });
    return changed;
}

// Along the step the energy changes by t a + t^2 b/2, a = g.dp, b = dp.du; t = 1 is kept unless it raises the energy.
void ElasticContact::descend()
{
    double slope = 0.0, curvature = 0.0;
    cells_.forEach([&](std::size_t i) {
        const double change = pressure_[i] - pressureBefore_[i];
        slope += gap_[i] * change;
        curvature += change * (displacement_[i] - displacementBefore_[i]);
    });
    if (slope + 0.5 * curvature <= 0.0 || ++rises_ <= mostRises) return;
    if (slope < 0.0) {
        const double part = -slope / curvature;
        mix(pressure_, part, pressureBefore_);
        mix(displacement_, part, displacementBefore_);
        return;
    }
    pressure_ = pressureBefore_;
    cells_.add(-1.0 / space_.largestCompliance(), gap_.data(), pressure_.data());
    project();
    displace();
}

} // namespace touchdown
