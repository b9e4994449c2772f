// SPDX-License-Identifier: GPL-3.0-or-later
//
// Multi-asperity contact and meniscus adhesion with bulk deformation, after Ono and Yamane as described by Chen & Bogy:
// forces as functions of the spacing for given radius, density and height deviation of the asperities, area of the pad
// and surface energy of the lubricant; the area is constant, only menisci adhere. Our reading, as the equations were
// not available:
//
//   s = d + F_c/k_b                    local separation of pad and the disk's mean plane; the bulk gives way to F_c
//   F_c = F_cr + F_m
//   F_cr = A p(s)                      p of core/physics/contact/asperity_contact.h
//   F_m = -eta A Q((zeta - y_s)/sigma_s) 2 pi R gamma (1 + cos theta), Q(x) the share of Gaussian heights above x
//   k_b = 1.0566 E* sqrt(A)            mean displacement of a square under uniform pressure (Love 1929)
//
// Heights are above the disk's mean plane, those of the summits about y_s. A summit of height z wets when its gap s - z
// falls to the film's thickness t, and dries when it exceeds the bridge's length h_b. So the wetted summits are those
// above one height zeta, which follows s with play:
//
//   zeta <- min(max(zeta, s - h_b), s - t).
//
// The state is (s, zeta). s follows d quasi-statically. Where menisci form faster than the bulk stiffness can balance,
// d(s) folds, and s jumps at fixed d: touch-down on the way in, take-off on the way out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/physics/contact/asperity_contact.h"

namespace touchdown {

struct MultiAsperityState {
    double separation = 0.0;  // s [m]
    double wettedAbove = 0.0; // zeta [m]
};

struct MultiAsperityForces {
    double contact = 0.0;                               // F_cr >= 0 [N]
    double adhesion = 0.0;                              // F_m <= 0 [N]
    double contactArea = 0.0;                           // of all summits [m^2]
    double contacts = 0.0;                              // number of pressed summits
    double menisci = 0.0;                               // number of wetted summits
    double storedEnergy = 0.0;                          // of the pressed summits and of the bulk [J]
    double total() const { return contact + adhesion; } // F_c [N]
};

/// Changes of the forces over a small move of d [N/m]; both infinite at a fold.
struct MultiAsperitySlopes {
    double contact = 0.0, adhesion = 0.0;
};

/// A jump at fixed pad separation.
struct MultiAsperityJump {
    double padSeparation = 0.0; // d [m]
    MultiAsperityState from, to;
};

enum class PadMotion : std::uint8_t { Towards, Away };

class MultiAsperity {
public:
    /// Radius, density, deviation, moduli and area are positive; surface tension and film thickness at least 0;
    /// breakingLength >= filmThickness.
    MultiAsperity(const Asperities& asperities, const Meniscus& meniscus, const ElasticPair& pair, double padArea);

    /// The pad brought to d [m] from afar, for the first time.
    MultiAsperityState start(double padSeparation) const;
    /// The pad moved to d [m] from where `state` holds, straight and slowly. Allocates nothing.
    MultiAsperityState advance(const MultiAsperityState& state, double padSeparation) const;

    MultiAsperityForces forces(const MultiAsperityState& state) const;
    /// d = s - F_c/k_b [m].
    double padSeparation(const MultiAsperityState& state) const;
    /// Of a small move from `state`, with d'(s): F_cr'(s)/d' and F_m'(s)/d'.
    MultiAsperitySlopes slopes(const MultiAsperityState& state, PadMotion motion) const;
    /// The first jump ahead, if there is one before all summits are wetted or dry.
    std::optional<MultiAsperityJump> nextJump(const MultiAsperityState& state, PadMotion motion) const;
    /// Energy lost in a jump: the pad rests, and what the forces on the surface do beyond the work of the bulk [J].
    double lostIn(const MultiAsperityJump& jump) const;

    double padArea() const { return area_; }                // A [m^2]
    double summitDensity() const { return density_; }       // eta [1/m^2]
    double bulkStiffness() const { return bulkStiffness_; } // k_b [N/m]
    /// With every summit wetted [N].
    double largestAdhesion() const { return meniscusForce_; }
    /// Beyond this pad separation there is no force in any state [m].
    double reach() const;

private:
    struct Path;
    double wettedShare(double wettedAbove) const;

    AsperityContact contact_;
    double sigma_ = 0.0;         // sigma_s [m]
    double film_ = 0.0;          // t [m]
    double bridge_ = 0.0;        // h_b [m]
    double planeHeight_ = 0.0;   // y_s [m]
    double area_ = 0.0;          // A [m^2]
    double density_ = 0.0;       // eta [1/m^2]
    double bulkStiffness_ = 0.0; // k_b [N/m]
    double meniscusForce_ = 0.0; // eta A 2 pi R gamma (1 + cos theta) [N]
};

/// One point of the curve of a pad that moves in and out.
struct MultiAsperityPoint {
    double padSeparation = 0.0; // d [m]
    MultiAsperityState state;
    MultiAsperityForces forces;
};

/// In from `start` to `closest` and back out, `points` evenly spaced ones each way; a jump adds its two ends at one d.
struct MultiAsperityCurve {
    std::vector<MultiAsperityPoint> towards, away;
    std::vector<MultiAsperityJump> touchDowns, takeOffs;
    /// Work lost on the way in and out: the area of the loop F_c(d) [J]; the jumps' part of it.
    double work = 0.0, lostInJumps = 0.0;
};

MultiAsperityCurve multiAsperityCurve(const MultiAsperity& model, double start, double closest, int points = 401);

} // namespace touchdown
