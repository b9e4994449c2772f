// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adhesive pressure between two smooth surfaces, a function of the local gap g. Pressure is positive where it pushes
// the surfaces apart, so attraction is negative.
//
//   lennard-jones   f = -(8 dgamma/(3 z0)) [s^3 - s^9], s = z0/(g + z0), g >= 0: zero at g = 0, where only elastic
//                   contact repels. Our reading of the improved intermolecular model, reference [8] of Chen & Bogy,
//                   whose equations were not available. Its integral over g from 0 is -dgamma.
//   van-der-waals   f = -A/(6 pi g^3) + B/(45 pi g^9)
//   electrostatic   f = -eps0 V^2/(2 (g + z0)^2), alone or added to either of them
//
// All are finite at every gap; a gap below zero counts as zero. Below half the gap at which its pressure vanishes, the
// van der Waals law continues along its tangent. With B = 0, the attraction below z0 is that at z0.
#pragma once

#include <cstdint>

namespace touchdown {

enum class AdhesionKind : std::uint8_t; // core/physics/contact/adhesion_kind.h

struct Adhesion {
    AdhesionKind kind{};                 // the first: none
    double surfaceEnergy = 0.05;         // dgamma [N/m], work of adhesion; the lubricant enters through it
    double equilibriumDistance = 0.3e-9; // z0 [m], 0.2..0.4 nm
    double hamakerA = 1e-19;             // A [J]
    double hamakerB = 1e-76;             // B [J m^6]
    double voltage = 0.0;                // V [V] between slider and disk

    bool acts() const { return kind != AdhesionKind{} || voltage != 0.0; }
    bool operator==(const Adhesion&) const = default;
};

class AdhesionLaw {
public:
    /// surfaceEnergy, A and B at least zero, z0 positive; all finite.
    explicit AdhesionLaw(const Adhesion& adhesion);

    /// f(g) [Pa].
    double pressure(double gap) const { return sample(gap).pressure; }
    /// df/dg [Pa/m]; at zero and below, the one towards larger gaps.
    double derivative(double gap) const { return sample(gap).derivative; }
    /// phi(g) [J/m^2], zero far away: f = -dphi/dg.
    double energy(double gap) const;

    /// The least of phi, at the gap where f = 0 or at zero [J/m^2].
    double leastEnergy() const;

    struct Sample {
        double pressure;   // [Pa]
        double derivative; // [Pa/m]
    };
    Sample sample(double gap) const;

    /// The law of gaps >= 0 but for van der Waals: with s = z0/(g + z0), -scale (s^3 - s^9) - electric (s/z0)^2.
    struct Shifted {
        double z0, perZ0, scale, electric; // [m], 1/z0 [1/m], [Pa], [N]
        Sample sample(double gap) const
        {
            const double s = z0 / (gap + z0), s3 = s * s * s, s9 = s3 * s3 * s3;
            const double near = s * perZ0; // 1/(g + z0) [1/m]
            return {-electric * near * near - scale * (s3 - s9),
                    near * (2.0 * electric * near * near + scale * (3.0 * s3 - 9.0 * s9))};
        }
    };
    const Shifted& shifted() const { return shifted_; }
    /// Whether that is the whole law.
    bool isShifted() const { return isShifted_; }

    /// Where the attraction is largest [m]: df/dg <= 0 below this gap, df/dg > 0 (softening) above it.
    double peakGap() const { return peakGap_; }
    /// The largest attraction, -f(peakGap) [Pa].
    double peakAttraction() const { return peakAttraction_; }
    bool acts() const { return acts_; }

private:
    double softeningGap() const;

    bool acts_;
    AdhesionKind kind_;
    bool isShifted_;               // not van der Waals
    Shifted shifted_;              // scale 8 dgamma/(3 z0), electric eps0 V^2/2; scale 0 unless lennard-jones
    double attraction_ = 0.0;      // A/(6 pi) [J]
    double repulsion_ = 0.0;       // B/(45 pi) [J m^6]
    double tangentGap_ = 0.0;      // below it van der Waals continues along its tangent [m]
    double tangentPressure_ = 0.0; // [Pa]
    double tangentSlope_ = 0.0;    // [Pa/m]
    double tangentEnergy_ = 0.0;   // [J/m^2]
    double peakGap_ = 0.0;         // [m]
    double peakAttraction_ = 0.0;  // [Pa]
};

} // namespace touchdown
