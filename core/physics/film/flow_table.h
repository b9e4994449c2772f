// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mobility G(w) = w Q(Kn) of a film, w = p h [Pa m], Kn = lambda0 p0/w: its conductance is h^2 G/(12 mu). Tabulated
// on the bits of w, 32 cubic pieces per octave, without logarithms; relative error of G below 1e-7
// (Fukui-Kaneko: 4e-9). The fit of Fukui & Kaneko is evaluated directly, with its jumps.
//
// G depends on the air as p0 lambda0 times a function of w/(p0 lambda0): dG/d(p0 lambda0) = (G - w dG/dw)/(p0 lambda0).
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/physics/film/air.h"
#include "core/physics/film/slip.h"

namespace touchdown {

/// One slip model's mobility at any w. w <= 0 counts as the smallest entry of the table, NaN stays NaN.
class Mobility {
public:
    struct Value {
        double mobility;   // G [Pa m]
        double derivative; // dG/dw, exactly that of `mobility` [-]
    };

    Mobility() = default; // the continuum's
    /// Not the combination.
    Mobility(SlipModel model, double accommodation, const Air& air);

    Value at(double w) const
    {
        const std::uint64_t index = (std::bit_cast<std::uint64_t>(w) >> pieceShift) - firstPiece_;
        if (index >= pieces_.size()) [[unlikely]]
            return direct(w);
        const double knot = std::bit_cast<double>((index + firstPiece_) << pieceShift);
        const Piece& c = pieces_[index];
        const double d = w - knot;
        return {c.c0 + d * (c.c1 + d * (c.c2 + d * c.c3)), c.c1 + d * (2.0 * c.c2 + d * (3.0 * c.c3))};
    }

    /// The same for many w at once.
    void at(std::span<const double> w, std::span<double> mobility, std::span<double> derivative) const;

    /// The formula that the table holds.
    Value direct(double w) const;

private:
    /// The exponent and the first five bits of the fraction number the pieces.
    static constexpr int pieceShift = 52 - 5;

    struct alignas(32) Piece {
        double c0, c1, c2, c3; // of (w - knot)^k
    };

    /// G = w 6 Q_P/D with w/D the same for all w [Pa m].
    double perFlowRate() const { return 6.0 / inverseKnudsen(1.0) * unit_; }

    SlipLaw law_ = slipLaws().front(); // the continuum
    double first_ = 0.0;               // of the expansion, with accommodation [-]
    double unit_ = 1.0;                // p0 lambda0 [Pa m]: w where Kn = 1
    double smallest_ = 6e-5;           // [Pa m]
    std::uint64_t firstPiece_ = 0;
    std::vector<Piece> pieces_;
};

/// The mobility of any slip model; the gap selects the branch of the combination.
class FlowTable {
public:
    using Value = Mobility::Value;

    FlowTable() = default;
    FlowTable(const Slip& slip, const Air& air);

    /// w = p h [Pa m], the gap [m]; the derivative by w holds the gap.
    Value at(double w, double gap) const { return gap > blendEnd_ ? wide_.at(w) : narrow(w, gap); }

    /// The same for many at once; any number where the gap is closed.
    void at(std::span<const double> w, std::span<const double> gap, std::span<double> mobility,
            std::span<double> derivative) const;

    /// dG/dgap at constant w [Pa]: zero but within the combination's blend.
    double gapDerivative(double w, double gap) const
    {
        return gap > blendStart_ && gap < blendEnd_ ? blendDerivative(w, gap) : 0.0;
    }

private:
    Value narrow(double w, double gap) const;
    double blendDerivative(double w, double gap) const;

    static constexpr double noGap = -std::numeric_limits<double>::infinity(); // without a combination

    Mobility wide_;                                // Fukui-Kaneko in the combination, else the only one
    Mobility narrow_;                              // new second order in the combination
    double blendStart_ = noGap, blendEnd_ = noGap; // [m]
};

} // namespace touchdown
