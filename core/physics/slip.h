// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flow factor Q(Kn) of a rarefied film: the Poiseuille flow in units of the continuum's. Kn = lambda(p)/h, D = (sqrt(pi)/2)/Kn,
// a = (2 - alpha)/alpha with alpha the accommodation coefficient.
//
//   continuum            1
//   first order          1 + 6 a Kn                      Burgdorfer 1959
//   second order         1 + 6 Kn + 6 Kn^2               Hsia & Domoto 1983
//   1.5 order            1 + 6 a Kn + (8/3) Kn^2         Mitsuya 1993
//   Fukui-Kaneko         6 Q_P(D)/D                      Fukui & Kaneko 1988, 1990: kinetic values, or their fit
//   new first order      1 + 4 a Kn                      Wu & Bogy 2003
//   new second order     1 + 4 a Kn + 3 Kn^2             Wu & Bogy 2003
//   combination          Fukui-Kaneko above a gap of 0.3 nm, new second order below (Chen & Bogy, section 2); hard, as there, or
//                        blended over a stated width
#pragma once

#include <cstdint>
#include <vector>

#include "core/physics/air.h"

namespace touchdown {

enum class SlipModel : std::uint8_t {
    Continuum,
    FirstOrder,
    SecondOrder,
    OnePointFiveOrder,
    FukuiKaneko,    // from the kinetic values
    FukuiKanekoFit, // the published fit, with its jumps at D = 5 and 0.15
    NewFirstOrder,
    NewSecondOrder,
    Combination,
};

struct Slip {
    SlipModel model = SlipModel::FukuiKaneko;
    double accommodation = 1.0;    // alpha [-], (0, 1]; Fukui-Kaneko and Hsia-Domoto: 1 only
    double switchGap = 0.3e-9;     // combination: gap of the switch [m]
    double blendWidth = 0.0;       // combination: width of the blend about the switch [m]; 0: the paper's hard switch
};

/// Poiseuille flow rate Q_P(D) from the kinetic (BGK) values, alpha = 1, smooth and with a monotone 6 Q_P/D. D > 0.
double kineticFlowRate(double inverseKnudsen);
/// The published three-part fit of it.
double fittedFlowRate(double inverseKnudsen);
/// Q(Kn) of a model other than the combination.
double flowFactor(const Slip& slip, double knudsen);

/// The mobility G(w) = w Q(Kn), w = p h [Pa m], Kn = lambda0 p0/w: the film's conductance is h^2 G/(12 mu). Tabulated on the bits
/// of w (eight cubic pieces an octave), so that no logarithm is taken; relative error of G below 1e-7.
class FlowTable {
public:
    FlowTable() = default;
    FlowTable(const Slip& slip, const Air& air);

    struct Value {
        double mobility;   // G [Pa m]
        double derivative; // dG/dw [-]
    };
    /// w > 0 [Pa m]; the gap selects the branch of the combination.
    Value at(double w, double gap) const;
};

} // namespace touchdown
