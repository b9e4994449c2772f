// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/spring_equilibria.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace touchdown {

namespace {

using Mode = SpringModel::Mode;
using Point = Eigen::Vector2d;

constexpr int cellsAlong = 160;           // of the grid on which equilibria are sought
constexpr double nearestSpacing = 1e-4;   // spacing from the end of an interval where it begins, in model scales [-]
constexpr double farthestSpacing = 200.0; // and where it ends
constexpr int mostNewtonIterations = 30;
constexpr double converged = 1e-12;    // last change, in model scales [-]
constexpr double apartInScales = 1e-6; // of two equilibria, in model scales [-]
constexpr double neutral = 1e-9;       // of the largest eigenvalue: below it a real part is rounding [-]

/// Forces in a mode at q, as accelerations.
Point forcesAt(const SpringModel& model, const Point& q, Mode mode)
{
    return model.derivative({q[0], q[1], 0.0, 0.0}, mode).tail<2>();
}

bool holdsAt(const SpringModel& model, const Point& q, Mode mode)
{
    const SpringModel::Guards guards = model.guards(q);
    for (int guard = 0; guard < SpringModel::guardCount; ++guard) {
        const Interval holds = model.interval(guard, mode);
        const double lower = std::max(holds.lower, -deepest * model.scale()[0]);
        if (!(guards[guard] > lower && guards[guard] < holds.upper)) return false;
    }
    return true;
}

/// Modes whose intervals have a width.
std::vector<Mode> modesOf(const SpringModel& model)
{
    std::vector<Mode> modes;
    for (const ContactRegion region :
         {ContactRegion::Apart, ContactRegion::Pressed, ContactRegion::Lifting, ContactRegion::Bridged})
        for (const bool front : {true, false})
            for (const bool rear : {true, false}) {
                const Mode mode{front, rear, region};
                const Interval pad = model.interval(SpringModel::Pad, mode);
                const bool neverTouches = !std::isfinite(pad.lower) && !std::isfinite(pad.upper);
                if (!(pad.upper > pad.lower) || (neverTouches && region != ContactRegion::Apart)) continue;
                const auto possible = [&](int guard) {
                    const Interval holds = model.interval(guard, mode);
                    return holds.lower < std::numeric_limits<double>::infinity();
                };
                if (possible(SpringModel::Front) && possible(SpringModel::Rear)) modes.push_back(mode);
            }
    return modes;
}

/// Spacings within an interval, dense at its end [m].
std::vector<double> axisWithin(const Interval& holds, double scale)
{
    std::vector<double> axis;
    const double ratio = farthestSpacing / nearestSpacing;
    const bool unbounded = !std::isfinite(holds.lower) && !std::isfinite(holds.upper);
    for (int i = 0; i <= cellsAlong; ++i) {
        const double share = double(i) / cellsAlong;
        if (unbounded)
            axis.push_back(scale * std::sinh((2.0 * share - 1.0) * std::asinh(farthestSpacing)));
        else if (std::isfinite(holds.lower))
            axis.push_back(holds.lower + scale * nearestSpacing * std::pow(ratio, share));
        else
            axis.push_back(holds.upper - scale * nearestSpacing * std::pow(ratio, share));
    }
    return axis;
}

/// Equilibria of one mode, at which its intervals hold.
class ModeSearch {
public:
    ModeSearch(const SpringModel& model, Mode mode) : model_(model), mode_(mode)
    {
        const SpringModel::State s = model.scale();
        scale_ = s.head<2>();
        forceScale_ = s.tail<2>() * (s[2] / s[0]);
    }

