// SPDX-License-Identifier: GPL-3.0-or-later
//
// The law of one cell of an adhesive contact: total pressure q against gap g.
//
//   contact   g = 0, f(0) <= q <= f(0) + H: the contact pressure p = q - f(0) is between zero and the hardness
//   near      0 < g < g_peak: q = f(g) falls with the gap: stable by itself
//   far       g >= g_peak: q = f(g) softens: only the half-space holds the cell
//   flowed    g < 0, q = f(0) + H: the softer body has flowed
//
// The energy is concave beyond g_peak. There it is replaced by its tangent at a gap g_0, which gives a law that falls
// everywhere: q = f(g) + d up to g_peak and constant beyond, d = f(g_0) - f(g_peak) for g_0 > g_peak, else 0. Its
// energy is nowhere below the true energy and equals it at g_0.
//
// For a pair (g, q) that is not on the law, v = g - c q decides, c the cell's own compliance: with all other cells at
// rest the cell moves along g - c q = v, which meets the law once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/physics/contact/adhesion.h"

namespace touchdown {

class AdhesiveCell {
public:
    enum class State : std::uint8_t { Contact, Near, Far, Flowed };

    /// The tangent at the law's point for (g, q): q = pressure - stiffness (g - gap).
    struct Tangent {
        State state;
        double gap;       // [m]
        double pressure;  // total, q [Pa]; in contact the given one
        double stiffness; // -dq/dg >= 0 [Pa/m]; unused in contact, where it is infinite
    };

    /// `compliance` c [m/Pa]; `hardness` H [Pa], 0: none.
    AdhesiveCell(const AdhesionLaw& law, double compliance, double hardness);

    /// d of the law that touches at the gap g_0 [Pa].
    double offset(double gap) const { return gap > law_.peakGap() ? law_.pressure(gap) + law_.peakAttraction() : 0.0; }
    Tangent tangent(double gap, double pressure, double offset) const;

    /// Those of many cells, field by field; the stiffness in contact is infinite.
    struct Tangents {
        std::vector<State> state;
        std::vector<double> gap, pressure, stiffness;
        explicit Tangents(std::size_t cells = 0) : state(cells), gap(cells), pressure(cells), stiffness(cells) {}
    };
    void tangents(std::span<const double> gap, std::span<const double> pressure, std::span<const double> offset,
                  Tangents& out) const;
    void offsets(std::span<const double> gap, std::span<double> offset) const;

    /// phi(g); for a gap below zero also the work of flow against q [J/m^2].
    double energy(double gap) const;
    /// The gap of a total pressure on the offset law [m]: zero in contact, g_peak below the lowest pressure.
    double gapUnder(double pressure, double offset) const;
    /// Range of pressures of the offset law [Pa].
    double lowest(double offset) const { return offset - law_.peakAttraction(); }
    double highest(double offset) const { return offset + ceiling_; }

    const AdhesionLaw& law() const { return law_; }
    double compliance() const { return compliance_; }
    /// f(0) [Pa].
    double closedPressure() const { return closed_; }

private:
    AdhesionLaw law_;
    double compliance_;
    double closed_;                                            // f(0) [Pa]
    double ceiling_ = std::numeric_limits<double>::infinity(); // f(0) + H [Pa]
    double farLine_;                                           // v where it is at g_peak [m]
};

} // namespace touchdown
