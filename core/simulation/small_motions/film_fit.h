// SPDX-License-Identifier: GPL-3.0-or-later
//
// The film about a steady state as a few dozen ordinary differential equations: a rational function through its dynamic
// stiffness Z (small_motions.h),
//
//   Z(s) ~ D + sum_k R_k/(s - p_k),   force = F_0 - D u - sum_k R_k x_k,   x_k' = p_k x_k + u
//
// u the displacement of q from that state. Values of Z are taken where the fit is not yet good: at the frequencies of
// the slider's own motions, and in the widest gaps between those known.
#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "core/numerics/small_matrix.h"

namespace touchdown {

class SmallMotions;

inline constexpr double lowestFitted = 1e3, highestFitted = 3.2e6; // frequencies of the values [Hz]

struct FilmFit {
    using Complex = std::complex<double>;

    struct Pole {
        Complex rate; // p_k [1/s]; with Im p > 0 also its conjugate, which is understood
        ComplexMatrix3 residue = ComplexMatrix3::Zero();
        void pass(auto& stream) { stream(rate, residue); }
    };
    Matrix3 constant = Matrix3::Zero(); // D [N/m ...]
    std::vector<Pole> poles;
    int order = 0;      // number of poles, pairs counted twice
    int values = 0;     // of Z that were computed
    double error = 0.0; // largest difference of Z from values before they were fitted, of its largest entry [-]

    ComplexMatrix3 at(Complex s) const;
    bool isFinite() const;
    void pass(auto& stream) { stream(constant, poles, order, values, error); }
};

/// Terms of a sum for a pole with this rate: two where its conjugate is understood.
inline double termsOf(FilmFit::Complex rate) { return rate.imag() == 0.0 ? 1.0 : 2.0; }

/// `goOn` false, asked before each value of Z: the result is of no use. `solved` becomes false where a linear system
/// was not solved.
FilmFit fitFilm(SmallMotions& motions, bool& solved, const std::function<bool()>& goOn = {});

/// Rates of the slider's motions over that film, with Im s > 0, by frequency [1/s].
std::vector<FilmFit::Complex> ratesOver(const FilmFit& film, const SmallMotions& motions);

} // namespace touchdown
