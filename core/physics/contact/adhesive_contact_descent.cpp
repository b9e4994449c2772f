// SPDX-License-Identifier: GPL-3.0-or-later
//
// One descent of the adhesive contact: the minimum of the energy with its concave part replaced by tangents.
#include "core/physics/contact/adhesive_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/numerics/line_minimum.h"
#include "core/numerics/vector_clones.h"

namespace touchdown {
namespace {

using enum AdhesiveCell::State;

constexpr double residualShare = 0.1; // to which conjugate gradients reduce the residual of one set of tangents
constexpr double errorShare = 0.3;    // to which a descent reduces the error of its convex law
constexpr int mostNewtonSteps = 6;    // that it takes for it
constexpr int mostGradientSteps = 200;
/// A cell whose stiffness times its compliance is less keeps its pressure while the others change theirs.
constexpr double leastStiffness = 1e-3;

/// Largest values over all cells, and a sum that is no number if any is.
struct Deviation {
    double pressure = 0.0, displacement = 0.0; // sizes [Pa], [m]
    double ofPressure = 0.0, ofGap = 0.0;      // from the law [Pa], [m]
    double all = 0.0;
};
struct Cells {
    std::size_t count;
    double compliance, ownStiffness; // [m/Pa], [Pa/m]
};
struct Present {
    const double *gap, *total, *displacement;
};
struct Law {
    const double *gap, *pressure, *stiffness;
};

/// Also sets the weights and the residuals of solveTangents().
TOUCHDOWN_VECTOR_CLONES Deviation deviate(Cells cells, Present at, Law law, double* weight, double* residual)
{
    constexpr std::size_t parts = 8;
    double pressure[parts] = {}, displacement[parts] = {}, ofPressure[parts] = {}, ofGap[parts] = {}, all[parts] = {};
    const auto larger = [](double a, double b) { return a > b ? a : b; };
    const auto visit = [&](std::size_t i, std::size_t k) {
        const double stiffness = law.stiffness[i], gap = law.gap[i] - at.gap[i], change = law.pressure[i] - at.total[i];
        const bool moves = stiffness * cells.compliance > leastStiffness;
        // In contact the stiffness is infinite: weight 1, residual -g.
        const double soft = moves ? stiffness : 1.0;
        const double share = 1.0 / std::sqrt(1.0 + cells.ownStiffness / soft), rest = change / soft + gap;
        weight[i] = moves ? share : 0.0;
        residual[i] = moves ? rest : 0.0;
        pressure[k] = larger(std::abs(at.total[i]), pressure[k]);
        displacement[k] = larger(std::abs(at.displacement[i]), displacement[k]);
        ofPressure[k] = larger(std::abs(change), ofPressure[k]);
        ofGap[k] = larger(std::abs(gap), ofGap[k]);
        all[k] += at.gap[i] + at.total[i];
    };
    std::size_t i = 0;
    for (; i + parts <= cells.count; i += parts)
#pragma GCC ivdep
        for (std::size_t k = 0; k < parts; ++k) visit(i + k, k);
    for (; i < cells.count; ++i) visit(i, 0);
    Deviation result;
    for (std::size_t k = 0; k < parts; ++k) {
        result.pressure = std::max(result.pressure, pressure[k]);
        result.displacement = std::max(result.displacement, displacement[k]);
        result.ofPressure = std::max(result.ofPressure, ofPressure[k]);
        result.ofGap = std::max(result.ofGap, ofGap[k]);
        result.all += all[k];
    }
    return result;
}

double product(std::span<const double> a, std::span<const double> b)
{
    return sumInLanes(a.size(), [&](std::size_t k) { return a[k] * b[k]; });
}

} // namespace

void AdhesiveContact::displace()
{
    space_->displace(now_.total, now_.displacement);
    now_.displaced = true;
    countIteration();
}

void AdhesiveContact::countIteration()
{
    ++iterations_;
    stopped_ = stopped_ || (options_.goOn && !options_.goOn());
}

// The law touches at the present gaps.
void AdhesiveContact::setOffsets()
{
    for (std::size_t i = 0; i < present_.size(); ++i) present_[i] = gapAt(i);
    cell_.offsets(present_, offset_);
}

// The tangents of the law that is set by the offsets, and the largest deviation from it.
double AdhesiveContact::linearise()
{
    for (std::size_t i = 0; i < present_.size(); ++i) present_[i] = gapAt(i);
    cell_.tangents(present_, now_.total, offset_, tangents_);
    const Deviation deviation = deviate({present_.size(), cell_.compliance(), space_->ownStiffness()},
                                        {present_.data(), now_.total.data(), now_.displacement.data()},
                                        {tangents_.gap.data(), tangents_.pressure.data(), tangents_.stiffness.data()},
                                        weight_.data(), residual_.data());
    if (!std::isfinite(deviation.all)) return deviation.all;
    const double gapScale = std::max(deviation.displacement, cell_.compliance() * deviation.pressure);
    if (!(deviation.pressure > 0.0)) return std::max(deviation.ofPressure, deviation.ofGap) > 0.0 ? 1.0 : 0.0;
    return std::max(deviation.ofPressure / deviation.pressure, deviation.ofGap / gapScale);
}

// Distance of the gaps on the law from the displacements by the pressures on the law, less the rounding of the gaps.
double AdhesiveContact::imbalance()
{
    for (std::size_t i = 0; i < work_.size(); ++i) work_[i] = tangents_.pressure[i] - now_.total[i];
    space_->displace(work_, work_);
    ++iterations_;
    double error = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < work_.size(); ++i) {
        const double u = now_.displacement[i] + work_[i];
        const double sizes = std::abs(now_.separation[i]) +
                             cell_.compliance() * std::abs(now_.total[i]); // that the law's gap is made of
        const double rounding = 2.0 * std::numeric_limits<double>::epsilon() * sizes;
        error = std::max(error, std::abs(tangents_.gap[i] - now_.separation[i] - u) - rounding);
        scale = std::max(scale, std::abs(u));
    }
    return scale > 0.0 ? error / scale : error > 0.0 ? 1.0 : 0.0;
}

