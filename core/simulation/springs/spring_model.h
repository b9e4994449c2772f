// SPDX-License-Identifier: GPL-3.0-or-later
//
// The 2-DOF slider of Ono & Yamane (Chen & Bogy, section 4, equations (1)-(5), Fig. 9): two lumped air springs,
// the suspension, and the contact at a pad by the law that the case names (pad_law.h).
//
//   z_f = z + d_f theta,  z_r = z - d_r theta,  d = z - d_h theta
//   M z''     = F_f + F_r + F_c - k (z - z_0) - c z'
//   J theta'' = d_f F_f - d_r F_r - d_h F_c - (b/2) mu F_cr - k_theta (theta - theta_0) - c_theta theta'
//   F_i = k_i0 z_i0^2/z_i^2 (z_i0 - z_i) [z_i > d_1] - c_i z_i',   c_i = 2 xi_i sqrt(M k_i0)
//
// z is the height of the mass centre's foot above the mean plane of the disk, theta > 0 has the leading edge up. Over a
// disk that is not flat, z_f, z_r and d are reckoned from the disk's surface under each place, and the equations stay
// as they are: z_f = z + d_f theta - w_f and so on, with z_f' = z' + d_f theta' - w_f' where the surface moves.
// Friction and pad force both press the nose down (the paper prints + d_h F_c: its d_h is a signed coordinate).
// Energy as in equation (5), with the k_theta term that the paper omits and J where it prints m; zero at rest.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/case/case.h"
#include "core/numerics/interval.h"
#include "core/physics/contact/coulomb_friction.h"
#include "core/physics/film/air_spring.h"
#include "core/simulation/recording/quantity.h"
#include "core/simulation/springs/pad_law.h"

namespace touchdown {

class SpringModel {
public:
    using State = Eigen::Vector4d; // z [m], theta [rad], z' [m/s], theta' [rad/s]
    using Guards = Eigen::Vector3d;
    /// The state without the time, which is one of its coordinates over a surface that moves (springs_over_disk.h).
    static const State& motionOf(const State& y) { return y; }
    static State motionOf(const Eigen::Matrix<double, 6, 1>& y) { return {y[0], y[1], y[3], y[4]}; }

    /// Which law holds.
    struct Mode {
        bool frontSpring = true;
        bool rearSpring = true;
        ContactRegion contact = ContactRegion::Apart;
        bool operator==(const Mode&) const = default;
    };

    /// Switching quantities: the separation of the pad, and the spacings of the two air springs [m].
    enum Guard { Pad, Front, Rear };
    static constexpr int guardCount = 3;

    /// The disk's surface under pad and pressure centres.
    struct Under {
        Guards height = Guards::Zero(); // w [m]
        Guards rate = Guards::Zero();   // w', as the surface moves [m/s]
        void pass(auto& stream) { stream(height, rate); }
    };

    /// `c` must be valid (checkCombinations). `under`: constant heights of a surface that stands still [m]; zero on a
    /// flat disk. Over a moving surface the model is flat, and each of its functions takes what is under it instead.
    explicit SpringModel(const Case& c, const Guards& under = Guards::Zero());

    State initialState() const { return initial_; }
    Mode initialMode() const { return initialMode(still_.height); }
    Mode initialMode(const Guards& under) const;
    /// The state of static equilibrium without contact above a flat disk.
    State staticState() const { return static_; }
    /// M [kg], J [kg m^2].
    Eigen::Vector2d inertia() const { return {1.0 / inverseMass_, 1.0 / inverseInertia_}; }

