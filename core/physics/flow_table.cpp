// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/flow_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/physics/kinetic_flow_rate.h"

namespace touchdown {

namespace {

/// From 2^-14 to 2^20 times p0 lambda0: Kn from 16000 to 1e-6.
constexpr int octavesBelow = 14, octavesAbove = 20;

} // namespace

Mobility::Mobility(SlipModel model, double accommodation, const Air& air)
    : model_(model), unit_(air.pressure * air.meanFreePath)
{
    assert(model != SlipModel::Combination && unit_ > 0.0);
    const int octave = std::ilogb(unit_);
    smallest_ = std::ldexp(1.0, octave - octavesBelow);
    if (model == SlipModel::FukuiKanekoFit) return;
    if (model != SlipModel::FukuiKaneko) expansion_ = slipExpansion(model, accommodation);

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

Mobility::Value Mobility::direct(double w) const
{
    if (std::isnan(w)) return {w, w};
    // Beyond 1e-100 and 1e100 all are alike, so that nothing leaves the numbers' range.
    w = w > 0.0 ? std::clamp(w, 1e-100 * unit_, 1e100 * unit_) : smallest_;
    if (model_ == SlipModel::FukuiKaneko || model_ == SlipModel::FukuiKanekoFit) {
        // G = w 6 Q_P/D with w/D the same for all w.
        const double perFlowRate = 6.0 / inverseKnudsen(1.0) * unit_;
        const double d = inverseKnudsen(unit_ / w);
        const FlowRate q = model_ == SlipModel::FukuiKaneko ? kineticFlowRate(d) : fittedFlowRate(d);
        return {perFlowRate * q.value, perFlowRate * q.logSlope / w};
    }
    const double knudsen = unit_ / w;
    return {w + unit_ * (expansion_.first + expansion_.second * knudsen), 1.0 - expansion_.second * knudsen * knudsen};
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

/// Weight of the wide gap's model: 3 s^2 - 2 s^3 with s the fraction of the blend, so that G is continuously differentiable.
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
