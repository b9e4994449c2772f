// SPDX-License-Identifier: GPL-3.0-or-later
//
// Energy balance of the film's air at constant temperature. The available energy is sum psi V, psi(p) = p ln(p/p0) - p
// + p0. The mass balance d(V p)/dt + R = 0 of the cells times ln(p/p0), summed, is
//
//   d(sum psi V)/dt = - sum (p - p0) dV/dt - sum ln(p/p0) R,   - sum ln(p/p0) R = input - dissipation,
//
// the work of slider and disk on the volumes, and the power of the flows. A face with the flow F = A p1 - B p2
// (path_flow.h) dissipates, with x = ln(p1/p2),
//
//   F x - (A - B)(p1 - p2) = A p1 (x - 1 + exp(-x)) + B p2 (exp(x) - 1 - x) >= 0,
//
// where it is smooth the integral of Q h^3 (grad p)^2/(12 mu p). The input is the power of the disk's motion, U h grad
// p/2, with the corrections of the complete flux scheme. Neither contains the power of Couette's shear.
#pragma once

#include <span>
#include <vector>

namespace touchdown {

class GasFilm;

struct FilmEnergyState {
    double stored = 0.0;      // [J]
    double input = 0.0;       // [W]
    double dissipation = 0.0; // >= 0 [W]
};

class FilmEnergy {
public:
    /// The film must last.
    explicit FilmEnergy(const GasFilm& film);

    /// At the pressures (padded) at the end of a time step, or in a steady state. The flows are those of the film's
    /// last residual, before the step's last small change of the pressures; their net power is taken from the storage
    /// of the cells. Allocates nothing.
    FilmEnergyState at(std::span<const double> p);

    /// Work of the disk's surface on the air between two states: sum of A (p - p0) dw, trapezoidal rule; padded [J].
    double surfaceWork(std::span<const double> p1, std::span<const double> p2, std::span<const double> height1,
                       std::span<const double> height2) const;
    /// The same from the volumes of the cells [J].
    double volumeWork(std::span<const double> p1, std::span<const double> p2, std::span<const double> volume1,
                      std::span<const double> volume2) const;

private:
    const GasFilm& film_;
    std::vector<double> log_, inverse_; // ln(p/p0) [-], p0/p [-]; padded
    std::vector<double> rowSums_;       // two by row
};

} // namespace touchdown