    // What the integrators ask: see core/numerics/switched_system.h.
    State derivative(const State& y, Mode mode) const { return derivativeAt(y, mode, guards(y.head<2>())); }
    State naiveDerivative(const State& y, Mode mode) const
    {
        const Guards at = guards(y.head<2>());
        return derivativeAt(y, lawAt(mode, at), at);
    }
    Mode naiveMode(const State& y, Mode mode) const { return naiveMode(y, mode, still_.height); }
    Guards guards(const Eigen::Vector2d& q) const { return guards(q, still_.height); }
    Guards guardRates(const State& y) const { return ratesOf(y.tail<2>()); }
    Eigen::RowVector2d guardSizes(int guard) const;
    Interval interval(int guard, Mode mode) const;
    Mode beyond(Mode mode, int guard, bool upper) const;
    bool isWall(int guard) const { return guard != Pad; }
    State scale() const { return scale_; }
    /// Kinetic, air spring and suspension energy, without that of the contact [J]; the air springs' held below d_1.
    double energy(const State& y) const { return energy(y, still_.height); }
    /// Power on the slider by part [W].
    struct Powers {
        double suspension = 0.0;                      // of its dashpots
        double frontDashpot = 0.0, rearDashpot = 0.0; // of the air springs
        double contact = 0.0;                         // of contact and adhesion
        double friction = 0.0;
        double disk = 0.0; // of a surface that moves: sum of the forces of air and contact times w'
        double sum() const { return suspension + frontDashpot + rearDashpot + contact + friction + disk; }
    };
    Powers powers(const State& y, Mode mode) const { return powers(y, mode, still_); }
    /// Power of dashpots, contact, friction and disk on the slider [W].
    double power(const State& y, Mode mode) const { return powers(y, mode).sum(); }
    /// Derivatives of (z'', theta'') by the state.
    Eigen::Matrix<double, 2, 4> jacobian(const State& y, Mode mode) const
    {
        return jacobianAt(guards(y.head<2>()), mode);
    }
    /// At these spacings [m].
    Eigen::Matrix<double, 2, 4> jacobianAt(const Guards& at, Mode mode) const;

    /// Shortest time scale of the motion about the static state and in contact [s].
    double shortestPeriod() const { return period_; }
    /// That of the motion near y, where an air spring may be much stiffer [s].
    double period(const State& y, Mode mode) const { return period(jacobian(y, mode)); }
    /// An energy that a sane run stays far below [J].
    double energyBound() const { return energyBound_; }
    const PadLaw& padLaw() const { return *pad_; }

    /// "touch-down", "rear spring lost", ...: the switch of a guard from one mode to another.
    std::string eventName(int guard, Mode before, Mode after) const;

    static std::vector<Quantity> quantities(const Case& c) { return quantitiesOf(rows(c)); }
    /// All quantities of one state, in the order of quantities(); `values` has their size.
    void observe(const State& y, Mode mode, const Under& under, double* values) const;

    // The same over a surface that moves.
    State derivative(const State& y, Mode mode, const Under& under) const
    {
        return pushed(derivativeAt(y, mode, guards(y.head<2>(), under.height)), under.rate);
    }
    State naiveDerivative(const State& y, Mode mode, const Under& under) const
    {
        const Guards at = guards(y.head<2>(), under.height);
        return pushed(derivativeAt(y, lawAt(mode, at), at), under.rate);
    }
    Mode naiveMode(const State& y, Mode mode, const Guards& under) const;
    Guards guards(const Eigen::Vector2d& q, const Guards& under) const
    {
        return {(q[0] - under[Pad]) - padDistance_ * q[1], (q[0] - under[Front]) + frontDistance_ * q[1],
                (q[0] - under[Rear]) - rearDistance_ * q[1]};
    }
    /// The rates of the guards over a surface that does not move, of (z', theta').
    Guards ratesOf(const Eigen::Vector2d& v) const
    {
        return {v[0] - padDistance_ * v[1], v[0] + frontDistance_ * v[1], v[0] - rearDistance_ * v[1]};
    }
    double energy(const State& y, const Guards& under) const;
    Powers powers(const State& y, Mode mode, const Under& under) const;
    double period(const Eigen::Matrix<double, 2, 4>& jacobian) const;

private:
    /// A state as it is recorded.
    struct Sample {
        State y;                                                            // as above
        double d, zf, zr;                                                   // separation, spacings [m]
        double airForce, kinetic, air, suspension;                          // [N], energies [J]
        double contact = 0.0, adhesion = 0.0, friction = 0.0, stored = 0.0; // [N], the last [J]
        double frictionPower = 0.0;                                         // [W]
        double area = 0.0;                                                  // of contact [m^2]
        Guards under = Guards::Zero();                                      // w [m]
        double diskPower = 0.0;                                             // [W]
    };
    static const std::vector<RecordedQuantity<Sample>>& rows(const Case& c);

