// SPDX-License-Identifier: GPL-3.0-or-later
//
// The return map of the spring model, whose fixed points are cycles of sustained bouncing.
//
// The section is the touch-down height: the separation d of the pad crosses d_s downwards, from any region of the
// contact law. A state on the section has three coordinates,
//
//   x = (theta, d', theta'),   z = d_s + d_h theta,   z' = d' + d_h theta',
//
// in units of SpringModel::scale of one case. P(x) is the n-th next crossing. A cycle with n crossings is P(x) = x. Its
// Floquet multipliers are the eigenvalues of dP/dx; the cycle is stable where all are inside the unit circle.
//
//   Phi' = A(t) Phi                          along a step, A = df/dy
//   S = I + (f+ - f-) g^T/(g . f-)           at a switch with the normal g (Aizerman & Gantmakher 1958)
//   dP/dx = C (I - f- g^T/(g . f-)) Phi B    at the section; B and C take x to y and y to x
//
// (Leine & Nijmeijer, Dynamics and Bifurcations of Non-Smooth Mechanical Systems, 2004, chapter 7.) At a grazing
// g . f- = 0 and the map is not smooth. Cycles that never cross d_s are not found.
#pragma once

#include <vector>

#include "core/numerics/small_matrix.h"
#include "core/numerics/switched_system.h"
#include "core/simulation/springs/spring_model.h"

namespace touchdown {

/// A switch along a cycle.
struct CycleSwitch {
    int guard = 0;
    SpringModel::Mode before, after;
    bool operator==(const CycleSwitch&) const = default;
};

/// Energy that the slider receives along a cycle, by part [J].
struct CycleEnergies {
    double air = 0.0;        // dashpots of the air springs
    double suspension = 0.0; // its dashpots
    double contact = 0.0;    // contact and adhesion: -W at each touch-down from flight
    double friction = 0.0;
    /// Zero for a cycle.
    double sum() const { return air + suspension + contact + friction; }
    double largest() const;
};

/// The smallest and the largest value of a length along a cycle [m].
struct SwingOf {
    double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();
    void add(double value);
};

struct ReturnRequest {
    int crossings = 1;         // n
    double limit = 1e-3;       // within which the slider must come back [s]
    bool derivative = false;   // dP/dx
    bool measurements = false; // energies and swings
    double tolerance = 1e-11;  // local error of a step, in units of SpringModel::scale [-]
};

struct Return {
    bool returned = false;
    Vector3 x = Vector3::Zero(); // P(x)
    double time = 0.0;           // until then [s]
    Matrix3 derivative = Matrix3::Zero();
    std::vector<CycleSwitch> switches; // the last one is the crossing itself
    std::vector<Vector3> passed;       // x at each crossing
    /// Distance from x of the nearest crossing after which a cycle would repeat itself; infinite for n = 1 [-].
    double repeats(const Vector3& from) const;
    CycleEnergies energies;
    SwingOf separation, minimumSpacing; // d; the smallest of d, z_f and z_r
};

/// Units of x: [rad], [m/s], [rad/s].
Vector3 sectionUnits(const Case& c);

class ReturnMap {
public:
    /// The case is valid and has Ono and Yamane's contact.
    ReturnMap(const Case& c, const Vector3& units);

    const SpringModel& model() const { return model_; }
    Return apply(const Vector3& x, const ReturnRequest& request) const;
    /// x of a state on the section.
    Vector3 coordinates(const SpringModel::State& y) const;
    /// The state on the section.
    SpringModel::State state(const Vector3& x) const;
    Start<SpringModel> start(const Vector3& x) const { return {state(x), modeAt(state(x))}; }
    /// Whether a switch is a crossing of the section.
    static bool crosses(int guard, SpringModel::Mode before, SpringModel::Mode after)
    {
        return guard == SpringModel::Pad && after.contact == ContactRegion::Pressed &&
               before.contact != ContactRegion::Pressed;
    }

private:
    SpringModel::Mode modeAt(const SpringModel::State& y) const;

    SpringModel model_;
    Vector3 units_;
    double touchDown_, padDistance_;  // d_s, d_h [m]
    double frontCutoff_, rearCutoff_; // below which a spring does not carry [m]
};

} // namespace touchdown
