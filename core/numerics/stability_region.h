// SPDX-License-Identifier: GPL-3.0-or-later
//
// Growth of a linear motion in a step of length h: the largest factor by which the difference of two initial states
// grows per step (the spectral radius of the step's matrix). A method is stable where it is at most 1. The matrices
// are found by steps of the integrators themselves on linear systems.
//
//   growth(z)           of y' = lambda y, z = lambda h: |R(z)| of a Runge-Kutta method; the largest root of a
//                       backward difference; with Newmark's rule, the oscillator whose eigenvalues are lambda and its
//                       conjugate: omega h = |z|, zeta = -Re z/|z|
//   coupledGrowth(w)    of a mass on a film that is a spring k with a leak (Maxwell), omega^2 = k/M, w = omega h; by
//                       default with the formula fitted to omega, as in runs:
//
//       q'' = -2 zeta omega q' - omega^2 (q - m),   m' = s (q - m),   q - m: compression of the film, m: leakage
//
//   the mass by Newmark's rule with gamma 1/2, the film by a backward difference, coupled
//     monolithic   both at once
//     iterated     staggered until both agree: the same where it converges, beta w^2 (1 - s/(s + c/h)) < 1 + zeta w,
//                  with c/h the weight of m in the backward difference; infinite elsewhere
//     staggered    a given number of times; once is one-way: the mass moves under the film's last force, then the
//                  film follows
#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "core/numerics/backward_difference.h"

namespace touchdown {

using Growth = std::function<double(std::complex<double> z)>;

double rk4Growth(std::complex<double> z);
/// The fifth-order result, with which the method continues.
double dopri5Growth(std::complex<double> z);
double newmarkGrowth(double beta, double gamma, std::complex<double> z);
/// `phase`: omega h of the fitted formula [-].
double backwardGrowth(BackwardRule rule, std::complex<double> z, double phase = 0.0);

enum class CouplingKind { Monolithic, Iterated, InTurns };

struct CoupledRule {
    double beta = 0.25; // of Newmark's rule [-]
    BackwardRule film = BackwardRule::Fitted;
    CouplingKind coupling = CouplingKind::Monolithic;
    int turns = 1; // InTurns: number of times that the mass moves and the film follows
};
/// w = omega h, the mass's own damping ratio, the leak s/omega [-].
double coupledGrowth(const CoupledRule& rule, double w, double dampingRatio, double leak);

/// Growth above which a method counts as unstable: round-off of the eigenvalues does not.
inline constexpr double stableGrowth = 1.0 + 1e-9;

/// The largest x up to which stable(x') holds for all x' <= x, looked for from `from` up to `to` in steps of a fraction
/// of an octave and by halving; `to` where it always holds, zero where it does not at `from`.
double largestStable(const std::function<bool(double)>& stable, double from, double to);

/// Lines of growth = 1 in a part of the complex plane, symmetrical about the real axis, joined into as few as there
/// are; a closed one ends where it begins. By marching squares (Lorensen & Cline 1987) on cells of width/columns, with
/// the crossings found by halving.
struct PlaneWindow {
    double left = -4.0, right = 1.0, height = 4.0; // of its upper half [-]
    int columns = 200;
};
std::vector<std::vector<std::complex<double>>> stabilityBoundary(const Growth& growth, const PlaneWindow& window);

} // namespace touchdown