    State derivativeAt(const State& y, Mode mode, const Guards& at) const
    {
        const double d = at[Pad], zf = at[Front], zr = at[Rear];
        const double front = mode.frontSpring ? (front_.staticSpacing - zf) / (zf * zf) : 0.0;
        const double rear = mode.rearSpring ? (rear_.staticSpacing - zr) / (zr * zr) : 0.0;
        const ContactRow& contact = contactRows_[static_cast<std::size_t>(mode.contact)];
        const double z = y[0] - static_[0];
        const double theta = y[1] - static_[1];
        // The springs' divisions take longest: everything else is summed while they run.
        const double vertical =
            ((linear_(0, 0) * z + (contact.z0 + contact.z1 * d)) + (linear_(0, 2) * y[2] + linear_(0, 3) * y[3])) +
            (frontVertical_ * front + rearVertical_ * rear);
        const double pitch = ((linear_(1, 1) * theta + (contact.theta0 + contact.theta1 * d)) +
                              (linear_(1, 2) * y[2] + linear_(1, 3) * y[3])) +
                             (frontPitch_ * front + rearPitch_ * rear);
        State rate{y[2], y[3], vertical, pitch};
        if (!affine_) press(rate, mode.contact, d);
        return rate;
    }
    /// Adds the forces of a law at the pad that is not affine.
    void press(State& rate, ContactRegion region, double d) const;
    /// With the forces by which the dashpots follow a surface that rises at these rates [m/s].
    State pushed(const State& rate, const Guards& rising) const
    {
        const double front = frontDamping_ * rising[Front], rear = rearDamping_ * rising[Rear];
        return {rate[0], rate[1], rate[2] + (front + rear) * inverseMass_,
                rate[3] + (frontDistance_ * front - rearDistance_ * rear) * inverseInertia_};
    }
    /// True where the laws of a mode are those of the spacings themselves.
    bool holds(Mode mode, const Guards& at) const
    {
        const ContactRow& contact = contactRows_[static_cast<std::size_t>(mode.contact)];
        return mode.frontSpring == (at[Front] > front_.cutoff) && mode.rearSpring == (at[Rear] > rear_.cutoff) &&
               at[Pad] > contact.lower && at[Pad] < contact.upper;
    }
    /// The laws at given spacings, on the branch of a mode.
    Mode lawAt(Mode mode, const Guards& at) const { return holds(mode, at) ? mode : lawOn(branchOf(mode), at); }
    Mode lawOn(ContactBranch branch, const Guards& at) const
    {
        return {at[Front] > front_.cutoff, at[Rear] > rear_.cutoff, pad_->region(branch, at[Pad])};
    }
    static ContactBranch branchOf(Mode mode) { return OnoYamaneLaw::branch(mode.contact); }
    /// Moment about the mass centre, nose down, of a force at the pad and the friction of its real contact [N m].
    double turning(double net, double contact) const { return padDistance_ * net + friction_.noseDown() * contact; }
    PadForces padForces(Mode mode, double d) const { return pad_->at(mode.contact, d); }
    /// An energy of the order of the largest that the contact law stores or gives, or more [J].
    double contactEnergyBound() const;
    double suspensionEnergy(const State& y) const;
    double kineticEnergy(const State& y) const;

    /// Acceleration by contact and friction under an affine law: z0 + z1 d [m/s^2], theta0 + theta1 d [rad/s^2]; under
    /// another zero. The separations d between which the law holds [m].
    struct ContactRow {
        double z0 = 0.0, z1 = 0.0, theta0 = 0.0, theta1 = 0.0;
        double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
    };

    Case case_;
    Under still_; // under the places, of a surface that does not move
    const std::vector<RecordedQuantity<Sample>>* rows_;
    AirSpring front_;
    AirSpring rear_;
    std::shared_ptr<const PadLaw> pad_;
    bool affine_; // pad_
    CoulombFriction friction_;
    double frontDistance_, rearDistance_, padDistance_;          // [m]
    double inverseMass_, inverseInertia_;                        // [1/kg], [1/(kg m^2)]
    double frontVertical_, rearVertical_;                        // k_i0 z_i0^2/M [m^2/s^2]
    double frontPitch_, rearPitch_;                              // d_f k_f0 z_f0^2/J, -d_r k_r0 z_r0^2/J [m rad/s^2]
    double frontDamping_, rearDamping_, damping_, pitchDamping_; // [N s/m], the last [N m s/rad]
    Eigen::Matrix<double, 2, 4> linear_;                         // suspension and dashpots, as accelerations
    std::array<ContactRow, 4> contactRows_;
    State static_, initial_, scale_;
    double period_;      // [s]
    double energyBound_; // [J]
};

} // namespace touchdown
