// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/flow_table.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/kinetic_flow_rate.h"
#include "core/physics/film/slip_model.h"

namespace touchdown {

namespace {

/// From 2^-14 to 2^20 times p0 lambda0: Kn from 16000 to 1e-6.
constexpr int octavesBelow = 14, octavesAbove = 20;

/// c0 + c1 d + c2 d^2 + c3 d^3 of the piece of each w; returns the number of w outside the table, with invalid results.
template <int shift>
TOUCHDOWN_VECTOR_CLONES std::uint64_t evaluate(std::size_t n, const double* w, const double* coefficients,
                                               std::uint64_t firstPiece, std::uint64_t pieces, double* mobility,
                                               double* derivative)
{
    std::uint64_t outside = 0;
    // Whole pieces are fetched one by one, which is faster than gathering their coefficients lane by lane.
    constexpr std::size_t most = 64;
    std::array<std::uint64_t, most> at;
    std::array<double, most> distance;
    std::array<double, 4 * most> c;
    for (std::size_t first = 0; first < n; first += most) {
        const std::size_t count = std::min(most, n - first);
#pragma GCC ivdep
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint64_t number = std::bit_cast<std::uint64_t>(w[first + k]) >> shift,
                                place = number - firstPiece;
            const bool inside = place < pieces;
            distance[k] = w[first + k] - std::bit_cast<double>(number << shift);
            at[k] = inside ? 4 * place : 0;
            outside += inside ? 0 : 1;
        }
        for (std::size_t k = 0; k < count; ++k) std::memcpy(&c[4 * k], coefficients + at[k], 4 * sizeof(double));
#pragma GCC ivdep
        for (std::size_t k = 0; k < count; ++k) {
            const double c0 = c[4 * k], c1 = c[4 * k + 1], c2 = c[4 * k + 2], c3 = c[4 * k + 3], d = distance[k];
            mobility[first + k] = c0 + d * (c1 + d * (c2 + d * c3));
            derivative[first + k] = c1 + d * (2.0 * c2 + d * (3.0 * c3));
        }
    }
    return outside;
}

/// The same for the fit's three parts; outside is the part of the free molecules' law.
TOUCHDOWN_VECTOR_CLONES std::uint64_t evaluateFit(std::size_t n, const double* w, double perUnit, double perFlowRate,
                                                  double* mobility, double* derivative)
{
    std::uint64_t outside = 0;
#pragma GCC ivdep
    for (std::size_t k = 0; k < n; ++k) {
        const double d = perUnit * w[k];
        const FlowRate q = fittedParts(d);
        mobility[k] = perFlowRate * q.value;
        derivative[k] = perFlowRate * q.logSlope / w[k];
        outside += d >= leastFittedInverseKnudsen && d < 1e50 ? 0 : 1;
    }
    return outside;
}

} // namespace

Mobility::Mobility(SlipModel model, double accommodation, const Air& air)
    : law_(slipLaw(model)), first_(law_.firstOrder(accommodation)), unit_(air.pressure * air.meanFreePath)
{
    assert(model != SlipModel::Combination && unit_ > 0.0);
    const int octave = std::ilogb(unit_);
    smallest_ = std::ldexp(1.0, octave - octavesBelow);
    if (!law_.tabulated) return;

    firstPiece_ = std::bit_cast<std::uint64_t>(smallest_) >> pieceShift;
    const std::uint64_t end = std::bit_cast<std::uint64_t>(std::ldexp(1.0, octave + octavesAbove)) >> pieceShift;
    pieces_.reserve(end - firstPiece_);
    double left = smallest_;
    Value a = direct(left);
    for (std::uint64_t i = firstPiece_; i < end; ++i) {
        const double right = std::bit_cast<double>((i + 1) << pieceShift);
        const double width = right - left;
        const Value b = direct(right);
        const double slope = (b.mobility - a.mobility) / width;
        pieces_.push_back({a.mobility, a.derivative, (3.0 * slope - 2.0 * a.derivative - b.derivative) / width,
                           (a.derivative + b.derivative - 2.0 * slope) / (width * width)});
        left = right;
        a = b;
    }
}

void Mobility::at(std::span<const double> w, std::span<double> mobility, std::span<double> derivative) const
{
    static_assert(sizeof(Piece) == 4 * sizeof(double));
    std::uint64_t outside = w.size();
    if (!pieces_.empty())
        outside = evaluate<pieceShift>(w.size(), w.data(), &pieces_[0].c0, firstPiece_, pieces_.size(), mobility.data(),
                                       derivative.data());
    else if (law_.rate == fittedFlowRate)
        outside = evaluateFit(w.size(), w.data(), inverseKnudsen(1.0) / unit_, perFlowRate(), mobility.data(),
                              derivative.data());
    if (outside == 0) return;
    for (std::size_t k = 0; k < w.size(); ++k) {
        const Value value = at(w[k]);
        mobility[k] = value.mobility;
        derivative[k] = value.derivative;
    }
}

Mobility::Value Mobility::direct(double w) const
{
    if (std::isnan(w)) return {w, w};
    // Beyond 1e-100 and 1e100 all are alike, so that nothing leaves the numbers' range.
    w = w > 0.0 ? std::clamp(w, 1e-100 * unit_, 1e100 * unit_) : smallest_;
    if (law_.rate) {
        const FlowRate q = law_.rate(inverseKnudsen(unit_ / w));
        return {perFlowRate() * q.value, perFlowRate() * q.logSlope / w};
    }
    const double knudsen = unit_ / w;
    return {w + unit_ * (first_ + law_.second * knudsen), 1.0 - law_.second * knudsen * knudsen};
}

FlowTable::FlowTable(const Slip& slip, const Air& air)
{
    if (slip.model != SlipModel::Combination) {
        wide_ = Mobility(slip.model, slip.accommodation, air);
        return;
    }
    wide_ = Mobility(SlipModel::FukuiKaneko, slip.accommodation, air);
    narrow_ = Mobility(SlipModel::NewSecondOrder, slip.accommodation, air);
    blendStart_ = slip.switchGap - 0.5 * slip.blendWidth;
    blendEnd_ = slip.switchGap + 0.5 * slip.blendWidth;
}

void FlowTable::at(std::span<const double> w, std::span<const double> gap, std::span<double> mobility,
                   std::span<double> derivative) const
{
    wide_.at(w, mobility, derivative);
    if (blendEnd_ == noGap) return;
    for (std::size_t k = 0; k < w.size(); ++k) {
        if (gap[k] > blendEnd_ || gap[k] <= 0.0) continue;
        const Value value = narrow(w[k], gap[k]);
        mobility[k] = value.mobility;
        derivative[k] = value.derivative;
    }
}

/// Weight of the wide gap's model: 3 s^2 - 2 s^3, s the fraction of the blend: G is continuously differentiable.
FlowTable::Value FlowTable::narrow(double w, double gap) const
{
    const Value low = narrow_.at(w);
    if (gap <= blendStart_) return low;
    const Value high = wide_.at(w);
    const double s = (gap - blendStart_) / (blendEnd_ - blendStart_);
    const double weight = s * s * (3.0 - 2.0 * s);
    return {low.mobility + weight * (high.mobility - low.mobility),
            low.derivative + weight * (high.derivative - low.derivative)};
}

double FlowTable::blendDerivative(double w, double gap) const
{
    const double width = blendEnd_ - blendStart_;
    const double s = (gap - blendStart_) / width;
    return 6.0 * s * (1.0 - s) / width * (wide_.at(w).mobility - narrow_.at(w).mobility);
}

} // namespace touchdown