// Where the concave part's tangents touch, unless at the present gaps: whether any does elsewhere.
bool AdhesiveContact::setTangents(bool first)
{
    if (first) {
        // The surfaces moved while what adheres stayed: the first tangents touch at the gaps of the last solution.
        for (std::size_t i = 0; i < offset_.size(); ++i)
            offset_[i] = cell_.offset(before_.separation[i] + before_.displacement[i]);
    } else if (ahead_ > 0.0) {
        // Ahead of the present gaps, no farther than at twice or half their distance.
        for (std::size_t i = 0; i < offset_.size(); ++i) {
            const double g = gapAt(i), distance = g + freeScale_;
            if (!(g > cell_.law().peakGap())) continue;
            const double step = ahead_ * (now_.displacement[i] - displacementEarlier_[i]);
            offset_[i] = cell_.offset(g + std::clamp(step, -0.5 * distance, distance));
        }
    }
    return first || ahead_ > 0.0;
}

// From the error that the present tangents have. Returns the largest change of a displacement [m].
double AdhesiveContact::descend(double error)
{
    displacementEarlier_ = now_.displacement;
    minimiseConvex(error);
    double moved = 0.0;
    for (std::size_t i = 0; i < offset_.size(); ++i)
        moved = std::max(moved, std::abs(now_.displacement[i] - displacementEarlier_[i]));
    return moved;
}

// Until the error is a share of `error`, what it is now.
void AdhesiveContact::minimiseConvex(double error)
{
    double last = error;
    for (int step = 0; step < mostNewtonSteps; ++step) {
        totalBefore_ = now_.total;
        displacementBefore_ = now_.displacement;
        bool changed = false;
        for (std::size_t i = 0; i < offset_.size(); ++i) {
            if (weight_[i] > 0.0 || now_.total[i] == tangents_.pressure[i]) continue;
            now_.total[i] = tangents_.pressure[i];
            changed = true;
        }
        if (changed) {
            displace();
            linearise();
        }
        solveTangents();
        double now = linearise();
        if (now > 0.5 * last && cutStep()) now = linearise();
        last = now;
        if (!(last > errorShare * error) || spent()) break;
    }
}

