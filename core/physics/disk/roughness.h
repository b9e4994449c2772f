// SPDX-License-Identifier: GPL-3.0-or-later
//
// Isotropic rough surfaces with Gaussian heights and a given spectrum, periodic in both directions. In the plane,
// with C(q) over the wave vector so that its integral is the variance:
//
//   gaussian      R(r) = sigma^2 exp(-r^2/lc^2)
//   exponential   R(r) = sigma^2 exp(-r/lc)
//   self-affine   C(q) = C0 for q < q_r, C0 (q/q_r)^(-2-2H) for q_r <= q <= q_c, 0 beyond (Persson et al. 2005);
//                 q_r and q_c are 2 pi over the roll-off and cut-off wavelengths; C0 follows from sigma.
//
// The first two are made from their autocovariance, repeated with the period (circulant embedding, Dietrich & Newsam
// 1997). The heights at the points have exactly that covariance, so the content of waves shorter than two cells is
// folded to longer ones, as in a measurement at those points. The third has no waves that short.
//
// Each realisation has the exact RMS about its mean, 0. Without a correction, the RMS over n correlated patches would
// scatter by 1/sqrt(2 n) of itself, 1 % and more. For this the power P of each wave is multiplied by 1 + alpha P,
// with one alpha for all waves: this is the expected power of normal waves, given the sum of the powers. It changes
// the few strong waves that make the RMS scatter, by a few per cent, and leaves the many weak ones alone: the density
// stays within the scatter of the request.
#pragma once

#include <functional>
#include <vector>

#include "core/physics/disk/disk_surface.h"

namespace touchdown {

/// Points of the map along the track and across.
int mapColumns(const DiskSurface& surface);
int mapRows(const DiskSurface& surface);

/// Heights [m], row by row, x fastest. The same seed gives the same bits, on every run. Made in place: beside the
/// result no second map is in memory. `goOn` is asked at each row; where it says false the heights mean nothing.
std::vector<double> generateRoughness(const DiskSurface& surface, const std::function<bool()>& goOn = {});

/// What the density of a profile along the track may be expected to be.
struct RequestedPsd {
    double density = 0.0;         // expected, one-sided over q [m^3]
    double low = 0.0, high = 0.0; // 95 % of realisations lie between [m^3]
};

/// The spectrum that the map is made with: at points, and periodic across.
class RequestedSpectrum {
public:
    explicit RequestedSpectrum(const DiskSurface& surface);

    /// Of the mean over all rows at wave number q = 2 pi/wavelength > 0 [rad/m], or of the mean over that many wave
    /// numbers of the period about q. The limits are those of a chi-square variable with 2 modes (sum C)^2/sum C^2
    /// degrees of freedom, the sums over the waves across that share q (its quantiles after Wilson & Hilferty 1931).
    RequestedPsd profile(double q, int modes = 1) const;
    /// C at a wave vector of that size [m^4]; without folding.
    double density(double q) const;

private:
    DiskSurface surface_;
    double scale_ = 1.0; // variance of all waves with the mean [m^2]; C0 of the self-affine spectrum [m^4]
};

} // namespace touchdown
