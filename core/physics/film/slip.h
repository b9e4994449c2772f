// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flow factor Q(Kn) of a rarefied film: the Poiseuille flow in units of the continuum's. Kn = lambda(p)/h,
// D = (sqrt(pi)/2)/Kn, a = (2 - alpha)/alpha with alpha the accommodation coefficient.
//
//   continuum            1
//   first order          1 + 6 a Kn                      Burgdorfer 1959
//   second order         1 + 6 Kn + 6 Kn^2               Hsia & Domoto 1983
//   1.5 order            1 + 6 a Kn + (8/3) Kn^2         Mitsuya 1993
//   Fukui-Kaneko         6 Q_P(D)/D                      Fukui & Kaneko 1988, 1990: kinetic values, or their fit
//   new first order      1 + 4 a Kn                      Wu & Bogy 2003
//   new second order     1 + 4 a Kn + 3 Kn^2             Wu & Bogy 2003
//   combination          Fukui-Kaneko above a gap of 0.3 nm, new second order below (Chen & Bogy, section 2); a hard
//                        switch, as there, or blended over a given width
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace touchdown {

struct FlowRate;

enum class SlipModel : std::uint8_t; // core/physics/film/slip_model.h
extern const SlipModel usualSlip;    // Fukui-Kaneko

struct Slip {
    SlipModel model = usualSlip;
    double accommodation = 1.0; // alpha [-], (0, 1]; Fukui-Kaneko and Hsia-Domoto: 1 only
    double switchGap = 0.3e-9;  // combination: gap of the switch [m]
    double blendWidth = 0.0;    // combination: width of the blend about the switch [m]; 0: the paper's hard switch
    bool operator==(const Slip&) const = default;
};

/// A model: its kinetic flow rate, or else the expansion Q = 1 + first Kn + second Kn^2. Choices, help and checks of
/// the key "air.slip" come from here.
struct SlipLaw {
    std::string_view name{};            // in case files
    std::string_view label{};           // in the window, at most 19 characters
    std::string_view meaning{};         // one sentence, with the source
    bool knowsAccommodation = true;     // else walls are diffuse, alpha = 1
    double first = 0.0, second = 0.0;   // `first` times a where the model knows accommodation [-]
    FlowRate (*rate)(double) = nullptr; // Q_P(D)
    bool tabulated = true;              // else evaluated directly: a table would smooth its jumps

    double firstOrder(double accommodation) const
    {
        return knowsAccommodation ? first * ((2.0 - accommodation) / accommodation) : first;
    }
};
/// All models, in the order of the enumerators.
std::span<const SlipLaw> slipLaws();
const SlipLaw& slipLaw(SlipModel model);

/// Q(Kn) of a model other than the combination; Kn > 0.
double flowFactor(const Slip& slip, double knudsen);

/// D = (sqrt(pi)/2)/Kn
double inverseKnudsen(double knudsen);

} // namespace touchdown
