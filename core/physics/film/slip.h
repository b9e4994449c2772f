// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flow factor Q(Kn) of a rarefied film: the Poiseuille flow in units of the continuum's. Kn = lambda(p)/h,
// D = (sqrt(pi)/2)/Kn, a = (2 - alpha)/alpha with alpha the accommodation coefficient. The models:
// core/physics/film/slip_model.h.
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