// (C + 1/D) dq = (q_law - q)/D + g_law - g on the cells with a weight, D = -dq/dg; others take the law's pressure. The
// displacement follows from those of the directions, unless a pressure meets a bound.
void AdhesiveContact::solveTangents()
{
    const std::size_t n = offset_.size();
    for (auto* field : {&change_, &moved_}) std::fill(field->begin(), field->end(), 0.0);
    precondition(residual_, direction_);
    double square = product(residual_, direction_);
    const double enough = residualShare * residualShare * square;
    for (int k = 0; k < mostGradientSteps && square > enough && !spent(); ++k) {
        space_->displace(direction_, shift_);
        countIteration();
        for (std::size_t i = 0; i < n; ++i)
            image_[i] = weight_[i] > 0.0 ? shift_[i] + direction_[i] / tangents_.stiffness[i] : 0.0;
        const double curvature = product(direction_, image_);
        if (!(curvature > 0.0)) break;
        const double length = square / curvature;
        for (std::size_t i = 0; i < n; ++i) {
            change_[i] += length * direction_[i];
            moved_[i] += length * shift_[i];
            residual_[i] -= length * image_[i];
        }
        precondition(residual_, image_);
        const double next = product(residual_, image_);
        const double turn = next / square;
        square = next;
        for (std::size_t i = 0; i < n; ++i) direction_[i] = image_[i] + turn * direction_[i];
    }
    bool bounded = false;
    for (std::size_t i = 0; i < n; ++i) {
        const double free = now_.total[i] + change_[i];
        const double next = weight_[i] > 0.0 ? std::clamp(free, cell_.lowest(offset_[i]), cell_.highest(offset_[i]))
                                             : tangents_.pressure[i];
        bounded = bounded || next != free;
        now_.total[i] = next;
    }
    if (bounded) return displace();
    for (std::size_t i = 0; i < n; ++i) now_.displacement[i] += moved_[i];
}

// The stiffness of the half-space as if the grid repeated, and for the mean what a uniform pressure meets; between it
// weights that make the diagonal right where 1/D is added.
void AdhesiveContact::precondition(std::span<const double> in, std::span<double> out)
{
    const auto nx = static_cast<std::size_t>(space_->grid().nx),
               stride = static_cast<std::size_t>(periodic_->grid().nx);
    double mean = 0.0;
    std::fill(repeated_.begin(), repeated_.end(), 0.0);
    for (std::size_t i = 0; i < in.size(); ++i) mean += work_[i] = weight_[i] * in[i];
    mean /= static_cast<double>(in.size());
    for (std::size_t row = 0; row * nx < in.size(); ++row)
        std::copy_n(work_.data() + row * nx, nx, repeated_.data() + row * stride);
    periodic_->stress(repeated_, repeated_);
    for (std::size_t row = 0; row * nx < in.size(); ++row)
        std::copy_n(repeated_.data() + row * stride, nx, work_.data() + row * nx);
    for (std::size_t i = 0; i < in.size(); ++i) out[i] = weight_[i] * (work_[i] + mean / reach_);
}

// The energy, convex in q, has the slope g - g_law(q). A step at whose end it rises is cut at its minimum.
bool AdhesiveContact::cutStep()
{
    const std::size_t n = offset_.size();
    const auto slope = [&](double part) {
        double sum = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double step = now_.total[i] - totalBefore_[i];
            if (step == 0.0) continue;
            const double u = displacementBefore_[i] + part * (now_.displacement[i] - displacementBefore_[i]);
            sum += (now_.separation[i] + u - cell_.gapUnder(totalBefore_[i] + part * step, offset_[i])) * step;
        }
        return sum;
    };
    if (!(slope(1.0) > 0.0)) return false;
    const double part = lineMinimum(slope);
    if (part == 1.0) return false;
    if (part == 0.0) {
        // No descent: a step along the gradient instead, too short to pass the least energy.
        for (std::size_t i = 0; i < n; ++i) {
            const double gap =
                now_.separation[i] + displacementBefore_[i] - cell_.gapUnder(totalBefore_[i], offset_[i]);
            now_.total[i] =
                std::clamp(totalBefore_[i] - gap / reach_, cell_.lowest(offset_[i]), cell_.highest(offset_[i]));
        }
        displace();
        return true;
    }
    shorten(part);
    return true;
}

void AdhesiveContact::shorten(double part)
{
    for (std::size_t i = 0; i < now_.total.size(); ++i) {
        now_.total[i] = totalBefore_[i] + part * (now_.total[i] - totalBefore_[i]);
        now_.displacement[i] = displacementBefore_[i] + part * (now_.displacement[i] - displacementBefore_[i]);
    }
}

} // namespace touchdown