    std::vector<Point> search()
    {
        // Coordinates u_f = z + a_f theta, u_r = z - a_r theta: the spacings of both springs, unless they coincide.
        const SpringModel::Guards turned = model_.ratesOf({0.0, 1.0});
        const double front = turned[SpringModel::Front];
        double rear = -turned[SpringModel::Rear];
        const bool onePlace = !(front + rear > 0.0);
        if (onePlace) rear = scale_[0] / scale_[1];
        const std::vector<double> uf = axisWithin(model_.interval(SpringModel::Front, mode_), scale_[0]);
        const std::vector<double> ur =
            axisWithin(onePlace ? Interval{} : model_.interval(SpringModel::Rear, mode_), scale_[0]);
        const auto at = [&](double f, double r) {
            const double theta = (f - r) / (front + rear);
            return Point{f - front * theta, theta};
        };
        // Moments about one spring's place do not contain its force: each depends mostly on the other spacing.
        const Point inertia = model_.inertia();
        std::vector<Point> below(uf.size());
        std::vector<Point> row(uf.size());
        for (std::size_t j = 0; j < ur.size(); ++j) {
            for (std::size_t i = 0; i < uf.size(); ++i) {
                const Point a = forcesAt(model_, at(uf[i], ur[j]), mode_).cwiseProduct(inertia);
                row[i] = {rear * a[0] + a[1], front * a[0] - a[1]};
            }
            for (std::size_t i = 1; j > 0 && i < uf.size(); ++i) {
                const auto changes = [&](int k) {
                    const double values[] = {row[i][k], row[i - 1][k], below[i][k], below[i - 1][k]};
                    const auto [least, most] = std::ranges::minmax(values);
                    return least <= 0.0 && most >= 0.0;
                };
                if (changes(0) && changes(1)) refine(at(0.5 * (uf[i] + uf[i - 1]), 0.5 * (ur[j] + ur[j - 1])));
            }
            std::swap(row, below);
        }
        refine(model_.staticState().head<2>());
        return std::move(found_);
    }

private:
    void refine(Point q)
    {
        for (int k = 0; k < mostNewtonIterations; ++k) {
            const Point force = forcesAt(model_, q, mode_);
            const Eigen::Matrix2d slope = model_.jacobian({q[0], q[1], 0.0, 0.0}, mode_).leftCols<2>();
            const Eigen::Matrix2d scaled = forceScale_.cwiseInverse().asDiagonal() * slope * scale_.asDiagonal();
            const Point change = scaled.partialPivLu().solve(force.cwiseQuotient(forceScale_));
            if (!change.allFinite()) return;
            q -= scale_.cwiseProduct(change);
            if (change.norm() > converged * std::max(1.0, q.cwiseQuotient(scale_).norm())) continue;
            if (!holdsAt(model_, q, mode_)) return;
            const auto same = [&](const Point& other) {
                return (q - other).cwiseQuotient(scale_).norm() < apartInScales;
            };
            if (std::ranges::none_of(found_, same)) found_.push_back(q);
            return;
        }
    }

    const SpringModel& model_;
    Mode mode_;
    Point scale_, forceScale_;
    std::vector<Point> found_;
};

} // namespace

std::vector<std::complex<double>> eigenvaluesAt(const SpringModel& model, const Point& q, Mode mode)
{
    const SpringModel::State s = model.scale();
    const double rate = s[2] / s[0]; // [1/s]
    Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
    a.topRightCorner<2, 2>().setIdentity();
    a.bottomRows<2>() = model.jacobian({q[0], q[1], 0.0, 0.0}, mode);
    // In the model's scales all entries are of the order of one.
    const Eigen::Matrix4d scaled = s.cwiseInverse().asDiagonal() * a * s.asDiagonal() / rate;
    const SmallComplexVector values = eigenvaluesOf(scaled) * rate;
    std::vector<std::complex<double>> sorted(values.begin(), values.end());
    std::ranges::stable_sort(
        sorted, [](auto x, auto y) { return x.real() > y.real() || (x.real() == y.real() && x.imag() > y.imag()); });
    return sorted;
}

Stability stabilityOf(const std::vector<std::complex<double>>& eigenvalues)
{
    double largest = 0.0;
    for (const std::complex<double>& value : eigenvalues) largest = std::max(largest, std::abs(value));
    const std::complex<double> first = eigenvalues.front();
    if (std::abs(first.real()) <= neutral * largest) return Stability::Neutral;
    if (first.real() < 0.0) return Stability::Stable;
    return first.imag() == 0.0 ? Stability::Divergence : Stability::Flutter;
}

std::vector<FoundEquilibrium> springEquilibria(const SpringModel& model)
{
    std::vector<FoundEquilibrium> found;
    for (const Mode mode : modesOf(model))
        for (const Point& q : ModeSearch(model, mode).search()) found.push_back({mode, q});
    return found;
}

} // namespace touchdown
